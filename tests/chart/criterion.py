"""The article's criterion of convergence: on halving the mesh the von Mises stress changes by less than 10 % wherever it exceeds a
tenth of its maximum. Evaluated for example 1 at its end, in the points where the chart compares fields, each with its area."""
from scene_files import areas, methods, run

SCENE = "rolling"
CHANGE, LEAST = 0.1, 0.1
MESHES = {"P1": [75, 150, 300, 600], "P2": [75, 150, 300]}
ARTICLE = 1200  # divisions of its finest mesh, P1
STEPS = "100"


def compared(coarse, fine, area):
    """Share of the area that counts, of that the share that meets the criterion, the largest change, that of 99 % of the area."""
    most = max(fine)
    changes = sorted((abs(f - c) / f, a) for c, f, a in zip(coarse, fine, area) if f > LEAST * most)
    total, below = sum(a for _, a in changes), 0
    for change, a in changes:
        below += a
        if below >= 0.99 * total:
            break
    return {"counted": total / sum(area), "share": sum(a for c, a in changes if c < CHANGE) / total, "change99": change,
            "largest": changes[-1][0]}


def measure(scene, article=False):
    """One row for every halving."""
    options = next(m for m in methods() if m["name"] == "implicit")["options"]
    area, rows = areas(scene), []
    for element, meshes in MESHES.items():
        before = None
        for n in meshes + ([ARTICLE] if article and element == "P1" else []):
            found = run(scene, [*options, "-element", element, "-n", str(n), "-steps", STEPS])
            if before and found["outcome"] in ("finished", "not to be trusted"):
                rows.append({"element": element, "coarse": before[0], "fine": n, **compared(before[1], found["fields"]["stress"], area),
                             "stress_max": max(found["fields"]["stress"]), "seconds": found["seconds"], "outcome": found["outcome"]})
            before = n, found["fields"].get("stress")
    return rows


def table(rows):
    lines = ["| Element, divisions of the outer arc | Area where it counts | Of that meets it | Change on 99 % of it | Largest change "
             "| s, finer mesh |", "|---|---|---|---|---|---|"]
    for r in rows:
        lines.append(f"| {r['element']}, {r['coarse']} to {r['fine']} | {100 * r['counted']:.1f} % | {100 * r['share']:.1f} % | "
                     f"{100 * r['change99']:.2g} % | {100 * r['largest']:.2g} % | {r['seconds']:.1f} |")
    return lines
