#!/usr/bin/python3
"""Lab 3: creep and traction of the rolling cylinder, or the torque of the crank. plot.py FOLDER [FILE], see labfigure.py."""
import os
import sys

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
import numpy as np
from labs.labfigure import main
from plotting.figure import BLUE, GRAY, GREEN, RED, new_figure
from plotting.inputs import option, read_summary, read_whole_table


def creep_along_way(axes, run, expected):
    axes.plot(run["way"], 1e4 * run["creep"], color=BLUE, marker="o", markersize=4, label="creep, computed")
    axes.axhline(1e4 * expected, color="black", linestyle="--", label="Carter, steady state")
    axes.set(xlabel="way of the center over a [-]", ylabel=r"creep $(V - |\omega| R)/V$ [$10^{-4}$]", title="Creep along the way")
    axes.legend(loc="upper right")
    other = axes.twinx()
    other.plot(run["way"], run["torque_found"] / 1e3, color=RED, marker="x", linestyle="none", markersize=5, label="torque found in the second run")
    other.plot(run["way"], run["torque"] / 1e3, color=RED, linewidth=1, label="torque prescribed in the first")
    other.set_ylabel(r"torque [kN$\cdot$mm/mm]", color=RED)
    other.grid(False)
    axes.set_ylim(0, 1.5 * 1e4 * run["creep"].max())
    other.set_ylim(-1, 1.8 * run["torque"].max() / 1e3)
    other.legend(loc="center right", bbox_to_anchor=(1, 0.36), fontsize=11)


def traction(axes, table):
    axes.plot(table["x"], table["expected"], color="black", label="Carter")
    for state, color, name in ((2, RED, "nodes that slide"), (3, GREEN, "nodes that stick"), (0, GRAY, "free nodes")):
        chosen = table["state"] == state
        axes.plot(table["x"][chosen], table["traction"][chosen], color=color, marker="o", markersize=4.5, linestyle="none", label=name)
    axes.set(xlabel="x from the axis, rolling to the right [mm]", ylabel="traction on the block [MPa]", title="Traction at the end")
    axes.set_ylim(top=1.45 * table["expected"].max())
    axes.legend(loc="upper right")


def crank(folder):
    run = read_whole_table(os.path.join(folder, "torque.csv"))
    figure, axes = new_figure(9, 4.8)
    axes.plot(run["beta"], run["torque"] / 1e3, color=BLUE, marker="o", markersize=4, label="torque of the drive")
    axes.plot(run["beta"], run["rigid"] / 1e3, color="black", linestyle="--", label=r"$-F\, dy/d\beta$")
    axes.set(xlabel="angle of the crank from the dead center [deg]", ylabel=r"torque [kN$\cdot$mm/mm]", title="Crank press")
    other = axes.twinx()
    other.plot(run["beta"], run["force"] / 1e3, color=GREEN, label="force on the punch")
    axes.set_ylim(0, 1.35 * run["torque"].max() / 1e3)
    other.set_ylim(0, 1.2 * run["force"].max() / 1e3)
    other.set_ylabel("force [kN/mm]", color=GREEN)
    other.grid(False)
    axes.legend(loc="upper left", ncol=2)
    other.legend(loc="lower center")
    return figure


def draw(folder):
    if os.path.isfile(os.path.join(folder, "torque.csv")):
        return crank(folder)
    figure, (left, right) = new_figure(11.5, 5, ncols=2)
    R, a, mu, share = (option(read_summary(os.path.join(folder, "summary.json")), name) for name in ("R", "a", "mu", "share"))
    creep_along_way(left, read_whole_table(os.path.join(folder, "roll.csv")), mu * a / R * (1 - np.sqrt(1 - share)))
    traction(right, read_whole_table(os.path.join(folder, "traction.csv")))
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw))
