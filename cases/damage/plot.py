#!/usr/bin/python3
"""Pictures of the crumbling block: plot.py OUTDIR reads what damage.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting import fields, maps, tools
from plotting.case import main
from plotting.figure import BLUE, GRAY, ORANGE, new_figure

BOX = (-5.0, 5.0, -5.0, 1.0)  # mm, round the punch
WAYS = ((0, 1, BLUE, "-", "first way down"), (1, 2, GRAY, "--", "withdrawn"), (2, 3, ORANGE, "-", "second way down"))


def force(run):
    """Force against depth on the three ways, and the number of damaged points."""
    h = run.history
    figure, (left, right) = new_figure(10.5, 4.4, ncols=2)
    for begin, end, color, dashes, label in WAYS:
        way = (h["t"] >= begin - 1e-9) & (h["t"] <= end + 1e-9)
        left.plot(1e3 * h["depth"][way], h["force"][way], dashes, color=color, label=label)
    left.set_xlabel(r"depth of the punch [$\mu$m]")
    left.set_ylabel("force [N/mm]")
    left.legend(loc="upper left")
    left.set_title("Force on the punch")
    right.plot(h["t"], h["damaged"], color=BLUE)
    right.set_xlabel("load parameter t [-]")
    right.set_ylabel("points with integrity below 1 [-]")
    right.set_title("Crumbles until 1, heals from 2 on, crumbles again")
    return figure


def integrity(run):
    """Integrity at the end of the three ways, and when healing has ended."""
    near = [min(run.series, key=lambda pair: abs(pair[0] - t)) for t in (1.0, 2.0, 2.4)]
    shown = [(t, run.read_field(path)) for t, path in near] + [(run.t, run.field)]
    figure, axes = new_figure(10.5, 6.8, ncols=2, nrows=2)
    for part, (t, field) in zip(axes.ravel(), shown):
        values = np.clip(field.data["integrity"], 0, 1)
        part.grid(False)
        maps.set_view(part, BOX)
        bands = maps.draw_bands(part, maps.deformed(field, 1.0), values, np.linspace(0, 1, 11) + 1e-9 * np.arange(11), "inferno")
        maps.draw_outline(part, maps.deformed(field, 1.0))
        tools.draw_tools(part, tools.at_time(run.tools, t), maps.deformed(field, 1.0), names=False)
        part.set_title(f"t = {t:.3g}: least integrity {values.min():.2f}")
    figure.colorbar(bands, ax=axes, label="integrity [-]", shrink=0.8)
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], mu="mu", without=("history", "pressure"), pictures=(force, integrity),
                  columns={"depth": None, "force": ("force", "N/mm", 1.0), "damaged": None, "least": None}))
