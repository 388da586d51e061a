"""The pictures of a sweep in out/sweep/CASE: sweep.png from sweep.csv; histories.png (overlay.py); cost.png, error against
CPU seconds, where an option of mesh, steps or solver is varied and results with expected values change (plotting/cost.py);
and index.html (table.py). A panel for each quantity of RESULT (names with commas, or with
semicolons where a name has a comma; default: the results of the case that change, else forces of the drives) against
the first varied option, a line for each combination of the others. Exit status 1 if a quantity of RESULT is not there.
"""
import csv
import json
import os
import re
import sys

from grid import case_name

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
try:
    import numpy as np
    from plotting.cost import cost_figure, results_of
    from plotting.curves import COLORS, DASHES
    from plotting.figure import apply_style, new_figure, save, say_empty

    from overlay import overlay_figure
    from table import write_table
except ImportError as error:
    sys.exit(f"sweep: {error}; the Debian packages python3-matplotlib and python3-numpy are needed")

MOST = 9  # panels
MARKERS = "os^vD<>P*X"
# meanings of options that change the error, not the problem
NUMERICAL = re.compile(r"\b(elements?|divisions?|mesh|steps?|tolerance|accuracy|spacing|scheme|P1 or P2|nodes?|solver)\b")


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return np.nan


def units_of(sweep):
    """Units of the results, from any summary."""
    units = {}
    for results in results_of(sweep):
        units.update({name: entry.get("unit", "") for name, entry in results.items()})
    return units


def changes(values):
    """By more than what the tolerance of the residual leaves."""
    known = [v for v in values if np.isfinite(v)]
    return bool(known) and max(known) - min(known) > 1e-3 * max(map(abs, known))


def asked_for():
    """Names in RESULT, separated by commas, or by semicolons where a name has a comma."""
    text = os.environ.get("RESULT", "")
    return [name.strip() for name in text.split(";" if ";" in text else ",") if name.strip()]


def chosen(columns, units, parameters, rows):
    """Quantities to draw."""
    asked = asked_for()
    known = [c for c in columns if c not in parameters and c not in ("status", "t")]
    missing = [name for name in asked if name not in known]
    if missing:
        raise LookupError(f"RESULT: no quantity {', '.join(missing)}; there are: {', '.join(known)}")
    varies = [c for c in known if len(rows) == 1 or changes([number(r[c]) for r in rows])]
    return asked or ([c for c in varies if c in units] or [c for c in varies if c.startswith("Q_")] or varies)[:MOST]


def axis(name, unit):
    return f"{name} [{unit}]" if unit and unit != "-" else name


def draw_panel(axes, rows, quantity, names, values):
    """Lines against the first parameter; values: its values as texts in order."""
    numeric = all(np.isfinite(number(v)) for v in values)
    groups = list(dict.fromkeys(tuple(r[n] for n in names[1:]) for r in rows))
    for i, group in enumerate(groups):
        mine = [r for r in rows if tuple(r[n] for n in names[1:]) == group]
        x = [number(r[names[0]]) if numeric else values.index(r[names[0]]) for r in mine]
        y = np.array([number(r[quantity]) for r in mine])
        order = np.argsort(x)
        label = ", ".join(f"{n} = {v}" for n, v in zip(names[1:], group))
        axes.plot(np.array(x)[order], y[order], color=COLORS[i % len(COLORS)], marker=MARKERS[i % len(MARKERS)],
                  linestyle=DASHES[i % len(DASHES)], linewidth=1.5, markersize=5, label=label or None)
    if not any(np.isfinite(number(r[quantity])) for r in rows):
        say_empty(axes, "no value")
    if not numeric:
        axes.set_xticks(range(len(values)), values)
    return groups


def figure_of(sweep, rows, quantities, units):
    names = [p["name"] for p in sweep["parameters"]]
    first = sweep["parameters"][0]
    values = list(dict.fromkeys(r[names[0]] for r in rows))
    columns = min(len(quantities), 3 if len(quantities) > 4 else 2)
    lines = -(-len(quantities) // columns)
    figure, panels = new_figure(4.6 * columns + 0.6, 3.3 * lines + 0.8, nrows=lines, ncols=columns, squeeze=False)
    groups = []
    for axes, quantity in zip(panels.flat, quantities):
        groups = draw_panel(axes, rows, quantity, names, values)
        axes.set_xlabel(axis(first["name"], first["unit"]))
        axes.set_ylabel(axis(quantity, units.get(quantity, "")))
    for axes in list(panels.flat)[len(quantities):]:
        axes.set_visible(False)
    if names[1:]:
        handles, labels = panels.flat[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=min(len(groups), 2 * columns))
    meaning = f" ({first['meaning']})" if first["meaning"] else ""
    figure.suptitle(f"{sweep['case']}: {len(rows)} variants, against {first['name']}{meaning}")
    return figure


def draw(sweep, rows, columns, top):
    """Prints the paths of the pictures. @returns the exit status"""
    good = [row for row in rows if row["status"] == "finished"]
    if not good:
        print("sweep: nothing to draw, no variant finished", file=sys.stderr)
        return 1
    units = units_of(sweep)
    try:
        quantities = chosen(columns, units, [p["name"] for p in sweep["parameters"]], good)
    except LookupError as error:
        print(f"sweep: {error.args[0]}", file=sys.stderr)
        return 1
    apply_style()
    if quantities:
        print(save(figure_of(sweep, good, quantities, units), top, "sweep"))
    else:
        print("sweep: nothing to draw, no number changes from variant to variant", file=sys.stderr)
    folders = [v["folder"] for v, row in zip(sweep["variants"], rows) if row["status"] == "finished"]
    numerical = any(NUMERICAL.search(p["meaning"]) for p in sweep["parameters"])
    for name, figure in (("histories", overlay_figure(sweep, good, folders)),
                         ("cost", cost_figure(sweep, good, asked_for()) if numerical else None)):
        if figure is not None:
            print(save(figure, top, name))
    return 0


def main():
    top = f"out/sweep/{case_name()}"
    with open(f"{top}/sweep.json", encoding="utf-8") as file:
        sweep = json.load(file)
    with open(f"{top}/sweep.csv", encoding="utf-8", newline="") as file:
        reader = csv.DictReader(file)
        rows, columns = list(reader), reader.fieldnames
    for name in ("sweep", "histories", "cost"):  # of another sweep
        if os.path.exists(f"{top}/{name}.png"):
            os.remove(f"{top}/{name}.png")
    status = draw(sweep, rows, columns, top)
    print(write_table(sweep, rows, columns, top))
    return status


if __name__ == "__main__":
    sys.exit(main())
