#!/usr/bin/python3
"""Pictures of example 1: plot.py OUTDIR reads what rolling.edp wrote there and puts PNG files beside it."""
import os
import sys
from types import SimpleNamespace

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
try:
    import numpy as np
    from matplotlib.patches import Rectangle
    from matplotlib.ticker import MaxNLocator
    from plotting import contact, fields, maps
    from plotting.case import draw
    from plotting.curves import pressure_figure
    from plotting.figure import (BLUE, GRAY, GREEN, MICRON, MM, ORANGE, RED, SKY, key_below, new_figure, say_empty)
    from plotting.final import final_figure
    from plotting.inputs import InputError, option, read_summary, read_table
    from plotting.run import Run
    from plotting.start import start_figure
    from plotting.vtu import read_vtu
except ImportError as error:
    sys.exit(f"plot.py: {error}; the Debian packages python3-matplotlib, python3-numpy and python3-meshio are "
             "needed")

# Pa, the values of the article's figures 2 and 3
LEVELS_BELOW, LEVELS_ABOVE = (0.43e8, 0.87e8, 1.3e8, 1.73e8), (2.2e8, 2.6e8, 3.0e8, 3.5e8)

FILES = ("history.csv", "events.csv", "summary.json", "final.vtu", "surface.csv")
HISTORY = ("t", "r", "phi", "theta", "Q_r", "Q_phi", "Q_theta", "contact_begin_deg", "contact_end_deg", "sticking",
           "sliding")
SURFACE = ("X", "Y", "x", "y", "pressure", "traction_tangential", "nodal_pressure", "nodal_traction")
FIELDS = ("displacement", "stress_eq", "plastic_strain_eq")


def read_run(folder):
    """All files of a run; an InputError names every missing one."""
    if not os.path.isdir(folder):
        raise InputError(f"{folder}: no such folder")
    path = {name: os.path.join(folder, name) for name in FILES}
    missing = [p for p in path.values() if not os.path.isfile(p)]
    if missing:
        raise InputError("missing: " + ", ".join(missing))
    field = read_vtu(path["final.vtu"], FIELDS)
    if field.data["displacement"].ndim != 2 or any(field.data[name].ndim != 1 for name in FIELDS[1:]):
        raise InputError(f"{path['final.vtu']}: expected displacement as vector, {' and '.join(FIELDS[1:])} as scalars")
    return SimpleNamespace(
        history=read_table(path["history.csv"], HISTORY),
        events=read_table(path["events.csv"], ("t", "x", "y"), ("event",), rows=0),
        summary=read_summary(path["summary.json"]),
        surface=read_table(path["surface.csv"], SURFACE, ("state",), rows=2),
        folder=folder, field=field, mesh=maps.deformed(field))


def at_end(run):
    return f"t = {run.history['t'][-1]:.4g}"


def roller_center(run):
    """At the end, in mm."""
    r, phi = run.history["r"][-1], run.history["phi"][-1]
    return MM * r * np.array([np.cos(phi), np.sin(phi)])


def contact_place(run):
    """Middle of the contact [mm], or where the roller points to."""
    middle = contact.middle_of_contact(run.surface)
    if middle is not None:
        return MM * middle
    rim = MM * np.column_stack([run.surface["x"], run.surface["y"]])
    return rim[np.argmin(np.hypot(*(rim - roller_center(run)).T))]


def contact_width(run):
    """Distance of the outermost contact nodes [mm], at least a part of the workpiece, so that a view stays readable."""
    where = np.flatnonzero(contact.touching(run.surface))
    x, y = MM * run.surface["x"], MM * run.surface["y"]
    least = 0.08 * np.hypot(np.ptp(x), np.ptp(y))
    return max(least, np.hypot(*(np.ptp(v[where[[0, -1]]]) for v in (x, y)))) if len(where) else least


def draw_tool_and_contact(axes, run, reach):
    """Outline, contact arc and the roller near it; returns handles for the key."""
    maps.draw_outline(axes, run.mesh)
    handles = [contact.mark_contact(axes, run.surface)]
    radius = option(run.summary, "R")
    if radius:
        handles.append(maps.draw_circle_near(axes, roller_center(run), MM * radius, contact_place(run), reach))
    return handles


def whole_view(run):
    return maps.box_of(run.mesh.x, run.mesh.y, 0.06)


def zone_view(run, zone, aspect):
    """Limits round a zone of the mesh and the contact; aspect: least and largest width over height."""
    width, place = contact_width(run), contact_place(run)
    near = [[place[0] - width, place[1] - width], [place[0] + width, place[1] + 0.2 * width]]
    points = np.vstack([np.column_stack([run.mesh.x, run.mesh.y])[zone], near])
    return maps.box_of(*points.T, 0.06, aspect)


def isoline_figure(run, levels, box, title):
    figure, axes = new_figure(8.5, 6.0)
    maps.set_view(axes, box)
    handles = maps.draw_isolines(axes, run.mesh, run.field.data["stress_eq"], levels, box)
    handles += draw_tool_and_contact(axes, run, 0.45 * (box[1] - box[0]))
    axes.set_title(f"{title}, {at_end(run)}")
    axes.grid(False)
    key_below(axes, handles, 3)
    return figure


def final(run):
    return final_figure(Run(run.folder))


def scene(run):
    return start_figure(Run(run.folder))


def stress_below_yield(run):
    return isoline_figure(run, LEVELS_BELOW, whole_view(run), "Von Mises stress below the initial yield stress")


def stress_above_yield(run):
    far = np.hypot(*(np.column_stack([run.mesh.x, run.mesh.y]) - contact_place(run)).T)
    zone = (run.field.data["stress_eq"] > LEVELS_ABOVE[0]) & (far < 2.5 * contact_width(run))
    box = zone_view(run, zone, (1.3, 1.9))
    return isoline_figure(run, LEVELS_ABOVE, box, "Von Mises stress above the initial yield stress")


def plastic_levels(values):
    """Round levels up to the largest value; the first one, a hundredth of it, ends the colored zone."""
    ticks = MaxNLocator(10, steps=[1, 2, 2.5, 5, 10]).tick_values(0, values.max())
    return np.r_[0.01 * values.max(), ticks[ticks > 0]]


def plastic_strain(run):
    values = np.nan_to_num(run.field.data["plastic_strain_eq"], nan=0.0)
    figure, (near, whole) = new_figure(9.0, 7.6, nrows=2)
    box = zone_view(run, values > 0.02 * max(values.max(), 1e-12), (1.3, 3.2))
    views = ((near, box), (whole, whole_view(run)))
    levels = plastic_levels(values)
    for axes, limits in views:
        maps.set_view(axes, limits)
        axes.grid(False)
        handles = draw_tool_and_contact(axes, run, 0.45 * (limits[1] - limits[0]))
        if values.max() > 0:
            bands = maps.draw_bands(axes, run.mesh, values, levels, fields.STRAIN.colors)
    if values.max() > 0:
        figure.colorbar(bands, ax=[near, whole], label="accumulated plastic strain [-]\nwhite: elastic",
                        ticks=levels[1:], format="%.3g")
    else:
        say_empty(near, "no plastic strain")
    whole.add_patch(Rectangle((box[0], box[2]), box[1] - box[0], box[3] - box[2], fill=False, edgecolor=RED,
                              linewidth=1.0, zorder=5))
    near.set_title(f"Accumulated plastic strain, {at_end(run)}: largest {values.max():.3g} at a node")
    key_below(whole, handles, 3, 0.2)
    return figure


def rotation_panel(axes, run):
    h = run.history
    axes.plot(h["t"], np.degrees(h["theta"]), color=BLUE,
              label=rf"computed, ${np.degrees(h['theta'][-1]):.2f}^\circ$ at the end")
    outer, radius = option(run.summary, "Ro"), option(run.summary, "R")
    if outer and radius:
        pure = h["theta"][0] + (h["phi"] - h["phi"][0]) * (outer + radius) / radius
        axes.plot(h["t"], np.degrees(pure), color="black", linewidth=1.0, linestyle="--",
                  label=rf"pure rolling $\Delta\varphi\,(R_o+R)/R$, ${np.degrees(pure[-1]):.2f}^\circ$")
    axes.legend()


def contact_panels(ends, nodes, h):
    ends.fill_between(h["t"], h["contact_begin_deg"], h["contact_end_deg"], color=SKY, alpha=0.35, linewidth=0)
    ends.plot(h["t"], h["contact_begin_deg"], color=BLUE, label="begin")
    ends.plot(h["t"], h["contact_end_deg"], color=ORANGE, label="end")
    ends.plot(h["t"], np.degrees(h["phi"]), color=GRAY, linewidth=1.0, linestyle="--",
              label=r"roller's center $\varphi$")
    ends.legend()
    nodes.step(h["t"], h["sticking"], where="mid", color=GREEN, linewidth=1.0, label="sticking")
    nodes.step(h["t"], h["sliding"], where="mid", color=RED, linewidth=1.0, label="sliding")
    nodes.yaxis.set_major_locator(MaxNLocator(integer=True))
    nodes.legend()


def tool_histories(run):
    h = run.history
    figure, panels = new_figure(10.0, 9.5, nrows=3, ncols=2, sharex=True)
    labels = ((r"depth $r - r(0)$ [$\mu$m]", r"rotation $\theta$ [deg]"),
              ("radial force $Q_r$ [kN/m]", r"moments [N$\cdot$m/m]"), ("contact ends [deg]", "nodes in contact"))
    for axes, label in zip(panels.flat, np.ravel(labels)):
        axes.set_ylabel(label)
    panels[0, 0].plot(h["t"], MICRON * (h["r"] - h["r"][0]), color=BLUE)
    rotation_panel(panels[0, 1], run)
    panels[1, 0].plot(h["t"], 1e-3 * h["Q_r"], color=BLUE)
    panels[1, 1].plot(h["t"], h["Q_theta"], color=BLUE, label=r"$Q_\theta$, about the roller's center")
    panels[1, 1].plot(h["t"], h["Q_phi"], color=RED, label=r"$Q_\varphi$, about the pivot")
    panels[1, 1].legend()
    contact_panels(panels[2, 0], panels[2, 1], h)
    for axes in panels[2]:
        axes.set_xlabel("load parameter t [-]")
    figure.suptitle("Roller: motion, drive forces and contact")
    return figure


def pressure(run):
    return pressure_figure(Run(run.folder), option(run.summary, "mu", "friction"))


def surface_profile(run):
    begin, end = run.history["contact_begin_deg"], run.history["contact_end_deg"]
    touched = np.flatnonzero(np.isfinite(begin) & np.isfinite(end))
    first = (begin[touched[0]] + end[touched[0]]) / 2 if len(touched) else None
    return contact.profile_figure(run.surface, first, f"Profile of the rolled surface, {at_end(run)}")


def events(run):
    return contact.events_figure(run.events, run.history, "Contact events")


PICTURES = (final, scene, stress_below_yield, stress_above_yield, plastic_strain, tool_histories, pressure, surface_profile,
            events)


if __name__ == "__main__":
    sys.exit(draw(sys.argv[1:], read_run, PICTURES, read_plain=Run))
