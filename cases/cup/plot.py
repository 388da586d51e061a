#!/usr/bin/python3
"""Pictures of the cup: plot.py OUTDIR reads what cup.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting.case import main
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, key_under_labels, new_figure, same_zero
from plotting.inputs import read_whole_table


def force(run):
    """Force of the punch and radius of the rim against the stroke, beside Siebel's and what the wall can carry."""
    history, most = run.history, run.result("largest force the wall can carry") / 1e3
    figure, axes = new_figure(8.0, 4.8)
    siebel = np.where(history["siebel"] > 0, history["siebel"], np.nan) / 1e3
    axes.plot(history["stroke"], history["punch_force"] / 1e3, color=BLUE, label="punch")
    axes.plot(history["stroke"], siebel, color=GRAY, linestyle="--", label="Siebel, rim on the flat")
    axes.axhline(most, color=ORANGE, linestyle=":", label="the wall can carry")
    axes.set_xlabel("stroke [mm]")
    axes.set_ylabel("force [kN]")
    rim = axes.twinx()
    rim.grid(False)
    rim.plot(history["stroke"], history["rim"], color=GREEN, linewidth=1, label="rim, right scale")
    rim.set_ylabel("radius of the rim [mm]")
    same_zero(axes, rim)
    axes.set_ylim(top=1.15 * max(most, history["punch_force"].max() / 1e3))
    key_under_labels(axes, [*axes.lines, *rim.lines], 4)
    axes.set_title("Force of the punch on the whole ring")
    return figure


def thickness(run):
    """Thickness across the sheet, from the middle of the bottom to the rim."""
    profile = read_whole_table(os.path.join(run.folder, "profile.csv"))
    figure, axes = new_figure(8.0, 4.2)
    axes.plot(profile["blank"], profile["thickness"], color=BLUE, marker=".", label="cup")
    axes.axhline(run.summary["options"]["thickness"], color=GRAY, linestyle=":", label="blank")
    axes.axhline(run.summary["options"]["gap"], color=ORANGE, linestyle="--", label="clearance of the die")
    axes.set_xlabel("radius in the blank [mm]")
    axes.set_ylabel("thickness [mm]")
    key_under_labels(axes, axes.lines, 3)
    axes.set_title(f"Thickness of the cup: {profile['thickness'].min():.3f} to {profile['thickness'].max():.3f} mm")
    return figure


sys.exit(main(sys.argv[1:], mu="mu", pictures=(force, thickness), without=("pressure",),
              columns={"stroke": None, "punch_force": None, "siebel": None, "rim": ("radius of the rim", "mm", 1.0),
                       "thinnest": ("smallest thickness", "mm", 1.0)}))
