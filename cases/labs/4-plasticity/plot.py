#!/usr/bin/python3
"""Lab 4: load and depth, residual stress, shear stress with three rates. plot.py FOLDER [FILE], see labfigure.py."""
import os
import sys

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
import numpy as np
from labs.labfigure import main
from plotting.figure import BLUE, GREEN, RED, new_figure
from plotting.inputs import read_whole_table


def load_depth(axes, run):
    pressed = run["t"] <= 1.9 + 1e-6
    axes.plot(1e3 * run["depth"][pressed], run["force"][pressed], color=BLUE, marker="o", markersize=3)
    axes.set(xlabel="depth [µm]", ylabel="force [N/mm]", title="Pressed and unloaded")


def residual(axes, table):
    order = np.argsort(table["depth"])
    axes.plot(table["depth"][order], table["stress_xx"][order], color=RED, marker="o", markersize=3)
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set(xlabel="depth below the axis [mm]", ylabel="residual stress xx [MPa]", title="After lifting")


def rates(axes, table):
    axes.plot(table["shear"], table["expected"], color="black", linestyle=":", linewidth=3, label="Jaumann, closed form")
    for name, color, label in (("jaumann", RED, "Jaumann"), ("greennaghdi", GREEN, "Green-Naghdi"), ("logarithmic", BLUE, "logarithmic")):
        axes.plot(table["shear"], table[name], color=color, label=label)
    axes.axvline(0.3 * np.sqrt(3), color="black", linewidth=1, linestyle="--", label="plastic strain 0.3")
    axes.set(xlabel=r"shear $\gamma$ [-]", ylabel="shear stress [MPa]", title="Sheared block, back stress")
    axes.set_ylim(top=1.85 * table["greennaghdi"].max())
    axes.legend(loc="upper center", fontsize=11)


def draw(folder):
    figure, (left, middle, right) = new_figure(13, 4.6, ncols=3)
    load_depth(left, read_whole_table(os.path.join(folder, "indentation.csv")))
    residual(middle, read_whole_table(os.path.join(folder, "residual.csv")))
    rates(right, read_whole_table(os.path.join(folder, "rates.csv")))
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw))
