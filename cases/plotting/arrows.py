"""Arrows of what the program prescribes for the tools (drives.py), each put where it covers nothing; space/arrows.py projects them."""
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D
from matplotlib.path import Path

from plotting import drives, maps, tools
from plotting.figure import GREEN, ORANGE

DARKER = 0.6                    # words than their arrow
LONG, LONGEST, RADIUS = 0.55, 1.1, 0.2       # of an arrow, of one along a way; radius of a turn [inches]
ROOM = 0.06                     # about an arrow [inches]
LETTER, LINE = 0.085, 0.19      # width of a letter, height of a line [inches]
GRID = 45                       # places tried along each side of the view
COVERED, AWAY, BESIDE = 1.0, 9.0, 10.0     # cost of a covered point, over the view: of the distance, of that of a force from its line of action,
OUTSIDE, WITHIN = 2.5, 1.0      # of a place outside of the tool, of one within another
SIZES, SHORTER = (1.0, 0.75, 0.55, 0.42, 0.3), 1.0      # of an arrow, tried in this order; cost of being shorter
UNSAID = 6.0                    # cost of a motion without its value
COLORS, DASHED = {"motion": ORANGE, "force": GREEN, "free turn": ORANGE}, (0, (1.6, 0.7))


def circle(sense):
    angle = np.radians(np.linspace(-50, 230, 40)[:: int(sense)])
    return np.column_stack([np.cos(angle), np.sin(angle)])


def points_of(shape):
    """Points of the arrow about its middle [inches]; of a way the whole in small. A turn that is projected has points for a radius of one."""
    if shape.kind == drives.TURN:
        return RADIUS * shape.points if np.ndim(shape.points) == 2 else RADIUS * circle(shape.points[0])
    if shape.kind == drives.STRAIGHT:
        return LONG * np.outer([-0.5, 0.5], shape.points)
    middle = 0.5 * (shape.points.min(axis=0) + shape.points.max(axis=0))
    return (shape.points - middle) * LONGEST / maps.length(shape.points)


def label_place(points, text):
    """Lower left corner of the words beside the arrow, and their size [inches]: to the right of an upright one, else above."""
    size = np.array([LETTER * len(shown(text)), LINE])
    wide, high = np.ptp(points, axis=0)
    if high > wide:
        return np.array([points[:, 0].max() + 0.1, -0.5 * size[1]]), size
    return np.array([-0.5 * size[0], points[:, 1].max() + 0.07]), size


def shown(text):
    """The letters that are seen of a text with formulas."""
    return text.replace(r"$\cdot$", ".").replace("$", "").replace("\\", "")


def box_about(points, text):
    """Corners of all that is drawn about the middle of the arrow [inches]."""
    low, high = points.min(axis=0) - ROOM, points.max(axis=0) + ROOM
    if text:
        corner, size = label_place(points, text)
        low, high = np.minimum(low, corner - 0.04), np.maximum(high, corner + size + 0.04)
    return low, high


def inches_in(axes, box):
    """What an inch of the picture is in units of the data, about: the layout is not known yet."""
    width, height = axes.figure.get_size_inches() * [axes.get_position().width, axes.get_position().height]
    return max((box[1] - box[0]) / width, (box[3] - box[2]) / height)


def obstacles_of(outlines, mesh, box, size):
    """Places that no arrow may cover: outlines of the tools, nodes of the workpiece, points between them on its rim."""
    places = [maps.refined(o.points, 0.006 * size) for o in outlines]
    places += [maps.refined(edge, 0.006 * size) for edge in maps.rim_edges(mesh)]
    places += [np.column_stack([mesh.x, mesh.y])[np.unique(mesh.triangles)]]
    middles = np.column_stack([v[mesh.triangles].mean(axis=1) for v in (mesh.x, mesh.y)])
    places = np.vstack(places + [middles])
    return places[maps.inside(places, box, -0.01)]


def anchor_of(outline, region, box, grid, mesh):
    """Between the middle of what is seen of a tool and its place nearest to the workpiece."""
    seen, rim = grid[region.contains_points(grid)], outline.points[maps.inside(outline.points, box)]
    if not len(rim):
        return seen.mean(axis=0)
    nodes = np.column_stack([mesh.x, mesh.y])[:: max(1, len(mesh.x) // 500)]
    return 0.5 * (seen.mean(axis=0) + rim[np.argmin(maps.distance(rim, nodes))])


def place_of(points, text, tool, grid, obstacles, view):
    """Cost and place of the middle of an arrow. tool: middle of what is seen of it, its region, those of others, across the line of action of a force;
    view: limits, an inch"""
    (anchor, region, others, across), (box, inch) = tool, view
    low, high = (inch * corner for corner in box_about(points, text))
    fits = ((grid[:, 0] + low[0] > box[0]) & (grid[:, 0] + high[0] < box[1]) & (grid[:, 1] + low[1] > box[2]) & (grid[:, 1] + high[1] < box[3]))
    places = grid[fits] if fits.any() else grid
    covered = np.array([maps.inside(obstacles - p, (low[0], high[0], low[1], high[1])).sum() for p in places])
    off = (places - anchor) / max(box[1] - box[0], box[3] - box[2])
    cost = COVERED * covered + AWAY * np.hypot(*off.T) + BESIDE * np.abs(off @ across) + OUTSIDE * ~region.contains_points(places)
    cost += WITHIN * sum((other.contains_points(places) for other in others), np.zeros(len(places)))
    return cost.min(), places[np.argmin(cost)]


def best_place(arrow, tool, grid, obstacles, view, largest):
    """Cost, points of the arrow in the size that fits best, at most this one [inches], where its middle goes, and its value, which is left out of a
    motion without room. A way around something is where it is."""
    tried, way = [], arrow.shape.points
    if arrow.shape.kind == drives.AROUND:
        middle = 0.5 * (way.min(axis=0) + way.max(axis=0))
        return 0.0, (way - middle) / view[1], middle, arrow.text
    for part in (p for p in SIZES if p <= largest):
        points = part * points_of(arrow.shape)
        for text in dict.fromkeys((arrow.text, arrow.text if arrow.what == "force" else "")):
            cost, place = place_of(points, text, tool, grid, obstacles, view)
            tried.append((cost + SHORTER * (1 - part) + UNSAID * (text != arrow.text), points, place, text))
    return min(tried, key=lambda one: one[0])


def behind(at, inch):
    """A point of the arrow so far behind its end that it says where that points."""
    return at[np.flatnonzero(np.hypot(*(at - at[-1]).T) > 0.09 * inch)[-1]]


def draw_one(axes, arrow, points, middle, inch):
    """The arrow with its value about a place."""
    color, at = COLORS[arrow.what], middle + inch * points
    small = min(1.0, maps.length(points) / LONG)
    head = 10 + 10 * small
    axes.plot(*at.T, color=color, linewidth=1.4 + 1.2 * small, zorder=6, solid_capstyle="butt",
              linestyle=DASHED if arrow.what == "free turn" else "-")
    ends = [(at[-1], behind(at, inch))] + ([(at[0], behind(at[::-1], inch))] if arrow.both else [])
    for tip, before in ends:
        way = (tip - before) / np.hypot(*(tip - before))
        axes.annotate("", tip + 0.07 * inch * way, tip - 0.03 * inch * way, zorder=6.1, annotation_clip=False,
                      arrowprops={"arrowstyle": "-|>", "color": color, "shrinkA": 0, "shrinkB": 0, "mutation_scale": head, "linewidth": 0})
    if arrow.text:
        corner, size = label_place(points, arrow.text)
        upright = corner[1] < points[:, 1].max()
        axes.text(*(middle + inch * (corner + (0 if upright else 0.5, 0.5) * size)), arrow.text, ha="left" if upright else "center", va="center", fontsize=10, color=[DARKER * c for c in to_rgb(color)],
                  path_effects=maps.WHITE_EDGE, zorder=6.2)


def draw_arrows(axes, run, outlines, mesh, words=("motion", "force", "free turn")):
    """All arrows of a run in the plane into axes with their limits set, over the tools at these places; handles for the key. words: which
    have their values"""
    (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
    box, size = (x0, x1, y0, y1), max(x1 - x0, y1 - y0)
    grid, regions, seen = grid_of(axes), {o.name: Path(tools.area_of(o.points, mesh, 0.15 * size, run.mirrors)) for o in outlines}, {}
    for outline in outlines:
        region = regions[outline.name]
        if region.contains_points(grid).any():
            seen[outline.name] = anchor_of(outline, region, box, grid, mesh), region
    return put(axes, run, drives.arrows(run, size), seen, obstacles_of(outlines, mesh, box, size), words)


def grid_of(axes):
    return np.array([(x, y) for x in np.linspace(*axes.get_xlim(), GRID) for y in np.linspace(*axes.get_ylim(), GRID)])


def fitting(shape, box):
    """A way around something that is seen in part is shown in small as others are."""
    return shape._replace(kind=drives.WAY) if shape.kind == drives.AROUND and not maps.inside(shape.points, box).all() else shape


def in_order(arrow):
    """First what has its place, then turns, which are as high as wide, then forces, which have their line."""
    return arrow.shape.kind != drives.AROUND, arrow.shape.kind != drives.TURN, arrow.what != "force"


def across(arrow):
    """Unit vector across a force, zero for what has no line of action."""
    if arrow.what != "force" or arrow.shape.kind != drives.STRAIGHT:
        return np.zeros(2)
    return np.array([-arrow.shape.points[1], arrow.shape.points[0]]) / np.hypot(*arrow.shape.points)


def placed_all(found, seen, grid, obstacles, view, largest):
    """Cost of all arrows in sizes up to this one, and a list of arrow, points, middle: a tool with several has room for small ones."""
    total, placed = 0.0, []
    for arrow in sorted(found, key=in_order):
        tool = (*seen[arrow.tool], [region for name, (_, region) in seen.items() if name != arrow.tool], across(arrow))
        cost, points, middle, text = best_place(arrow, tool, grid, obstacles, view, largest)
        taken = maps.refined(points, ROOM)
        if arrow.shape.kind != drives.AROUND:
            low, high = box_about(points, text)
            taken = np.array([(x, y) for x in np.linspace(low[0], high[0], 9) for y in np.linspace(low[1], high[1], 9)])
        obstacles = np.vstack([obstacles, np.repeat(middle + view[1] * taken, 3, axis=0)])
        total, placed = total + cost, placed + [(arrow._replace(text=text), points, middle)]
    return total, placed


def put(axes, run, found, seen, obstacles, words):
    """Draws these arrows, shapes in the plane of the picture; handles for the key. seen: {tool: its anchor and region} of those in the view"""
    box, grid = (*axes.get_xlim(), *axes.get_ylim()), grid_of(axes)
    inch, found = inches_in(axes, box), [arrow if arrow.what in words else arrow._replace(text="") for arrow in found if arrow.tool in seen]
    found = [arrow._replace(shape=fitting(arrow.shape, box)) for arrow in found]
    placed = min((placed_all(found, seen, grid, obstacles, (box, inch), part) for part in SIZES), key=lambda one: one[0])[1]
    for arrow, points, middle in placed:
        draw_one(axes, arrow, points, middle, inch)
    kinds = {kind: kind for kind in COLORS if any(arrow.what == kind for arrow in found)}
    if run.said_symmetry and "force" in kinds:
        kinds["force"] = "force on what was computed"
    return [Line2D([], [], color=COLORS[kind], linewidth=2.6, linestyle=DASHED if kind == "free turn" else "-", marker=">", markersize=7,
                   label=label) for kind, label in kinds.items()]
