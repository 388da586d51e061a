"""The pictures of -draw in a study's folder: sweep.png; cost.png, error against CPU seconds, where an option of mesh, steps or solver
is varied and results with expected values change (plotting/cost.py). A panel for each result asked for (names with commas, or with
semicolons where a name has a comma) against the first varied option, a line for each combination of the others.
"""
import os
import re
import sys

from gather import asked_columns

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
try:
    import numpy as np
    from plotting.cost import cost_figure, results_of
    from plotting.curves import COLORS, DASHES
    from plotting.figure import apply_style, new_figure, save, say_empty
except ImportError as error:
    sys.exit(f"burnish sweep: {error}; the Debian packages python3-matplotlib and python3-numpy are needed")

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


def draw_asked(study, columns, rows):
    """Draws what -draw names and prints the paths. @returns the exit status"""
    good = [(name, row) for name, row in zip(study.variants, rows) if row["status"] == "finished"]
    if not good:
        print("burnish sweep: nothing to draw, no variant finished", file=sys.stderr)
        return 1
    asked = asked_columns(study)
    shown = [{n: "" if row.get(n) is None else str(row.get(n, "")) for n in columns} for _, row in good]
    sweep = {"case": study.request.name, "parameters": study.parameters, "variants": [{"folder": study.place_of(n)} for n, _ in good]}
    apply_style()
    print(save(figure_of(sweep, shown, asked, units_of(sweep)), study.folder, "sweep"))
    numerical = any(NUMERICAL.search(p["meaning"]) for p in study.parameters)
    figure = cost_figure(sweep, shown, asked) if numerical else None
    if figure is not None:
        print(save(figure, study.folder, "cost"))
    return 0
