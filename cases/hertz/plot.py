#!/usr/bin/python3
"""Pictures of the Hertz case: plot.py OUTDIR reads what hertz.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from matplotlib.ticker import NullFormatter
from hertz.halfplane import circle, contact_nodes, curves_figure, number, stress_near
from plotting.case import main
from plotting.figure import BLUE, ORANGE, RED, key_under_labels, new_figure
from plotting.inputs import read_whole_table
from plotting.labels import log_ticks


def near_contact(run):
    a = number(run, "a")
    return stress_near(run, -3 * a, 3 * a, 3 * a, circle(run, -3 * a, 3 * a), "rigid cylinder")


def pressure(run):
    a, p0 = number(run, "a"), run.summary["results"]["largest pressure p0, by fit"]["expected"]
    x, p = contact_nodes(run)[:2]
    near, fine = abs(x) < 1.3 * a, np.linspace(-a, a, 400)
    return curves_figure([(fine, p0 * np.sqrt(1 - (fine / a) ** 2), dict(color="black", label="Hertz")),
                          (x[near], p[near], dict(color=BLUE, marker="o", markersize=4, linestyle="none",
                                                  label="computed, at the nodes"))],
                         "x [mm]", "pressure [MPa]", "Contact pressure under the whole force")


def convergence(run):
    """Errors against the mesh size; None without the study."""
    path = os.path.join(run.folder, "study.csv")
    if not os.path.isfile(path):
        return None
    table = read_whole_table(path, ("element",))
    figure, axes = new_figure(8.0, 5.6)
    for element, color in (("P1", ORANGE), ("P2", BLUE)):
        chosen = table["element"] == element
        h = 1 / (table["n"][chosen] + 0.4)
        for name, marker, label in (("l2", "o", "p in L2"), ("l2_inner", "s", "p in L2 inside 0.8 a"),
                                    ("a_moment", "^", "a, $p_0$ by moment")):
            axes.loglog(h, 100 * abs(table[name][chosen]), color=color, marker=marker, linewidth=1,
                        linestyle="-" if name.startswith("l2") else ":", label=f"{element}: {label}")
    ends = np.array([h.min(), h.max()])
    axes.loglog(ends, 4e1 * ends, color=RED, linestyle="--", linewidth=1, label="order 1")
    axes.loglog(ends, 1.2e1 * ends**2, color=RED, linestyle="-.", linewidth=1, label="order 2")
    axes.set_xlabel("edge of the triangles over the half-width a [-]")
    axes.set_ylabel("error against Hertz [%]")
    axes.set_title("Hertz: errors against the mesh size")
    axes.set_xticks(h, [f"{x:.3g}" for x in h])
    axes.xaxis.set_minor_formatter(NullFormatter())
    log_ticks(axes.yaxis)
    key_under_labels(axes, axes.get_legend_handles_labels()[0], 4)
    return figure


sys.exit(main(sys.argv[1:], without=("stress", "sequence", "history", "pressure"),
              pictures=(near_contact, pressure, convergence)))
