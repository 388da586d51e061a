#!/usr/bin/python3
"""Pictures of rolling contact: plot.py OUTDIR reads what rolling-contact.edp wrote there, puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from hertz.halfplane import circle, contact_nodes, curves_figure, number, stress_near
from plotting.case import main
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, RED, key_of_both, same_zero


def near_contact(run):
    a, X = number(run, "a"), run.history["x"][-1]
    return stress_near(run, X - 3 * a, X + 3 * a, 3 * a, circle(run, X - 3 * a, X + 3 * a), "rigid cylinder")


def traction(run):
    a, mu, share, R = (number(run, name) for name in ("a", "mu", "Q", "R"))
    c, p0 = a * np.sqrt(1 - share), number(run, "E") / (1 - number(run, "nu") ** 2) * a / (2 * R)
    x, p, q, stick, slide = contact_nodes(run)
    x, fine = x - run.history["x"][-1], np.linspace(-a, a, 600)
    bound = mu * p0 * np.sqrt(np.maximum(1 - (fine / a) ** 2, 0))
    less = mu * p0 * np.sqrt(np.maximum(c**2 - (fine - a + c) ** 2, 0)) / a
    dots = dict(marker="o", markersize=4, linestyle="none")
    figure = curves_figure([(fine, bound, dict(color=GRAY, linestyle="--", label=r"$\mu p$, Hertz")),
                            (fine, bound - less, dict(color="black", label="traction, Carter")),
                            (x[slide], q[slide], dict(color=RED, label="nodes that slide", **dots)),
                            (x[stick], q[stick], dict(color=GREEN, label="nodes that stick", **dots))],
                           "x from the cylinder's axis [mm], it rolls to the right", "tangential traction [MPa]",
                           f"Rolling with Q = {share:g} $\\mu$P: the stick zone is at the leading edge")
    figure.axes[0].axvspan(a - 2 * c, a, color=GREEN, alpha=0.2, linewidth=0, zorder=0)
    return figure


def creep(run):
    """Creep over the way, and the torque."""
    history = run.history
    shown = history["t"] > 1
    way = history["x"][shown]
    figure = curves_figure([(way, 1e3 * history["creep"][shown],
                             dict(color=BLUE, marker="o", markersize=3, label="creep, computed")),
                            (way, 1e3 * history["creep_expected"][shown],
                             dict(color="black", linestyle="--", label="steady creep, Carter"))],
                           "way of the cylinder [mm]", r"creep [$10^{-3}$]",
                           "Creep while the torque grows, and after that")
    axes = figure.axes[0]
    force = axes.twinx()
    force.grid(False)
    force.plot(way, history["Q_over_muP"][shown], color=ORANGE, label=r"force Q/($\mu$P), right scale")
    force.set_ylabel(r"tangential force Q/($\mu$P) [-]")
    same_zero(axes, force)
    key_of_both(axes, force, loc="center right")
    return figure


sys.exit(main(sys.argv[1:], without=("stress", "sequence", "history", "pressure"),
              pictures=(near_contact, traction, creep)))
