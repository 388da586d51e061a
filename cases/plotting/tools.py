"""Outlines of the tools from tools.csv (tool, name, t, x, y): reading, choosing a time, drawing over a map."""
from collections import namedtuple

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.path import Path

from plotting import maps
from plotting.inputs import read_table
from plotting.units import plain

FACE, RIM = "#c9d0d8", "#4d5a68"
LEVEL = 0.05     # of the size: ends of an outline at one height or on a line of symmetry
STEP = 2e-3      # of the view, between the points of an outline that another tool hides

Outline = namedtuple("Outline", "name t points")  # points: n x 2, in the length unit of the pictures


def read_tools(path, scale):
    """All outlines of the file; scale: from its length unit to that of the pictures."""
    table = read_table(path, ("tool", "t", "x", "y"), ("name",), rows=0)
    points = scale * np.column_stack([table["x"], table["y"]])
    border = np.flatnonzero((np.diff(table["tool"]) != 0) | (np.diff(table["t"]) != 0)) + 1
    blocks = [b for b in np.split(np.arange(len(points)), border) if len(b)]
    return [Outline(str(table["name"][b[0]]), table["t"][b[0]], points[b]) for b in blocks]


def at_time(outlines, t):
    """Of each tool the outline nearest to t."""
    best = {}
    for outline in outlines:
        if outline.name not in best or abs(outline.t - t) < abs(best[outline.name].t - t):
            best[outline.name] = outline
    return list(best.values())


def own_side(outlines, mesh, mirrors):
    """Those of which something lies where the workpiece was computed: one that is drawn back through a line of symmetry is its mirror image's."""
    for k, places in enumerate((mesh.x, mesh.y)):
        if any(sign[k] < 0 for sign in mirrors):
            side = np.sign(places.mean())
            outlines = [o for o in outlines if (side * o.points[:, k]).max() > 1e-6 * np.ptp(o.points)]
    return outlines


def closed(points):
    size = np.ptp(points, axis=0).max()
    return len(points) > 3 and np.hypot(*(points[0] - points[-1])) < 1e-3 * size


def encloses(points, mesh):
    """Whether most of the workpiece lies within a closed outline: the tool is what is outside of it."""
    corners = np.column_stack([mesh.x, mesh.y])
    return Path(points).contains_points(corners).mean() > 0.5


def side_of_body(points, mesh):
    """+1: the workpiece lies to the left of the outline's travel, judged where it is nearest, -1: to the right."""
    middles, along = 0.5 * (points[1:] + points[:-1]), np.diff(points, axis=0)
    corners = np.column_stack([mesh.x, mesh.y])
    corners = corners[::max(1, len(corners) // 2000)]
    square = ((corners[:, None, :] - middles[None, :, :]) ** 2).sum(axis=2)
    corner, k = np.unravel_index(np.argmin(square), square.shape)
    off = corners[np.argsort(square[:, k])[:50]].mean(axis=0) - middles[k]  # one may lie just inside the tool
    return 1.0 if along[k, 0] * off[1] - along[k, 1] * off[0] > 0 else -1.0


def band(points, side, width):
    """Polygon along the outline, width to the side away from the body."""
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.hypot(*along.T), 1e-300)[:, None]
    return np.vstack([points, (points + side * width * np.column_stack([along[:, 1], -along[:, 0]]))[::-1]])


def closing(points, mirrors):
    """What closes an open outline: the straight line between ends beside or above one another, of one that begins on a line of symmetry the
    corner on that line beside its other end; None where neither is."""
    off, room = points[-1] - points[0], LEVEL * np.ptp(points, axis=0).max()
    for k in (0, 1):
        for end, other in ((points[0], points[-1]), (points[-1], points[0])):
            if any(sign[k] < 0 for sign in mirrors) and abs(end[k]) < room:
                return np.where(np.arange(2) == k, end, other)[None]
    return np.empty((0, 2)) if np.abs(off).min() < room else None


def as_far_as(points, mesh, mirrors):
    """An outline as far as the lines of symmetry, on which it goes on."""
    for k, places in enumerate((mesh.x, mesh.y)):
        if any(sign[k] < 0 for sign in mirrors):
            side = np.sign(places.mean())
            points = np.where(np.arange(2) == k, side * np.maximum(side * points, 0), points)
    return points


def area_of(points, mesh, width, mirrors=()):
    """Polygon of a tool: within a closed outline or a punch that goes on beyond what is known of it, else a band beside the outline. A workpiece in a
    closed outline is within the tool. mirrors: Run.mirrors"""
    inside = encloses(points, mesh)
    if closed(points) and not inside:
        return points
    side, own = side_of_body(points, mesh), as_far_as(points, mesh, mirrors)
    rest = None if inside else closing(own, mirrors)
    if rest is not None:
        whole = np.vstack([own, rest])
        ahead = np.roll(whole, -1, axis=0)
        area = 0.5 * side * (whole[:, 0] * ahead[:, 1] - whole[:, 1] * ahead[:, 0]).sum()
        if area < -LEVEL * np.ptp(points, axis=0).max() ** 2:    # the workpiece is on the other side
            return whole
    return band(points, side, width)


def rim_of(outline, areas, view):
    """The outline as it is seen: not where it lies within a smaller tool, as that of a holder behind a punch. areas: {outline's name: its area}"""
    size = np.ptp(outline.points, axis=0).max()
    over = [area for name, area in areas.items() if name != outline.name and np.ptp(area, axis=0).max() < size]
    if not any(Path(area).contains_points(outline.points).any() or Path(outline.points).contains_points(area).any() for area in over):
        return outline.points
    points = maps.refined(outline.points, STEP * view)
    hidden = np.any([Path(area).contains_points(points) for area in over], axis=0)
    return np.where(hidden[:, None], np.nan, points)


def widened(box, outlines, part=0.3):
    """Limits that show the tools too, but not more than a part of the larger side beyond each side of the box; a third
    of that for open outlines, which go on anyway."""
    x0, x1, y0, y1 = box
    for outline in outlines:
        room = (part if closed(outline.points) else part / 3) * max(box[1] - box[0], box[3] - box[2])
        low, high = np.nanmin(outline.points, axis=0), np.nanmax(outline.points, axis=0)
        x0, y0 = min(x0, max(low[0], box[0] - room)), min(y0, max(low[1], box[2] - room))
        x1, y1 = max(x1, min(high[0], box[1] + room)), max(y1, min(high[1], box[3] + room))
    pad = 0.02 * max(x1 - x0, y1 - y0)
    return x0 - pad, x1 + pad, y0 - pad, y1 + pad


def own_part(axes, mesh, mirrors):
    """The part of the view that is this mesh's own, where symmetry leaves out the others; None without symmetry."""
    if not mirrors:
        return None
    limits = [sorted(axes.get_xlim()), sorted(axes.get_ylim())]
    for k, places in enumerate((mesh.x, mesh.y)):
        if any(sign[k] < 0 for sign in mirrors):
            limits[k][0 if places.mean() > 0 else 1] = 0
    (x0, x1), (y0, y1) = limits
    return Path([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)])


def label_of(outlines):
    """What the key says of the tools."""
    names = list(dict.fromkeys(outline.name for outline in outlines))
    return plain(names[0]) if len(names) == 1 else "tools: " + plain(", ".join(names)) if len(names) < 4 else "tools"


def draw_tools(axes, outlines, mesh, names=True, mirrors=()):
    """Outlines, filled where they are closed and do not enclose the workpiece, otherwise with a band on the tool's
    side; set the view before. A tool ends where its mirror image (mirrors: Run.mirrors) begins. Returns handles for the
    key."""
    view, outlines = max(np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())), own_side(outlines, mesh, mirrors)
    part, areas = own_part(axes, mesh, mirrors), {o.name: area_of(o.points, mesh, 0.03 * view, mirrors) for o in outlines}
    for outline in outlines:
        drawn = axes.fill(*areas[outline.name].T, facecolor=FACE, edgecolor="none", zorder=0.5)
        drawn += axes.plot(*rim_of(outline, areas, view).T, color=RIM, linewidth=1.2, zorder=3.5)
        for artist in drawn if part else ():
            artist.set_clip_path(part, axes.transData)
            artist.set_in_layout(False)  # matplotlib 3.6 fails where the view and this part share nothing of it
    if not outlines or not names:
        return []
    return [Line2D([], [], color=FACE, linewidth=7, label=label_of(outlines))]
