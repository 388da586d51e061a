#!/usr/bin/python3
"""Plot of lab 8: plot.py FOLDER [FILE]; FOLDER: results of lab.edp; runs in folders inside of it are drawn beside it"""
import os
import sys
from pathlib import Path

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
from labs.labfigure import answers, main, option, table
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, PURPLE, RED, new_figure


def draw(folder):
    folder = Path(folder)
    runs = [folder, *sorted(f.parent for f in folder.glob("*/answers.csv"))]
    figure, axes = new_figure(6.4, 7.6, nrows=2)
    for run, color in zip(runs, (BLUE, ORANGE, GREEN, RED, PURPLE, GRAY)):
        history, profile = table(run / "history.csv", "depth"), table(run / "profile.csv")
        label = f"r {option(run, 'r'):g} mm, b {option(run, 'b'):g} deg, depth {option(run, 'depth'):.4g} mm"
        axes[0].plot(history["depth"], history["force"], color=color, label=label)
        axes[1].plot(profile["x"], profile["y"], color=color, label=f"groove {answers(run)['groove']:.3f} mm")
    axes[0].set(xlabel="depth of the tool [mm]", ylabel="force [N/mm]", title="Pressed and lifted")
    axes[1].set(xlabel="x [mm]", ylabel="y [mm]", title="The groove that stays (half)", xlim=(0, 4))
    axes[0].set_ylim(top=1.5 * axes[0].get_ylim()[1])    # room for the key
    for place in axes:
        place.legend()
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw, scene=False))
