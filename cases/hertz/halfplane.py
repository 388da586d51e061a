"""What the pictures of the cases on a half-plane share: stress near the contact, the contact from surface.csv."""
import numpy as np

from plotting import fields
from plotting.figure import GRAY, new_figure
from plotting.tools import FACE


def number(run, name):
    """Value of an option."""
    return float(run.summary["options"][name])


def contact_nodes(run):
    """x, pressure and traction of the nodes of surface.csv, sorted by x; which of them stick, which slide."""
    order = np.argsort(run.surface["x"])
    x, p, q = (run.surface[c][order] for c in ("x", "pressure", "traction_tangential"))
    state = run.surface["state"][order]
    return x, p, q, state == "sticking", state == "sliding"


def stress_near(run, left, right, depth, outline, name):
    """Von Mises stress in the box from left to right, down to the depth [mm]; outline: (x, y) of the tool's lower side,
    name: its own."""
    run.tools = []
    mesh, values = run.mesh, run.field.data["stress_eq"]
    box = (left, right, -depth, 0.12 * (right - left))
    within = (mesh.x > left) & (mesh.x < right) & (mesh.y > -depth)
    run.field.data["stress_eq"] = np.where(within, values, np.minimum(values, values[within].max()))
    figure = fields.field_figure(run, fields.STRESS, box)
    run.field.data["stress_eq"] = values
    axes, (x, y) = figure.axes[0], outline
    axes.fill_between(x, y, box[3] + 1, facecolor=FACE, edgecolor=GRAY, linewidth=1.2, zorder=3.5)
    axes.set_ylim(box[2:])
    axes.text(0.5 * (x[0] + x[-1]), 0.6 * box[3], name, ha="center", va="center", zorder=6)
    return figure


def circle(run, left, right):
    """Lower side of a cylinder of radius R between two x [mm]."""
    x = np.linspace(left, right, 200)
    radius, center = number(run, "R"), (run.history["x"][-1], run.history["y"][-1])
    return x, center[1] - np.sqrt(radius**2 - (x - center[0]) ** 2)


def curves_figure(curves, xlabel, ylabel, title, height=4.8):
    """curves: (x, y, keywords of plot) each."""
    figure, axes = new_figure(7.8, height)
    for x, y, style in curves:
        axes.plot(x, y, **style)
    axes.set_xlabel(xlabel)
    axes.set_ylabel(ylabel)
    axes.set_title(title)
    axes.legend()
    return figure
