"""Curves of a run: history, chosen columns against one another, pressure under each tool, computed against expected."""
import numpy as np
from matplotlib.ticker import MaxNLocator

from plotting import contact, drives
from plotting import units as u
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, PURPLE, RED, SKY, key_under_labels, new_figure, say_empty

COLORS = (BLUE, RED, GREEN, ORANGE, PURPLE, SKY, "black", GRAY)
DASHES = ("-", (0, (4, 1.5)), (0, (1.2, 1.2)), (0, (5, 1.2, 1.2, 1.2)))
PANELS = ((u.LENGTH, "displacement of the tools"), (u.ANGLE, "turn of the tools"), (u.FORCE, "drive force"),
          (u.MOMENT, "drive moment"), (u.NODES, "nodes"), (u.STRAIN, "largest plastic strain"),
          (u.STRESS, "largest von Mises stress"))


def moves(values):
    values = values[np.isfinite(values)]
    return len(values) > 0 and np.ptp(values) > 1e-12 * max(np.abs(values).max(), 1e-300)


def values_of(run, column, change=False):
    """Column in the unit of the pictures; change: from its first value."""
    return run.columns[column].factor * (run.history[column] - (run.history[column][0] if change else 0))


def power_of_panel(run, columns, change):
    """Exponent of the power of ten before the unit, for numbers that would be long on an axis."""
    values = np.concatenate([values_of(run, name, change) for name in columns])
    return u.power_of_ten(np.nanmax(np.abs(values), initial=0.0), 1e-3, 1e5)


def draw_column(axes, run, column, against, style, change=False, exponent=0):
    """One column over another one. style: color and dashes."""
    y, values = run.columns[column], values_of(run, column, change)
    how = "steps-mid" if y.kind == u.NODES else "default"
    axes.plot(values_of(run, against), values * 10.0**-exponent, color=style[0], linestyle=style[1], label=y.label, drawstyle=how,
              linewidth=1.0 if y.kind == u.NODES else 1.5)


OF_STATES = {**{name: color for name, color, _ in contact.STATES.values()}, "in contact": "black"}


def styles(labels):
    """Color and dashes of each curve: of several tools, "die: x", a color each, and dashes for the coordinate; of a state of nodes that which it
    has everywhere."""
    free = [c for c in COLORS if c not in OF_STATES.values() or not OF_STATES.keys() & set(labels)]
    tools = list(dict.fromkeys(label.split(": ")[0] for label in labels if ": " in label))
    if len(tools) < 2:
        return [(OF_STATES.get(label, free[k % len(free)]), "-") for k, label in enumerate(labels)]
    others = iter((free[len(tools):] or free) * len(labels))
    parts = list(dict.fromkeys(label.split(": ")[1] for label in labels if ": " in label))
    return [(free[tools.index(label.split(": ")[0]) % len(free)], DASHES[parts.index(label.split(": ")[1]) % len(DASHES)])
            if ": " in label else (OF_STATES.get(label) or next(others), "-") for label in labels]


def letters(text):
    """About how many letters wide a text is drawn."""
    return len(text) - sum(text.count(c) for c in "${}_^\\")


def label_panel(axes, run, columns, title, change, exponent):
    """What is drawn and its unit above the panel; a key beside it if there are several curves."""
    first, labels = run.columns[columns[0]], [run.columns[name].label for name in columns]
    if len(columns) == 1:
        title = ("change of " if change else "") + (f"{title} " if first.label.startswith("$") else "") + first.label
    title = u.with_unit(title, u.in_powers(exponent, first.unit))
    longest = max(letters(label) for label in labels)
    beside = 1.2 * letters(title) + len(labels) * (6 + longest) < 68 and len(labels) < 3
    across = len(labels) if beside else int(np.clip(68 // (6 + longest), 1, min(3, len(labels))))
    lines = 0 if beside or len(labels) == 1 else -(-len(labels) // across)  # of the key, under the title
    rise = 12 if any("$" in label for label in labels) else 10  # of a line, formulas are higher [points]
    axes.set_title(title, loc="left", fontsize=10, pad=6 + rise * lines)
    if len(columns) > 1:
        where = {"loc": "lower right", "bbox_to_anchor": (1.01, 0.97)}
        if not beside:
            where = {"loc": "lower left", "bbox_to_anchor": (-0.02, 0.97)}
        axes.legend(fontsize=8, ncol=across, frameon=False, borderpad=0.3, labelspacing=0.2,
                    handlelength=1.8, columnspacing=0.8, handletextpad=0.4, **where)
    if first.kind == u.NODES:
        axes.yaxis.set_major_locator(MaxNLocator(integer=True))


APART, MOST = 20.0, 4            # of curves in a panel: their sizes, their number
NOTHING = 1e-3                   # over the largest of its panel, below which a curve is zero
LEFT = 1e-2                      # reaction over what is out of balance under a force, from which it is one
WITHOUT_MEANING = ("x", "angle")  # in axisymmetry a drive force along r or about the axis has no meaning
RESULTANTS = ("_Fx", "_Fy", "_Fz", "_Mx", "_My", "_Mz")  # of supports and tools: the forces of the drives show the same


def out_of_balance(run):
    """Columns of the drives whose prescribed force is zero, or whose reaction is by symmetry: what they show is what is left of the equilibrium."""
    driven = {name: drive for name, drive in drives.given(run).items() if "Q_" + name in run.history}
    loads = {name: drives.load_of({**drive, "force": np.nanmax(np.abs(run.history["Q_" + name]))}, run.size()) for name, drive in driven.items()}
    most = drives.NOISE * max(loads.values(), default=0)
    return {"Q_" + name for name, load in loads.items() if load <= (most if driven[name]["kind"] == "force" else LEFT * most)}


def default_panels(run):
    """(title, columns, change) of the panels with something to show; a column of the case has a panel of its own."""
    panels, without = [], out_of_balance(run)
    for kind, title in PANELS:
        names = [n for n, c in run.columns.items() if c.kind == kind and moves(run.history[n]) and n not in without
                 and not (run.axisymmetric and n.startswith("Q_") and n[2:].split(".")[-1] in WITHOUT_MEANING)]
        change = kind in (u.LENGTH, u.ANGLE)
        sizes = [np.nanmax(np.abs(values_of(run, n, change)), initial=0.0) for n in names]
        names = [n for n, size in zip(names, sizes) if size > NOTHING * max(sizes)]
        if names:
            panels.append((title, names, change))
    own = [n for n, c in run.columns.items() if c.kind == u.OTHER and n != "factorizations"
           and not n.endswith(RESULTANTS) and moves(run.history[n])]
    return panels + [(run.columns[names[0]].label if len(names) == 1 else "quantities of the script", names, False) for names in grouped(run, own)]


def grouped(run, names):
    """Columns of one unit and of about the same size, at most MOST together; each of the others alone."""
    groups = []
    for name in names:
        unit, size = run.columns[name].unit, np.nanmax(np.abs(values_of(run, name)), initial=0.0)
        near = [g for g in groups if unit not in ("", "-") and g[0] == unit and 1 / APART < size / g[1] < APART and len(g[2]) < MOST]
        if near:
            near[0][2].append(name)
        else:
            groups.append((unit, size, [name]))
    return [group for _, _, group in groups]


def history_figure(run, panels=None, against="t"):
    """Chosen columns against t or another one. panels: a list of lists of columns, default: all that change, by
    kind; None if nothing changes."""
    chosen = default_panels(run) if panels is None else [("", list(p), False) for p in panels]
    if not chosen:
        return None
    rows = max(1, -(-len(chosen) // 2))
    columns = 2 if len(chosen) > 1 else 1
    figure, axes = new_figure(5.2 * columns, 0.8 + 2.1 * rows, nrows=rows, ncols=columns, squeeze=False, sharex=True)
    for place, (title, names, change) in zip(axes.flat, chosen):
        exponent = power_of_panel(run, names, change)
        for name, style in zip(names, styles([run.columns[n].label for n in names])):
            draw_column(place, run, name, against, style, change, exponent)
        units = {run.columns[n].unit for n in names}
        title = title or " / ".join(sorted(units)) if len(units) > 1 else title
        label_panel(place, run, names, title, change, exponent)
    for place in list(axes.flat)[len(chosen):]:
        place.set_visible(False)
    for place in list(axes.flat)[max(0, len(chosen) - columns):len(chosen)]:
        place.set_xlabel(run.columns[against].axis())
        place.tick_params(labelbottom=True)
    return figure


def under_tool(run, name):
    """Arc from the middle of the contact, growing with x (or y where the surface stands upright), the nodes near the
    contact of one tool, and what the arc is called; None without contact. On a level surface x is the arc. Of several
    chains the one that the tool touches most."""
    surface, scale, unit = run.surface, run.units.length, run.units.length_unit
    touching = contact.touching(surface) & (surface["tool"] == name)
    if not touching.any():
        return None
    arc, chain = contact.arcs(surface)
    mine = chain == np.bincount(chain[touching]).argmax()
    touching &= mine
    nodes = np.flatnonzero(touching)
    arc = scale * (arc - 0.5 * (arc[nodes[0]] + arc[nodes[-1]]))
    ends = nodes[[0, -1]] if len(nodes) > 1 else np.clip([nodes[0] - 1, nodes[0] + 1], 0, len(arc) - 1)
    step = np.array([np.diff(surface[c][ends])[0] for c in "xy"])
    if step[np.argmax(np.abs(step))] < 0:
        arc = -arc
    reach = 1.3 * np.abs(arc[touching]).max() + 2 * np.median(np.abs(np.diff(arc)))
    other = contact.touching(surface) & (surface["tool"] != name)
    shown = (np.abs(arc) <= reach) & mine & ~other
    x = scale * surface["x"]
    if np.ptp(x[shown]) > 0.97 * np.ptp(arc[shown]):
        return x, shown, f"x [{unit}]"
    return arc, shown, f"arc from the middle of the contact [{unit}]"


def pressure_panel(axes, run, name, mu=None, expected=None, columns=3):
    """Pressure and tangential traction under one tool; expected: (function of x or the arc in the units of the
    pictures, its label); columns: of the key."""
    found = under_tool(run, name)
    axes.set_ylabel(f"traction [{run.units.stress_unit}]")
    if found is None:
        say_empty(axes, f"{name} touches no node")
        return
    arc, shown, label = found
    axes.set_xlabel(label)
    order = np.flatnonzero(shown)[np.argsort(arc[shown])]
    for field, nodal, color, label in (("pressure", "nodal_pressure", BLUE, "pressure p"),
                                       ("traction_tangential", "nodal_traction", RED, "tangential traction")):
        values = run.units.stress * run.surface[field][order]
        if label != "pressure p" and not values.any():
            continue
        axes.plot(arc[order], values, color=color, label=label)
        if len(order) < 120:
            dots = run.units.stress * run.surface[nodal][order]
            near = (dots != 0) & (np.abs(dots) < 5 * np.abs(values).max(initial=0))    # not at an axis, where a node has next to no area
            axes.plot(arc[order][near], dots[near], color=color, marker="o", markersize=3, linestyle="none", alpha=0.5,
                      label="nodal force over tributary area" if field == "pressure" else None)
        if mu and label == "pressure p":
            for sign in (1, -1):
                axes.plot(arc[order], sign * mu * values, color=GRAY, linewidth=0.9, linestyle="--", zorder=1.5,
                          label=rf"$\pm\mu p$, $\mu$ = {mu:g}" if sign > 0 else None)
    if expected:
        x = np.linspace(arc[order[0]], arc[order[-1]], 400)
        axes.plot(x, expected[0](x), color="black", linewidth=1.2, linestyle=(0, (5, 2)), label=expected[1])
    if contact.shade_sticking(axes, arc[order], {"state": run.surface["state"][order]}):
        axes.fill([], [], color=contact.STATES[3][1], alpha=0.2, label="sticking nodes")
    axes.axhline(0, color="black", linewidth=0.8)
    handles = axes.get_legend_handles_labels()[0]
    key_under_labels(axes, handles, min(len(handles), columns))


def pressure_figure(run, mu=None, expected=None):
    """Contact pressure and friction under each tool at the end (dots: nodal forces over their tributary areas);
    None without contact."""
    touching = [o for o in dict.fromkeys(run.surface["tool"]) if o and under_tool(run, o)]
    if not touching:
        return None
    names = touching[:6]
    columns = 2 if len(names) > 1 else 1
    rows = -(-len(names) // columns)
    width = 7.5 if columns == 1 else 10.5
    figure, panels = new_figure(width, 0.9 + 3.6 * rows, nrows=rows, ncols=columns, squeeze=False)
    at_time = "" if run.t is None else f" at t = {run.t:.4g}"
    what = "Pressure and friction" if run.surface["traction_tangential"].any() else "Pressure"
    for axes, name in zip(panels.flat, names):
        pressure_panel(axes, run, name, mu, expected, 3 if columns == 1 else 2)
        axes.set_title(u.plain(name) if columns > 1 else f"{what} under {u.plain(name)}{at_time}")
    if columns > 1:
        shown = f", {len(names)} of {len(touching)} tools" if len(names) < len(touching) else ""
        figure.suptitle(f"{what}{at_time}{shown}")
    for axes in list(panels.flat)[len(names):]:
        axes.set_visible(False)
    return figure


def expected_results(summary):
    """(name, entry) of the results with an expected value."""
    results = summary.get("results") or {}
    return [(name, r) for name, r in results.items() if isinstance(r, dict) and r.get("expected") is not None]


def expected_row(name, entry):
    """Texts of a row, and whether the result is within its tolerance."""
    value, wanted, tolerance = entry["value"], entry["expected"], entry["tolerance"]
    if value is None:
        return [name, "nan", f"{wanted:.5g}", entry["unit"].strip("-"), "", "", entry["source"]], False
    value, error = value + 0.0, (value - wanted) / (abs(wanted) or 1) + 0.0     # not -0
    percent = (lambda number: f"{100 * number:.3g} %") if wanted else (lambda number: f"{number:.3g}")
    texts = [name, f"{value:.5g}", f"{wanted:.5g}", entry["unit"].strip("-"), percent(error), percent(tolerance), entry["source"]]
    return texts, abs(error) <= tolerance


def made_by(summary):
    """What the run was, as far as the summary says it."""
    options, mesh, counts = (summary.get(name) or {} for name in ("options", "mesh", "counts"))
    known = [str(options.get("element", "")), f"{mesh['nodes']} nodes" if "nodes" in mesh else "",
             f"{counts['steps']} steps" if "steps" in counts else ""]
    return "Made with " + ", ".join(word for word in known if word)


def expected_figure(run):
    """Each result beside what is expected of it, a table; None if nothing is expected."""
    rows = [expected_row(name.strip(), entry) for name, entry in expected_results(run.summary)]
    if not rows:
        return None
    heads = ("", "computed", "expected", "unit", "error", "allowed", "source")
    texts = [list(map(u.plain, row)) for row, _ in rows]
    wide = [max(len(row[k]) for row in (heads, *texts)) + 2 for k in range(len(heads))]
    lines = 0.33 * (len(rows) + 1)
    high = max(1.8, lines + 0.35)
    figure, axes = new_figure(max(6.0, 0.095 * sum(wide)), high + 0.4)
    axes.axis("off")
    table = axes.table(texts, colLabels=heads, colWidths=[w / sum(wide) for w in wide], bbox=(0, 1 - lines / high, 1, lines / high), cellLoc="right")
    table.auto_set_font_size(False)
    table.set_fontsize(11)
    for (line, column), cell in table.get_celld().items():
        cell.set_edgecolor("#bbbbbb")
        if column in (0, len(heads) - 1):
            cell.set_text_props(ha="left")
        if line == 0:
            cell.set_facecolor("#eeeeee")
        elif column == 4:
            cell.set_facecolor("#b3d6f0" if rows[line - 1][1] else "#f3ae94")
    axes.set_title("Computed against expected; blue: within what is allowed, red: not")
    axes.text(0, 0, made_by(run.summary), transform=axes.transAxes, color=GRAY, fontsize=9, va="bottom")
    return figure
