#!/usr/bin/python3
"""Pictures of the rolled ball: plot.py OUTDIR reads what ball-rolling.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main
from plotting.figure import BLUE, GRAY, RED, key_under_labels, new_figure
from plotting.inputs import option


def creep(run):
    """Creep and Q over mu P along the way of the ball; dashed: the steady creep that is known."""
    rolled = run.history["t"] > 1
    way = run.history["t"][rolled] - 1
    known = run.summary["results"].get("creep over the last 2 a", {}).get("expected")
    figure, axes = new_figure(8.0, 4.6)
    axes.plot(way, 1e3 * run.history["creep"][rolled], color=BLUE, marker=".", label="creep, mean over the last a/2 (left)")
    if known is not None:
        axes.axhline(1e3 * known, color=RED, linestyle="--", label="steady state of a half-space, boundary elements")
    axes.axvspan(option(run.summary, "way") - 2, option(run.summary, "way"), color=GRAY, alpha=0.15, linewidth=0, label="what the mean is taken over")
    axes.set_xlabel("way of the ball over the radius of the contact")
    axes.set_ylabel(r"creep [10$^{-3}$]")
    axes.set_title("The creep while the moment grows, and steady")
    other = axes.twinx()
    other.plot(way, run.history["Q_over_muP"][rolled], color=GRAY, label=r"$Q/\mu P$ (right)")
    other.set_ylabel(r"$Q/\mu P$")
    other.grid(False)
    key_under_labels(axes, [handle for a in (axes, other) for handle in a.get_legend_handles_labels()[0]], 2)
    return figure


sys.exit(main(sys.argv[1:], columns={"creep": ("creep", "-", 1.0), "Q_over_muP": ("Q/(mu P)", "-", 1.0)}, pictures=[creep]))
