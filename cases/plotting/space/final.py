"""final.png of a run in space: workpiece with its field, tools and their tracks at the end, as plotting/final.py draws it in the plane."""
import numpy as np

from plotting import border
from plotting.space import scene
from plotting.space.arrows import draw_arrows
from plotting.units import amount, in_powers

SIZE = (1300, 1000)   # of what VTK draws, in pixels
ROOM = 0.16           # about the workpiece, over its size in the picture; some times that above it


def near(image, places, above=2):
    """Rows and columns of the image about the workpiece, places: those of its corners; large tools go on beyond."""
    (top, bottom), (left, right) = scene.window_of([image])
    places = places * (1, -1) + (0, image.shape[0])
    low, high = places.min(axis=0), places.max(axis=0)
    room = ROOM * (high - low).max()
    return ((int(max(top, low[1] - above * room)), int(min(bottom, high[1] + room))), (int(max(left, low[0] - room)), int(min(right, high[0] + room))))


def final_figure(run, k=-1):
    """k: number of the frame"""
    frame = run.view(k)
    scale = scene.scale_of(run, [frame])
    box = scene.box_of([frame])
    image, placed = scene.picture(run, frame, box, scale, SIZE)
    (top, bottom), (left, right) = window = near(image, placed.pixels(scene.corners(frame.body.points)))
    room = border.WIDTH - border.RIGHT - 0.3
    height = float(np.clip(room * (bottom - top) / (right - left), 2.5, 6.0))
    key = scene.key_of(run, frame)
    below = border.key_height(key) + 0.05
    whole = height + border.ABOVE + below
    figure = border.new_figure(whole)
    figure.shaded = True
    axes = figure.add_axes((0.3 / border.WIDTH, below / whole, room / border.WIDTH, height / whole))
    scene.show(axes, image, window)
    scene.label_edges(axes, run, frame, placed)
    label, values = scale.quantity.label, scene.values_of(frame, scale)
    unit = run.units.stress_unit if scale.quantity.stress else in_powers(int(round(-np.log10(scale.factor))), "-")
    border.add_title(figure, f"{label[0].upper() + label[1:]} at t = {frame.t:.4g}, largest {amount(values.max(), unit)}")
    border.add_key(figure, key)
    if scale.levels is not None:
        border.add_scale(figure, scale.quantity, scale.levels, unit, (below + 0.1 * height, 0.8 * height))
    return figure


def gallery_figure(run, shared=None):
    """The same with arrows of the drives in place of words, in the size of plotting/final.py's. shared: a scale of several runs, as of plotting/final.py's scale_of"""
    frame, (wide, high) = run.view(-1), border.GALLERY
    scale = scene.Scale(shared.quantity, "", shared.factor, shared.levels) if shared else scene.scale_of(run, [frame])
    image, placed = scene.picture(run, frame, scene.box_of([frame]), scale, (2 * wide, 2 * high))
    (top, bottom), (left, right) = near(image, placed.pixels(scene.corners(frame.body.points)), above=3)
    figure = border.new_figure(high / 150, wide / 150)
    figure.shaded = True
    axes = figure.add_axes((0, 0, 1, 1))
    left, right, top, bottom = border.fitted((left, right, top, bottom), wide / high)
    scene.show(axes, image, ((top, bottom), (left, right)))
    draw_arrows(axes, run, frame, placed)
    return figure
