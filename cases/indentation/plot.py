#!/usr/bin/python3
"""Pictures of the indentation: plot.py OUTDIR reads what indentation.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting import fields, maps, tools
from plotting.case import main
from plotting.figure import BLUE, GRAY, RED, arrows_along, new_figure
from plotting.inputs import option

ALONG, REACH = "stress_xx", 4.0  # mm  round the crater


def at_largest_force(run):
    """Field of the series at t = 1."""
    near = [path for t, path in run.series if abs(t - 1) < 1e-6]
    return run.read_field(near[0]) if near else None


def near_crater(run):
    left = 0.0 if option(run.summary, "half") else -REACH
    return left, REACH, -REACH, 0.15 * REACH


def load_depth(run):
    """Force against depth: loading, unloading, lifting."""
    h, depth, force = run.history, 1e6 * run.history["depth"], 1e-3 * run.history["force"]
    figure, axes = new_figure(7.5, 4.8)
    axes.plot(depth, force, color=BLUE, marker=".", markersize=4, label="computed")
    arrows_along(axes, depth, force, BLUE, (0.25, 0.7))
    steep = force[h["t"] > 1]
    for name in ("depth under load", "depth unloaded", "crater"):
        axes.axvline(run.result(name), color=GRAY, linewidth=0.8, linestyle="--")
    axes.annotate("unloading", (np.interp(0.5 * force.max(), steep[::-1], depth[h["t"] > 1][::-1]), 0.5 * force.max()),
                  xytext=(8, 0), textcoords="offset points", va="top", color=BLUE)
    axes.set_xlabel(r"depth of the cylinder [$\mu$m]")
    axes.set_ylabel("force [kN/m]")
    axes.set_title(rf"Force against depth; dashed: {run.result('depth under load'):.2f} $\mu$m under load, "
                   rf"{run.result('depth unloaded'):.2f} unloaded, crater {run.result('crater'):.2f}")
    return figure


def stiffness(run):
    """Slope of the force over the depth and at the start of unloading, against the half-width; a line contact of that half-width."""
    h = run.history
    a, forward, back = 1e6 * h["half_width"], 1e-9 * h["stiffness"], 1e-9 * h["stiffness_unloading"]
    loading = (h["t"] <= 1) & (back > 0) & (a > 0)
    unloading = (h["t"] > 1) & (h["t"] < 1.9) & (a > 0)
    figure, axes = new_figure(7.5, 4.8)
    axes.plot(a[loading], back[loading], color=RED, marker=".", markersize=4, label="at the start of unloading, elastic=true")
    axes.plot(a[loading], forward[loading], color=BLUE, marker=".", markersize=4, label="loading")
    axes.plot(a[unloading], forward[unloading], color=GRAY, marker=".", markersize=4, linewidth=0.8, label="unloading")
    star = 2e-9 * option(run.summary, "G") / (1 - option(run.summary, "nu"))
    known = np.flatnonzero(loading)[-1]                # METHOD.md (3.28), from the largest load on
    line = np.linspace(a[loading].min(), a[loading].max(), 100)
    axes.plot(line, 1 / (1 / back[known] + 2 / (np.pi * star) * np.log(a[known] / line)), "k--", linewidth=1,
              label=r"$1/S = 1/S_0 + 2\,\ln(a_0/a)/(\pi E^*)$")
    axes.set_xlabel(r"half-width of the contact, outermost node [$\mu$m]")
    axes.set_ylabel("stiffness [GPa]")
    axes.set_ylim(bottom=0)
    axes.set_title("Stiffness of the cylinder, force per thickness over depth")
    axes.legend()
    return figure


def top(field):
    """x [mm] and height [um] of the top surface in order of x."""
    nodes = np.flatnonzero(np.abs(field.points[:, 1]) < 1e-12)
    nodes = nodes[np.argsort(field.points[nodes, 0])]
    place = field.points[nodes] + field.data["displacement"][nodes, :2]
    return 1e3 * place[:, 0], 1e6 * place[:, 1]


def crater(run):
    loaded = at_largest_force(run)
    figure, axes = new_figure(7.5, 4.4)
    if loaded:
        axes.plot(*top(loaded), color=RED, label="under the largest force")
    axes.plot(*top(run.field), color=BLUE, label="lifted")
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set_xlim(near_crater(run)[:2])
    axes.set_xlabel("x [mm]")
    axes.set_ylabel(r"height of the surface [$\mu$m]")
    axes.set_title("Surface of the block, heights not to the scale of x")
    axes.legend()
    return figure


def stress_under_load(run):
    loaded = at_largest_force(run)
    if loaded is None:
        return None
    mesh, values = maps.deformed(loaded, run.units.length), run.units.stress * loaded.data["stress_eq"]
    figure, axes = new_figure(8.0, 5.2)
    bands, _ = fields.draw_map(axes, mesh, values, fields.levels_to(values.max()), tools.at_time(run.tools, 1.0),
                               near_crater(run), fields.STRESS.colors)
    figure.colorbar(bands, ax=axes, label="von Mises stress [MPa]", shrink=0.75)
    axes.set_title(f"Under the largest force: von Mises stress up to {values.max():.0f} MPa at a node")
    return figure


def residual_stress(run):
    """Stress along the surface after unloading: map, and its course below the middle of the crater."""
    values = run.units.stress * run.field.data[ALONG]
    most = 50 * np.ceil(np.abs(values).max() / 50)
    box = near_crater(run)
    shape = (box[1] - box[0]) / (box[3] - box[2])
    figure, (axes, line) = new_figure(3.7 + 3.5 * shape, 4.9, ncols=2, width_ratios=(shape, 1))
    maps.set_view(axes, box)
    axes.grid(False)
    bands = maps.draw_bands(axes, run.mesh, values, np.linspace(-most, most, 21), "RdBu_r")
    maps.draw_outline(axes, run.mesh)
    axes.set_title(r"Residual $\sigma_{xx}$ after lifting")
    figure.colorbar(bands, ax=axes, label=r"residual $\sigma_{xx}$ [MPa]", location="bottom",
                    ticks=np.arange(-most, most + 1, 50 if shape > 1.5 else 100))
    nodes = np.flatnonzero(np.abs(run.field.points[:, 0]) < 1e-9)
    nodes = nodes[np.argsort(-run.field.points[nodes, 1])]
    line.plot(values[nodes], -1e3 * run.field.points[nodes, 1], color=BLUE)
    line.axvline(0, color="black", linewidth=0.8)
    line.set_ylim(REACH, 0)
    line.set_xlabel(r"$\sigma_{xx}$ at x = 0 [MPa]")
    line.set_ylabel("depth below the surface [mm]")
    line.set_title("below the middle")
    return figure


COLUMNS = {"half_width": ("half-width of the contact", "mm", 1e3), "force": ("force", "kN/m", 1e-3)}
if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], mu="mu", columns=COLUMNS, without=("pressure", "history"),
                  pictures=(load_depth, stiffness, crater, stress_under_load, residual_stress)))
