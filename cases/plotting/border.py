"""What frames the one picture of a run, in the plane and in space: its size, title, key and scale."""
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure

from plotting import fields

WIDTH = 8.0                    # inches at 150 pixels
LEFT, RIGHT, BELOW, ABOVE, BETWEEN = 0.72, 1.2, 0.9, 0.42, 0.85   # inches beside the panels
GALLERY = (690, 460)           # pixels


def new_figure(height, width=WIDTH):
    """Figure that is drawn as it is; its axes are placed in inches."""
    figure = Figure(figsize=(width, height), dpi=150, layout="none")
    FigureCanvasAgg(figure)
    figure.placed = True     # nothing is moved or cut off
    return figure


def fitted(box, aspect):
    """The box widened on its shorter side to a width over height."""
    x0, x1, y0, y1 = box
    wide, high = max(x1 - x0, aspect * (y1 - y0)), max(y1 - y0, (x1 - x0) / aspect)
    mx, my = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    return mx - wide / 2, mx + wide / 2, my - high / 2, my + high / 2


def add_title(figure, text):
    figure.text(0.5, 1 - 0.13 / figure.get_figheight(), text, ha="center", va="top", fontsize=12)


def columns_of(handles):
    longest = max((6 + len(h.get_label()) for h in handles), default=1)
    return int(np.clip(105 // longest, 1, max(1, len(handles))))


def key_height(handles):
    """In inches."""
    return 0.05 + 0.2 * -(-len(handles) // columns_of(handles))


def add_key(figure, handles):
    """At the lower edge, in as many columns as fit."""
    figure.legend(handles=handles, loc="lower center", ncol=columns_of(handles), frameon=False, fontsize=9.5, bbox_to_anchor=(0.5, 0.0), borderpad=0.1)


def add_scale(figure, quantity, levels, unit, span):
    """Color bar at the right edge; span: its lower end and its height in inches."""
    height = figure.get_figheight()
    axes = figure.add_axes((1 - (RIGHT - 0.15) / WIDTH, span[0] / height, 0.16 / WIDTH, span[1] / height))
    scale = ScalarMappable(BoundaryNorm(levels, len(levels) - 1), fields.band_colors(quantity, levels))
    figure.colorbar(scale, cax=axes, label=fields.axis_label(quantity, unit), format="%.4g",
                    ticks=levels[0 if levels[0] == 0 else 1:: 1 if len(levels) <= 9 else 2])
