"""Is a PNG file a picture with something in it?  picture.py FILE...  says what is wrong and exits with 1.

The file is decoded. Looked at: its size in pixels, the number of its colors, and how much of it is colored: curves, bands
and marks are; text, grid, frames and tools are gray, so axes without anything in them are refused.
"""
import os
import sys
from collections import namedtuple

import numpy as np
from PIL import Image

LEAST_SIDE, MOST_SIDE = 300, 4000  # pixels
LEAST_COLORS = 4
LEAST_INK = 0.0001
COLORED = 40  # least difference of red, green and blue, of 255

# width, height in pixels; number of colors; colored part of the area
Picture = namedtuple("Picture", "width height colors ink")


def look(path):
    """@throws whatever PIL raises for a file that is no whole picture"""
    with Image.open(path) as file:
        red, green, blue = (np.asarray(channel).astype(int) for channel in file.convert("RGB").split())
    number = np.bincount(((red >> 4 << 8) + (green >> 4 << 4) + (blue >> 4)).ravel())
    spread = np.maximum(np.maximum(red, green), blue) - np.minimum(np.minimum(red, green), blue)
    height, width = red.shape
    return Picture(width, height, int((number >= 20).sum()), float(np.mean(spread > COLORED)))


def faults(path):
    """What is wrong with the picture, a list of words; empty for a good one."""
    if not os.path.isfile(path):
        return [f"{path}: missing"]
    try:
        picture = look(path)
    except Exception as error:
        return [f"{path}: cannot be decoded: {error}"]
    found = []
    if not all(LEAST_SIDE <= side <= MOST_SIDE for side in (picture.width, picture.height)):
        found.append(f"{picture.width} x {picture.height} pixels, expected {LEAST_SIDE} to {MOST_SIDE}")
    if picture.colors < LEAST_COLORS:
        found.append(f"{picture.colors} colors, expected at least {LEAST_COLORS}")
    if picture.ink < LEAST_INK:
        found.append(f"blank: {100 * picture.ink:.2g} % of it colored, expected {100 * LEAST_INK:g} %")
    return [f"{path}: {text}" for text in found]


def main(paths):
    if not paths:
        sys.exit("usage: picture.py FILE...")
    wrong = {path: faults(path) for path in paths}
    for path, texts in wrong.items():
        print(*texts or [f"{path}: {look(path)}"], sep="\n")
    return 1 if any(wrong.values()) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
