#!/usr/bin/python3
"""Pictures of example 2: plot.py OUTDIR reads what planetary.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from matplotlib.colors import LogNorm
from plotting import maps
from plotting.case import main
from plotting.figure import BLUE, GRAY, GREEN, RED, key_below, new_figure, say_empty
from plotting.inputs import option
from plotting.tools import FACE

LEVELS = (0.87e8, 1.72e8, 1.93e8)  # Pa, the article's figure 7
STRAINS = (1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1)
NEAR = 6.0  # mm  to both sides of the middle of a rolled arc


def whole(run):
    return option(run.summary, "whole") > 0


def view(run):
    """Limits in mm: the ring, or its half."""
    return -33.0, 33.0, -33.0 if whole(run) else -1.0, 33.0


def centers(run):
    """Centers of the rollers at the end [mm], by their own coordinates, see planetary.edp; 3 and 4 are mirror images."""
    h, reach = {k: v[-1] for k, v in run.history.items()}, option(run.summary, "Ro") + option(run.summary, "R")
    found = []
    for one, two, side in (("roller 1", "roller 2", 1), ("roller 3", "roller 4", -1))[:1 + whole(run)]:
        r, phi = h[one + ".r"], h[one + ".phi"]
        d, beta = reach - h[two + ".advance"], h[two + ".beta"]
        found += [[r * np.cos(phi), r * np.sin(phi)], [-d * np.cos(beta), side * d * np.sin(beta)]]
    return 1e3 * np.array(found)


def draw_rollers(axes, run):
    angle = np.linspace(0, 2 * np.pi, 721)
    for number, center in enumerate(centers(run), 1):
        axes.fill(*(center[:, None] + 1e3 * option(run.summary, "R") * np.array([np.cos(angle), np.sin(angle)])),
                  facecolor=FACE, edgecolor=GRAY, linewidth=1.2, zorder=0.5)
        toward = center * (1 - 0.8 * 1e3 * option(run.summary, "R") / np.hypot(*center))
        axes.annotate(f"roller {number}", toward, ha="center", va="center", fontsize=10, annotation_clip=True)


def isolines(run):
    figure, axes = new_figure(9.0, 9.0 if whole(run) else 6.0)
    maps.set_view(axes, view(run))
    axes.grid(False)
    handles = maps.draw_isolines(axes, run.mesh, run.field.data["stress_eq"], LEVELS, view(run))
    maps.draw_outline(axes, run.mesh)
    draw_rollers(axes, run)
    axes.set_title(rf"Isolines of the von Mises stress at t = {run.t:.4g}, "
                   rf"$F_0$ = {option(run.summary, 'F0') / 1e3:.4g} kN/m")
    key_below(axes, handles, 3)
    return figure


def box_at(run, side):
    """Limits around the middle of a rolled arc, through the whole thickness; side: 1 for roller 1, -1 for roller 2."""
    angle = np.radians(option(run.summary, "start") + 0.5 * option(run.summary, "turn"))
    middle = 500 * (option(run.summary, "Ro") + option(run.summary, "Ri"))
    x, y = middle * np.array([side * np.cos(angle), np.sin(angle)])
    return x - NEAR, x + NEAR, y - 0.8 * NEAR, y + 0.8 * NEAR


def strain_zones(run):
    """Plastic strain, bands on a logarithmic scale: the ring or its half, and through the thickness under rollers 1 and 2."""
    values = np.maximum(np.nan_to_num(run.field.data["plastic_strain_eq"]), 1e-9)
    height, ratio = (13.0, 2.0) if whole(run) else (8.8, 1.1)
    figure, panels = new_figure(10.0, height, nrows=2, ncols=2, height_ratios=(ratio, 1))
    grid = panels[0, 0].get_gridspec()
    for axes in panels[0]:
        axes.remove()
    ring = figure.add_subplot(grid[0, :])
    left, right = panels[1]
    bands = None
    for axes, box in ((ring, view(run)), (left, box_at(run, -1)), (right, box_at(run, 1))):
        maps.set_view(axes, box)
        axes.grid(False)
        if values.max() > STRAINS[0]:
            bands = axes.tricontourf(run.mesh, values, levels=STRAINS, cmap="magma_r", zorder=1,
                                     norm=LogNorm(1e-5, 1e-1))
        else:
            say_empty(axes, "no plastic strain")
        maps.draw_outline(axes, run.mesh)
        draw_rollers(axes, run)
    for axes, name in ((left, "roller 2"), (right, "roller 1")):
        rolled, opposite = (run.result(f"ep, {name}, {side} side") for side in ("rolled", "opposite"))
        axes.set_title(f"{name}: rolled side {rolled:.2g}, opposite {opposite:.2g}")
    ring.set_title(f"Accumulated plastic strain at t = {run.t:.4g}, largest at a point "
                   f"{run.result('largest plastic strain'):.3g}")
    if bands:
        figure.colorbar(bands, ax=[ring, left, right], label="accumulated plastic strain [-]\nwhite: elastic", ticks=STRAINS, format="%g",
                        shrink=0.8)
    return figure


def strain_history(run):
    """Largest plastic strain of the four regions against t; the force's law beside it."""
    figure, (axes, lower) = new_figure(8.0, 6.4, nrows=2, sharex=True, height_ratios=(2, 1))
    t = run.history["t"]
    for number, color in ((1, BLUE), (2, RED)):
        for side, style in (("rolled", "-"), ("opposite", "--")):
            values = run.history[f"ep_{side}_{number}"]
            axes.plot(t, np.where(values > 0, values, np.nan), color=color, linestyle=style,
                      label=f"roller {number}, {side} side" + ("" if values[-1] > 0 else ": none"))
    axes.set_yscale("log")
    axes.set_ylim(1e-6, 1e-1)
    axes.set_ylabel("largest plastic strain [-]")
    axes.set_title("Plastic strain under the rollers and opposite them; forces and advance")
    axes.legend(fontsize=10)
    lower.plot(t, -1e-3 * run.history["Q_roller 1.r"], color=BLUE, label="roller 1, reaction at fixed distance")
    lower.plot(t, 1e-3 * run.history["Q_roller 2.advance"], color=RED, label="roller 2, prescribed")
    advance = run.history["roller 2.advance"]
    other = lower.twinx()
    other.grid(False)
    other.plot(t, 1e6 * (advance - advance[0]), color=GREEN, linestyle=":")
    other.set_ylabel(r"advance of roller 2 [$\mu$m]", color=GREEN)
    lower.set_ylabel("force toward C1 [kN/m]")
    lower.set_xlabel("load parameter t [-]")
    lower.legend(fontsize=10, loc="lower right")
    return figure


COLUMNS = {"Q_roller 2.turn": ("$Q_{turn}$", r"N$\cdot$m/m", 1.0)}
if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], mu="mu", columns=COLUMNS, pictures=(isolines, strain_zones, strain_history),
                  without=("stress", "plastic_strain", "sequence", "history", "expected")))
