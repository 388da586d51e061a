"""What the plot.py of the labs share:  plot.py FOLDER [FILE]

Draws the lab's figure of the results in FOLDER into FILE, or into FOLDER/plot.png. Without FILE the pictures of any scene
(stress, pressure, history, ...) are drawn into FOLDER as well, in mm and MPa, unless the lab does without: so it is called at the
end of a run. A folder of another script of the lab, without the tables of the figure, gets these pictures only.
"""
import csv
import io
import os
import sys
from pathlib import Path

from matplotlib import pyplot as plt

from plotting.case import DEFAULT, draw_all
from plotting.figure import MARK, Image, apply_style
from plotting.inputs import InputError, MissingInput, read_summary
from plotting.run import Run

LARGER = {"font.size": 13, "axes.titlesize": 13, "axes.labelsize": 13, "legend.fontsize": 12,
          "figure.constrained_layout.h_pad": 0.1, "figure.constrained_layout.w_pad": 0.07}  # readable at half size


def save(figure, file):
    """A PNG of always the same size, 256 colors."""
    drawn = io.BytesIO()
    figure.savefig(drawn, format="png", dpi=110)
    plt.close(figure)
    with Image.open(drawn) as picture:
        picture.convert("RGB").quantize(256, dither=Image.Dither.NONE).save(file, optimize=True, pnginfo=MARK)
    print(file, flush=True)


def answers(folder):
    """{name: value} of answers.csv."""
    rows = table(Path(folder) / "answers.csv", "name", "value", texts=("name", "unit"))
    return dict(zip(rows["name"], rows["value"]))


def table(file, *needed, texts=()):
    """{column: list of numbers} of a CSV file; needed: columns that it must have; texts: those of words."""
    if not Path(file).is_file():
        raise MissingInput(f"{file} is not there")
    with open(file, encoding="utf-8") as text:
        rows = list(csv.DictReader(text))
    missing = [name for name in needed if not rows or name not in rows[0]]
    if missing:
        raise InputError(f"{file} has no column {missing[0]!r}: it is of another script")
    return {name: [row[name] if name in texts else float(row[name]) for row in rows] for name in (rows[0] if rows else {})}


def option(folder, name):
    """Value of an option of the run, a number or a word."""
    return read_summary(str(Path(folder) / "summary.json"))["options"][name]


def draw_lab(folder, file, draw, patient):
    """Exit status; patient: tables that are missing are no fault."""
    apply_style()
    plt.rcParams.update(LARGER)
    try:
        save(draw(folder), file)
    except InputError as error:
        if not (patient and isinstance(error, MissingInput)):
            print(f"plot.py: {error}", file=sys.stderr)
            return 1
    return 0


def main(arguments, draw, scene=True):
    """The body of a plot.py; draw: function of the folder that returns the figure; scene: the pictures of any scene, too. Returns
    the exit status."""
    if len(arguments) not in (1, 2) or arguments[0].startswith("-"):
        print("usage: plot.py FOLDER [FILE]    (the folder of a run's results, the PNG file to be drawn)", file=sys.stderr)
        return 2
    if not os.path.isdir(arguments[0]):
        print(f"plot.py: {arguments[0]}: no such folder", file=sys.stderr)
        return 1
    if len(arguments) == 2:
        return draw_lab(arguments[0], arguments[1], draw, patient=False)
    folder = arguments[0]
    status = draw_lab(folder, os.path.join(folder, "plot.png"), draw, patient=scene)
    if not scene:
        return status
    return max(status, draw_all(Run(folder), DEFAULT, folder, patient=True))
