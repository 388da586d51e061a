"""Nodal fields on the deformed workpiece: outline, isolines with numbers, filled bands, marks."""
import numpy as np
from matplotlib import colormaps
from matplotlib import patheffects
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.path import Path
from matplotlib.tri import Triangulation

from plotting.figure import GRAY, MM, MPA

WHITE_EDGE = [patheffects.withStroke(linewidth=3, foreground="white")]


def deformed(field, scale=MM):
    """Triangulation of the deformed workpiece; scale: from the file's unit of length to that of the picture."""
    place = scale * (field.points + field.data["displacement"][:, :2])
    bad = ~np.isfinite(place).all(axis=1)
    return Triangulation(*np.where(bad[:, None], 0, place).T, field.triangles,
                         mask=bad[field.triangles].any(axis=1) if bad.any() else None)


def drawable(mesh, values):
    """The mesh without triangles that have a value which is not finite, and values without such ones."""
    bad = ~np.isfinite(values)
    if not bad.any():
        return mesh, values
    hidden = bad[mesh.triangles].any(axis=1)
    if mesh.mask is not None:
        hidden = hidden | mesh.mask
    return Triangulation(mesh.x, mesh.y, mesh.triangles, mask=hidden), np.where(bad, 0, values)


def rim_edges(mesh):
    """Ends of the edges that belong to one triangle only, k x 2 x 2."""
    triangles = mesh.get_masked_triangles()
    edges = np.sort(np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, count = np.unique(edges, axis=0, return_counts=True)
    rim = edges[count == 1]
    return np.stack([mesh.x[rim], mesh.y[rim]], axis=-1)


def draw_outline(axes, mesh, width=1.0):
    axes.add_collection(LineCollection(rim_edges(mesh), colors="black", linewidths=width, zorder=3))


def box_of(x, y, margin, aspect=None):
    """Limits (x0, x1, y0, y1) round the points; margin as part of the larger side; aspect: least width over height
    and its largest value, reached by widening the shorter side; the top stays when the height grows."""
    x0, x1, y0, y1 = np.min(x), np.max(x), np.min(y), np.max(y)
    pad = margin * max(x1 - x0, y1 - y0)
    x0, x1, y0, y1 = x0 - pad, x1 + pad, y0 - pad, y1 + pad
    if aspect:
        short = aspect[0] * (y1 - y0) - (x1 - x0)
        x0, x1 = (x0 - short / 2, x1 + short / 2) if short > 0 else (x0, x1)
        y0 = min(y0, y1 - (x1 - x0) / aspect[1])
    return x0, x1, y0, y1


def set_view(axes, box, unit="mm"):
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlim(box[:2])
    axes.set_ylim(box[2:])
    axes.set_xlabel(f"x [{unit}]")
    axes.set_ylabel(f"y [{unit}]")


def draw_symmetry(axes, mirrors, label="symmetry"):
    """The lines of symmetry, mirrors: Run.mirrors; handles for the key."""
    drawn = [line(0, color=GRAY, linewidth=0.9, linestyle="-.", zorder=3.2) for k, line in enumerate((axes.axvline, axes.axhline))
             if any(sign[k] < 0 for sign in mirrors)]
    return [Line2D([], [], color=GRAY, linewidth=0.9, linestyle="-.", label=label)] * bool(drawn)


def inside(points, box, part=0.0):
    """Which points lie in the box, shrunk by a part of its sides."""
    dx, dy = part * (box[1] - box[0]), part * (box[3] - box[2])
    return ((points[:, 0] > box[0] + dx) & (points[:, 0] < box[1] - dx)
            & (points[:, 1] > box[2] + dy) & (points[:, 1] < box[3] - dy))


def length(path):
    return np.hypot(*np.diff(path, axis=0).T).sum()


def refined(path, step):
    """The path with points not farther apart than step."""
    at = np.r_[0, np.cumsum(np.hypot(*np.diff(path, axis=0).T))]
    new = np.linspace(0, at[-1], max(2, int(at[-1] / step) + 1))
    return np.column_stack([np.interp(new, at, path[:, k]) for k in (0, 1)])


def distance(points, others):
    """From each point to the nearest of the others."""
    if not len(others):
        return np.full(len(points), np.inf)
    return np.sqrt(((points[:, None, :] - others[None, :, :]) ** 2).sum(axis=2).min(axis=1))


def label_places(paths, others, box, most=3):
    """Where to number an isoline: on its longest paths, far from other lines (others), from the edge of the view and
    from each other."""
    width = box[1] - box[0]
    places = np.empty((0, 2))
    for path in sorted(paths, key=length, reverse=True)[:most]:
        points = refined(path, 0.01 * width)
        points = points[inside(points, box, 0.04)]
        if len(points) < (3 if not len(places) else 20):
            continue
        room = np.minimum(distance(points, others), 0.5 * distance(points, places))
        middle = np.abs(np.arange(len(points)) - len(points) / 2) / len(points)
        best = np.argmax(np.minimum(room, 0.06 * width) - 0.02 * width * middle)
        if room[best] > 0.012 * width or not len(places):
            places = np.vstack([places, points[best]])
    return places


def number_isolines(axes, paths, rim, box, colors):
    """Numbers 1, 2, ... on the isolines; paths: a list of polygons for each level; rim: edges to keep away from."""
    step = 0.01 * (box[1] - box[0])
    cloud = [[refined(p, step) for p in level if len(p) > 1] for level in paths]
    cloud = [np.vstack(level) if level else np.empty((0, 2)) for level in cloud]
    taken = np.vstack([refined(edge, step) for edge in rim])
    taken = taken[inside(taken, box)]
    for i, level in enumerate(paths):
        others = np.vstack([taken] + [c[inside(c, box)] for k, c in enumerate(cloud) if k != i])
        for place in label_places([p for p in level if len(p) > 1], others, box):
            axes.text(*place, str(i + 1), color=colors[i], fontweight="bold", fontsize=12, ha="center", va="center",
                      path_effects=WHITE_EDGE, zorder=6, clip_on=True)
            taken = np.vstack([taken, place])


def drop_fragments(lines, least):
    """Takes pieces of isolines away that are shorter than least: at rims the mesh cuts them off where they run along it."""
    for collection in lines.collections if lines else []:
        paths = [part for path in collection.get_paths() for part in path.to_polygons(closed_only=False)]
        collection.set_paths([Path(part) for part in paths if length(part) >= least])


def draw_isolines(axes, mesh, values, levels, box):
    """Numbered isolines; returns one handle a level for the key, which says when a level is not reached."""
    colors = [colormaps["plasma"](c) for c in np.linspace(0, 0.78, len(levels))]
    mesh, values = drawable(mesh, values)
    lines = axes.tricontour(mesh, values, levels=levels, colors=colors, linewidths=1.4, zorder=2) \
        if values.min() < max(levels) and values.max() > min(levels) else None
    least = 0.02 * (box[1] - box[0])
    paths = [[part for part in level if length(part) >= least] for level in lines.allsegs] if lines else [[] for _ in levels]
    drop_fragments(lines, least)
    number_isolines(axes, paths, rim_edges(mesh), box, colors)
    handles = []
    for i, level in enumerate(levels):
        note = "" if len(paths[i]) else " (not reached)" if values.max() < level else \
            " (exceeded everywhere)" if values.min() > level else " (in spots only)"
        handles.append(Line2D([], [], color=colors[i], label=f"{i + 1}:  {MPA * level:.4g} MPa{note}"))
    return handles


def draw_bands(axes, mesh, values, levels, cmap="viridis_r"):
    """Filled bands between the levels; nothing below the first one."""
    mesh, values = drawable(mesh, values)
    return axes.tricontourf(mesh, values, levels=levels, cmap=cmap, zorder=1)


def draw_circle_near(axes, center, radius, place, reach):
    """Thin arc of the tool's circle, reach to both sides of a place [mm]; returns the handle for the key."""
    angle = np.arctan2(*(np.asarray(place) - center)[::-1]) + np.linspace(-1, 1, 201) * min(np.pi, reach / radius)
    line, = axes.plot(center[0] + radius * np.cos(angle), center[1] + radius * np.sin(angle), color=GRAY,
                      linewidth=0.9, linestyle=(0, (6, 2)), zorder=3, label="roller")
    return line
