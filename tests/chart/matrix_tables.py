"""Tables of matrices.md from the rows of matrices.py, and what they must show for the page to be true."""
import math
import os
import re
import shutil
import sys

LONGEST = {"hertz": "elastic Hertz", "rolling": "rolling, example 1", "indentation": "indentation"}


def number(value):
    if not math.isfinite(value):
        return "singular" if value == math.inf else "-"
    return f"{value:.1e}" if value >= 1e4 or 0 < abs(value) < 1e-2 else f"{value:.3g}"


def over(values, form=number):
    """Least to most, once where both read the same."""
    low, high = form(min(values)), form(max(values))
    return low if low == high else f"{low} to {high}"


def scene_table(rows, scene, element):
    mine = [r for r in rows if r["scene"] == scene and r["element"] == element]
    finest = max(r["n"] for r in mine)
    mine = [r for r in mine if r["n"] == finest]
    lines = ["| Matrix | size | entries | MB | condition | scaled | largest off-diagonal over diagonal | rows above 1 | zeros | negative | null | nonsymmetry |",
             "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for name in dict.fromkeys(r["matrix"] for r in mine):
        group = [r for r in mine if r["matrix"] == name]
        column = {key: [r[key] for r in group] for key in group[0]}
        lines.append(f"| {name} | {over(column['size'], str)} | {over(column['entries'], str)} | {max(column['megabytes']):.2f} | "
                     f"{over(column['condition'])} | {over(column['condition_scaled'])} | {over(column['row_ratio'])} | "
                     f"{100 * max(column['rows_above_1']):.2g} % | {over(column['zeros'], str)} | {over(column['negative'], str)} | "
                     f"{over(column['null'], str)} | {over(column['nonsymmetry'])} |")
    contact = sorted({r["contact"] for r in mine})
    return f"{LONGEST[scene]}, {element}, n = {finest}, nodes in contact: {', '.join(map(str, contact))}\n\n" + "\n".join(lines) + "\n"


def rivals_table(rows):
    lines = ["| Hertz, P1, n = 4 | off the matrix of the rival's own loop |", "|---|---|"]
    return "\n".join(lines + [f"| {r['matrix']} | {number(r['off'])} |" for r in rows]) + "\n"


def parts_table(rows):
    names = [key for key in rows[0] if key != "t"]
    lines = ["| | " + " | ".join(f"t = {r['t']}" for r in rows) + " |", "|---|" + "---|" * len(rows)]
    return "\n".join(lines + [f"| {name} | " + " | ".join(number(r[name]) for r in rows) + " |" for name in names]) + "\n"


def ways_table(rows):
    base = rows[0]
    lines = ["| Matrix | outcome | steps | rejected | iterations | matrices | CPU s | over all of it | MB | depth off |", "|---|---|---|---|---|---|---|---|---|---|"]
    for r in rows:
        off = f"{r['depth'] / base['depth'] - 1:.0e}" if r["outcome"] == "finished" else "-"
        lines.append(f"| {r['way']} | {r['outcome']} | {r['steps']} | {r['rejected']} | {r['iterations']} | {max(r['condensations'], r['factorizations'])} | "
                     f"{r['seconds']:.1f} | {r['seconds'] / base['seconds']:.2f} | {r['megabytes']:.0f} | {off} |")
    return "\n".join(lines) + "\n"


def integrals_table(rows):
    lines = ["| | t | contact, sliding | curvature | change of area | turn | of the matrix | stiffness, nodal | stiffness, literal |",
             "|---|---|---|---|---|---|---|---|---|"]
    for r in rows:
        lines.append(f"| {r['element']} | {r['t']} | {r['contact']}, {r['sliding']} | {number(r['lumping'])} | {number(r['area'])} | {number(r['turn'])} | "
                     f"{number(r['of the matrix'])} | {100 * r['stiffness, article']:+.2f} % | {100 * r['stiffness, literal']:+.2f} % |")
    return "\n".join(lines) + "\n"


def tables(found):
    made = {f"{scene} {element}": scene_table(found["matrices"], scene, element) for scene in LONGEST for element in ("P1", "P2")}
    return {**made, "rivals": rivals_table(found["rivals"]), "parts": parts_table(found["parts"]), "ways": ways_table(found["ways"]), "integrals": integrals_table(found["integrals"])}


def broken_claims(found):
    """What the page says and these numbers do not bear out."""
    wrong = []
    for r in found["matrices"]:
        where = f"{r['scene']}, {r['element']}, n = {r['n']}, state {r['state']}, {r['matrix']}"
        body = next(s for s in found["matrices"] if s["matrix"] == "K" and all(s[k] == r[k] for k in ("scene", "element", "n", "state")))
        if r["matrix"].startswith("condensed") and (r["zeros"] or r["null"]):
            wrong.append(f"{where}: no zero on the diagonal, none singular")
        if r["matrix"] == "condensed, coordinates scaled" and r["condition"] > 3 * body["condition"]:
            wrong.append(f"{where}: a condition below three times that of K")
        if r["matrix"] == "multipliers" and r["negative"] + r["null"] < r["contact"]:
            wrong.append(f"{where}: a negative eigenvalue for each node in contact")
    wrong += [f"{r['matrix']}: that of the rival's own loop" for r in found["rivals"] if not r["off"] < 1e-2]
    return wrong


def store(made, folder, here):
    """Tables between the marks of matrices.md, the picture beside it."""
    shutil.copy(os.path.join(folder, "matrices.png"), os.path.join(here, "matrices.png"))
    path = os.path.join(here, "matrices.md")
    with open(path) as f:
        page = f.read()
    for name, text in made.items():
        page, count = re.subn(rf"(<!-- matrices {re.escape(name)} -->\n).*?(<!-- end -->)", lambda m: m.group(1) + text + m.group(2), page, flags=re.S)
        if count != 1:
            sys.exit(f"matrices: {path} has {count} times <!-- matrices {name} -->, expected once")
    with open(path, "w") as f:
        f.write(page)
