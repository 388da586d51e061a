#!/usr/bin/python3
"""Lab 2: the loop of force and slip displacement, tractions at three instants. plot.py FOLDER [FILE], see labfigure.py."""
import os
import sys

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
import numpy as np
from labs.labfigure import main
from plotting.figure import BLUE, GREEN, RED, new_figure
from plotting.inputs import option, read_summary, read_whole_table


def loop(axes, run, summary):
    """Displacement less the elastic part, which is in proportion to Q and belongs to the block: such that both ends fit."""
    R, a, mu, share = (option(summary, name) for name in ("R", "a", "mu", "share"))
    t, q, x = run["t"], run["q"], run["x"]
    scale = 1e3 * mu * a**2 / (4 * R)  # mu P/(pi E*) in micrometers
    part = lambda k: scale * (k + (1 - k) * np.log(1 - k))
    ends = x[np.argmin(abs(t - 2))] - x[np.argmin(abs(t - 4))]
    elastic = (ends - 2e-3 * part(share)) / (2 * share)
    k = np.linspace(0, share, 100)
    axes.plot(part(k), k, color="black", label="closed form")
    for sign in (1, -1):
        axes.plot(sign * (part(share) - 2 * part((share - np.linspace(share, -share, 200)) / 2)),
                  sign * np.linspace(share, -share, 200), color="black")
    axes.plot(1e3 * (x - elastic * q)[t >= 1], q[t >= 1], color=BLUE, marker="o", markersize=3.5, linestyle="none", label="computed")
    axes.set(xlabel="displacement by slip [µm]", ylabel=r"tangential force $Q/(\mu P)$ [-]", title="The loop")
    axes.legend(loc="upper left")


def tractions(axes, table):
    for t, color, name in ((2, BLUE, "largest Q"), (3, GREEN, "back to Q = 0"), (4, RED, "opposite Q")):
        chosen = abs(table["t"] - t) < 1e-6
        x = table["x"][chosen]
        axes.plot(x, table["expected"][chosen], color=color)
        axes.plot(x, table["traction"][chosen], color=color, marker="o", markersize=3.5, linestyle="none", label=name)
    axes.set(xlabel="x from the axis of the cylinder [mm]", ylabel="traction on the block [MPa]",
             title="Traction: dots computed, lines closed form")
    axes.set_ylim(top=1.75 * table["expected"].max())
    axes.legend(loc="upper right")


def draw(folder):
    figure, (left, right) = new_figure(10.5, 5, ncols=2)
    summary = read_summary(os.path.join(folder, "summary.json"))
    loop(left, read_whole_table(os.path.join(folder, "loop.csv")), summary)
    tractions(right, read_whole_table(os.path.join(folder, "traction.csv")))
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw))
