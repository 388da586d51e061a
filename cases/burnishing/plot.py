#!/usr/bin/python3
"""Pictures of ball burnishing: plot.py OUTDIR reads what burnishing.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting import maps
from plotting.case import main
from plotting.figure import BLUE, RED, new_figure
from plotting.inputs import option

ALONG, ACROSS, STRAIN = "stress_xx", "stress_yy", "plastic_strain_eq"
REACH, DEEP = 2.6, 2.2   # of the radius of the contact: what is shown beside the tracks, below them


def radius(run):
    """Of a contact that is plastic all over, as in the script."""
    return np.sqrt(option(run.summary, "P") / (3 * np.pi * option(run.summary, "sigY")))


def panel(axes, run, name, normal, levels, colors, title):
    """A section of the block through the middle of the middle track; returns its bands."""
    from matplotlib.tri import Triangulation
    from plotting.space.maps import cut_body
    a = radius(run)
    places, cells, values = cut_body(run, run.undeformed, name, np.zeros(3), np.eye(3)[normal])
    shown = [1, 2] if normal == 0 else [0, 2]
    mesh = Triangulation(*places[:, shown].T, cells)
    half = REACH * a + (option(run.summary, "pitch") if normal == 0 else 0.5 * option(run.summary, "way")) * a
    maps.set_view(axes, (-half, half, -DEEP * a, 0.25 * a), "mm")
    axes.set_xlabel("across the tracks, y [mm]" if normal == 0 else "along the middle track, x [mm]")
    axes.set_ylabel("z [mm]")
    axes.grid(False)
    bands = axes.tricontourf(mesh, values, levels, cmap=colors, extend="both")
    maps.draw_outline(axes, mesh, 1.4)
    axes.set_title(title, fontsize=11)
    return bands


def residual_stress(run):
    """Residual stress and plastic strain in two sections: across the tracks, along the middle one."""
    unloaded = run.undeformed.data
    step = np.ceil(max(np.percentile(np.abs(unloaded[name]), 99.5) for name in (ALONG, ACROSS)) / 8 / 25) * 25
    stress = step * np.arange(-8, 9)
    strain = np.ceil(100 * np.percentile(unloaded[STRAIN][unloaded[STRAIN] > 1e-3], 99)) / 100 * np.linspace(0, 1, 11)
    figure, panels = new_figure(13.0, 9.0, nrows=3, ncols=2)
    rows = (("residual stress along the tracks, xx", ALONG), ("residual stress across the tracks, yy", ACROSS),
            ("accumulated plastic strain", STRAIN))
    for row, (words, name) in zip(panels, rows):
        plastic = name == STRAIN
        for axes, normal in zip(row, (0, 1)):
            bands = panel(axes, run, name, normal, strain if plastic else stress, "magma_r" if plastic else "RdBu_r",
                          words[0].upper() + words[1:] + (", section x = 0" if normal == 0 else ", section y = 0"))
        figure.colorbar(bands, ax=list(row), label="strain [-]" if plastic else "stress [MPa]", format="%.3g", pad=0.01, shrink=0.9)
    return figure


def profile(run):
    """Height of the surface across the tracks, at the middle of their length."""
    from plotting.space.maps import cut_body
    from matplotlib.tri import Triangulation
    a, pitch = radius(run), option(run.summary, "pitch")
    places, cells, _ = cut_body(run, run.undeformed, STRAIN, np.zeros(3), np.eye(3)[0])
    edges = maps.rim_edges(Triangulation(*places[:, [1, 2]].T, cells))
    top = edges[(edges[:, :, 1] > -0.5 * a).all(axis=1)].reshape(-1, 2)
    top = top[np.argsort(top[:, 0])]
    figure, axes = new_figure(8.0, 4.2)
    axes.plot(top[:, 0], 1e3 * top[:, 1], color=BLUE, label="surface after the three tracks")
    for number in (-1, 0, 1):
        axes.axvline(number * pitch * a, color=RED, linewidth=0.8, linestyle="--", label="tracks" if number == 0 else None)
    axes.set_xlim(-(pitch + 3) * a, (pitch + 3) * a)
    axes.set_xlabel("across the tracks, y [mm]")
    axes.set_ylabel(r"height of the surface [$\mu$m]")
    axes.set_title("Section x = 0: dents, ridges between them, pile-up")
    axes.legend()
    return figure


sys.exit(main(sys.argv[1:], columns={"depth": ("depth", "mm", 1.0), "track": None},
              pictures=[residual_stress, profile], without=["pressure", "section"]))
