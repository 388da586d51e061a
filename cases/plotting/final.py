"""final.png, the picture of a run in the plane: workpiece with its field and mesh, the whole tools with their way, beside it what is near
the contact where that is small. 1200 pixels wide; few artists, since a run draws it every time."""
from collections import namedtuple

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

from plotting import arrows, contact, drives, fields, maps, quadratic, tools
from plotting.border import ABOVE, BELOW, BETWEEN, GALLERY, LEFT, RIGHT, WIDTH, add_key, add_scale, add_title, fitted, new_figure
from plotting.figure import BLUE, ORANGE
from plotting.units import amount, touch_columns

LARGE = 4.0                    # a tool over the workpiece, from which only its part near the workpiece is drawn
FAR = 0.02                     # a way over the view, below which it is not drawn
OVER = 0.04                    # of the view: height of a way over the contact
ZONE, SMALL = 0.2, 0.25        # of the largest value: what makes the zone; zone over the view, below which it is drawn beside, too
FEWEST = 1e-3                  # plastic strain from which it is shown
GHOST = (0, (4, 2.5))
Scale = namedtuple("Scale", "quantity unit factor largest levels")
THIN = 1e-3                    # zone over the view of the gallery by area, below which it shows the stress
LONG = 2.0                     # width over height of what the gallery shows, at most


class Shown:
    """What is drawn of one instant, in the units of the pictures. scale: quantity, unit, factor, largest, levels; by default its own"""

    def __init__(self, run, t, field, surface=None, scale=None):
        self.t, self.run, self.surface = t, run, surface
        scale = scale or scale_of([run], [field], fields.MOST_LEVELS)
        self.quantity, self.unit, self.largest, self.levels = scale.quantity, scale.unit, scale.largest, scale.levels
        self.smooth = quadratic.smooth(field, scale.factor * np.nan_to_num(field.data[self.quantity.name]), run.units.length)
        self.mirrors, self.rim = run.mirrors, maps.rim_edges(self.smooth.mesh)
        self.outlines, self.first = (tools.own_side(tools.at_time(run.tools, when), self.smooth.mesh, run.mirrors) for when in (t, 0.0))
        self.seen = [o.name for o in self.outlines if tools.closed(o.points) and not tools.encloses(o.points, self.smooth.mesh)
                     and np.ptp(o.points, axis=0).max() < LARGE * self.size() and not self.crosses(o.points)]   # as a whole
        self.ways = {o.name: way for o in self.outlines if len(way := way_of(run.tools, o.name, t)) > 1}

    def size(self):
        return max(np.ptp(self.smooth.mesh.x), np.ptp(self.smooth.mesh.y))

    def crosses(self, points):
        """Whether a line of symmetry cuts the tool."""
        return any(points[:, k].min() < 0 < points[:, k].max() for k in (0, 1) if any(sign[k] < 0 for sign in self.mirrors))

    def way_in(self, name, size):
        """The way of a tool's middle; of a tool that is seen in part the same over the middle of its contact. size: of the view"""
        way, contact_at = self.ways[name], self.surface and contact.middle_of_contact(self.surface, name)
        if name in self.seen or contact_at is None:
            return way if name in self.seen else way[:1]
        off = self.run.units.length * contact_at - way[-1]
        return way + (1 - OVER * size / np.hypot(*off)) * off

    def whole(self):
        """Limits with the workpiece, its mirror images and the tools, large ones in part."""
        box = fields.view_of(self.run, self.smooth.mesh, [o for o in self.outlines if o.name not in self.seen])
        for outline in [o for o in self.outlines + self.first if o.name in self.seen]:
            for sign in [(1, 1), *self.mirrors]:
                low, high = (f(outline.points * sign, axis=0) for f in (np.min, np.max))
                box = min(box[0], low[0]), max(box[1], high[0]), min(box[2], low[1]), max(box[3], high[1])
        pad = 0.03 * max(box[1] - box[0], box[3] - box[2])
        return box[0] - pad, box[1] + pad, box[2] - pad, box[3] + pad

    def near(self, first=()):
        """Limits with the workpiece, its mirror images and the tools near them, those that are smaller as a whole, some where they began."""
        small = [o.points * sign for o in [*self.outlines, *first] for sign in [(1, 1), *self.mirrors] if np.ptp(o.points, axis=0).max() < self.size()]
        ends = [(p[:, 0].min(), p[:, 0].max(), p[:, 1].min(), p[:, 1].max()) for p in small if tools.closed(p)]
        return hull([fields.view_of(self.run, self.smooth.mesh, self.outlines), *ends])

    def zone(self):
        """Limits of where the values are large, None without any."""
        if self.levels is None:
            return None
        mesh = self.smooth.mesh
        some = self.smooth.values > ZONE * self.largest
        return maps.box_of(mesh.x[some], mesh.y[some], 0.15) if some.any() else None


def largest_of(listed, name):
    return max((np.nanmax(field.data[name], initial=0) for field in listed if name in field.data), default=0)


def scale_of(runs, listed, number, strain=True):
    """Quantity, unit, factor, largest value, levels for the fields of these runs: the plastic strain where there is some and it is wanted,
    else the stress. number: of the levels, about"""
    quantity = fields.STRAIN if strain and largest_of(listed, fields.STRAIN.name) > FEWEST else fields.STRESS
    top = max(listed, key=lambda field: largest_of([field], quantity.name))
    unit, factor = fields.unit_of(runs[0], quantity, top)
    largest = factor * largest_of(listed, quantity.name)
    return Scale(quantity, unit, factor, largest, fields.levels_to(largest, number, quantity))


def common_view(listed):
    """Limits for several Shown: of where the values are large, where that is small in the workpieces, else of all."""
    zones = [z for z in (shown.zone() for shown in listed) if z]
    whole, zone = hull([shown.whole() for shown in listed]), hull(zones) if zones else None
    small = zone and max(zone[1] - zone[0], zone[3] - zone[2]) <= SMALL * max(whole[1] - whole[0], whole[3] - whole[2])
    return zone if small else whole


def hull(boxes):
    return tuple(f(b[k] for b in boxes) for k, f in enumerate((min, max, min, max)))


def way_of(outlines, name, t):
    """Middles of a closed tool up to t; empty for others and where it does not go."""
    own = [o for o in outlines if o.name == name and o.t <= t * (1 + 1e-9)]
    if not own or not tools.closed(own[0].points):
        return np.empty((0, 2))
    return np.array([middle(o.points) for o in sorted(own, key=lambda o: o.t)])


def middle(points):
    """Centroid of a polygon."""
    x, y = points.T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    return np.array([((x + np.roll(x, -1)) * cross).sum(), ((y + np.roll(y, -1)) * cross).sum()]) / (3 * cross.sum())


def draw_tool(axes, shown, outline, areas, view):
    """A tool with its mirror images, each as far as the line of symmetry, filled where it is closed."""
    mesh, area, rim = shown.smooth.mesh, areas[outline.name], tools.rim_of(outline, areas, view)
    for sign in [(1, 1), *shown.mirrors]:
        part = tools.own_part(axes, fields.reflected(mesh, sign), shown.mirrors)
        drawn = axes.fill(*(area * sign).T, facecolor=tools.FACE, edgecolor="none", zorder=0.5)
        drawn += axes.plot(*(rim * sign).T, color=tools.RIM, linewidth=1.1, zorder=3.5)
        for artist in drawn if part else ():
            artist.set_clip_path(part, axes.transData)


def draw_ways(axes, shown):
    """Ways of the tools' middles, dashed, with where they began; handles for the key."""
    size, handles = np.ptp(axes.get_xlim()), []
    for way in [shown.way_in(name, size) for name in shown.ways]:
        if np.ptp(way, axis=0).max() < FAR * size:
            continue
        axes.plot(*way.T, color=ORANGE, linewidth=1.6, zorder=3.8)
        axes.plot(*way[0], color=ORANGE, marker="o", markersize=5, markerfacecolor="white", zorder=3.9)
        axes.annotate("", way[-1], way[-2], arrowprops={"arrowstyle": "-|>", "color": ORANGE, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 16},
                      zorder=3.9)
        handles = [Line2D([], [], color=ORANGE, linewidth=1.6, label="way of the tools" if len(shown.ways) > 1 else "way of the tool")]
    before = {outline.name: outline.points for outline in shown.first}
    for now in [o for o in shown.outlines if o.name in shown.seen and o.name in before]:
        if np.abs(middle(before[now.name]) - middle(now.points)).max() > FAR * size:
            axes.plot(*before[now.name].T, color=tools.RIM, linewidth=0.8, linestyle=GHOST, zorder=0.6)
            handles.append(Line2D([], [], color=tools.RIM, linewidth=0.8, linestyle=GHOST, label="where it began"))
    return list({h.get_label(): h for h in handles}.values())


def draw_body(axes, shown, thin):
    """Field, edges of the elements, outline, and the parts that symmetry leaves out. thin: width of the edges"""
    mesh = shown.smooth.mesh
    levels, colors = [-1.0, 1e300], [fields.BODY]
    if shown.levels is not None:      # below the first level the workpiece has its own color
        levels = [-1.0, *shown.levels]
        colors = [fields.BODY, *fields.band_colors(shown.quantity, shown.levels).colors]
    for sign in [(1, 1), *shown.mirrors]:
        other = mesh if sign == (1, 1) else fields.reflected(mesh, sign)
        axes.tricontourf(other, shown.smooth.values, levels=levels, colors=colors, zorder=1)
        axes.add_collection(LineCollection(shown.rim * sign, colors="black", linewidths=1.0, zorder=3), autolim=False)
    axes.add_collection(LineCollection(shown.smooth.edges, colors="black", linewidths=thin, alpha=0.4, zorder=1.5), autolim=False)


def draw_panel(axes, shown, box):
    """One view; returns the handles of the key."""
    maps.set_view(axes, box, shown.run.units.length_unit)
    axes.grid(False)
    view = max(box[1] - box[0], box[3] - box[2])
    areas = {o.name: tools.area_of(o.points, shown.smooth.mesh, 0.04 * view, shown.mirrors) for o in shown.outlines}
    for outline in shown.outlines:
        draw_tool(axes, shown, outline, areas, view)
    inches = axes.get_position().width * axes.figure.get_figwidth()
    part = shown.size() / (box[1] - box[0]) * inches / np.sqrt(len(shown.smooth.edges))
    draw_body(axes, shown, float(np.clip(2.0 * part, 0.08, 0.5)))
    handles = draw_ways(axes, shown)
    if shown.surface is not None and contact.touching(shown.surface).any():
        for sx, sy in [(1, 1), *shown.mirrors]:
            other = {**shown.surface, "x": sx * shown.surface["x"], "y": sy * shown.surface["y"]}
            mark = contact.mark_contact(axes, other, letters="", scale=shown.run.units.length)
        handles.append(mark)
    handles += maps.draw_symmetry(axes, shown.mirrors)
    return [Line2D([], [], color=tools.FACE, linewidth=7, label=tools.label_of(shown.outlines))] * bool(shown.outlines) + handles


def layout(whole, zone):
    """[(place in inches: left, bottom, width, height), ...] of the panels, and the height of the figure."""
    room, aspect = WIDTH - LEFT - RIGHT, (whole[1] - whole[0]) / (whole[3] - whole[2])
    if zone is None:
        height = float(np.clip(room / aspect, 1.6, 6.5))
        return [(LEFT, BELOW, room, height)], height + BELOW + ABOVE
    if aspect > 2.2:
        first, second = room / aspect, float(np.clip(room * (zone[3] - zone[2]) / (zone[1] - zone[0]), 2.0, 3.4))
        return [(LEFT, BELOW + second + BETWEEN, room, first), (LEFT, BELOW, room, second)], first + second + BETWEEN + BELOW + ABOVE
    room -= BETWEEN
    height = float(np.clip(0.45 * room / aspect, 2.6, 4.8))
    first = min(height * aspect, 0.6 * room)
    return [(LEFT, BELOW, first, height), (LEFT + first + BETWEEN, BELOW, room - first, height)], height + BELOW + ABOVE


def final_figure(run, now=None):
    """The end of the run, or another instant. now: its t and its field, as at_work has them"""
    surface = run.surface if now is None and run.has("surface.csv") else None
    shown = Shown(run, *(now or (run.t, run.field)), surface)
    whole, zone = shown.whole(), shown.zone()
    if zone and max(zone[1] - zone[0], zone[3] - zone[2]) > SMALL * max(whole[1] - whole[0], whole[3] - whole[2]):
        zone = None
    places, height = layout(whole, zone)
    figure = new_figure(height)
    handles = []
    for (left, low, wide, high), box in zip(places, (whole, zone)):
        axes = figure.add_axes((left / WIDTH, low / height, wide / WIDTH, high / height))
        box = fitted(box, wide / high)
        handles += draw_panel(axes, shown, box)
        if zone and axes is figure.axes[0]:
            near = fitted(zone, places[1][2] / places[1][3])
            axes.add_patch(Rectangle((near[0], near[2]), near[1] - near[0], near[3] - near[2], fill=False, edgecolor=BLUE, linewidth=1.2, zorder=5))
        elif zone:
            for side in axes.spines.values():
                side.set(color=BLUE, linewidth=1.2)
    add_words(figure, shown, list({handle.get_label(): handle for handle in handles}.values()), height)
    return figure


def frame_at_work(run):
    """Instant and file of the last frame in which as many tools touch as ever; None if none does."""
    history = run.history
    touching = sum((history[n] > 0).astype(int) for n in touch_columns(history))
    if not run.series or not touching.max() > 0:
        return None
    return max(run.series, key=lambda frame: (round(np.interp(frame[0], history["t"], touching)), frame[0]))


def at_work(run):
    """Instant and field of that frame, or of the end."""
    frame = frame_at_work(run)
    return (frame[0], run.read_field(frame[1])) if frame else (run.t, run.field)


def cropped(box, outlines):
    """Of a long scene the part about its tools."""
    x0, x1, y0, y1 = box
    if x1 - x0 < LONG * (y1 - y0):
        return box
    middles = [middle(o.points)[0] for o in outlines if tools.closed(o.points)] or [0.5 * (x0 + x1)]
    half = 0.5 * LONG * (y1 - y0)
    center = np.clip(np.mean(middles), x0 + half, x1 - half)
    return center - half, center + half, y0, y1


def share_of_zone(shown, box):
    """Area where the values are large over that of a view."""
    mesh = shown.smooth.mesh
    x, y, large = mesh.x[mesh.triangles], mesh.y[mesh.triangles], shown.smooth.values[mesh.triangles].mean(axis=1) > ZONE * shown.largest
    area = 0.5 * np.abs((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0]))
    return area[large].sum() * (1 + len(shown.mirrors)) / ((box[1] - box[0]) * (box[3] - box[2]))


def bare_figure(shown, box, first=()):
    """Workpiece and tools without words, in the size of the gallery. first: tools that are shown where they began, too"""
    shown.ways, shown.first = {}, first
    figure = new_figure(GALLERY[1] / 150, GALLERY[0] / 150)
    axes = figure.add_axes((0, 0, 1, 1))
    draw_panel(axes, shown, fitted(box, GALLERY[0] / GALLERY[1]))
    axes.set_axis_off()
    return figure


def gallery_figure(run):
    """The process at a look, with arrows of its drives, without words: all pictures of this kind have one size. Stress, not strain, where that is in zones too
    thin to be seen; who shows such a picture says so."""
    now = at_work(run)
    shown = Shown(run, *now)
    around = [arrow.tool for arrow in drives.arrows(run, shown.size()) if arrow.shape.kind == drives.AROUND]
    first = [o for o in shown.first if o.name in around and o.name in shown.seen]
    box = cropped(shown.near(first), shown.outlines)
    if shown.levels is not None and share_of_zone(shown, fitted(box, GALLERY[0] / GALLERY[1])) < THIN:
        shown = Shown(run, *now, scale=scale_of([run], [now[1]], fields.MOST_LEVELS, strain=False))
    figure = bare_figure(shown, box, first)
    arrows.draw_arrows(figure.axes[0], run, shown.outlines, shown.smooth.mesh, words=())
    return figure


def add_words(figure, shown, handles, height):
    """Title, key and scale."""
    label, when = shown.quantity.label, "" if shown.t is None else f" at t = {shown.t:.4g}"
    add_title(figure, f"{label[0].upper() + label[1:]}{when}, largest {amount(shown.largest, shown.unit)}")
    add_key(figure, handles)
    if shown.levels is not None:
        place = figure.axes[-1].get_position()
        add_scale(figure, shown.quantity, shown.levels, shown.unit, (BELOW + 0.05 * place.height * height, 0.9 * place.height * height))
