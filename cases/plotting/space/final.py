"""final.png of a run in space: workpiece with its field, tools and their tracks at the end, as plotting/final.py draws it in the plane."""
import numpy as np

from plotting import border
from plotting.space import scene
from plotting.space.arrows import draw_arrows
from plotting.space.display import start_display
from plotting.space.edge_labels import draw_labels, with_room
from plotting.units import amount

SIZE = (1300, 1000)   # pixels of the view of all, of which a part is drawn
FONT = 9              # of the words at the edges


def final_figure(run, k=-1):
    """k: number of the frame"""
    start_display()  # while the files are read
    frame = run.close_view(k)
    scale = scene.scale_of(run, [frame])
    stage = scene.staged(run, frame, scene.box_of([frame]), scale, SIZE)
    room = border.WIDTH - border.RIGHT - 0.3
    (left, right), (bottom, top) = window = with_room(run, [frame], [stage], scene.near(stage, frame.body), room, FONT)
    height = float(np.clip(room * (top - bottom) / (right - left), 2.5, 6.0))
    key = scene.key_of(run, frame)
    below = border.key_height(key) + 0.05
    whole = height + border.ABOVE + below
    figure = border.new_figure(whole)
    figure.shaded = True
    axes = figure.add_axes((0.3 / border.WIDTH, below / whole, room / border.WIDTH, height / whole))
    wide = 150 * min(room, height * (right - left) / (top - bottom))
    stage.narrow(*window, (round(wide), round(wide * (top - bottom) / (right - left))))
    scene.show(axes, stage.image())
    draw_labels(axes, run, frame, stage, FONT)
    label, values = scale.quantity.label, scene.values_of(frame, scale)
    unit = scene.unit_of(run, scale)
    border.add_title(figure, f"{label[0].upper() + label[1:]} at t = {frame.t:.4g}, largest {amount(values.max(), unit)}")
    border.add_key(figure, key)
    if scale.levels is not None:
        border.add_scale(figure, scale.quantity, scale.levels, unit, (below + 0.1 * height, 0.8 * height))
    return figure


def gallery_figure(run, shared=None):
    """The same with arrows of the drives in place of words, in the size of plotting/final.py's. shared: a scale of several runs, as of plotting/final.py's scale_of"""
    frame, (wide, high) = run.close_view(-1), border.GALLERY
    scale = scene.Scale(shared.quantity, "", shared.factor, shared.levels) if shared else scene.scale_of(run, [frame])
    stage = scene.staged(run, frame, scene.box_of([frame]), scale, (2 * wide, 2 * high))
    (left, right), (bottom, top) = scene.near(stage, frame.body, above=3)
    figure = border.new_figure(high / 150, wide / 150)
    figure.shaded = True
    axes = figure.add_axes((0, 0, 1, 1))
    left, right, bottom, top = border.fitted((left, right, bottom, top), wide / high)
    scene.show(axes, stage.image(), ((left, right), (bottom, top)))
    draw_arrows(axes, run, frame, stage)
    return figure
