"""Quadratic fields on the deformed workpiece, drawn as smooth as they are: elements are divided, by their own shape functions."""
from collections import namedtuple

import numpy as np
from matplotlib.tri import Triangulation

MOST = 60000   # triangles that are drawn
FINEST = 6     # parts of an edge

# mesh: Triangulation of the divided elements; values at its points; edges: of the elements, n x (parts + 1) x 2
Smooth = namedtuple("Smooth", "mesh values edges")


def elements_of(triangles):
    """Nodes of the elements, n x 3, or n x 6 of quadratic ones: corners, then the nodes between 0 and 1, 1 and 2, 2 and 0. Of quadratic ones
    the file has the four triangles between their nodes, see workpiece_file.cpp."""
    if len(triangles) % 4:
        return triangles
    first, second, third, middle = (triangles[k::4] for k in range(4))
    corners = np.column_stack([first[:, 0], second[:, 1], third[:, 2]])
    between = np.column_stack([first[:, 1], second[:, 2], first[:, 2]])
    if not (middle == between[:, [1, 2, 0]]).all():
        return triangles
    return np.hstack([corners, between])


def shapes(kind, points):
    """Shape functions of a linear (3) or quadratic (6) triangle at barycentric points n x 3."""
    a, b, c = points.T
    if kind == 3:
        return points
    return np.column_stack([a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a])


def lattice(parts):
    """Barycentric points of a triangle whose edges have so many parts, and its small triangles."""
    number, points = {}, []
    for i in range(parts + 1):
        for j in range(parts + 1 - i):
            number[i, j] = len(points)
            points.append(((parts - i - j) / parts, i / parts, j / parts))
    cells = [(number[i, j], number[i + 1, j], number[i, j + 1]) for i, j in number if i + j < parts]
    cells += [(number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]) for i, j in number if i + j < parts - 1]
    return np.array(points), np.array(cells)


def edge_lines(elements, places, parts):
    """Each edge of the elements once, as a line of points."""
    kind, ends = elements.shape[1], elements[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    _, chosen = np.unique(np.sort(ends, axis=1), axis=0, return_index=True)
    if kind == 3:
        return places[ends[chosen]]
    middle, s = elements[:, 3:].reshape(-1)[chosen], np.linspace(0, 1, parts + 1)
    weights = np.column_stack([(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)])
    return np.einsum("pk,ekd->epd", weights, places[np.column_stack([ends[chosen], middle])])


def smooth(field, values, scale):
    """The field's elements in their deformed places times scale, divided as finely as MOST allows; values at the nodes, which are not
    exceeded: a quadratic function may swing beyond them where its nodes are far apart."""
    places = scale * (field.points + field.data["displacement"][:, :2])
    elements = elements_of(field.triangles)
    good = np.isfinite(places[elements]).all(axis=(1, 2)) & np.isfinite(values[elements]).all(axis=1)
    elements = elements[good]
    parts = 1 if elements.shape[1] == 3 else int(np.clip(np.sqrt(MOST / max(1, len(elements))), 2, FINEST))
    points, cells = lattice(parts)
    weights = shapes(elements.shape[1], points)
    low, high = values[elements].min(axis=1), values[elements].max(axis=1)
    found = np.clip(values[elements] @ weights.T, low[:, None], high[:, None])
    drawn = np.einsum("pk,ekd->epd", weights, places[elements]).reshape(-1, 2)
    undeformed = np.einsum("pk,ekd->epd", weights, field.points[elements]).reshape(-1, 2)
    size = np.ptp(field.points, axis=0).max()
    keys = np.round(undeformed / (1e-7 * size)).astype(np.int64)  # points on common edges are one, else the bands part there
    _, first, number = np.unique(keys[:, 0] * (1 << 31) + keys[:, 1], return_index=True, return_inverse=True)
    triangles = number.reshape(len(elements), -1)[:, cells].reshape(-1, 3)
    return Smooth(Triangulation(*drawn[first].T, triangles), found.reshape(-1)[first], edge_lines(elements, places, 2 * parts))
