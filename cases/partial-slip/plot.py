#!/usr/bin/python3
"""Pictures of partial slip: plot.py OUTDIR reads what partial-slip.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from hertz.halfplane import circle, contact_nodes, curves_figure, number, stress_near
from plotting.case import main
from plotting.figure import GRAY, GREEN, RED


def near_contact(run):
    a = number(run, "a")
    return stress_near(run, -3 * a, 3 * a, 3 * a, circle(run, -3 * a, 3 * a), "rigid cylinder")


def traction(run):
    """Tangential traction and friction's bound, computed and in closed form."""
    a, mu, share = number(run, "a"), number(run, "mu"), number(run, "Q")
    p0, c = run.summary["results"]["largest pressure p0 at t = 1"]["expected"], a * np.sqrt(1 - share)
    x, p, q, stick, slide = contact_nodes(run)
    x, fine = x - run.history["x"][-1], np.linspace(-a, a, 600)
    bound = mu * p0 * np.sqrt(np.maximum(1 - (fine / a) ** 2, 0))
    less = mu * p0 * np.sqrt(np.maximum(c**2 - fine**2, 0)) / a
    dots = dict(marker="o", markersize=4, linestyle="none")
    figure = curves_figure([(fine, bound, dict(color=GRAY, linestyle="--", label=r"$\mu p$, Hertz")),
                            (fine, bound - less, dict(color="black", label="traction, Cattaneo and Mindlin")),
                            (x[slide], q[slide], dict(color=RED, label="nodes that slide", **dots)),
                            (x[stick], q[stick], dict(color=GREEN, label="nodes that stick", **dots))],
                           "x from the cylinder's axis [mm]", "tangential traction [MPa]",
                           f"Tangential traction at Q = {share:g} $\\mu$P")
    figure.axes[0].axvspan(-c, c, color=GREEN, alpha=0.2, linewidth=0, zorder=0)
    return figure


def slips(run):
    """Instants at which nodes begin to slip, and the half-width of the stick zone in the closed form."""
    a, share = number(run, "a"), number(run, "Q")
    chosen = (run.events["event"] == "stick-to-slip") & (run.events["t"] > 1) & (abs(run.events["x"]) < a)
    t = run.events["t"][chosen]
    place = abs(run.events["x"][chosen] - np.interp(t, run.history["t"], run.history["x"]))
    fine = np.linspace(0, share, 300)
    return curves_figure([(fine, np.sqrt(1 - fine), dict(color="black", label="c/a, Cattaneo and Mindlin")),
                          (share * (t - 1), place / a, dict(color=RED, marker="o", markersize=5, linestyle="none",
                                                            label="located slips of nodes"))],
                         r"tangential force Q/($\mu$P) [-]", "distance from the axis over a [-]",
                         "The stick zone shrinks as Q grows")


sys.exit(main(sys.argv[1:], without=("stress", "sequence", "history", "pressure"),
              pictures=(near_contact, traction, slips)))
