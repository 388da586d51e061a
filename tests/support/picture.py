"""Is a PNG file a picture with something in it?  picture.py FILE...  says what is wrong and exits with 1.

The file is decoded. Looked at: its size in pixels, the number of its colors, and how much of the area within its axes
(the longest dark lines are their frames) is colored: text, grid and frames are gray.
"""
import os
import sys
from collections import namedtuple

import matplotlib

matplotlib.use("Agg")
import numpy as np
from matplotlib.image import imread

LEAST_SIDE, MOST_SIDE = 300, 4000  # pixels
LEAST_COLORS = 4
LEAST_INK = 0.0005
DARK = 0.35  # gray level of the frames
COLORED = 0.15  # difference of red, green and blue

# width, height in pixels; number of colors; colored part of the area within the axes, None without axes
Picture = namedtuple("Picture", "width height colors ink")


def longest_run(dark):
    """Of each row, the largest number of true entries one after another."""
    count, longest = np.zeros(dark.shape[0], int), np.zeros(dark.shape[0], int)
    for column in dark.T:
        count = np.where(column, count + 1, 0)
        longest = np.maximum(longest, count)
    return longest


def frame(gray):
    """Rows and columns of the outermost frame lines: top, bottom, left, right; None if there are none."""
    rows = np.flatnonzero(longest_run(gray < DARK) > 0.2 * gray.shape[1])
    columns = np.flatnonzero(longest_run((gray < DARK).T) > 0.2 * gray.shape[0])
    if len(rows) < 2 or len(columns) < 2:
        return None
    return rows[0], rows[-1], columns[0], columns[-1]


def ink_of(pixels):
    gray = pixels.mean(axis=2)
    found = frame(gray)
    if found is None:
        return None
    top, bottom, left, right = found
    inside = pixels[top + 4:bottom - 3, left + 4:right - 3]
    if not inside.size:
        return None
    return float(np.mean(np.ptp(inside, axis=2) > COLORED))


def look(path):
    """@throws whatever imread raises for a file that is no whole picture"""
    pixels = imread(path)
    pixels = np.repeat(pixels[:, :, None], 3, axis=2) if pixels.ndim == 2 else pixels[:, :, :3]
    coarse = (pixels * 15).round().astype(int) @ [256, 16, 1]
    _, count = np.unique(coarse, return_counts=True)
    height, width = pixels.shape[:2]
    return Picture(width, height, int((count >= 20).sum()), ink_of(pixels))


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
    if picture.ink is None:
        found.append("no axes")
    elif picture.ink < LEAST_INK:
        found.append(f"blank: {100 * picture.ink:.2g} % of the axes colored, expected {100 * LEAST_INK:g} %")
    return [f"{path}: {text}" for text in found]


def main(paths):
    if not paths:
        sys.exit("usage: picture.py FILE...")
    wrong = [text for path in paths for text in faults(path)]
    for path in paths:
        if not any(text.startswith(path) for text in wrong):
            print(f"{path}: {look(path)}")
    print(*wrong, sep="\n", end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
