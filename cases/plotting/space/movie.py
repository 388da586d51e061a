"""The movie of a run in space (-movie 1): movie.html, where it turns under the mouse, and movie.gif. Both are whole or not there."""
import os

import numpy as np
from PIL import Image, ImageDraw

from plotting.inputs import MissingInput
from plotting.movie import COLORS, gif, write_whole
from plotting.space import scene
from plotting.space.page import page

MOST = 30            # frames
SIZE = (700, 560)    # of the GIF


def frames_of(run):
    if len(run.frames) < 2:
        raise MissingInput(f"{run.folder}: fewer than two frames of fields, too few for a movie")
    chosen = np.unique(np.linspace(0, len(run.frames) - 1, min(MOST, len(run.frames))).round().astype(int))
    return [run.frame(k) for k in chosen]


def gif_frame(run, frame, box, look):
    image, _ = scene.picture(run, frame, box, *look, size=SIZE)
    drawn = Image.fromarray(image)
    ImageDraw.Draw(drawn).text((12, 10), f"t = {frame.t:.4g}", fill="black")
    return drawn.quantize(COLORS, dither=Image.Dither.NONE)


def write_movie(run, folder):
    """movie.html and movie.gif in the folder; returns their paths."""
    frames, quantity = frames_of(run), scene.quantity_of(run)
    unit, factor, levels = scene.scale_of(run, quantity, frames)
    if levels is None:
        raise MissingInput(f"{run.folder}: no {quantity.label} in any frame")
    values = [scene.values_of(frame, quantity, factor) for frame in frames]
    colors, limits = scene.bands(quantity, levels)
    above, name = os.path.split(os.path.abspath(folder))
    name = os.path.basename(above) if name == "out" else name
    box = scene.box_of(frames)
    html = page(name, frames, values, scene.Bands(colors, limits, levels, f"{quantity.label} [{unit}]"),
                scene.View(scene.eye_of(run), run.up, box, run.units.length_unit))
    pictures = [gif_frame(run, frame, box, (v, colors, limits)) for frame, v in zip(frames, values)]
    return [write_whole(os.path.join(folder, "movie.html"), html.encode()), write_whole(os.path.join(folder, "movie.gif"), gif(pictures))]
