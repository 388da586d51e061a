"""The parts that planes of symmetry leave out (rcSymmetry), as arrays: what was computed comes first, what is reflected after it.

A plane goes through 0 across an axis; the computed part lies on the side `side`, 1 or -1, of it."""
import numpy as np

from plotting.space import grids

ON_PLANE = 1e-9   # of the size: nodes that have no image of their own
SAME = 1e-6       # of the size: a tool that is its own image
# Order of the nodes of a reflected cell, by their number: that keeps its orientation
TURNED = {3: [0, 2, 1], 4: [0, 2, 1, 3], 6: [0, 2, 1, 5, 4, 3], 10: [0, 2, 1, 3, 6, 5, 4, 7, 9, 8]}


def normal_of(axis, side):
    return side * np.eye(3)[axis]


def reflected(points, axis):
    """Also of vectors at the nodes."""
    return points * (1 - 2 * np.eye(3)[axis])


def doubled(points, cells, data, axis):
    """(points, cells, data) with their image; data: {name: n or n x components}, of which those with three are vectors."""
    own = np.abs(points[:, axis]) > ON_PLANE * np.ptp(points, axis=0).max()
    numbers = np.where(own, len(points) - 1 + np.cumsum(own), np.arange(len(points)))
    images = {name: reflected(values, axis) if values.shape[1:] == (3,) else values for name, values in data.items()}
    return (np.vstack([points, reflected(points[own], axis)]), np.vstack([cells, numbers[cells][:, TURNED[cells.shape[1]]]]),
            {name: np.concatenate([values, images[name][own]]) for name, values in data.items()})


def image_of_itself(points, axis):
    """Whether a tool's box lies on both sides alike."""
    low, high = points.min(axis=0), points.max(axis=0)
    return abs(low[axis] + high[axis]) <= SAME * (high - low).max()


def doubled_tools(points, triangles, cells, axis, side):
    """The same for tools, cells: {name: of the triangles}: as far as the plane, with their image; one that lies on both sides alike stays."""
    parts = []
    for number in np.unique(cells["tool"]):
        mine = cells["tool"] == number
        nodes, own = np.unique(triangles[mine], return_inverse=True)
        given, own, named = points[nodes], own.reshape(-1, 3), {name: values[mine] for name, values in cells.items()}
        if not image_of_itself(given, axis):
            given, own = grids.clipped_triangles(given, own, normal_of(axis, side))
            given, own, named = (np.vstack([given, reflected(given, axis)]), np.vstack([own, len(given) + own[:, TURNED[3]]]),
                                 {name: np.repeat(values[:1], 2 * len(own), axis=0) for name, values in named.items()})
        parts.append((given, own, named))
    firsts = np.cumsum([0] + [len(given) for given, _, _ in parts])
    return (np.vstack([given for given, _, _ in parts]), np.vstack([own + first for (_, own, _), first in zip(parts, firsts)]),
            {name: np.concatenate([named[name] for _, _, named in parts]) for name in cells})
