#!/usr/bin/python3
"""Pictures of the leveller: plot.py OUTDIR reads what leveller.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main
from plotting.figure import BLUE, GRAY, key_under_labels, new_figure
from plotting.inputs import read_whole_table


def curvature(run):
    """Curvature along the strip before and after."""
    profile = read_whole_table(os.path.join(run.folder, "profile.csv"))
    figure, axes = new_figure(8.0, 4.2)
    axes.plot(profile["arc"], profile["curvature"], color=BLUE, label="after")
    axes.axhline(run.result("curvature before"), color=GRAY, linestyle="--", label="before")
    axes.axhline(0, color="black", linewidth=0.6)
    axes.set_xlabel("arc from the held end [mm]")
    axes.set_ylabel("curvature [1/m]")
    key_under_labels(axes, axes.lines[:2], 2)
    axes.set_title(f"Curvature of the strip, in the middle {run.result('curvature after, mean'):.2f} 1/m on average")
    return figure


sys.exit(main(sys.argv[1:], mu="mu", pictures=(curvature,), without=("pressure",),
              columns={"way": ("way of the rolls", "mm", 1.0), "press": ("press of the upper rolls", "N/mm", 1.0),
                       "pull": ("pull along the strip", "N/mm", 1.0), "torque": ("torque of the rolls", "N", 1.0)}))
