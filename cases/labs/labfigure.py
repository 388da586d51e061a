"""What the plot.py of the labs share:  plot.py FOLDER [FILE]

Draws the lab's figure of the results in FOLDER into FILE, or into FOLDER/plot.png. Without FILE the pictures of any scene
(stress, pressure, history, ...) are drawn into FOLDER as well: so it is called at the end of a run.
"""
import io
import os
import subprocess
import sys

from plotting.figure import Image, apply_style, plt
from plotting.inputs import InputError

SCENE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "plotting", "scene.py")


def save(figure, file):
    """A PNG of always the same size, 256 colors."""
    drawn = io.BytesIO()
    figure.savefig(drawn, format="png", dpi=110)
    plt.close(figure)
    with Image.open(drawn) as picture:
        picture.convert("RGB").quantize(256, dither=Image.Dither.NONE).save(file, optimize=True)


def main(arguments, draw):
    """The body of a plot.py; draw: function of the folder that returns the figure. Returns the exit status."""
    if len(arguments) not in (1, 2) or arguments[0].startswith("-"):
        print("usage: plot.py FOLDER [FILE]    (the folder of a run's results, the PNG file to be drawn)", file=sys.stderr)
        return 2
    folder = arguments[0]
    file = arguments[1] if len(arguments) == 2 else os.path.join(folder, "plot.png")
    apply_style()
    plt.rcParams.update({"font.size": 13, "axes.titlesize": 13, "axes.labelsize": 13, "legend.fontsize": 12})
    try:
        save(draw(folder), file)
    except InputError as error:
        print(f"plot.py: {error}", file=sys.stderr)
        return 1
    print(file, flush=True)
    if len(arguments) == 1:
        subprocess.run([sys.executable, SCENE, folder], check=False)
    return 0
