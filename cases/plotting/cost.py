"""Accuracy against time: the error of each result that has an expected value over the CPU seconds of the run.

For sweeps (cases/sweep/plot.py): a curve joins the variants of the first varied option, usually the mesh, whose values
stand beside the points; one curve for each combination of the other options. Both axes are logarithmic.
"""
import json
import os

import numpy as np

from plotting.curves import COLORS
from plotting.figure import new_figure
from plotting.labels import log_ticks, place_labels

MOST = 6  # panels
MARKERS = "os^vD<>P*X"


def results_of(sweep):
    """Results of the variants that have some: [{name: {"value":, "unit":, "expected":}}]."""
    found = []
    for variant in sweep["variants"]:
        try:
            with open(os.path.join(variant["folder"], "summary.json"), encoding="utf-8") as file:
                found.append(json.load(file).get("results") or {})
        except (OSError, ValueError):
            continue
    return found


def expected_values(sweep):
    """{result: (value expected, unit)} of the first variant that has results."""
    for results in results_of(sweep):
        return {name: (r["expected"], r.get("unit") or "-") for name, r in results.items() if r.get("expected") is not None}
    return {}


def numbers(rows, column):
    """Column as numbers, nan where there is none."""
    return np.array([float(r.get(column) or "nan") for r in rows])


def quantities(sweep, rows, asked):
    """(result, unit of its error: % if it is relative) of what can be drawn: asked for, or all whose error changes."""
    chosen = []
    for name, (value, unit) in expected_values(sweep).items():
        error = numbers(rows, name + "_error")
        known = error[np.isfinite(error) & (error > 0)]
        if (name in asked) if asked else (len(known) > 1 and known.max() > 1.5 * known.min()):
            chosen.append((name, "%" if value else unit))
    return chosen[:MOST]


def draw_panel(axes, rows, name, unit, names):
    """Curves of one result; returns the labels of its points."""
    factor, labels = 100 if unit == "%" else 1, []
    groups = list(dict.fromkeys(tuple(r[n] for n in names[1:]) for r in rows))
    for i, group in enumerate(groups):
        mine = [r for r in rows if tuple(r[n] for n in names[1:]) == group]
        seconds, error = numbers(mine, "cpu_seconds"), factor * numbers(mine, name + "_error")
        color = COLORS[i % len(COLORS)]
        axes.loglog(seconds, error, color=color, marker=MARKERS[i % len(MARKERS)], markersize=5,
                    label=", ".join(f"{n} {v}" for n, v in zip(names[1:], group)) or None)
        labels += [(x, y, row[names[0]], color) for row, x, y in zip(mine, seconds, error) if np.isfinite(x) and y > 0]
    axes.margins(0.1)
    axes.autoscale_view()
    for axis in (axes.xaxis, axes.yaxis):
        log_ticks(axis)
    axes.set_xlabel("CPU seconds of the run")
    axes.set_ylabel(f"error [{unit}]")
    axes.set_title(name, fontsize=11)
    return labels


def cost_figure(sweep, rows, asked=()):
    """None if no result with an expected value changes; asked: names of results, default all of those."""
    rows = [row for row in rows if np.isfinite(numbers([row], "cpu_seconds")[0])]
    drawn, names = quantities(sweep, rows, asked), [p["name"] for p in sweep["parameters"]]
    if not drawn or len(rows) < 2:
        return None
    columns = min(len(drawn), 2 if len(drawn) == 4 else 3)
    lines = -(-len(drawn) // columns)
    width = {1: 6.4, 2: 4.8, 3: 4.0}[columns] * columns + 0.6
    figure, panels = new_figure(width, 3.6 * lines + 0.6, nrows=lines, ncols=columns, squeeze=False)
    beside = [(axes, draw_panel(axes, rows, name, unit, names)) for axes, (name, unit) in zip(panels.flat, drawn)]
    for axes in list(panels.flat)[len(drawn):]:
        axes.set_visible(False)
    handles, labels = panels.flat[0].get_legend_handles_labels()
    if handles:
        figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=min(len(handles), 2 * columns))
    meaning = sweep["parameters"][0]["meaning"].split(";")[0].split(":")[0]
    figure.suptitle(f"{sweep['case']}: error against time; beside the points {names[0]}"
                    + (f" ({meaning})" if meaning else ""), fontsize=12)
    figure.draw_without_rendering()  # places of the panels
    for axes, mine in beside:
        place_labels(axes, mine)
    return figure
