"""final.png of a run in space: workpiece with its field, tools and their tracks at the end, as plotting/final.py draws it in the plane."""
import numpy as np

from plotting import border
from plotting.space import scene
from plotting.space.display import start_display
from plotting.units import amount, in_powers

SIZE = (1300, 1000)   # pixels of the view of all, of which a part is drawn
MARGIN = 45           # pixels about what is drawn
ROOM = 0.16           # about the workpiece, over its size in the picture; twice that above it


def near(drawn, places):
    """Rows and columns about the workpiece, places: pixels of its corners; large tools go on beyond. drawn: pixels of all points"""
    (left, top), (right, bottom) = drawn.min(axis=0) - MARGIN, drawn.max(axis=0) + MARGIN
    low, high = places.min(axis=0), places.max(axis=0)
    room = ROOM * (high - low).max()
    return (max(top, low[1] - 2 * room), min(bottom, high[1] + room)), (max(left, low[0] - room), min(right, high[0] + room))


def final_figure(run):
    start_display()  # while the files are read
    frame = run.view(-1)
    scale = scene.scale_of(run, [frame])
    box = scene.box_of([frame])
    stage, ends = scene.staged(run, frame, box, scale, SIZE), scene.corners(frame.body.points)
    (top, bottom), (left, right) = near(stage.pixels(np.vstack(stage.points)), stage.pixels(ends))
    room = border.WIDTH - border.RIGHT - 0.3
    height = float(np.clip(room * (bottom - top) / (right - left), 2.5, 6.0))
    key = scene.key_of(run)
    below = border.key_height(key) + 0.05
    whole = height + border.ABOVE + below
    figure = border.new_figure(whole)
    axes = figure.add_axes((0.3 / border.WIDTH, below / whole, room / border.WIDTH, height / whole))
    wide = 150 * min(room, height * (right - left) / (bottom - top))
    stage.narrow((top, bottom), (left, right), (round(wide), round(wide * (bottom - top) / (right - left))))
    axes.imshow(stage.image(), interpolation="nearest")
    axes.set_axis_off()
    scene.label_edges(axes, run, frame, stage.pixels(ends))
    label, values = scale.quantity.label, scene.values_of(frame, scale)
    unit = run.units.stress_unit if scale.quantity.stress else in_powers(int(round(-np.log10(scale.factor))), "-")
    border.add_title(figure, f"{label[0].upper() + label[1:]} at t = {frame.t:.4g}, largest {amount(values.max(), unit)}")
    border.add_key(figure, key)
    if scale.levels is not None:
        border.add_scale(figure, scale.quantity, scale.levels, unit, (below + 0.1 * height, 0.8 * height))
    return figure


def gallery_figure(run, shared=None):
    """The same without words, in the size of plotting/final.py's. shared: a scale of several runs, as of plotting/final.py's scale_of"""
    frame, (wide, high) = run.view(-1), border.GALLERY
    scale = scene.Scale(shared.quantity, "", shared.factor, shared.levels) if shared else scene.scale_of(run, [frame])
    stage = scene.staged(run, frame, scene.box_of([frame]), scale, (2 * wide, 2 * high))
    (top, bottom), (left, right) = near(stage.pixels(np.vstack(stage.points)), stage.pixels(scene.corners(frame.body.points)))
    figure = border.new_figure(border.WIDTH * high / wide)
    figure.set_dpi(wide / border.WIDTH)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.imshow(stage.image(), interpolation="antialiased")
    box = border.fitted((left, right, top, bottom), wide / high)
    axes.set(xlim=box[:2], ylim=box[:1:-1])
    axes.set_axis_off()
    return figure
