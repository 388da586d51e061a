#!/usr/bin/python3
"""Pictures of the hole expansion, one of them its own; as plot.py beside a script it is called at the end of every run."""
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP", "."), "cases"))
from plotting.case import main
from plotting.figure import new_figure


def hole_over_stroke(run):
    figure, axes = new_figure()
    axes.plot(run.history["stroke_mm"], run.history["hole_mm"], ".-")
    axes.set_xlabel("stroke of the punch [mm]")
    axes.set_ylabel("radius of the hole, lower rim [mm]")
    return figure


sys.exit(main(sys.argv[1:], pictures=[hole_over_stroke]))
