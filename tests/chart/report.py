"""Words of the chart: what to use for which error, where a rival is better, how the matrices are."""

LEVELS = [0.05, 0.01, 0.002]
STEP = 0.1
MEANING = {"pressure": "pressure, L2", "pressure_inner": "pressure, L2 inside 0.8 a", "a": "half-width, and largest pressure",
           "depth": "depth of the tool"}


def run_name(row):
    return f"{row['method']}, {row['element']}, n = {row['n']}"


def front(rows, quantity):
    """Rows than which no other is both faster and more accurate, from fast to accurate; in steps of STEP of the error."""
    found = []
    for row in sorted(rows, key=lambda r: (r["seconds"], r[quantity])):
        if not found or row[quantity] < (1 - STEP) * found[-1][quantity]:
            found.append(row)
    return found


def reaches(rows, row, quantity, level):
    """Error below the level on this mesh and, lest it were by chance, on all finer ones of the same method."""
    return all(r[quantity] <= level for r in rows
               if (r["method"], r["element"]) == (row["method"], row["element"]) and r["n"] >= row["n"])


def fastest(rows, quantity, level, whose):
    able = [r for r in rows if r["whose"] == whose and reaches(rows, r, quantity, level)]
    return min(able, key=lambda r: r["seconds"], default=None)


def cell(rows, row, quantity, whose):
    if row:
        return f"{run_name(row)}: {row['seconds']:.2f} s"
    best = min((r for r in rows if r["whose"] == whose), key=lambda r: r[quantity])
    return f"not reached ({100 * best[quantity]:.2g} % by {run_name(best)})"


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
            lines.append(f"| {MEANING.get(quantity, quantity)}: {100 * level:g} % | {cell(rows, ours, quantity, 'ours')} | "
                         f"{cell(rows, rival, quantity, 'rival')} | {verdict(ours, rival)} |")
    return lines


def same_forms(rows):
    """Seconds and solves beside the condensed matrix on the same forms, element and mesh."""
    lines = ["| Method, on the finest mesh | P1: s | solves | over condensed | P2: s | solves | over condensed |",
             "|---|---|---|---|---|---|---|"]
    finest = max(r["n"] for r in rows)
    last = {(r["method"], r["element"]): r for r in rows if r["n"] == finest}
    for method in dict.fromkeys(r["method"] for r in rows):
        cells = [method]
        for element in ("P1", "P2"):
            row, base = last[method, element], last["condensed", element]
            cells += [f"{row['seconds']:.2f} ± {100 * row['spread']:.0f} %", str(row["solves"]),
                      f"{row['seconds'] / base['seconds']:.2f}"]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def better_rivals(rows, quantities):
    """Sentences: rivals on a front, and penalties that are more accurate than the exact constraint."""
    lines = []
    for quantity in quantities:
        rivals = [run_name(r) for r in front(rows, quantity) if r["whose"] == "rival"]
        if rivals:
            lines.append(f"- On the front of {MEANING.get(quantity, quantity)}: {'; '.join(rivals)}.")
    for quantity in quantities:
        better = [(r, o) for r in rows for o in rows
                  if r["whose"] == "rival" and o["method"] == "condensed" and (o["element"], o["n"]) == (r["element"], r["n"])
                  and r[quantity] < 0.8 * o[quantity]]
        if better:
            lines.append(f"- {MEANING.get(quantity, quantity)} with a smaller error than the condensed matrix on the same mesh: "
                         + "; ".join(f"{run_name(r)} ({100 * r[quantity]:.2g} against {100 * o[quantity]:.2g} %)" for r, o in better)
                         + ".")
    return lines or ["- Nowhere in this run."]


def report(scene, rows, quantities):
    lines = [f"## {scene}: for this error use this", "", *table(rows, quantities), "",
             f"## {scene}: the same forms, one load step", "", *same_forms(rows), "",
             f"## {scene}: where a rival is better", "", *better_rivals(rows, quantities), ""]
    for quantity in quantities:
        names = "; ".join(f"{run_name(r)} ({r['seconds']:.2f} s, {100 * r[quantity]:.2g} %)" for r in front(rows, quantity))
        lines.append(f"Front of {MEANING.get(quantity, quantity)}: {names}.")
    return "\n".join(lines) + "\n"


def matrices(rows):
    lines = ["", "## Matrices", "", "| Method | Element, n | Size | Condition number | after scaling | Asymmetry | "
             "Zeros on the diagonal | Negative eigenvalues |", "|---|---|---|---|---|---|---|---|"]
    for r in rows:
        name = r["method"] if r["factor"] == "" else f"penalty, factor {r['factor']}"
        lines.append(f"| {name} | {r['element']}, {r['n']} | {r['size']} | {r['condition']:.1e} | {r['condition_scaled']:.1e} | "
                     f"{r['asymmetry']:.0e} | {r['zero_diagonal']} | {r['negative']} |")
    return "\n".join(lines) + "\n"
