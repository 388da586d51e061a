#!/usr/bin/python3
"""Lab 0: depth and turn of the roller. plot.py FOLDER [FILE], see labfigure.py."""
import os
import sys

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
import numpy as np
from labs.labfigure import main
from plotting.figure import BLUE, RED, new_figure
from plotting.inputs import option, read_summary, read_whole_table


def draw(folder):
    run = read_whole_table(os.path.join(folder, "history.csv"))
    radius = option(read_summary(os.path.join(folder, "summary.json")), "R")
    figure, (left, right) = new_figure(9, 4.4, ncols=2)
    figure.suptitle("A roller is pressed on a block and driven along it")
    left.plot(-run["Q_y"], 1e3 * run["depth"], color=BLUE, marker="o", markersize=4, label="computed")
    left.set(xlabel="pressing force [N/mm]", ylabel="depth of the roller [µm]")
    rigid = -(run["x"] - run["x"][0]) / radius
    right.plot(run["x"], np.degrees(run["angle"]), color=BLUE, marker="o", markersize=4, label="computed")
    right.plot(run["x"], np.degrees(rigid), color=RED, linestyle="--", label=r"rolling without slip, $-(x-x_0)/R$")
    right.set(xticks=np.linspace(run["x"][0], run["x"][-1], 5), xlabel="place x of its center [mm]", ylabel="turn, counter-clockwise [deg]")
    right.set_ylim(top=1.5)
    for axes in (left, right):
        axes.legend()
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw))
