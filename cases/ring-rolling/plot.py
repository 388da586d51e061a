#!/usr/bin/python3
"""Pictures of ring-rolling: plot.py OUTDIR reads what ring-rolling.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting import fields
from plotting.case import main
from plotting.figure import GRAY, new_figure
from plotting.inputs import option

# words beside the tools: place over the outer radius, and what they say
WORDS = (((1.25, 0), "driven\nroll"), ((0.15, 0), "mandrel,\nidle, fed"), ((-1.47, 0), "cones\nabove and\nbelow"),
         ((-0.84, 1.18), "guide"), ((-0.62, -1.08), "guide"))


def plan(run):
    """The ring from above, cut at half of its upper half, with the circle that it was."""
    from plotting.space.maps import section_panel
    from plotting.space.scene import scale_of
    radius, scale = option(run.summary, "Ro"), scale_of(run, [run.last])
    figure, axes = new_figure(8.4, 7.0)
    bands = section_panel(axes, run, scale, np.array([0, 0, 0.5 * option(run.summary, "B")]), 2, "Plastic strain from above, ")
    for line in (radius, option(run.summary, "Ri")):
        around = np.linspace(0, 2 * np.pi, 200)
        axes.plot(line * np.cos(around), line * np.sin(around), "--", color=GRAY, linewidth=1.0, label="before" if line == radius else None)
    axes.set_xlim(-1.75 * radius, 1.45 * radius)
    axes.set_ylim(-1.4 * radius, 1.45 * radius)
    for place, words in WORDS:
        axes.text(*(radius * np.array(place)), words, ha="center", va="center", fontsize=10)
    axes.annotate("", (radius * 1.12, radius * 0.45), (radius * 1.12, radius * 0.2), arrowprops={"arrowstyle": "->", "lw": 1.8})
    axes.legend(loc="upper left")
    fields.add_scale(figure, bands, [axes], scale.label, 0.7)
    return figure


sys.exit(main(sys.argv[1:], columns={"torque": None, "diameter": ("mean outer diameter", "mm", 1.0), "ringturn": None}, pictures=(plan,)))
