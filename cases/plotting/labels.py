"""Numbers of logarithmic axes; words beside points that lie on no other word, point or curve where there is room."""
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

# from the point, y upward
WAYS = [(0, -1), (1, 0), (-1, 0), (0, 1), (-0.8, -0.8), (0.8, 0.8), (0.8, -0.8), (-0.8, 0.8)]
STEPS = (1.0, 1.9, 3.0, 4.2)   # how far, in the nearest distance
LETTER, GAP = 0.62, 1.5   # width over font size; between mark and label [points]
DARKER = 0.8              # than the curve, light letters are hard to read
ON_LABEL, ON_POINT, ON_CURVE, OUTSIDE, PER_STEP = 60.0, 6.0, 0.5, 500.0, 1.0
ROOM = 0.32               # of a number on an axis [inches]


def log_ticks(axis):
    """1, 2 and 5 of each decade where there is room, more within less than one; plain numbers. Set the limits before."""
    decades = np.ptp(np.log10(axis.get_view_interval()))
    window = axis.axes.get_window_extent()
    inches = (window.width if axis.axis_name == "x" else window.height) / axis.axes.figure.dpi
    some = (1, 2, 5) if inches > 3 * decades * ROOM else (1,)
    axis.set_major_locator(LogLocator(subs=(1, 1.5, 2, 3, 5, 7) if decades < 0.9 else some))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def obstacles(axes):
    """Points with a mark, and places on the curves every three pixels, k x 2 each [pixels]."""
    points, places = [np.empty((0, 2))], [np.empty((0, 2))]
    for line in axes.lines:
        path = line.get_transform().transform(np.column_stack(line.get_data()).astype(float))
        path = path[np.isfinite(path).all(axis=1)]
        if len(path) and line.get_marker() not in ("None", None, ""):
            points.append(path)
        for a, b in zip(path[:-1], path[1:]) if line.get_linestyle() != "None" else ():
            part = np.linspace(0, 1, 2 + int(np.hypot(*(b - a)) / 3))[:, None]
            places.append(a + part * (b - a))
    return np.vstack(points), np.vstack(places)


def inside(points, box, margin=0.0):
    return ((points > box[0] - margin) & (points < box[1] + margin)).all(axis=1)


def badness(box, points, places, frame, mark):
    """Of a label in the box, lower left and upper right corner, the other labels aside."""
    bad = OUTSIDE * ((box[0] < frame[0]).any() or (box[1] > frame[1]).any())
    return bad + ON_POINT * inside(points, box, mark).sum() + ON_CURVE * inside(places, box).sum()


def place_labels(axes, labels, fontsize=9, mark=5, **style):
    """labels: (x, y, text, color); mark: size of the marks in points. The axes must have their final place and limits:
    call figure.draw_without_rendering() before."""
    pixel = axes.figure.dpi / 72
    points, places = obstacles(axes)
    frame = axes.get_window_extent().get_points()
    at = axes.transData.transform([label[:2] for label in labels]) if labels else []
    halves = [0.5 * pixel * fontsize * np.array([LETTER * len(label[2]), 0.95]) for label in labels]
    ways = [step * np.array(way) for step in STEPS for way in WAYS]
    offsets = [[(half + pixel * (0.5 * mark + GAP)) * way for way in ways] for half in halves]
    costs = [[PER_STEP * step + 0.02 * k for step in STEPS for k in range(len(WAYS))] for _ in labels]
    boxes = [[np.array([p + d - half, p + d + half]) for d in mine] for p, half, mine in zip(at, halves, offsets)]
    costs = [[cost + badness(box, points, places, frame, 0.4 * pixel * mark) for cost, box in zip(c, b)]
             for c, b in zip(costs, boxes)]
    chosen = settled(boxes, costs)
    for label, p, mine, k in zip(labels, at, offsets, chosen):
        place = axes.transData.inverted().transform(p + mine[k])
        axes.text(*place, label[2], fontsize=fontsize, ha="center", va="center",
                  color=[DARKER * c for c in to_rgb(label[3])], **style)


def settled(boxes, costs, rounds=6):
    """The choice of each label; again and again the cheapest beside those of the others."""
    chosen = [int(np.argmin(cost)) for cost in costs]
    for _ in range(rounds):
        before = list(chosen)
        for i, (mine, cost) in enumerate(zip(boxes, costs)):
            others = np.array([boxes[j][chosen[j]] for j in range(len(boxes)) if j != i])
            total = list(cost)
            for k, box in enumerate(mine if len(others) else ()):
                total[k] += ON_LABEL * ((box[0] < others[:, 1] + 1) & (others[:, 0] < box[1] + 1)).all(axis=1).sum()
            chosen[i] = int(np.argmin(total))
        if chosen == before:
            break
    return chosen
