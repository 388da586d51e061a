#!/usr/bin/python3
"""Pictures of the incline: plot.py OUTDIR reads what incline.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from hertz.halfplane import curves_figure, number
from plotting.case import main
from plotting.figure import BLUE, GREEN, ORANGE, RED
from plotting.inputs import read_whole_table


def ratio(run):
    """F/G over the way for each friction."""
    table = read_whole_table(os.path.join(run.folder, "table.csv"))
    curves = []
    for mu, color in zip(dict.fromkeys(table["mu"]), (BLUE, GREEN, ORANGE, RED)):
        chosen = table["mu"] == mu
        way = table["t"][chosen] * number(run, "way")
        curves.append((way, table["expected"][chosen], dict(color=color, linestyle="--", linewidth=1)))
        curves.append((way, table["F_over_G"][chosen],
                       dict(color=color, marker="o", markersize=4, linestyle="none", label=rf"$\mu$ = {mu:g}")))
    figure = curves_figure(curves, "way of the incline [mm]", "F/G [-]",
                           "Horizontal over vertical force; dots computed, dashed Coulomb's law")
    figure.axes[0].set_ylim(0, 1.3 * table["expected"].max())
    figure.axes[0].legend(loc="upper right", ncol=4)
    return figure


sys.exit(main(sys.argv[1:], without=("sequence", "history"), pictures=(ratio,)))
