"""Maps of a run in space in a plane: the contact surface seen along its normal, sections through the contact."""
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.tri import Triangulation
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersGeneral import vtkWarpVector

from plotting import fields, maps
from plotting.contact import STATES
from plotting.figure import GRAY, ORANGE, key_under_labels, new_figure, say_empty
from plotting.space import files
from plotting.space.contact_view import middle_of, nodes_of, places_in, view_of
from plotting.space.grids import cut, poly
from plotting.space.run import AXES
from plotting.space.scene import scale_of
from plotting.units import amount, plain

ARROWS = 18                      # along the longer side of the contact, at most
LEAST_SHEAR = 0.02               # of the largest, below which no arrow is drawn
NO_FRICTION = 1e-4               # largest shear over the largest pressure, below which it is what the iteration left
MOST = 6                         # tools
SMALL, ZOOM = 0.05, 4.0          # contact over the workpiece, below which sections show so many times the contact
OFF = 1e-5                       # of the workpiece: a section of the tools beside their vertices, on which VTK loses edges
BARE = 1e-3                      # of the first level of the pressure, below which the surface stays white


def contact_box(points, margin=0.35):
    low, high = points.min(axis=0), points.max(axis=0)
    room = margin * (high - low).max()
    return low[0] - room, high[0] + room, low[1] - room, high[1] + room


def show_way(axes, run, tool, box, view):
    """An arrow below the upper edge along the way that the tool has gone, if it has; handles for the key."""
    track = run.tracks.get(int(tool), np.zeros((1, 3)))
    way = view.axes @ (track[-1] - track[0])
    if not np.hypot(*way) > 1e-3 * (box[1] - box[0]):
        return []
    way = 0.07 * (box[1] - box[0]) * way / np.hypot(*way)
    start = np.array([0.5 * (box[0] + box[1]), box[3] - 0.07 * (box[3] - box[2])])
    axes.annotate("", start + way, start - way, arrowprops={"arrowstyle": "-|>", "color": ORANGE, "linewidth": 2, "mutation_scale": 18})
    return [Line2D([], [], color=ORANGE, linewidth=2, marker=">", markersize=7, label="way of the tool")]


def draw_arrows(axes, points, shear, spread):
    """Shear at nodes that lie apart; spread: their least distance. Returns whether there is any."""
    size = np.hypot(*shear.T)
    if not size.max(initial=0) > 0:
        return 0.0
    order, taken = np.argsort(-size), np.empty((0, 2))
    chosen = []
    for k in order[size[order] > LEAST_SHEAR * size.max()]:
        if not len(taken) or np.hypot(*(taken - points[k]).T).min() >= spread:
            taken, chosen = np.vstack([taken, points[k]]), chosen + [k]
    axes.quiver(*points[chosen].T, *(shear[chosen] / size.max()).T, angles="xy", scale_units="xy", scale=0.6 / spread, color="black",
                width=0.003, zorder=5)
    return size.max()


def draw_states(axes, surface, places, mine):
    """A mark at every node that touches; handles for the key."""
    keys = []
    for state, (name, color, marker) in STATES.items():
        chosen = mine & (surface.data["state"] == state)
        if chosen.any():
            keys += axes.plot(*places[chosen].T, linestyle="none", marker=marker, color=color, markersize=5, markeredgecolor="white",
                              markeredgewidth=0.4, zorder=4, label=f"{name} node")
    return keys


def beside(surface, mine, view, far):
    """The triangles of the contact and those about it that face the viewer: of a closed surface not what lies before or behind."""
    corners = surface.points[surface.triangles]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ np.cross(*view.axes)
    own, depth = mine[surface.triangles].any(axis=1), surface.points @ np.cross(*view.axes)
    facing *= np.sign(facing[own].sum())
    near = np.abs(depth - depth[mine].mean())[surface.triangles].max(axis=1) < far
    return surface.triangles[own | (facing > 0) & near]


def pressure_panel(figure, axes, run, tool, mine, view):
    """Bands of the pressure, arrows of the shear, nodes by their state. mine: the nodes of this contact; view: from where they are seen"""
    surface, unit = run.last.surface, run.units.length_unit
    places = places_in(view, surface.points)
    values = run.units.stress * np.maximum(surface.data["pressure"], 0)
    shear = run.units.stress * surface.data["traction_tangential"] @ view.axes.T
    levels = fields.levels_to(values[mine].max())
    box = contact_box(places[mine])
    maps.set_view(axes, box, unit)
    axes.set(xlabel=f"{view.labels[0]} [{unit}]", ylabel=f"{view.labels[1]} [{unit}]")
    axes.grid(False)
    mesh = Triangulation(*places.T, beside(surface, mine, view, box[1] - box[0]))
    if levels is not None:
        bands = maps.draw_bands(axes, mesh, values, np.r_[BARE * levels[1], levels[1:]], "viridis_r")
        figure.colorbar(bands, ax=axes, label=f"contact pressure [{run.units.stress_unit}]", ticks=levels[1:], format="%.4g", shrink=0.9)
    axes.triplot(mesh, color="black", linewidth=0.2, alpha=0.35, zorder=1.5)
    if not np.hypot(*shear[mine].T).max() > NO_FRICTION * values[mine].max():
        shear = np.zeros_like(shear)
    largest = draw_arrows(axes, places[mine], shear[mine], max(box[1] - box[0], box[3] - box[2]) / ARROWS)
    keys = draw_states(axes, surface, places, mine) + show_way(axes, run, tool, box, view)
    if largest:
        keys.append(Line2D([], [], color="black", marker=r"$\rightarrow$", markersize=12, linestyle="none",
                           label=f"friction on the workpiece, longest {amount(largest, run.units.stress_unit)}"))
    key_under_labels(axes, keys, 2)
    return bool(largest)


def panel_size(boxes, columns):
    """Width and height for panels with these limits [inches]."""
    wide = 8.5 if columns == 1 else 13.0 / columns
    aspect = max((box[3] - box[2]) / (box[1] - box[0]) for box in boxes)
    return wide, float(np.clip((wide - 2.3) * aspect, 1.5, 5.5)) + 1.6


def pressure_figure(run):
    """Under each tool that touches at the end, at most six, seen along its normal; None without contact."""
    surface = run.last.surface
    if surface is None or not files.touching(surface).any():
        return None
    tools = np.unique(surface.data["tool"][files.touching(surface)])[:MOST]
    mine = [nodes_of(run, surface, tool) for tool in tools]
    views = [view_of(run, surface, nodes) for nodes in mine]
    columns = min(3 if len(tools) > 4 else 2, len(tools))
    rows = -(-len(tools) // columns)
    wide, high = panel_size([contact_box(places_in(view, surface.points[nodes])) for view, nodes in zip(views, mine)], columns)
    figure, panels = new_figure(columns * wide, rows * high, nrows=rows, ncols=columns, squeeze=False)
    when, without = f"t = {run.last.t:.4g}", [plain(run.tool_name(k)) for k in run.tracks if k not in surface.data["tool"][files.touching(surface)]]
    rubbing = [pressure_panel(figure, axes, run, *one) for axes, *one in zip(panels.flat, tools, mine, views)]
    what = "Pressure and friction" if any(rubbing) else "Pressure"
    for axes, tool, view in zip(panels.flat, tools, views):
        name = plain(run.tool_name(tool))
        axes.set_title(f"{name}, seen {view.words}" if len(tools) > 1 else f"{what} under {name} at {when}, seen {view.words}", fontsize=11)
    for axes in list(panels.flat)[len(tools):]:
        axes.set_visible(False)
    if len(tools) > 1 or without:
        told = (f"{what} at {when}; " if len(tools) > 1 else "") + (f"no contact at the end: {', '.join(without)}" if without else "")
        figure.suptitle(told.removesuffix("; "), fontsize=12)
    return figure


def cut_body(run, body, name, point, normal):
    """(places, triangles, values) of the section of the deformed workpiece; point in the unit of the picture."""
    warp = vtkWarpVector()
    warp.SetInputData(body.vtk)
    warp.SetInputArrayToProcess(0, 0, 0, 0, "displacement")
    warp.Update()
    grid = warp.GetOutput()
    grid.GetPointData().SetActiveScalars(name)
    section = cut(grid, point / run.units.length, normal)
    cells = vtk_to_numpy(section.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return (run.units.length * vtk_to_numpy(section.GetPoints().GetData()), cells,
            vtk_to_numpy(section.GetPointData().GetArray(name)))


def cut_tools(frame, point, normal):
    """Ends of the edges in which the plane meets the tools, k x 2 x 3."""
    edges, point = [np.empty((0, 2, 3))], point + OFF * np.ptp(frame.body.points, axis=0).max() * np.asarray(normal)
    for _, points, triangles, _ in files.tool_parts(frame.tools):
        section = cut(poly(points, triangles), point, normal)
        if section.GetNumberOfLines():
            places = vtk_to_numpy(section.GetPoints().GetData())
            edges.append(places[vtk_to_numpy(section.GetLines().GetConnectivityArray()).reshape(-1, 2)])
    return np.vstack(edges)


def section_panel(axes, run, scale, point, across, title):
    """The plane through the point whose normal is the axis `across`; returns the bands."""
    normal = np.eye(3)[across]
    shown = [k for k in range(3) if k != across]
    if abs(run.up[shown[0]]) > 0.5:
        shown.reverse()                          # the tools' side is above
    places, cells, values = cut_body(run, run.last.body, scale.quantity.name, point, normal)
    mesh = Triangulation(*places[:, shown].T, cells)
    edges = cut_tools(run.last, point, normal)[:, :, shown]
    box = fields.mesh_box(mesh)
    height = box[3] - box[2]
    box = (*box[:2], box[2], box[3] + 0.35 * height) if run.up.sum() > 0 else (*box[:2], box[2] - 0.35 * height, box[3])
    maps.set_view(axes, box, run.units.length_unit)
    axes.set_xlabel(f"{AXES[shown[0]]} [{run.units.length_unit}]")
    axes.set_ylabel(f"{AXES[shown[1]]} [{run.units.length_unit}]")
    axes.grid(False)
    bands = fields.fill(axes, mesh, scale.factor * values, scale.levels, scale.quantity.colors)
    maps.draw_outline(axes, mesh)
    axes.add_collection(LineCollection(edges, colors=GRAY, linewidths=1.6, zorder=3.5))
    step = 10.0 ** np.floor(np.log10(1e-2 * (box[1] - box[0])))
    place = round(round(point[across] / step) * step, 12) + 0.0
    axes.set_title(f"{title}section {AXES[across]} = {amount(place, run.units.length_unit)}", fontsize=11)
    return bands


def section_figure(run):
    """Two sections through the middle of the contact at the end, along the way of the tools and across it; of a contact that is small in the
    workpiece what is near it."""
    surface = run.last.surface
    if surface is None or not files.touching(surface).any():
        return None
    scale = scale_of(run, [run.last])
    quantity, touching = scale.quantity, files.touching(surface)
    point = middle_of(surface, touching)
    first, up = (int(np.argmax(np.abs(v))) for v in (run.along, run.up))
    second = ({0, 1, 2} - {first, up}).pop()
    size, contact = np.ptp(run.last.body.points, axis=0), np.ptp(surface.points[touching], axis=0).max()
    small = contact < SMALL * size.max()
    wide = size if not small else np.full(3, ZOOM * contact)
    figure, panels = new_figure(12.0, float(np.clip(1.6 + 5.0 * 1.45 * wide[up] / max(wide[first], wide[second]), 3.4, 7)), ncols=2,
                                width_ratios=(wide[first], wide[second]))
    title = f"{quantity.label[0].upper() + quantity.label[1:]} {'near' if small else 'through'} the middle of the contact at t = {run.last.t:.4g}"
    bands = [section_panel(axes, run, scale, point, across, words) for axes, across, words in
             zip(panels, (second, first), (title + "\n", ""))]
    for axes, along in zip(panels, (first, second)) if small else ():
        axes.set_xlim(*point[along] + ZOOM * contact * np.array([-0.5, 0.5]))
        axes.set_ylim(*point[up] + ZOOM * contact * (np.array([-0.75, 0.25]) if run.up[up] > 0 else np.array([-0.25, 0.75])))
    if bands[0] is None:
        say_empty(panels[0], f"no {quantity.label}")
    else:
        fields.add_scale(figure, bands[0], list(panels), scale.label, 0.7)
    key_under_labels(panels[0], [Line2D([], [], color=GRAY, linewidth=1.6, label="rigid tool")], 1)
    return figure
