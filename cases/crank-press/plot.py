#!/usr/bin/python3
"""Pictures of the crank press: plot.py OUTDIR reads what crank-press.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting.case import main
from plotting.figure import BLUE, GRAY, ORANGE, key_of_both, new_figure, same_zero
from plotting.inputs import read_whole_table


def torque(run):
    """Torque and force against the crank angle: prescribed motion as lines, prescribed torque as dots."""
    table = read_whole_table(os.path.join(run.folder, "torque.csv"))
    beta, found = np.degrees(table["beta"]), np.degrees(table["beta_found"])
    figure, axes = new_figure(8.0, 4.8)
    axes.plot(beta, table["torque"] / 1e3, color=BLUE, label="angle prescribed, torque read")
    driven = np.arange(len(beta)) <= run.result("instants reached under torque")
    axes.plot(found[driven], table["torque"][driven] / 1e3, color=ORANGE, marker="o", markersize=4, linestyle="none",
              label="torque prescribed, angle found")
    axes.axvline(run.result("at the angle"), color=GRAY, linestyle=":", linewidth=1)
    axes.set_xlabel("crank angle from the dead center [deg]")
    axes.set_ylabel("torque [kN·m/m]")
    force = axes.twinx()
    force.grid(False)
    force.plot(beta, table["force"] / 1e6, color=GRAY, linestyle="--", label="force on the punch, right scale")
    force.set_ylabel("force [MN/m]")
    same_zero(axes, force)
    key_of_both(axes, force, loc="lower center")
    axes.set_title("Crank press driven by the angle, and by the torque; dotted: the largest torque")
    return figure


sys.exit(main(sys.argv[1:], mu="mu", pictures=(torque,),
              columns={"height": ("height of the punch", "mm", 1e3), "force": ("force on the punch", "MN/m", 1e-6)}))
