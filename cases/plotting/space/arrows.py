"""Arrows of what the program prescribes, over a picture in space: plotting/drives.py finds them, plotting/arrows.py places them, here they are projected."""
import numpy as np
from matplotlib.path import Path

from plotting import arrows, drives, maps
from plotting.space import files
from plotting.space.run import unit

LEAST = 0.4                    # of a straight arrow that points to the viewer or away
OPEN = np.radians(np.linspace(-140, 140, 40))   # of a turn, from what of it faces the viewer
ROUND = 1.3                    # its radius over that in the plane
CELL = 0.012                   # of the view: size of the cells that the workpiece covers
MOST_POINTS = 3000             # of a tool
WORDS = 3                      # weight of a place of words over that of the workpiece
INNER = np.array([(i, j, 6 - i - j) for i in range(7) for j in range(7 - i)]) / 6    # points of a triangle


def hull(points):
    """What a tool covers in the picture, taken as convex: the outline, from left to right below and back above."""
    outline, ordered = [], np.unique(points, axis=0)
    for way in (ordered, ordered[::-1]):
        half = []
        for x, y in way:
            while len(half) > 1 and ((half[-1][0] - half[-2][0]) * (y - half[-2][1]) <= (half[-1][1] - half[-2][1]) * (x - half[-2][0])):
                half.pop()
            half.append((x, y))
        outline += half[:-1]
    return Path(outline + outline[:1])


def projected(shape, eye, up):
    """The shape in the plane of the picture."""
    right = unit(np.cross(up, eye))
    screen = np.column_stack([right, unit(np.cross(eye, right))])
    if shape.kind == drives.STRAIGHT:
        direction = shape.points @ screen
        return shape._replace(points=direction * max(1.0, LEAST / max(np.linalg.norm(direction), 1e-9)))
    front = eye - (eye @ shape.points) * shape.points
    front = unit(front if np.linalg.norm(front) > 0.05 * np.linalg.norm(eye) else np.cross(shape.points, right))
    around = np.outer(np.cos(OPEN), front) + np.outer(np.sin(OPEN), np.cross(shape.points, front))
    return shape._replace(points=ROUND * around @ screen)


def without_image(run, points):
    """Of a tool beside a plane of symmetry what was computed; one that the plane cuts is whole."""
    for axis, side in run.symmetry:
        height = side * points[:, axis]
        if np.abs(height).min() > 1e-6 * np.ptp(points):
            points = points[height > 0]
    return points


def seen_tools(run, frame, scene, grid):
    """{tool: its middle in the view and what it covers}"""
    seen = {}
    for number, points, _, _ in files.tool_parts(frame.tools):
        points = without_image(run, points)
        places = scene.pixels(points[:: len(points) // MOST_POINTS + 1])
        region = hull(places)
        inside = grid[region.contains_points(grid)]
        inside = inside if len(inside) else places[maps.inside(places, np.column_stack([grid.min(axis=0), grid.max(axis=0)]).ravel())]   # a small one
        if len(inside):
            seen[run.tool_name(number)] = inside.mean(axis=0), region
    return seen


def covered(axes, frame, scene, size, up):
    """Middles of the cells of the view that show the workpiece; where it goes on beyond all sides of the view, all that is not above the tools."""
    low, high = np.column_stack([sorted(axes.get_xlim()), sorted(axes.get_ylim())])
    places, triangles = scene.pixels(frame.body.points), files.triangles_of(frame.body.faces)
    if (places.min(axis=0) < low).all() and (places.max(axis=0) > high).all():
        tools = frame.tools.points
        above = unit(np.diff(scene.pixels(tools[0] + np.outer([0, 1e-3 * np.ptp(tools)], up)), axis=0)[0])
        view = np.stack(np.meshgrid(*(np.arange(a, b, CELL * size) for a, b in zip(low, high))), axis=-1).reshape(-1, 2)
        return view[view @ above < (scene.pixels(tools) @ above).max()]
    cells = np.floor(np.einsum("kc,tcx->tkx", INNER, places[triangles]).reshape(-1, 2) / (CELL * size))
    return CELL * size * (0.5 + np.unique(cells, axis=0))


def draw_arrows(axes, run, frame, scene, words=("motion", "force"), taken=np.empty((0, 2))):
    """All arrows of a run into axes with their limits set and the picture of this frame; handles for the key. taken: places of words, which no arrow
    may cover"""
    size = max(np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim()))
    length = np.ptp(np.vstack([frame.body.points.min(axis=0), frame.body.points.max(axis=0)]), axis=0).max()
    found = [arrow._replace(shape=projected(arrow.shape, scene.eye, run.up)) for arrow in drives.arrows(run, length)]
    return arrows.put(axes, run, found, seen_tools(run, frame, scene, arrows.grid_of(axes)),
                      np.vstack([covered(axes, frame, scene, size, run.up), np.repeat(taken, WORDS, axis=0)]), words)
