"""Words of the chart: what to use for which error, where a rival is better."""

from scene_files import methods

BASE = "implicit"
LEVELS = [0.05, 0.01, 0.002]
STEP = 0.1
NEARLY = 0.8
MEANING = {"pressure": "pressure, L2", "pressure_inner": "pressure, L2 inside 0.8 a", "a": "half-width, and largest pressure",
           "radius": "radius of the contact, by its moment", "peak": "largest pressure, by a fit inside 0.8 a",
           "depth": "depth of the tool", "shift": "way along the surface",
           "traction": "traction, L2", "sticking": "sticking share", "width": "width of the contact", "p99": "plastic strain, 99 %",
           "nodal": "plastic strain, largest at a node", "stress99": "von Mises stress, 99 %", "strain": "field of plastic strain, L2",
           "stress": "field of von Mises stress, L2", "end": "ends of the contact", "rotation": "rotation", "torque": "torque"}


def run_name(row):
    return f"{row['method']}, {row['element']}, n = {row['n']}" + (f", {row['dtsteps']} steps" if row["dtsteps"] else "")


def front(rows, quantity):
    """Rows than which no other is both faster and more accurate, from fast to accurate; in steps of STEP of the error."""
    found = []
    for row in sorted(rows, key=lambda r: (r["seconds"], r[quantity])):
        if not found or row[quantity] < (1 - STEP) * found[-1][quantity]:
            found.append(row)
    return found


def reaches(rows, row, quantity, level):
    """Error below the level with this mesh and step and, lest it were by chance, with all finer ones of the same method."""
    return all(r[quantity] <= level for r in rows
               if (r["method"], r["element"]) == (row["method"], row["element"]) and r["n"] >= row["n"] and r["dtsteps"] >= row["dtsteps"])


def fastest(rows, quantity, level, whose):
    able = [r for r in rows if r["whose"] == whose and reaches(rows, r, quantity, level)]
    return min(able, key=lambda r: r["seconds"], default=None)


def cell(rows, row, quantity, whose, level):
    if row:
        return f"{run_name(row)}: {row['seconds']:.2f} s"
    best = min((r for r in rows if r["whose"] == whose), key=lambda r: r[quantity], default=None)
    if best is None:
        return "no run finished"
    kept = "" if best[quantity] > level else ", by chance: not on finer meshes"
    finest = max(r["n"] for r in rows if (r["method"], r["element"]) == (best["method"], best["element"]))
    run = "; finer not run" if any(r["n"] > finest and r["element"] == best["element"] for r in rows if r["method"] == BASE) else ""
    return f"not reached ({100 * best[quantity]:.2g} % by {run_name(best)} in {best['seconds']:.2f} s{kept}{run})"


def kernels(a, b):
    """Both kernels in words: a ratio of seconds is that of the methods and of these."""
    return f"both {a['kernel']}" if a["kernel"] == b["kernel"] else f"{a['kernel']} against {b['kernel']}"


def by_work(winner, loser):
    """Ratio of the factorizations: that of the methods alone."""
    if not winner["factorizations"] or not loser["factorizations"]:
        return ""
    return f"; factorizations {loser['factorizations']} : {winner['factorizations']} = {loser['factorizations'] / winner['factorizations']:.1f}"


def verdict(ours, rival):
    """Who is faster; what is within the spread of the repetitions is no difference."""
    if not ours or not rival:
        return "neither" if not ours and not rival else "ours only" if ours else "**the rival only**"
    ratio = ours["seconds"] / rival["seconds"]
    noise = 1 + ours["spread"] + rival["spread"]
    if 1 / noise < ratio < noise:
        return f"equal within the spread ({ratio:.2f}, {kernels(ours, rival)}{by_work(ours, rival)})"
    if ratio < 1:
        return f"ours, {1 / ratio:.1f} times ({kernels(ours, rival)}{by_work(ours, rival)})"
    return f"**the rival, {ratio:.1f} times** ({kernels(rival, ours)}{by_work(rival, ours)})"


def table(rows, quantities, known):
    """known: to which error the reference answers for a quantity."""
    lines = ["| Error at most | Fastest of ours | Fastest rival | Faster, in seconds |", "|---|---|---|---|"]
    for quantity in quantities:
        for level in LEVELS:
            words = f"{MEANING.get(quantity, quantity)}: {100 * level:g} %"
            if level < known.get(quantity, 0):
                lines.append(f"| {words} | - | - | the reference is known to {100 * known[quantity]:.2g} % |")
                continue
            ours, rival = (fastest(rows, quantity, level, whose) for whose in ("ours", "rival"))
            lines.append(f"| {words} | {cell(rows, ours, quantity, 'ours', level)} | {cell(rows, rival, quantity, 'rival', level)} | "
                         f"{verdict(ours, rival)} |")
    return lines


def over(row, base, name):
    return f"{row[name] / base[name]:.2f}" if base and row[name] and base[name] else "-"


def costs(rows):
    """What every method takes on the finest mesh and step that nearly all have run; beside condensed, whose loop is interpreted."""
    count = {}
    for r in rows:
        count[r["n"], r["dtsteps"]] = count.get((r["n"], r["dtsteps"]), 0) + 1
    shared = max(key for key in count if count[key] > NEARLY * max(count.values()))
    here = {(r["method"], r["element"]): r for r in rows if (r["n"], r["dtsteps"]) == shared}
    title = f"n = {shared[0]}" + (f", {shared[1]} steps" if shared[1] else "")
    lines = [f"| {title} | kernel | s | s over condensed | factorizations | over condensed | MB | rejected steps | outcome |", "|---" * 9 + "|"]
    for (method, element), r in sorted(here.items(), key=lambda item: item[0][1]):
        base = here.get(("condensed", element))
        seconds = f"{r['seconds']:.2f}" + (f" ± {100 * r['spread']:.0f} %" if r["repeats"] > 1 else "")
        lines.append(f"| {method}, {element} | {r['kernel']} | {seconds} | {over(r, base, 'seconds')}"
                     + (f", {kernels(r, base)}" if base else "")
                     + f" | {r['factorizations'] or '-'} | {over(r, base, 'factorizations')} | {r['megabytes']:.0f} | {r['rejected']} | "
                     + f"{r['outcome']} |")
    return lines + not_run(rows)


def not_run(rows):
    """A sentence of the meshes that the base has run and others have not."""
    finest, most = {}, {}
    for r in rows:
        finest[r["method"], r["element"]] = max(finest.get((r["method"], r["element"]), 0), r["n"])
    for (method, element), n in finest.items():
        if n < finest.get((BASE, element), 0) and "," not in method:
            most.setdefault((element, n), []).append(method)
    words = [f"{', '.join(names)} on {element} above n = {n}" for (element, n), names in most.items()]
    return ["", f"Not run: {'; '.join(words)}."] if words else []


def quarters(rows, known):
    """Error of ours at every quarter, on the coarsest and the finest mesh; known: that of the reference."""
    names = sorted(known)
    lines = ["| P2 | degrees of freedom | steps taken | s | " + " | ".join(f"{n.replace('_', ', quarter ')}, %" for n in names) + " |",
             "|---" * (4 + len(names)) + "|"]
    for method in dict.fromkeys(r["method"] for r in rows if r["whose"] == "ours"):
        mine = sorted((r for r in rows if r["method"] == method and r["element"] == "P2"), key=lambda r: (r["n"], r["dtsteps"]))
        for r in mine if len(mine) < 2 else (mine[0], mine[-1]):
            lines.append(f"| {run_name(r)} | {r['dofs']} | {r['steps']} | {r['seconds']:.2f} | "
                         + " | ".join(f"{100 * r[n]:.2f}" for n in names) + " |")
    return [*lines, "| the reference's own | | | | " + " | ".join(f"{100 * known[n]:.2f}" for n in names) + " |"]


def peers(rows, quantities):
    """Every peer beside ours: on its mesh, and the fastest of ours whose error is not above the peer's, quantity by quantity."""
    names = {m["name"] for m in methods() if m["program"]}
    ours = [r for r in rows if r["whose"] == "ours"]
    lines = ["| Peer | s | over implicit, same mesh | " + " | ".join(MEANING.get(q, q) for q in quantities) + " |", "|---" * (3 + len(quantities)) + "|"]
    for r in sorted((r for r in rows if r["method"] in names), key=lambda r: (r["method"], r["element"], r["n"])):
        same = next((o for o in ours if (o["method"], o["element"], o["n"]) == (BASE, r["element"], r["n"])), None)
        cells = []
        for q in quantities:
            best = min((o["seconds"] for o in ours if o[q] <= r[q]), default=None)
            own = f"{100 * same[q]:.2g} %" if same else "-"
            cells.append(f"{100 * r[q]:.2g} %, {own}; " + (f"{r['seconds'] / best:.3g}" if best else "none of the runs"))
        ratio = f"{r['seconds'] / same['seconds']:.3g}" if same else "-"
        lines.append(f"| {run_name(r)} | {r['seconds']:.2f} | {ratio} | {' | '.join(cells)} |")
    return lines


def use(cases):
    """Lines of the project's README.md; cases: scene, words for it, quantity, what n is, levels, rows."""
    lines = ["| Error | Set | Ours | Forms of the script, `condensed` | Best rival |", "|---|---|---|---|---|"]
    for _, words, quantity, n, levels, rows in cases:
        rows = [r for r in rows if r["outcome"] == "finished"]
        own = [r for r in rows if r["method"].split(",")[0] == "condensed"]
        for level in levels:
            ours = fastest(rows, quantity, level, "ours")
            cells = [cell(some, fastest(some, quantity, level, whose), quantity, whose, level) for some, whose in ((own, "ours"), (rows, "rival"))]
            lines.append(f"| {words}: {100 * level:g} % | " + (f"{setting(ours, n)} | {ours['seconds']:.2f} s" if ours else "- | not reached")
                         + f" | {' | '.join(cells)} |")
    return lines


def setting(row, n):
    """Method, element, mesh and steps of a run in words."""
    meaning = "" if row["method"] == BASE else ": " + next(m["meaning"] for m in methods() if m["name"] == row["method"])
    return f"`{row['method']}`{meaning}; {row['element']}, n = {row['n']} ({n}), {row['steps']} step" + "s" * (row["steps"] > 1)


def better_rivals(rows, quantities):
    """Sentences: rivals on a front, and penalties that are more accurate than the exact constraint."""
    lines = []
    for quantity in quantities:
        rivals = [run_name(r) for r in front(rows, quantity) if r["whose"] == "rival"]
        if rivals:
            lines.append(f"- On the front of {MEANING.get(quantity, quantity)}: {'; '.join(rivals)}.")
    for quantity in quantities:
        better = [(r, o) for r in rows for o in rows
                  if r["whose"] == "rival" and o["method"] == BASE
                  and (o["element"], o["n"], o["dtsteps"]) == (r["element"], r["n"], r["dtsteps"])
                  and r[quantity] < 0.8 * o[quantity]]
        if better:
            lines.append(f"- {MEANING.get(quantity, quantity)} with a smaller error than {BASE} on the same mesh: "
                         + "; ".join(f"{run_name(r)} ({100 * r[quantity]:.2g} against {100 * o[quantity]:.2g} %)" for r, o in better)
                         + ".")
    return lines or ["- Nowhere in this run."]


def report(scene, rows, done, quantities, tables):
    """rows: all; done: those that finished."""
    lines = [f"## {scene}: for this error use this", "", *tables["use"], "",
             f"## {scene}: what it takes", "", *tables["forms"], "",
             f"## {scene}: where a rival is better", "", *better_rivals(done, quantities), ""]
    failed = [f"{run_name(r)}: {r['outcome']}" for r in rows if r["outcome"] != "finished"]
    lines += [f"Not finished: {'; '.join(failed)}.", ""] if failed else []
    rows = done
    for quantity in quantities:
        names = "; ".join(f"{run_name(r)} ({r['seconds']:.2f} s, {100 * r[quantity]:.2g} %)" for r in front(rows, quantity))
        lines.append(f"Front of {MEANING.get(quantity, quantity)}: {names}.")
    return "\n".join(lines) + "\n"
