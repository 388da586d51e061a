"""Maps of a nodal field on the deformed workpiece with the tools: one picture, or a row of instants."""
from collections import namedtuple

import numpy as np
from matplotlib.cm import get_cmap
from matplotlib.colors import ListedColormap
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

from plotting import contact, maps, tools
from plotting.figure import key_under_labels, new_figure, say_empty
from plotting.units import amount, in_powers, power_of_ten, with_unit

# name in the .vtu, label, color map, whether it is measured in units of stress
Quantity = namedtuple("Quantity", "name label colors stress")
STRESS = Quantity("stress_eq", "von Mises stress", "viridis_r", True)
STRAIN = Quantity("plastic_strain_eq", "accumulated plastic strain", "magma_r", False)
ELASTIC = 1e-3  # of the first level of the plastic strain: what is below keeps the color of the workpiece
BODY = "#f4f1ea"  # the workpiece below the first level
MOST_LEVELS = 16
ERROR = Quantity("stress_error", "estimated stress error", "cividis_r", True)


def unit_of(run, quantity, field=None):
    """Unit in the pictures, factor from the file's numbers to it. field: that at the end unless given"""
    if quantity.stress:
        return run.units.stress_unit, run.units.stress
    exponent = power_of_ten(np.nanmax((field or run.field).data[quantity.name], initial=0.0), 1e-3)
    return in_powers(exponent, "-"), 10.0**-exponent


def axis_label(quantity, unit):
    """Name and unit, "-" left out."""
    return with_unit(quantity.label, "" if unit == "-" else unit)


def levels_to(largest, number=14, quantity=STRESS):
    """Round levels from zero to the largest value, of the plastic strain from just above zero; None if that is zero."""
    if not largest > 0:
        return None
    levels = MaxNLocator(number, steps=[1, 2, 2.5, 5, 10]).tick_values(0, largest)
    return np.r_[ELASTIC * levels[1], levels[1:]] if quantity is STRAIN else levels


def band_colors(quantity, levels):
    """Color map with one color for each band, that which draw_map gives it."""
    colors, middles = get_cmap(quantity.colors), 0.5 * (levels[1:] + levels[:-1])
    return ListedColormap([colors(part) for part in (middles - levels[0]) / (levels[-1] - levels[0])])


def reflected(mesh, sign):
    return Triangulation(sign[0] * mesh.x, sign[1] * mesh.y, mesh.triangles, mesh.mask)


def fill(axes, mesh, values, levels, cmap):
    """Bands over the color of the workpiece; levels: None for that alone. Returns the bands or None."""
    if levels is None or levels[0] > 0:
        axes.tricontourf(mesh, np.zeros(len(mesh.x)), levels=[-1, 1], colors=[BODY], zorder=0.9)
    return None if levels is None else maps.draw_bands(axes, mesh, np.maximum(values, 0), levels, cmap)


def draw_mirrored(axes, mesh, values, levels, outlines, cmap, mirrors, edge=1.0):
    """The parts that symmetry leaves out: bands, outlines, tools; no mesh. Returns the handles for the key."""
    for sign in mirrors:
        other = reflected(mesh, sign)
        fill(axes, other, values, levels, cmap)
        maps.draw_outline(axes, other, edge)
        tools.draw_tools(axes, [o._replace(points=o.points * sign) for o in outlines], other, mirrors=mirrors)
    return maps.draw_symmetry(axes, mirrors, "symmetry; the mesh is what was computed")


def draw_map(axes, mesh, values, levels, outlines, box, cmap, unit="mm", mirrors=(), edge=1.0):
    """Filled bands, outline of the workpiece, tools; levels: None for no bands; unit: of length; mirrors: Run.mirrors;
    edge: width of the outline. Returns (bands or None, handles)."""
    maps.set_view(axes, box, unit)
    axes.grid(False)
    bands = fill(axes, mesh, values, levels, cmap)
    axes.triplot(mesh, color="black", linewidth=0.2, alpha=min(0.35, 400 / len(mesh.triangles)), zorder=1.5)
    maps.draw_outline(axes, mesh, edge)
    handles = tools.draw_tools(axes, outlines, mesh, mirrors=mirrors)
    if mirrors:
        handles += draw_mirrored(axes, mesh, values, levels, outlines, cmap, mirrors, edge)
    return bands, handles


def add_scale(figure, bands, axes, label, shrink=0.9):
    """Color bar with a tick at every level or at every second one."""
    first = 0 if bands.levels[0] == 0 else 1  # of the plastic strain that just above zero is no number to read
    ticks = bands.levels[first:: 1 if len(bands.levels) <= 9 else 2]
    label += "\nlight: elastic" if first else ""
    figure.colorbar(bands, ax=axes, label=label, shrink=shrink, format="%.4g", ticks=ticks)


def mesh_box(mesh, mirrors=()):
    x = np.concatenate([mesh.x, *(sign[0] * mesh.x for sign in mirrors)])
    y = np.concatenate([mesh.y, *(sign[1] * mesh.y for sign in mirrors)])
    return maps.box_of(x, y, 0.03)


def view_of(run, mesh, outlines, part=0.3):
    """Limits that show the whole workpiece and the tools near it."""
    mirrored = [o._replace(points=o.points * sign) for o in outlines for sign in run.mirrors]
    return tools.widened(mesh_box(mesh, run.mirrors), outlines + mirrored, part)


def shape_of(box, width):
    """Height of a figure of this width for the box, with room for the labels."""
    return float(np.clip((width - 2.6) * (box[3] - box[2]) / (box[1] - box[0]) + 1.4, 3.2, 9.5))


def at_time(run):
    return "" if run.t is None else f" at t = {run.t:.4g}"


def field_figure(run, quantity, box=None, width=8.5):
    """One field at the end; quantity: STRESS, STRAIN or the like. box: limits, default the workpiece and the tools near
    it."""
    unit, factor = unit_of(run, quantity)
    label, values = quantity.label, factor * np.nan_to_num(run.field.data[quantity.name])
    if quantity is ERROR:      # an estimate beyond the stress says no more than that
        values = np.minimum(values, factor * np.nan_to_num(run.field.data[STRESS.name]))
    outlines = tools.at_time(run.tools, run.t)
    box = box or view_of(run, run.mesh, outlines)
    figure, axes = new_figure(width, shape_of(box, width))
    levels = levels_to(values.max(), MOST_LEVELS, quantity)
    bands, handles = draw_map(axes, run.mesh, values, levels, outlines, box, quantity.colors, run.units.length_unit, run.mirrors)
    if run.has("surface.csv"):
        handles.append(contact.mark_contact(axes, run.surface, letters="", scale=run.units.length))
        for sx, sy in run.mirrors:
            other = {**run.surface, "x": sx * run.surface["x"], "y": sy * run.surface["y"]}
            contact.mark_contact(axes, other, letters="", scale=run.units.length)
    if bands is None:
        say_empty(axes, f"no {label}")
    else:
        add_scale(figure, bands, axes, f"{label} [{unit}]")
    axes.set_title(f"{label[0].upper() + label[1:]}{at_time(run)}, largest at a node {amount(values.max(), unit)}")
    if handles:
        key_under_labels(axes, handles, min(3, len(handles)))
    return figure


def instants(run, number):
    """Field files of the series nearest to equal intervals of t, and the end: (t, field) pairs."""
    if run.t is None:
        return [(t, run.read_field(path)) for t, path in run.series[-number:]]
    before = [(t, path) for t, path in run.series if t < run.t * (1 - 1e-9)]
    wanted = run.t * np.arange(1, number) / number
    chosen = dict(min(before, key=lambda pair: abs(pair[0] - t)) for t in wanted) if before else {}
    return [(t, run.read_field(path)) for t, path in sorted(chosen.items())] + [(run.t, run.field)]


def sequence_figure(run, quantity, number=4, width=10.0):
    """The same field at several instants with one scale."""
    unit, factor = unit_of(run, quantity)
    shown = [(t, maps.deformed(f, run.units.length), factor * np.nan_to_num(f.data[quantity.name]))
             for t, f in instants(run, number)]
    outlines = [tools.at_time(run.tools, t) for t, _, _ in shown]
    boxes = np.array([view_of(run, mesh, o, 0.2) for (_, mesh, _), o in zip(shown, outlines)])
    box = (boxes[:, 0].min(), boxes[:, 1].max(), boxes[:, 2].min(), boxes[:, 3].max())
    columns = 2 if len(shown) > 2 else len(shown)
    rows = -(-len(shown) // columns)
    height = rows * ((width - 2.4) / columns * (box[3] - box[2]) / (box[1] - box[0]) + 0.4) + 0.6
    figure, panels = new_figure(width, float(np.clip(height, 3.5, 12)), nrows=rows, ncols=columns, squeeze=False,
                                sharex=True, sharey=True)
    levels = levels_to(max(values.max() for _, _, values in shown), MOST_LEVELS, quantity)
    bands = None
    for axes, (t, mesh, values), drawn in zip(panels.flat, shown, outlines):
        mine, _ = draw_map(axes, mesh, values, levels, drawn, box, quantity.colors, run.units.length_unit,
                           run.mirrors, edge=0.6)
        bands = mine or bands
        axes.set_title(f"t = {t:.3g}")
        axes.locator_params(axis="x", nbins=6)
        axes.label_outer()
    for axes in list(panels.flat)[len(shown):]:
        axes.set_visible(False)
    if bands is not None:
        add_scale(figure, bands, list(panels.flat), f"{quantity.label} [{unit}]")
    return figure
