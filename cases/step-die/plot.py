#!/usr/bin/python3
"""Pictures of the grooved die: plot.py OUTDIR reads what step-die.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main
from plotting.figure import BLUE, GRAY, ORANGE, key_of_both, new_figure, same_zero


def filling(run):
    """Force and filling of the groove against the stroke; dotted: nodes pass from curve to curve of the die."""
    history, stroke = run.history, run.history["y"][0] - run.history["y"]
    figure, axes = new_figure(8.0, 4.6)
    axes.plot(stroke, -2 * history["Q_y"], color=BLUE, label="force")
    axes.set_xlabel("stroke [mm]")
    axes.set_ylabel("force on the whole die [N/mm]")
    share = axes.twinx()
    share.grid(False)
    share.plot(stroke, 100 * history["filling"], color=ORANGE, linestyle="--", label="filling, right scale")
    share.set_ylabel("groove filled [%]")
    for t, kind in zip(run.events["t"], run.events["event"]):
        if kind == "next-piece":
            axes.axvline(t * stroke[-1], color=GRAY, linestyle=":", linewidth=1)
    same_zero(axes, share)
    key_of_both(axes, share, loc="lower right")
    axes.set_title("Pressing into the groove; dotted: a node passes from one curve of the die to the next")
    return figure


sys.exit(main(sys.argv[1:], mu="mu", pictures=(filling,),
              columns={"filling": ("groove filled", "-", 1.0), "rise": ("highest point above the face", "mm", 1.0)}))
