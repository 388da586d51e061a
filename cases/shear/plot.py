#!/usr/bin/python3
"""Pictures of the shear: plot.py OUTDIR reads what shear.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting.case import draw
from plotting.figure import BLUE, GREEN, RED, new_figure
from plotting.inputs import option, read_summary, read_whole_table

RATES = (("jaumann", "Jaumann", RED), ("greennaghdi", "Green-Naghdi", GREEN), ("logarithmic", "logarithmic", BLUE))
DOTS = 24


def read_shear(folder):
    """History, summary."""
    return read_whole_table(os.path.join(folder, "history.csv")), read_summary(os.path.join(folder, "summary.json"))


def draw_rates(axes, history, law, component, scale):
    """A stress of a law over the shear, with each rate; closed forms, where there are, as dots."""
    for rate, label, color in RATES:
        name = f"{law}_{rate}_{component}"
        axes.plot(history["t"], scale * history[name], color=color, label=label)
        if "expected_" + name in history:
            every = slice(None, None, max(1, len(history["t"]) // DOTS))
            axes.plot(history["t"][every], scale * history["expected_" + name][every], color=color, linestyle="none",
                      marker="o", markersize=4)
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set_xlabel(r"shear $\gamma$ [-]")


def stress(run, component):
    """The laws side by side: elastic, Prager's back stress, isotropic hardening."""
    history, summary = run
    tau = rf"$\tau_{{{component}}}$"
    dots = component == "xy"
    figure, panels = new_figure(12.0, 4.3, ncols=3)
    for axes, law, scale, ylabel, title in (
            (panels[0], "elastic", 1 / option(summary, "G"), tau + "/G [-]", "Elastic" + "; dots: closed form" * dots),
            (panels[1], "prager", 1e-6, tau + " [MPa]", "Prager's back stress" + "; dots: rigid-plastic" * dots),
            (panels[2], "isotropic", 1e-6, tau + " [MPa]", "Isotropic hardening")):
        draw_rates(axes, history, law, component, scale)
        axes.set_ylabel(ylabel)
        axes.set_title(title)
    same = [history[f"isotropic_{rate}_{component}"] for rate, _, _ in RATES]
    if all(np.allclose(values, same[0], rtol=5e-3) for values in same):
        panels[2].set_title("Isotropic hardening: all three alike")
    panels[0].legend()
    return figure


def shear_stress(run):
    return stress(run, "xy")


def normal_stress(run):
    return stress(run, "xx")


sys.exit(draw(sys.argv[1:], read_shear, (shear_stress, normal_stress)))
