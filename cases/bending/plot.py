#!/usr/bin/python3
"""Pictures of the V-bending: plot.py OUTDIR reads what bending.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting.case import main
from plotting.figure import BLUE, GRAY, arrows_along, new_figure


def springback(run):
    """Force against the bend angle: bending, then the way back."""
    history = run.history
    figure, axes = new_figure(8.0, 4.6)
    axes.plot(2 * history["leg_angle"], 2 * history["punch_force"], color=BLUE)
    turn = 1 + np.argmax(history["leg_angle"])
    for part, at in ((slice(0, turn), (0.3, 0.7)), (slice(turn - 1, None), (0.5,))):
        arrows_along(axes, 2 * history["leg_angle"][part], 2 * history["punch_force"][part], BLUE, at)
    for name in ("bend angle under load", "bend angle after springback"):
        axes.axvline(run.result(name), color=GRAY, linestyle=":", linewidth=1)
    axes.set_xlabel("bend angle [deg]")
    axes.set_ylabel("punch force, both halves [N/mm]")
    axes.set_title(f"V-bending; between the dotted lines {run.result('springback'):.2f} deg of springback")
    return figure


sys.exit(main(sys.argv[1:], mu="mu", pictures=(springback,), without=("pressure",),
              columns={"leg_angle": ("angle of one leg", "deg", 1.0), "punch_force": None}))
