"""Words of the chart: what to use for which error, where a rival is better."""

LEVELS = [0.05, 0.01, 0.002]
STEP = 0.1
MEANING = {"pressure": "pressure, L2", "pressure_inner": "pressure, L2 inside 0.8 a", "a": "half-width, and largest pressure",
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
    return f"not reached ({100 * best[quantity]:.2g} % by {run_name(best)}{kept})"


def verdict(ours, rival):
    """Who is faster; what is within the spread of the repetitions is no difference."""
    if not ours or not rival:
        return "neither" if not ours and not rival else "ours only" if ours else "**the rival only**"
    ratio = ours["seconds"] / rival["seconds"]
    noise = 1 + ours["spread"] + rival["spread"]
    if 1 / noise < ratio < noise:
        return f"equal within the spread ({ratio:.2f})"
    return f"ours, {1 / ratio:.1f} times" if ratio < 1 else f"**the rival, {ratio:.1f} times**"


def table(rows, quantities):
    lines = ["| Error at most | Fastest of ours | Fastest rival | Faster |", "|---|---|---|---|"]
    for quantity in quantities:
        for level in LEVELS:
            ours, rival = (fastest(rows, quantity, level, whose) for whose in ("ours", "rival"))
            lines.append(f"| {MEANING.get(quantity, quantity)}: {100 * level:g} % | {cell(rows, ours, quantity, 'ours', level)} | "
                         f"{cell(rows, rival, quantity, 'rival', level)} | {verdict(ours, rival)} |")
    return lines


def costs(rows):
    """What every method takes with the finest mesh and step; with condensed, on the same forms, beside it."""
    finest = max((r["n"], r["dtsteps"]) for r in rows if r["whose"] == "ours")
    last = {(r["method"], r["element"]): r for r in rows if (r["n"], r["dtsteps"]) == finest}
    based = ("condensed", "P1") in last
    head = ["s", "solves", "over condensed"] if based else ["s", "factorizations", "rejected steps", "outcome"]
    n = f"n = {finest[0]}" + (f", {finest[1]} steps" if finest[1] else "")
    titles = [f"Method, {n}"] + [(f"{e}: " if k == 0 else "") + t for e in ("P1", "P2") for k, t in enumerate(head)]
    lines = ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]
    for method in dict.fromkeys(r["method"] for r in rows):
        cells = [method]
        for element in ("P1", "P2"):
            row = last.get((method, element))
            if row is None:
                cells += ["not run"] + ["-"] * (len(head) - 1)
                continue
            seconds = f"{row['seconds']:.2f}" + (f" ± {100 * row['spread']:.0f} %" if row["repeats"] > 1 else "")
            if based:
                cells += [seconds, str(row["solves"] or "-"), f"{row['seconds'] / last['condensed', element]['seconds']:.2f}"]
            else:
                cells += [seconds, str(row["factorizations"] or "-"), str(row["rejected"]), row["outcome"]]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def better_rivals(rows, quantities):
    """Sentences: rivals on a front, and penalties that are more accurate than the exact constraint."""
    lines, base = [], "condensed" if any(r["method"] == "condensed" for r in rows) else "implicit"
    for quantity in quantities:
        rivals = [run_name(r) for r in front(rows, quantity) if r["whose"] == "rival"]
        if rivals:
            lines.append(f"- On the front of {MEANING.get(quantity, quantity)}: {'; '.join(rivals)}.")
    for quantity in quantities:
        better = [(r, o) for r in rows for o in rows
                  if r["whose"] == "rival" and o["method"] == base
                  and (o["element"], o["n"], o["dtsteps"]) == (r["element"], r["n"], r["dtsteps"])
                  and r[quantity] < 0.8 * o[quantity]]
        if better:
            lines.append(f"- {MEANING.get(quantity, quantity)} with a smaller error than {base} on the same mesh: "
                         + "; ".join(f"{run_name(r)} ({100 * r[quantity]:.2g} against {100 * o[quantity]:.2g} %)" for r, o in better)
                         + ".")
    return lines or ["- Nowhere in this run."]


def report(scene, rows, done, quantities):
    """rows: all; done: those that finished."""
    lines = [f"## {scene}: for this error use this", "", *table(done, quantities), "",
             f"## {scene}: what it takes", "", *costs(rows), "",
             f"## {scene}: where a rival is better", "", *better_rivals(done, quantities), ""]
    failed = [f"{run_name(r)}: {r['outcome']}" for r in rows if r["outcome"] != "finished"]
    lines += [f"Not finished: {'; '.join(failed)}.", ""] if failed else []
    rows = done
    for quantity in quantities:
        names = "; ".join(f"{run_name(r)} ({r['seconds']:.2f} s, {100 * r[quantity]:.2g} %)" for r in front(rows, quantity))
        lines.append(f"Front of {MEANING.get(quantity, quantity)}: {names}.")
    return "\n".join(lines) + "\n"
