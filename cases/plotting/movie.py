"""The movie of a run (-movie 1): movie.html, a page with a slider for the time, and movie.gif.

Each frame of the series: stress on the deformed mesh, the tools, the nodes in contact by their state; beside it curves of the
history with the time marked. Both files are whole or not there.
"""
import base64
import io
import os

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from PIL import Image

from plotting import curves, fields, maps, tools
from plotting import units as u
from plotting.contact import STATES
from plotting.figure import key_under_labels
from plotting.inputs import MissingInput
from plotting.movie_page import page
from plotting.vtp import read_vtp

MOST = 60                              # frames
PIXELS = 118                           # an inch
COLORS = 96                            # of a frame
SECONDS, LAST_SECONDS = 0.2, 1.5       # a frame of the GIF
SMALL = 0.1                            # contact over the workpiece, below which the map shows what is near it
NEARLY_ALL, PEAK = 0.998, 1.5          # quantile of the nodes; largest value over it, from which the scale ends there
PANELS = (u.FORCE, u.MOMENT, u.NODES, u.LENGTH, u.ANGLE, u.OTHER, u.STRAIN, u.STRESS)  # the first three that change


class Frame:
    """One instant: mesh, values, outlines of the tools and nodes in contact, in the units of the pictures."""

    def __init__(self, run, t, parts):
        scale, self.t = run.units.length, t
        field = run.read_field(parts["workpiece"])
        self.mesh = maps.deformed(field, scale)
        self.values = run.units.stress * np.nan_to_num(field.data["stress_eq"])
        self.outlines = []
        if "tools" in parts:
            lines = read_vtp(parts["tools"])
            self.outlines = [tools.Outline(str(k), t, scale * lines.points[line, :2]) for k, line in enumerate(lines.lines)]
        self.places, self.states = np.empty((0, 2)), np.empty(0)
        if "contact surface" in parts:
            surface = read_vtp(parts["contact surface"])
            self.places = scale * (surface.points + surface.data["displacement"])[:, :2]
            self.states = surface.data["state"]


def frames_of(run):
    """At most MOST frames, evenly taken."""
    found = run.frames
    if len(found) < 2:
        raise MissingInput(f"{run.folder}: fewer than two frames of fields, too few for a movie")
    chosen = np.unique(np.linspace(0, len(found) - 1, min(MOST, len(found))).round().astype(int))
    return [Frame(run, *found[k]) for k in chosen]


def panels_of(run):
    """(title, columns, change) of the curves beside the map."""
    kinds = {title: kind for kind, title in curves.PANELS}
    order = lambda panel: PANELS.index(kinds.get(panel[0], u.OTHER))
    return sorted(curves.default_panels(run), key=order)[:3]


def whole_box(run, frames):
    """The workpiece and the tools near it in all frames."""
    boxes = np.array([fields.view_of(run, f.mesh, f.outlines, 0.2) for f in frames])
    return boxes[:, 0].min(), boxes[:, 1].max(), boxes[:, 2].min(), boxes[:, 3].max()


def near_contact(frames):
    """Where the contact of all frames is so small that it could not be seen: what is near it; None otherwise."""
    touching = np.vstack([f.places[np.isin(f.states, list(STATES))] for f in frames])
    if not len(touching):
        return None
    size, middle = np.ptp(touching, axis=0).max(), 0.5 * (touching.min(axis=0) + touching.max(axis=0))
    mesh = frames[0].mesh
    if size > SMALL * max(np.ptp(mesh.x), np.ptp(mesh.y)) or size == 0:
        return None
    low = middle - np.array([2.0, 2.2]) * size
    high = middle + np.array([2.0, 0.8]) * size
    edges = np.array([[mesh.x.min(), mesh.y.min()], [mesh.x.max(), mesh.y.max()]])
    if abs(middle[1] - edges[0, 1]) < abs(middle[1] - edges[1, 1]):  # the workpiece lies above
        low, high = middle - np.array([2.0, 0.8]) * size, middle + np.array([2.0, 2.2]) * size
    low[0], high[0] = max(low[0], edges[0, 0] - 0.3 * size), min(high[0], edges[1, 0] + 0.3 * size)
    return low[0], high[0], low[1], high[1]


def levels_of(frames, box):
    """Levels of the stress for all frames, and whether they end below the largest: that at a corner hides all others."""
    seen = [f.values[maps.inside(np.column_stack([f.mesh.x, f.mesh.y]), box)] for f in frames]
    seen = [values for values in seen if len(values)] or [f.values for f in frames]
    largest, most = max(v.max() for v in seen), max(np.quantile(v, NEARLY_ALL) for v in seen)
    cut = most > 0 and largest > PEAK * most
    return fields.levels_to(most if cut else largest), cut


class Screen:
    """A figure with the map, its scale and the curves; `show` draws a frame into it."""

    def __init__(self, run, frames):
        self.run = run
        self.box = near_contact(frames) or whole_box(run, frames)
        self.levels, self.cut = levels_of(frames, self.box)
        panels = panels_of(run)
        self.map, places = self.layout(panels)
        if self.levels is not None:
            scale = ScalarMappable(BoundaryNorm(self.levels, len(self.levels) - 1), fields.band_colors(fields.STRESS, self.levels))
            self.figure.colorbar(scale, ax=self.map, label=f"{fields.STRESS.label} [{run.units.stress_unit}]", shrink=0.9,
                                 ticks=self.levels[::2], format="%.4g", extend="max" if self.cut else "neither")
        self.marks = [self.curve(axes, *panel) for axes, panel in zip(places, panels)]
        for axes in places:
            axes.set_xlabel(run.columns["t"].axis())
        self.show(frames[-1])
        self.figure.canvas.draw()
        self.figure.set_layout_engine("none")  # every frame at the same place

    def layout(self, panels):
        """Axes of the map, and of the curves: below a flat map, else beside it."""
        flat = (self.box[1] - self.box[0]) > 1.7 * (self.box[3] - self.box[2])
        number, lines = max(1, len(panels)), [0.14 * -(-len(names) // 2) * (len(names) > 1) for _, names, _ in panels] or [0]   # of the keys [inches]
        if flat:
            self.figure = FigureCanvasAgg(Figure(figsize=(8.5, 6.2 + max(lines)), dpi=PIXELS)).figure
            grid = self.figure.add_gridspec(2, number, height_ratios=(1.6, 1))
            return (self.figure.add_subplot(grid[0, :]),
                    [self.figure.add_subplot(grid[1, k]) for k in range(len(panels))])
        self.figure = FigureCanvasAgg(Figure(figsize=(9.4, 5.5 + sum(lines)), dpi=PIXELS)).figure
        grid = self.figure.add_gridspec(number, 2, width_ratios=(1.7, 1))
        return (self.figure.add_subplot(grid[:, 0]),
                [self.figure.add_subplot(grid[k, 1]) for k in range(len(panels))])

    def curve(self, axes, title, names, change):
        """A panel of the history; returns the mark of the present time."""
        exponent = curves.power_of_panel(self.run, names, change)
        for name, style in zip(names, curves.styles([self.run.columns[n].label for n in names])):
            curves.draw_column(axes, self.run, name, "t", style, change, exponent)
        if len(names) == 1:
            curves.label_panel(axes, self.run, names, title, change, exponent)
        else:
            axes.set_title(u.with_unit(title, u.in_powers(exponent, self.run.columns[names[0]].unit)), loc="left", fontsize=10)
            key_under_labels(axes, axes.get_legend_handles_labels()[0], 2, 7)
        return axes.axvline(0, color="black", linewidth=1.6, alpha=0.7)

    def show(self, frame):
        self.map.clear()
        values = np.minimum(frame.values, self.levels[-1]) if self.cut else frame.values
        fields.draw_map(self.map, frame.mesh, values, self.levels, frame.outlines, self.box, fields.STRESS.colors,
                        self.run.units.length_unit, self.run.mirrors)
        for state, (_, color, marker) in STATES.items():
            self.map.plot(*frame.places[frame.states == state].T, linestyle="none", marker=marker, color=color, markersize=5,
                          markeredgecolor="white", markeredgewidth=0.5, zorder=5)
        keys = [Line2D([], [], linestyle="none", marker=m, color=c, label=name) for name, c, m in STATES.values()]
        key_under_labels(self.map, keys, 3)
        self.map.set_title(f"t = {frame.t:.4g}")
        for mark in self.marks:
            mark.set_xdata([frame.t, frame.t])

    def picture(self, frame):
        self.show(frame)
        self.figure.canvas.draw()
        colors = np.asarray(self.figure.canvas.buffer_rgba())[..., :3]
        return Image.fromarray(colors).quantize(COLORS, dither=Image.Dither.NONE)


def data_uri(picture):
    data = io.BytesIO()
    picture.save(data, format="png", optimize=True)
    return "data:image/png;base64," + base64.b64encode(data.getvalue()).decode()


def write_whole(path, content):
    """Under another name, then moved."""
    new = os.path.join(os.path.dirname(path), ".new." + os.path.basename(path))
    with open(new, "wb") as file:
        file.write(content)
    os.replace(new, path)
    return path


def gif(pictures):
    data, milliseconds = io.BytesIO(), [int(1000 * SECONDS)] * (len(pictures) - 1) + [int(1000 * LAST_SECONDS)]
    pictures[0].save(data, format="gif", save_all=True, append_images=pictures[1:], duration=milliseconds, loop=0)
    return data.getvalue()


def write_movie(run, folder):
    """movie.html and movie.gif in the folder; returns their paths."""
    frames = frames_of(run)
    screen = Screen(run, frames)
    pictures = [screen.picture(frame) for frame in frames]
    above, name = os.path.split(os.path.abspath(folder))
    name = os.path.basename(above) if name == "out" else name
    html = page(name, [frame.t for frame in frames], [data_uri(p) for p in pictures], pictures[0].size)
    return [write_whole(os.path.join(folder, "movie.html"), html.encode()),
            write_whole(os.path.join(folder, "movie.gif"), gif(pictures))]
