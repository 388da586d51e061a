#!/usr/bin/python3
"""Pictures of the upsetting: plot.py OUTDIR reads what upsetting.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting.case import main
from plotting.figure import BLUE, GRAY, ORANGE, new_figure
from plotting.inputs import read_whole_table


def mark_folds(axes, x, y):
    """Where the barrelling jumps down: a node of the side has come to the platen, and the contact is wider by an edge."""
    for k in np.flatnonzero(np.diff(y) < -0.05 * y.max()):
        axes.axvspan(x[k], x[k + 1], color=ORANGE, alpha=0.3, linewidth=0)
        axes.annotate("a node of the side\nfolds onto the platen:\nthe contact is wider\nby one edge", (x[k], y[k]),
                      xytext=(0.03, 0.97), textcoords="axes fraction", ha="left", va="top", fontsize=10,
                      arrowprops={"arrowstyle": "->", "color": GRAY})


def force(run):
    """Force and barrelling against the reduction, with friction and without."""
    plain = read_whole_table(os.path.join(run.folder, "frictionless.csv"))
    history, unit = run.history, run.summary["results"]["force with friction"]["unit"]
    figure, (left, right) = new_figure(10.0, 4.4, ncols=2)
    left.plot(100 * history["reduction"], history["force"] / 1e3, color=BLUE, label="with friction")
    left.plot(100 * plain["reduction"], plain["force"] / 1e3, color=ORANGE, label="without friction")
    left.plot(100 * plain["reduction"], plain["formula"] / 1e3, color=GRAY, linestyle="--", label="without, formula")
    left.set_ylabel(f"force on the platen [k{unit}]")
    left.legend(loc="lower right")
    right.plot(100 * history["reduction"], history["barrelling"], color=BLUE)
    right.set_ylabel("largest half width less that of the contact [mm]")
    right.set_title("Barrelling")
    mark_folds(right, 100 * history["reduction"], history["barrelling"])
    left.set_title(f"Force; with friction {run.result('force ratio'):.3f} times the other at the end")
    for axes in (left, right):
        axes.set_xlabel("reduction of height [%]")
        axes.set_ylim(bottom=0)
    return figure


sys.exit(main(sys.argv[1:], pictures=(force,),
              columns={"reduction": None, "force": None, "barrelling": ("barrelling", "mm", 1.0)}))
