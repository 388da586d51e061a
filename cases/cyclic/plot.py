#!/usr/bin/python3
"""Pictures of cyclic: plot.py OUTDIR reads what cyclic.edp wrote there and in the folders of -beside, and puts PNG files
there."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from matplotlib.ticker import MaxNLocator
from plotting.case import main
from plotting.figure import BLUE, MICRON, ORANGE, RED, arrows_along, new_figure
from plotting.inputs import read_summary, read_whole_table

LAWS = {"none": ("isotropic", BLUE), "prager": ("Prager", ORANGE), "armstrongfrederick": ("Armstrong-Frederick", RED)}


def laws(run):
    """(label, color, history, cycles) of this run and of those beside it."""
    names = [name for name in str(run.summary["options"].get("beside", "")).split(",") if name]
    for folder in (*names, run.folder):
        summary = read_summary(os.path.join(folder, "summary.json"))
        yield (*LAWS[summary["options"]["backstress"]], read_whole_table(os.path.join(folder, "history.csv")),
               read_whole_table(os.path.join(folder, "cycles.csv")))


def load_depth(run):
    """Force over depth, a panel for each law."""
    drawn = list(laws(run))
    figure, panels = new_figure(max(6.5, 4.3 * len(drawn)), 4.6, ncols=len(drawn), sharex=True, sharey=True,
                                squeeze=False)
    for axes, (label, color, history, _) in zip(panels[0], drawn):
        axes.plot(MICRON * history["depth"], 1e-3 * history["force"], color=color, linewidth=1)
        first = slice(0, 1 + np.flatnonzero(history["force"] > 0.999 * history["force"].max())[0])
        low = first.stop + np.argmin(history["force"][first.stop:])
        for part in (first, slice(first.stop - 1, low + 1)):
            arrows_along(axes, MICRON * history["depth"][part], 1e-3 * history["force"][part], color, (0.5,))
        axes.set_title(label)
        axes.set_xlabel(r"depth of the cylinder [$\mu$m]")
    panels[0, 0].set_ylabel("force [kN/m]")
    return figure


def loops(run):
    """Area of the loops, and how much deeper each cycle ends."""
    figure, (left, right) = new_figure(10.0, 4.4, ncols=2)
    for label, color, _, cycles in laws(run):
        style = dict(color=color, marker="o", markersize=4, label=label)
        left.plot(cycles["cycle"], cycles["work"], **style)
        deeper = MICRON * (cycles["depth_low"][1:] - cycles["depth_low"][:-1])
        right.plot(cycles["cycle"][1:], deeper, **style)
    for axes, ylabel, title in ((left, "work of the cycle [J/m]", "Area of the loop"),
                                (right, r"depth more than the cycle before [$\mu$m]", "Ratchetting, unloaded")):
        axes.set_xlabel("cycle [-]")
        axes.set_ylabel(ylabel)
        axes.set_title(title)
        axes.set_ylim(bottom=-0.03 * axes.dataLim.y1)
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        axes.axhline(0, color="black", linewidth=0.8)
        axes.legend()
    return figure


sys.exit(main(sys.argv[1:], without=("sequence", "history", "pressure", "expected"), pictures=(load_depth, loops)))
