"""The scene at t = 0: mesh, supports, contact surface, tools."""
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.tri import Triangulation

from plotting import arrows, fields, maps, quadratic, tools
from plotting.figure import BLUE, RED, key_under_labels, new_figure

ROOM = 0.15   # for arrows, over the workpiece
APART = 0.17  # of the marks of nodes that are held [inches]
KINDS = ((True, True, "s", "held"), (True, False, ">", "held along x"), (False, True, "^", "held along y"))


def spread(places, apart):
    """Some of these places, none of them nearer to another one."""
    kept = []
    for place in places[np.lexsort(places.T)]:
        if not kept or maps.distance(place[None], np.array(kept))[0] >= apart:
            kept.append(place)
    return np.array(kept)


def draw_supports(axes, run):
    """Marks at nodes that are held, as many as can be told apart; returns handles for the key."""
    places, fixed = run.supports
    handles, apart = [], APART * arrows.inches_in(axes, (*axes.get_xlim(), *axes.get_ylim()))
    for x, y, marker, label in KINDS:
        chosen = (fixed == (x, y)).all(axis=1)
        if chosen.any():
            handles += axes.plot(*spread(run.units.length * places[chosen], apart).T, linestyle="none", marker=marker, color=RED, markersize=6.0,
                                 markeredgewidth=0, label=label, zorder=5, clip_on=False)
    return handles


def draw_surface(axes, run):
    """The contact surface, which the table has in order; one that is closed ends beside its beginning."""
    surface = run.surface
    path = run.units.length * np.column_stack([surface["X"], surface["Y"]])
    path = np.vstack([path, path[:1]])
    steps = np.hypot(*np.diff(path, axis=0).T)
    edges = np.stack([path[:-1], path[1:]], axis=1)[steps < 8 * np.median(steps)]
    axes.add_collection(LineCollection(edges, colors=BLUE, linewidths=2.2, zorder=4))
    return [Line2D([], [], color=BLUE, linewidth=2.2, label="contact surface")]


def with_room(box, mesh, outlines):
    """The limits with room for arrows above and below the workpiece where a tool is there, however small."""
    room = ROOM * max(np.ptp(mesh.x), np.ptp(mesh.y))
    above, below = (any(f(o.points[:, 1]) for o in outlines) for f in (lambda y: y.min() > mesh.y.mean(), lambda y: y.max() < mesh.y.mean()))
    return (*box[:2], min(box[2], mesh.y.min() - room) if below else box[2], max(box[3], mesh.y.max() + room) if above else box[3])


def start_figure(run, width=8.5):
    """The undeformed mesh, the nodes held, the contact surface, the tools, and what drives them."""
    mesh = Triangulation(*(run.units.length * run.field.points).T, quadratic.elements_of(run.field.triangles)[:, :3])
    outlines = tools.at_time(run.tools, 0)
    box = with_room(tools.widened(fields.mesh_box(mesh), outlines), mesh, outlines)
    figure, axes = new_figure(width, fields.shape_of(box, width))
    maps.set_view(axes, box, run.units.length_unit)
    axes.grid(False)
    axes.triplot(mesh, color="black", linewidth=0.35, alpha=min(0.8, 3000 / len(mesh.triangles)), zorder=1.5)
    maps.draw_outline(axes, mesh)
    handles = tools.draw_tools(axes, outlines, mesh)
    if run.has("surface.csv"):
        handles += draw_surface(axes, run)
    handles += draw_supports(axes, run)
    handles += maps.draw_symmetry(axes, run.mirrors)
    handles += arrows.draw_arrows(axes, run, outlines, mesh)
    axes.set_title("Mesh, supports and tools at t = 0")
    key_under_labels(axes, handles, min(4, len(handles)))
    return figure
