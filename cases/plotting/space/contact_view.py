"""From where the contact of one tool is seen in a picture in a plane: along its own mean normal, where it is in the deformed workpiece."""
from collections import namedtuple

import numpy as np

from plotting.space import files
from plotting.space.run import AXES, unit

# axes: directions to the right and upward, 2 x 3; labels: theirs, without the unit; words: the direction of the view
ContactView = namedtuple("ContactView", "axes origin labels words")
ALIGNED = np.cos(np.radians(2))   # from which a direction is that of an axis
AROUND = 0.3                      # mean normal of a contact that goes around the workpiece, which has no side of its own
NAMED = 0.25                      # component of a direction, from which its axis is named
ON_PLANE = 1e-6                   # of the size: a contact that a plane of symmetry cuts


def nodes_of(run, surface, tool):
    """Which nodes touch the tool: of a contact beside a plane of symmetry those that were computed, of one that the plane cuts all."""
    mine = files.touching(surface) & (surface.data["tool"] == tool)
    for axis, side in run.symmetry:
        height = side * surface.points[:, axis]
        if mine.any() and np.abs(height[mine]).min() > ON_PLANE * np.ptp(surface.points, axis=0).max():
            mine &= height > 0
    return mine


def mean_normal(surface, mine):
    """Outward, weighted by the pressure; shorter than 1 as the normals differ, 0 without pressure."""
    normal = (surface.data["traction_tangential"] - surface.data["traction"])[mine]
    size = np.linalg.norm(normal, axis=1).sum()
    return normal.sum(axis=0) / size if size > 0 else np.zeros(3)


def middle_of(surface, mine):
    """Of the contact, weighted by the pressure."""
    weight = np.maximum(surface.data["pressure"][mine], 0)
    return np.average(surface.points[mine], axis=0, weights=weight if weight.sum() > 0 else None)


def axis_of(direction):
    """Number of the axis along a direction, None for one between them."""
    k = int(np.argmax(np.abs(direction)))
    return k if abs(direction[k]) > ALIGNED else None


def frame_of(run, normal):
    """Directions to the right and upward, across the normal: the way of the tools goes to the right or what is above upward; one is that of an axis
    if it can be."""
    level = abs(normal @ run.up) > 0.9
    first = int(np.argmax(np.abs(run.along if level else run.up)))
    exact = [axis for axis in range(3) if abs(normal[axis]) < np.sqrt(1 - ALIGNED**2)]
    swapped = bool(exact) and first not in exact
    one = np.eye(3)[exact[0] if swapped else first]
    one = unit(one - (one @ normal) * normal)
    other = np.cross(normal, one)
    other *= np.sign(other[np.argmax(np.abs(other))])      # numbers grow to the right and upward
    return np.array([one, other] if level != swapped else [other, one])


def words_of(direction):
    """An axis with its sign, or the axes between which a direction is, "+x and -z"."""
    return " and ".join(("+" if direction[k] > 0 else "-") + AXES[k] for k in np.argsort(-np.abs(direction)) if abs(direction[k]) > NAMED)


def view_of(run, surface, mine):
    normal = mean_normal(surface, mine)
    normal = unit(normal) if np.linalg.norm(normal) > AROUND else run.up
    axis = axis_of(normal)
    axes = frame_of(run, normal if axis is None else np.eye(3)[axis])
    between = [axis_of(direction) is None for direction in axes]      # lengths along these are from the middle of the contact
    middle = middle_of(surface, mine)
    origin = sum(((middle @ direction) * direction for direction in axes[between]), np.zeros(3))
    labels = ["from the middle of the contact toward " + words_of(direction) if far else AXES[axis_of(direction)] for direction, far in zip(axes, between)]
    exact = "along its normal ({:.2g}, {:.2g}, {:.2g})".format(*(normal.round(2) + 0.0))
    return ContactView(axes, origin, labels, exact if axis is None else f"along {AXES[axis]}")


def places_in(view, points):
    return (points - view.origin) @ view.axes.T
