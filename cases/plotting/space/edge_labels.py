"""What the edges of a workpiece in space measure, in words along them: where the words are, what they cover, room for them in a view."""
from collections import namedtuple

import numpy as np

# text; its middle [pixels]; turn [degrees]; points that it covers, k x 2 [pixels]
EdgeLabel = namedtuple("EdgeLabel", "text place turn covers")
DPI = 150
AWAY, LETTER, HIGH = 14.0, 0.56, 1.3   # from the edge [points]; width of a letter, height of a line, over the font size


def corners(points):
    """Of their box, 8 x 3: bit a of the number is the end along axis a."""
    ends = np.array([points.min(axis=0), points.max(axis=0)])
    return np.array([[ends[k >> axis & 1, axis] for axis in range(3)] for k in range(8)])


def edges_of(run, ends, places, eye):
    """(axis, number of the corner that it has in common with others, number of its other one): those below, and the outermost upward one at the left."""
    nearest = int(np.argmax(ends @ (1e-2 * eye - run.up)))  # of the corners below
    for axis in range(3):
        first = nearest
        if abs(run.up[axis]) > 0.5:
            first = int(np.argmin(places[:, 0] - 1e-3 * places[:, 1]))
            other = first ^ 1 << axis
            first, other = (first, other) if places[first, 1] < places[other, 1] else (other, first)   # the lower one
            yield axis, first, other
        else:
            yield axis, first, first ^ 1 << axis


def edge_labels(run, frame, scene, point, font):
    """point: of the picture [pixels]. Words longer than their edge go on beyond its far end, so that none lie on those of another edge."""
    ends, found = corners(frame.body.points), []
    places, size = scene.pixels(ends), np.ptp(ends, axis=0).max()
    for axis, first, last in edges_of(run, ends, places, scene.eye):
        a, b = places[first], places[last]
        if not ((0.5 * (a + b) > 0) & (0.5 * (a + b) < scene.size)).all():       # of a workpiece that goes on beyond the view
            continue
        way = (b - a) / np.hypot(*(b - a))
        out = np.array([-way[1], way[0]])
        out *= np.sign(out @ (0.5 * (a + b) - places.mean(axis=0)))
        low, high = (end if abs(end) > 1e-4 * size else 0.0 for end in (ends[:, axis].min(), ends[:, axis].max()))
        text = f"{'xyz'[axis]}: {low:.3g} to {high:.3g} [{run.units.length_unit}]"
        half = 0.5 * LETTER * font * point * len(text.replace("$", "").replace("\\mu", "u"))
        middle = a + max(0.5 * np.hypot(*(b - a)), half) * way + AWAY * point * out
        s, t = np.meshgrid(np.linspace(-half, half, 21), 0.5 * HIGH * font * point * np.array([-1, 0, 1]))
        right = way if (way[0], way[1]) > (0, 0) else -way
        found.append(EdgeLabel(text, middle, np.degrees(np.arctan2(*right[::-1])), middle + np.outer(s.ravel(), way) + np.outer(t.ravel(), out)))
    return found


def with_room(run, frames, stages, window, wide, font):
    """The window, columns and rows of the views, widened so that the words of all are seen in a picture that is `wide` inches wide."""
    for _ in range(4):       # what is seen becomes smaller, the words do not
        point = (window[0][1] - window[0][0]) / (72 * wide)
        covers = [label.covers for frame, stage in zip(frames, stages) for label in edge_labels(run, frame, stage, point, font)]
        if not covers:
            break
        covers = np.vstack(covers)
        low, high = covers.min(axis=0) - 2 * point, covers.max(axis=0) + 2 * point
        window = tuple((min(first, low[k]), max(last, high[k])) for k, (first, last) in enumerate(window))
    return window


def draw_labels(axes, run, frame, scene, font=9):
    """Into axes with a picture of 150 dots an inch; returns what they cover."""
    labels = edge_labels(run, frame, scene, DPI / 72, font)
    for label in labels:
        axes.text(*label.place, label.text, ha="center", va="center", rotation=label.turn, rotation_mode="anchor", fontsize=font)
    return np.vstack([np.empty((0, 2)), *(label.covers for label in labels)])
