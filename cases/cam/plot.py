#!/usr/bin/python3
"""Pictures of the rolling cam: plot.py OUTDIR reads what cam.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting import fields, maps
from plotting.case import main
from plotting.figure import BLUE, GRAY, ORANGE, new_figure


def height(run):
    """Height of the center, depth of the track and torque against the angle, beside the rigid cam's."""
    history = run.history
    rolling = history["t"] > 0.1 - 1e-9
    angle = np.degrees(history["angle"][0] - history["angle"])[rolling]
    figure, axes = new_figure(8.0, 7.6, nrows=3, sharex=True)
    axes[0].set_title("Cam rolling over the block, and a rigid cam rolling over a rigid plane")
    dashed = dict(color=GRAY, linestyle="--")
    axes[0].plot(angle, history["rigid_height"][rolling], label="rigid cam on a rigid plane", **dashed)
    axes[0].plot(angle, history["y"][rolling], color=BLUE, label="computed")
    axes[0].set_ylabel("height of the center [mm]")
    axes[1].plot(angle, 1e3 * history["depth"][rolling], color=ORANGE)
    axes[1].set_ylabel("depth under the cam [µm]")
    axes[2].plot(angle, history["rigid_torque"][rolling], label="rigid: force times dh/d(angle)", **dashed)
    axes[2].plot(angle, history["torque"][rolling], color=BLUE, label="computed")
    axes[2].set_ylabel("torque [N·mm/mm]")
    axes[2].set_xlabel("angle rolled [deg]")
    axes[0].legend()
    axes[2].legend()
    return figure


def groove(run):
    """The track that the cam leaves, its depth drawn larger than it is; the workpiece alone."""
    surface = run.surface
    x, depth = surface["x"], surface["y"] - surface["Y"].max()
    times = 10 ** np.floor(np.log10(0.1 * np.ptp(x) / max(np.abs(depth).max(), 1e-12)))
    field = run.field._replace(data={**run.field.data, "displacement": run.field.data["displacement"] * [1, times, 1]})
    mesh, strain = maps.deformed(field, run.units.length), run.field.data["plastic_strain_eq"]
    figure, axes = new_figure(9.0, 4.6)
    bands, _ = fields.draw_map(axes, mesh, strain, fields.levels_to(strain.max(), quantity=fields.STRAIN), [], fields.mesh_box(mesh),
                               fields.STRAIN.colors)
    if bands is not None:
        fields.add_scale(figure, bands, axes, "accumulated plastic strain [-]", 0.75)
    axes.set_title(f"Track of the cam: vertical displacement {times:g} times as large, deepest {1e3 * -depth.min():.0f} µm")
    return figure


sys.exit(main(sys.argv[1:], mu="mu", pictures=(height, groove),
              columns={"depth": ("depth under the cam", "µm", 1e3), "rigid_height": None, "rigid_travel": None,
                       "torque": None, "rigid_torque": None}))
