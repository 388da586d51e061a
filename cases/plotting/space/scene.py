"""The scene in space: workpiece, tools and their tracks at the start, on the way and at the end."""
from collections import namedtuple

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from plotting import border, fields
from plotting.figure import ORANGE
from plotting.space import files
from plotting.space.arrows import draw_arrows
from plotting.space.display import start_display
from plotting.space.edge_labels import corners, draw_labels, with_room
from plotting.space.render import APART, BODY, STEEL, Scene
from plotting.space.run import unit
from plotting.units import plain

# label with its unit; factor from the file's numbers; levels: None where all is zero
Scale = namedtuple("Scale", "quantity label factor levels")
View = namedtuple("View", "eye up box length")  # directions; what is seen, low and high corner; unit of length
SMALL = 0.1        # of tools over the workpiece, below which only what is near them is seen
TOOL_ROOM = 0.35   # how far a tool is shown beyond the workpiece, over the workpiece's largest side
ASIDE, ABOVE = 0.55, 0.42  # of the view: sideways and upward, over straight from the front
FLOWING = 1e-6     # plastic strain from which it is shown
LEAST_WAY = 5e-2   # of the largest side, below which no way is drawn
LIFTED = 3e-3      # of the largest side, above its lowest place: the tool is on its way to the next track
TRACK = 0.006      # radius of a track over the largest side
SIZE, MARGIN = (1100, 900), 45   # pixels of a view of all, of which a part is drawn; about what is drawn
ROOM, OVER = 0.16, 4             # about the workpiece, over its size in the picture; times that above it, where arrows are
COLUMNS, FONT = 2, 8             # of pictures, of the words in them


def scale_of(run, frames):
    """The plastic strain at the end if there is some, else the stress, with levels for all these frames."""
    strain = run.last.body.data.get("plastic_strain_eq", np.zeros(1))
    quantity = fields.STRAIN if strain.max() > FLOWING else fields.STRESS
    most = max(np.nanmax(frame.body.data[quantity.name], initial=0.0) for frame in frames)
    exponent = fields.power_of_ten(most, 1e-3)
    unit_name = run.units.stress_unit if quantity.stress else fields.in_powers(exponent, "-")
    factor = run.units.stress if quantity.stress else 10.0**-exponent
    return Scale(quantity, f"{quantity.label} [{unit_name}]", factor, fields.levels_to(factor * most, quantity=quantity))


def values_of(frame, scale):
    return np.maximum(scale.factor * np.nan_to_num(frame.body.data[scale.quantity.name]), 0)


def box_of(frames):
    """Workpieces of the frames and their tools near them, of tools that are small beside them what is near the tools: low and high corner."""
    bodies = np.vstack([frame.body.points for frame in frames])
    low, high = bodies.min(axis=0), bodies.max(axis=0)
    room = TOOL_ROOM * (high - low).max()
    found = [points for frame in frames for _, points, _, _ in files.tool_parts(frame.tools)]
    size = max((np.ptp(points, axis=0).max() for points in found), default=np.inf)
    if size < SMALL * (high - low).max():
        low, high = (f([f(points, axis=0) for points in found], axis=0) for f in (np.min, np.max))
        return low - 0.4 * size, high + 0.4 * size
    ends = [(np.maximum(points.min(axis=0), low - room), np.minimum(points.max(axis=0), high + room)) for points in found]
    return np.min([low, *(end for end, _ in ends)], axis=0), np.max([high, *(end for _, end in ends)], axis=0)


def eye_of(run):
    """Direction to the viewer: the tools go to the right, and their side is above."""
    return unit(run.front + ASIDE * run.along + ABOVE * run.up)


def bands(scale):
    """Colors of the bands, with that of the workpiece below the first level if it is above zero, and the ends of their range."""
    levels = scale.levels
    colors = [fields.band_colors(scale.quantity, levels)(k) for k in range(len(levels) - 1)]
    if levels[0] == 0:
        return colors, (levels[0], levels[-1])
    return [BODY + (1.0,)] + colors, (levels[0] - levels[1], levels[-1] + levels[0])


def ways_of(run, frame):
    """Tracks of the tools that go along the workpiece, in parts between which they are lifted. None of those that only press, that push its
    end, or that are beside it in this frame."""
    side, across, ways = np.ptp(run.last.body.points, axis=0).max(), np.abs(run.up) < 0.5, []
    low, high = frame.body.points.min(axis=0) - LIFTED * side, frame.body.points.max(axis=0) + LIFTED * side
    for number, places in run.tracks.items():
        now = places[[t for t, _ in run.frames].index(frame.t)]
        if number not in run.riders or not ((now > low) & (now < high))[across].all():
            continue
        lifted = places @ run.up > (places @ run.up).min() + LIFTED * side
        ways += [part[~lifted[first:first + len(part)]] for first, part in parted(places, lifted)]
    return [way for way in ways if len(way) > 1 and np.ptp(way, axis=0)[across].max() > LEAST_WAY * side]


def parted(places, lifted):
    """(number of its first place, places) of each part that begins where the tool is lifted."""
    firsts = [0, *np.flatnonzero(lifted)]
    return [(first, places[first:last]) for first, last in zip(firsts, [*firsts[1:], len(places)])]


def staged(run, frame, box, scale, size):
    """All that is to be seen, and from where."""
    scene, eye = Scene(size), eye_of(run)
    if scale.levels is None:
        scene.add_body(frame.body, eye)
    else:
        scene.add_body(frame.body, eye, values_of(frame, scale), *bands(scale))
    side = np.ptp(run.last.body.points, axis=0).max()
    seen = min(side, np.ptp(box, axis=0).max())
    scene.add_tools(frame.tools, -APART * seen * eye, side, None if run.cut is None else -run.front)
    top = (frame.body.points @ run.up).max() + TRACK * side
    for places in ways_of(run, frame):
        scene.add_track(places + np.outer(top - places @ run.up, run.up), TRACK * side)
    scene.look(eye, run.up, box)
    return scene


def picture(run, frame, box, scale, size=SIZE):
    """(image, the scene, which knows the places in it)"""
    scene = staged(run, frame, box, scale, size)
    return scene.image(), scene


def show(axes, image, window=None):
    """window: columns and rows of the image, None: all; y of the axes and rows are upward."""
    height, width = image.shape[:2]
    axes.imshow(image, extent=(0, width, 0, height), interpolation="antialiased")
    columns, rows = window or ((0, width), (0, height))
    axes.set(xlim=columns, ylim=rows)
    axes.set_axis_off()


def key_of(run, frame, more=()):
    """more: further handles"""
    numbers = np.unique(frame.tools.cells["tool"]) if frame.tools else []
    names = plain(", ".join(map(run.tool_name, numbers))) if 0 < len(numbers) < 4 else "tools"
    told = "workpiece, edges of its elements" + (" where it was computed" if run.symmetry else "")
    told += "" if run.cut is None else f"; cut open at {'xyz'[run.cut]} = 0"
    handles = [Patch(facecolor=BODY, edgecolor="black", label=told),
               Patch(facecolor=STEEL, alpha=0.6, label=f"rigid {names}")]
    if ways_of(run, frame):
        handles.append(Line2D([], [], color=ORANGE, linewidth=4, label="way of the tool, on the surface"))
    return handles + list(more)


def near(stage, body, above=2):
    """Columns and rows (first, last), rows upward, of the view about the workpiece; large tools go on beyond, and so does a large workpiece.
    above: how much of the tools is seen, over the room on the other sides"""
    drawn, places = stage.pixels(np.vstack(stage.points)), stage.pixels(corners(body.points))
    first, last = drawn.min(axis=0), drawn.max(axis=0)
    (left, bottom), (right, top) = np.where(first < 0, 0, first - MARGIN), np.where(last > stage.size, stage.size, last + MARGIN)
    low, high = places.min(axis=0), places.max(axis=0)
    room = ROOM * (high - low).max()
    return (max(left, low[0] - room), min(right, high[0] + room)), (max(bottom, low[1] - room), min(top, high[1] + above * room))


def window_of(run, frames, stages, wide):
    """The view about the workpieces of all these frames, with room for the words at their edges: columns and rows (first, last), rows upward."""
    found = np.array([near(stage, frame.body, OVER) for frame, stage in zip(frames, stages)])
    window = tuple((found[:, k, 0].min(), found[:, k, 1].max()) for k in (0, 1))
    return with_room(run, frames, stages, window, wide, FONT)


def unit_of(run, scale):
    return run.units.stress_unit if scale.quantity.stress else fields.in_powers(int(round(-np.log10(scale.factor))), "-")


def place(figure, panels, size, below):
    """The panels in rows with room for their titles, above what is below them. size: of one [inches]"""
    whole = below + -(-len(panels) // COLUMNS) * (size[1] + border.ABOVE)
    figure.set_figheight(whole)
    for k, axes in enumerate(panels):
        left, top = k % COLUMNS * size[0], whole - k // COLUMNS * (size[1] + border.ABOVE) - border.ABOVE
        axes.set_position((left / border.WIDTH, (top - size[1]) / whole, size[0] / border.WIDTH, size[1] / whole))


def row_figure(run, frames, titles, driven=False):
    """Images of the frames with one scale. driven: the first one with the arrows of what drives the tools"""
    start_display()  # while the scenes are made
    scale, box = scale_of(run, frames), box_of(frames)
    stages = [staged(run, frame, box, scale, SIZE) for frame in frames]
    wide = (border.WIDTH - border.RIGHT) / COLUMNS
    (left, right), (bottom, top) = window = window_of(run, frames, stages, wide)
    size = wide, wide * (top - bottom) / (right - left)
    figure, more = border.new_figure(size[1]), []
    figure.shaded, panels = True, [figure.add_axes((0, 0, 1, 1), label=title) for title in titles]
    place(figure, panels, size, 0)
    for axes, frame, title, stage in zip(panels, frames, titles, stages):
        stage.narrow(*window, [round(150 * length) for length in size])
        show(axes, stage.image())
        axes.text(0.5, 1, title, transform=axes.transAxes, ha="center", va="bottom", fontsize=12)
        words = draw_labels(axes, run, frame, stage, FONT)
        if driven and axes is panels[0]:
            more = draw_arrows(axes, run, frame, stage, taken=words)
    key = key_of(run, frames[-1], more)
    place(figure, panels, size, border.key_height(key) + 0.05)
    border.add_key(figure, key)
    if scale.levels is not None:
        low, high = panels[-1].get_position().y0 * figure.get_figheight(), figure.get_figheight() - border.ABOVE
        border.add_scale(figure, scale.quantity, scale.levels, unit_of(run, scale), (low + 0.1 * (high - low), 0.8 * (high - low)))
        if scale.levels[0] > 0:
            figure.axes[-1].set_ylabel(scale.label + "\nlight: elastic")
    return figure


def scene_figure(run):
    titles = [f"{word}, t = {run.frames[k][0]:.4g}" for word, k in (("Start", 0), ("End", -1))]
    return row_figure(run, [run.view(0), run.view(-1)], titles, driven=True)


def sequence_figure(run, number=4):
    chosen = np.unique(np.linspace(0, len(run.frames) - 1, number + 1).round().astype(int))[1:]
    if len(chosen) < 3:
        return None
    frames = [run.view(k) for k in chosen]
    return row_figure(run, frames, [f"t = {frame.t:.4g}" for frame in frames])
