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
    return [run.view(k) for k in chosen]


def gif_frame(run, frame, box, scale):
    drawn = Image.fromarray(scene.picture(run, frame, box, scale, SIZE)[0])
    ImageDraw.Draw(drawn).text((12, 10), f"t = {frame.t:.4g}", fill="black")
    return drawn.quantize(COLORS, dither=Image.Dither.NONE)


def write_movie(run, folder):
    """movie.html and movie.gif in the folder; returns their paths."""
    frames = frames_of(run)
    scale, box = scene.scale_of(run, frames), scene.box_of(frames)
    if scale.levels is None:
        raise MissingInput(f"{run.folder}: no {scale.quantity.label} in any frame")
    above, name = os.path.split(os.path.abspath(folder))
    name = os.path.basename(above) if name == "out" else name
    html = page(name, frames, scale, scene.View(scene.eye_of(run), run.up, box, run.units.length_unit))
    pictures = [gif_frame(run, frame, box, scale) for frame in frames]
    return [write_whole(os.path.join(folder, "movie.html"), html.encode()), write_whole(os.path.join(folder, "movie.gif"), gif(pictures))]
