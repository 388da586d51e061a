"""Arrows of what the program prescribes for the tools, from `drive` of the summary: motion, straight, along the way or turning, and forces
with their values. Each is put where it covers nothing. What they are holds in space, too; space/arrows.py projects them."""
from collections import namedtuple

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D
from matplotlib.path import Path

from plotting import maps, tools
from plotting.figure import GREEN, ORANGE
from plotting.inputs import InputError
from plotting.units import amount, split_name, touch_columns

# Of one tool: "motion", "force" or "free turn", that of a tool which nothing turns but the workpiece; points of the arrow about its middle,
# whose size is chosen later; text: its value
Arrow = namedtuple("Arrow", "tool what shape both text")
STRAIGHT, TURN, WAY = "straight", "turn", "way"
Shape = namedtuple("Shape", "kind points")     # points: of a straight one its direction, of a turn its axis, of a way its places

FAR, TURNED, ROLLED = 0.02, 0.05, 0.2    # motion over the view, turn, free turn [rad], below which there is no arrow,
NEAR = 1e-3                     # of a run with such arrows; of one without any
SMALL = 0.2                     # of the largest motion of the run, below which another is none to see: a tool that goes off
NOISE = 1e-3                    # of the largest force on a tool, below which another is what is out of balance
BACK = 0.3                      # of the motion, back from its end: an arrow with two heads
DARKER = 0.6                    # words than their arrow
BACK_WORDS = ", and back"
CURVED = 0.02                   # sagitta over length, above which the arrow goes along the way
LONG, LONGEST, RADIUS = 0.55, 1.1, 0.2       # of an arrow, of one along a way; radius of a turn [inches]
ROOM = 0.06                     # about an arrow [inches]
LETTER, LINE = 0.085, 0.19      # width of a letter, height of a line [inches]
GRID = 45                       # places tried along each side of the view
COVERED, AWAY = 1.0, 9.0        # cost of a covered point, of the distance over the view,
OUTSIDE, WITHIN = 2.5, 1.0      # of a place outside of the tool, of one within another
SIZES, SHORTER = (1.0, 0.75, 0.55, 0.42), 1.0      # of an arrow, tried in this order; cost of being shorter
UNSAID = 6.0                    # cost of a motion without its value
COLORS, DASHED = {"motion": ORANGE, "force": GREEN, "free turn": ORANGE}, (0, (1.6, 0.7))


def drives(run):
    """{coordinate: its drive}, {} where the files do not say it."""
    try:
        return run.summary.get("drive", {})
    except InputError:
        return {}


def arrows(run, size):
    """All arrows of a run. size: of the view, in the unit of the pictures"""
    names, found = run.tool_names, []
    given = [(split_name(name)[0] or next(iter(names), ""), name, drive) for name, drive in drives(run).items()]
    given = [(tool, name, drive, moved_by(run, tool, name, drive)) for tool, name, drive in given if tool in names]
    largest = max((abs(most) * rates(drive)[0] for _, _, drive, (most, _) in given), default=0) * run.units.length
    length = size / run.units.length
    heaviest = max((load_of({**drive, "force": np.nanmax(np.abs(run.history["Q_" + name]))}, length) for _, name, drive, _ in given), default=0)
    for least in (FAR * size, NEAR * size):      # where nothing goes far, as in a test of a material, what goes
        for tool, _, drive, (most, both) in given if not found else ():
            motion = motion_of(run, (tool, drive, most, both), max(least, SMALL * largest))
            force = force_of(run, tool, drive) if load_of(drive, length) > NOISE * heaviest else []
            found += force or motion if drive["kind"].startswith("force") else motion or force     # what comes first is what the process is
    return found


def load_of(drive, length):
    """A force, or a moment as a pair of forces at this distance."""
    fast, turn = rates(drive)
    return abs(drive["force"]) / fast if fast else abs(drive["force"]) / (turn * length) if turn else 0.0


def parts(drive):
    """Velocity and angular velocity for a unit rate, the latter one number in the plane."""
    return np.split(np.array(drive["twist"]), [2 if len(drive["twist"]) == 3 else 3])


def rates(drive):
    return [np.linalg.norm(part) for part in parts(drive)]


def moved_by(run, tool, name, drive):
    """How far a coordinate goes that is moved, follows or turns, 0 for others; whether it comes back."""
    if name not in run.history or not rates(drive)[0] == 0 and not any(word in drive["kind"] for word in ("motion", "follows")):
        return 0.0, False
    moved = (run.history[name] - run.history[name][0])[:while_touching(run.history, tool)]
    last = int(np.nanargmax(np.abs(moved)))
    most, there = moved[last], np.sign(moved[last]) * moved
    return most, bool(np.nanmax(there[last] - there[last:]) > BACK * abs(most) or np.nanmin(there) < -BACK * abs(most))


def while_touching(history, tool):
    """Lines of the history up to the last in which the tool touches: what comes then takes it off. All if it never does."""
    own = [n for n in touch_columns(history) if n == f"{tool}.contact"] or touch_columns(history)
    touching = np.flatnonzero(sum(history[n] > 0 for n in own))
    return 1 + int(touching[-1]) if len(touching) else None


def motion_of(run, given, least):
    """The arrow of a coordinate that goes far enough, in a list. given: tool, drive, and what moved_by says; least: length"""
    tool, drive, most, both = given
    (velocity, turn), (fast, spin), units = parts(drive), rates(drive), run.units
    if fast * abs(most) * units.length > least:
        far = distance(run, tool) if len(velocity) == 2 and alone(run, tool) else fast * abs(most) * units.length
        text = rounded(far, units.length_unit) + BACK_WORDS * both
        return [Arrow(tool, "motion", way_or_line(run, tool, np.sign(most) * velocity / fast), both, text)]
    what, least = ("free turn", ROLLED) if drive["kind"] == "force" else ("motion", TURNED)
    if fast == 0 and spin * abs(most) > least:
        return [Arrow(tool, what, Shape(TURN, np.sign(most) * turn / spin), both, f"{np.degrees(spin * abs(most)):.3g}°" + BACK_WORDS * both)]
    return []


def alone(run, tool):
    """Whether only one coordinate moves a tool: it may be one of a mechanism, whose rate changes on the way."""
    moving = [name for name in drives(run) if (split_name(name)[0] or tool) == tool and name in run.history and np.ptp(run.history[name]) > 0]
    return len(moving) == 1


def distance(run, tool):
    """How far a tool goes that does not turn, from where it begins."""
    way = way_of(run, tool)
    return np.hypot(*(way - way[0]).T).max()


def way_or_line(run, tool, direction):
    """The way of the tool in the plane where that is curved, else the direction in which it begins."""
    if len(direction) == 3:
        return Shape(STRAIGHT, direction)
    way = way_of(run, tool)
    chord = way[-1] - way[0]
    length = maps.length(way)
    if length > 0 and len(way) > 4 and np.hypot(*chord) > 0:
        off = np.abs((way - way[0]) @ np.array([-chord[1], chord[0]])).max() / np.hypot(*chord)
        if off > CURVED * length and (way[len(way) // 4] - way[0]) @ direction > 0.8 * np.hypot(*(way[len(way) // 4] - way[0])):
            return Shape(WAY, way)
    return Shape(STRAIGHT, direction)


def way_of(run, tool):
    """Middles of the box about a tool at the instants of tools.csv while tools touch, those where it rests once."""
    last = run.history["t"][:while_touching(run.history, tool)][-1]
    own = sorted((o for o in run.tools if o.name == tool and o.t <= last * (1 + 1e-9)), key=lambda o: o.t)
    way = np.array([0.5 * (o.points.min(axis=0) + o.points.max(axis=0)) for o in own])
    goes = np.hypot(*np.diff(way, axis=0).T) > 1e-3 * maps.length(way)
    return way[np.r_[True, goes]]


def force_of(run, tool, drive):
    """The arrow of a coordinate under a force, in a list; none without one."""
    force, (velocity, turn), (fast, spin), units = drive["force"], parts(drive), rates(drive), run.units
    if fast:
        text = rounded(abs(force) / fast * units.force, units.force_unit)
        return [Arrow(tool, "force", Shape(STRAIGHT, np.sign(force) * velocity / fast), False, text)]
    return [Arrow(tool, "force", Shape(TURN, np.sign(force) * turn / spin), False, rounded(abs(force / spin) * units.moment, units.moment_unit))]


def rounded(number, unit):
    """Three digits: what was prescribed, without what is out of balance."""
    return amount(float(f"{number:.3g}"), unit)


def circle(sense):
    angle = np.radians(np.linspace(-50, 230, 40)[:: int(sense)])
    return np.column_stack([np.cos(angle), np.sin(angle)])


def points_of(shape):
    """Points of the arrow about its middle [inches]; of a way the whole in small. A turn that is projected has points for a radius of one."""
    if shape.kind == TURN:
        return RADIUS * shape.points if np.ndim(shape.points) == 2 else RADIUS * circle(shape.points[0])
    if shape.kind == STRAIGHT:
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
    """Cost and place of the middle of an arrow. tool: middle of what is seen of it, its region, those of others; view: limits, an inch"""
    (anchor, region, others), (box, inch) = tool, view
    low, high = (inch * corner for corner in box_about(points, text))
    fits = ((grid[:, 0] + low[0] > box[0]) & (grid[:, 0] + high[0] < box[1]) & (grid[:, 1] + low[1] > box[2]) & (grid[:, 1] + high[1] < box[3]))
    places = grid[fits] if fits.any() else grid
    covered = np.array([maps.inside(obstacles - p, (low[0], high[0], low[1], high[1])).sum() for p in places])
    far = np.hypot(*(places - anchor).T) / max(box[1] - box[0], box[3] - box[2])
    cost = COVERED * covered + AWAY * far + OUTSIDE * ~region.contains_points(places)
    cost += WITHIN * sum((other.contains_points(places) for other in others), np.zeros(len(places)))
    return cost.min(), places[np.argmin(cost)]


def best_place(arrow, tool, grid, obstacles, view):
    """Points of the arrow in the size that fits best [inches], where its middle goes, and its value, which is left out of a motion without room."""
    tried = []
    for part in SIZES:
        points = part * points_of(arrow.shape)
        for text in dict.fromkeys((arrow.text, arrow.text if arrow.what == "force" else "")):
            cost, place = place_of(points, text, tool, grid, obstacles, view)
            tried.append((cost + SHORTER * (1 - part) + UNSAID * (text != arrow.text), points, place, text))
    return min(tried, key=lambda one: one[0])[1:]


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
    return put(axes, run, arrows(run, size), seen, obstacles_of(outlines, mesh, box, size), words)


def grid_of(axes):
    return np.array([(x, y) for x in np.linspace(*axes.get_xlim(), GRID) for y in np.linspace(*axes.get_ylim(), GRID)])


def put(axes, run, found, seen, obstacles, words):
    """Draws these arrows, shapes in the plane of the picture; handles for the key. seen: {tool: its anchor and region} of those in the view"""
    box, grid = (*axes.get_xlim(), *axes.get_ylim()), grid_of(axes)
    inch, found = inches_in(axes, box), [arrow if arrow.what in words else arrow._replace(text="") for arrow in found if arrow.tool in seen]
    for arrow in sorted(found, key=lambda one: one.shape.kind != TURN):      # these need a place that is as high as wide
        tool = (*seen[arrow.tool], [region for name, (_, region) in seen.items() if name != arrow.tool])
        points, middle, text = best_place(arrow, tool, grid, obstacles, (box, inch))
        arrow = arrow._replace(text=text)
        draw_one(axes, arrow, points, middle, inch)
        low, high = box_about(points, arrow.text)
        taken = np.array([(x, y) for x in np.linspace(low[0], high[0], 9) for y in np.linspace(low[1], high[1], 9)])
        obstacles = np.vstack([obstacles, np.repeat(middle + inch * taken, 3, axis=0)])
    kinds = {kind: kind for kind in COLORS if any(arrow.what == kind for arrow in found)}
    if run.said_symmetry and "force" in kinds:
        kinds["force"] = "force on what was computed"
    return [Line2D([], [], color=COLORS[kind], linewidth=2.6, linestyle=DASHED if kind == "free turn" else "-", marker=">", markersize=7,
                   label=label) for kind, label in kinds.items()]
