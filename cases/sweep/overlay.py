"""The histories of all variants of a sweep, each column a panel, each variant a curve: out/sweep/CASE/histories.png."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from plotting import units
from plotting.curves import COLORS
from plotting.figure import new_figure
from plotting.inputs import InputError
from plotting.run import Run

MOST = 6          # panels
KEYED = 8         # variants up to which each has a color of its own
APART = 5e-3      # at the end, over the largest value: what less may be is the tolerance
LINES = ("-", "--", ":", "-.")
KINDS = (units.LENGTH, units.ANGLE, units.FORCE, units.MOMENT, units.STRAIN, units.OTHER)


def histories(rows, folders):
    """[(row, Run)] of the variants whose history can be read."""
    found = []
    for row, folder in zip(rows, folders):
        run = Run(folder)
        try:
            if len(run.history.get("t", ())) > 1:
                found.append((row, run))
        except InputError:
            continue
    return found


def curve(run, name):
    """A column in the units of the picture; of a coordinate its change."""
    column, values = run.columns[name], run.history[name]
    return column.factor * (values - values[0] if column.kind in (units.LENGTH, units.ANGLE) else values)


def spread(runs, name):
    """How far the variants are apart at the end, over the largest value."""
    ends = [curve(run, name)[-1] for run in runs]
    largest = max(np.nanmax(np.abs(curve(run, name)), initial=0) for run in runs)
    return (np.nanmax(ends) - np.nanmin(ends)) / largest if largest > 0 and np.isfinite(ends).any() else 0


def chosen_columns(runs):
    """Names of the columns of all runs that tell variants apart, coordinates and forces of the drives first."""
    common = [n for n in runs[0].columns if all(n in run.columns for run in runs)]
    apart = [n for n in common if runs[0].columns[n].kind in KINDS and not n.endswith(("_Fx", "_Fy", "_Mz"))
             and n != "factorizations" and spread(runs, n) > APART]
    return sorted(apart, key=lambda n: KINDS.index(runs[0].columns[n].kind) == KINDS.index(units.OTHER))[:MOST]


def colors_of(rows, first):
    """(color of each row, mappable or None): by variant, or by the first parameter where there are many."""
    if len(rows) <= KEYED:
        return [COLORS[i % len(COLORS)] for i in range(len(rows))], None
    values = list(dict.fromkeys(r[first] for r in rows))
    try:
        numbers = [float(r[first]) for r in rows]
    except ValueError:
        numbers = [values.index(r[first]) for r in rows]
    scale = ScalarMappable(Normalize(min(numbers), max(numbers)), colormaps["viridis"])
    return [scale.to_rgba(n) for n in numbers], scale


def label_of(row, names):
    return ", ".join(f"{n} = {row[n]}" for n in names)


def overlay_figure(sweep, rows, folders):
    """None if no history tells the variants apart. rows of sweep.csv, folders of their runs."""
    found = histories(rows, folders)
    names = [p["name"] for p in sweep["parameters"]]
    shown = chosen_columns([run for _, run in found]) if len(found) > 1 else []
    if not shown:
        return None
    columns = min(len(shown), 2 if len(shown) < 5 else 3)
    lines = -(-len(shown) // columns)
    figure, panels = new_figure(4.4 * columns + 0.6, 2.9 * lines + 0.8, nrows=lines, ncols=columns, squeeze=False)
    colors, scale = colors_of([row for row, _ in found], names[0])
    others = list(dict.fromkeys(label_of(row, names[1:]) for row, _ in found))
    for axes, name in zip(panels.flat, shown):
        for (row, run), color in zip(found, colors):
            line = LINES[others.index(label_of(row, names[1:])) % len(LINES)] if scale else "-"
            axes.plot(run.history["t"], curve(run, name), line, color=color, linewidth=1.2, label=label_of(row, names))
        axes.set_xlabel("load parameter t")
        column = found[0][1].columns[name]
        axes.set_ylabel(("change of " if column.kind in (units.LENGTH, units.ANGLE) else "") + column.axis())
    for axes in list(panels.flat)[len(shown):]:
        axes.set_visible(False)
    if scale is None:
        handles, labels = panels.flat[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=min(len(found), 2 * columns))
    else:
        unit = sweep["parameters"][0]["unit"]
        if 1 < len(others) <= len(LINES):
            figure.legend([Line2D([], [], color="black", linestyle=line) for line in LINES[:len(others)]], others,
                          loc="upper center", bbox_to_anchor=(0.5, 0), ncol=len(others))
        figure.colorbar(scale, ax=panels, label=units.with_unit(names[0], unit if unit != "-" else ""), shrink=0.8)
    figure.suptitle(f"{sweep['case']}: histories of {len(found)} variants")
    return figure
