#!/usr/bin/python3
"""Pictures of the flat punch: plot.py OUTDIR reads what punch.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from hertz.halfplane import curves_figure, number, stress_near
from plotting.case import main
from plotting.figure import BLUE, GREEN, ORANGE, RED
from plotting.inputs import read_whole_table


def expected(x, e, a, mean):
    """Closed form of the pressure at x for the force 2 a mean at e."""
    if e <= a / 2:
        return 2 * a * mean * (1 + 2 * e * x / a**2) / (np.pi * np.sqrt(a**2 - x**2))
    length = 4 * (a - e)
    return 4 * a * mean / (np.pi * length) * np.sqrt(np.maximum(length - (a - x), 0) / (a - x))


def near_contact(run):
    a, tilt = number(run, "a"), run.history["angle"][-1]
    x = np.array([-a, a])
    return stress_near(run, -2.5 * a, 2.5 * a, 2.5 * a, (x, run.history["y"][-1] + tilt * x), "rigid punch")


def pressure(run):
    """At the instants that the case compares."""
    table = read_whole_table(os.path.join(run.folder, "pressure.csv"))
    a, mean = number(run, "a"), number(run, "p")
    fine = a * np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, 1001)[1:-1])
    curves = []
    for e, color in zip(dict.fromkeys(table["e_over_a"]), (BLUE, GREEN, RED)):
        chosen = (table["e_over_a"] == e) & (abs(table["x"]) < 1.2 * a)
        label = f"e = {e:.3g} a" if e else "e = 0"
        curves.append((fine, expected(fine, e * a, a, mean), dict(color=color, label=label)))
        curves.append((table["x"][chosen], table["pressure"][chosen],
                       dict(color=color, marker="o", markersize=3.5, linestyle="none")))
    figure = curves_figure(curves, "x [mm]", "pressure [MPa]",
                           "Pressure under the punch: lines closed form, dots computed, at the nodes")
    figure.axes[0].set_ylim(-0.3 * mean, 6 * mean)
    figure.axes[0].legend(loc="upper center", title="place of the force")
    return figure


def release(run):
    """Where nodes are released against e, and the end of the contact in the closed form."""
    chosen = run.events["event"] == "release"
    e = np.linspace(0.45, run.t - 1, 200)
    form = np.where(e <= 0.5, -1, 1 - 4 * (1 - e))
    return curves_figure([(e, form, dict(color="black", label="end of the contact, closed form")),
                          (run.events["t"][chosen] - 1, run.events["x"][chosen] / number(run, "a"),
                           dict(color=BLUE, marker="o", markersize=4, linestyle="none",
                                label="located releases of nodes"))],
                         "place of the force e/a [-]", "place on the surface x/a [-]",
                         "Lifting off: each node is released as the end of the contact passes it")


def tilt(run):
    a, mean, Es = number(run, "a"), number(run, "p"), number(run, "E") / (1 - number(run, "nu") ** 2)
    e = np.linspace(0, run.t - 1, 300)
    form = np.where(e < 0.5, 8 * mean * e, 2 * mean / np.maximum(1 - e, 0.1)) / (np.pi * Es)
    return curves_figure([(e, 1e3 * form, dict(color="black", label="closed form")),
                          (run.history["e_over_a"], 1e3 * run.history["tilt"],
                           dict(color=ORANGE, marker="o", markersize=4, linestyle="none", label="computed"))],
                         "place of the force e/a [-]", "tilt [mrad]",
                         "Tilt of the punch against the place of the force")


sys.exit(main(sys.argv[1:], without=("stress", "sequence", "history", "pressure"),
              pictures=(near_contact, pressure, release, tilt)))
