"""Style shared by the pictures of all cases: size, fonts, colors that colorblind readers can tell apart."""
import io
import os

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.transforms import ScaledTranslation
from PIL import Image, PngImagePlugin  # matplotlib needs it too

# Okabe and Ito; told apart by colorblind readers
BLUE, ORANGE, GREEN, RED, PURPLE, SKY, GRAY = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9",
                                               "#777777")
MM, MICRON, MPA = 1e3, 1e6, 1e-6  # from SI

MARK = PngImagePlugin.PngInfo()  # a run removes pictures of an older one that bear it, cxx/base/run_folder.cpp
MARK.add_text("Software", "Burnish")

STYLE = {
    "font.size": 11, "axes.titlesize": 12, "axes.labelsize": 11, "legend.fontsize": 10,
    "xtick.labelsize": 10, "ytick.labelsize": 10,
    "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "axes.axisbelow": True,
    "lines.linewidth": 1.5, "legend.frameon": True, "legend.framealpha": 0.9, "legend.edgecolor": "#cccccc",
    "axes.formatter.useoffset": False, "figure.constrained_layout.use": True,
}


def apply_style():
    matplotlib.rcParams.update(STYLE)


def new_figure(width=8.0, height=5.0, **grid):
    """Figure and axes; grid: arguments of Figure.subplots. Without pyplot, which takes as long to load as the rest."""
    figure = Figure(figsize=(width, height))
    return figure, figure.subplots(**grid)


def fewer_colors(image):
    """256, among them those of arrows, ways and bodies, however little of the picture they have."""
    kept = (ORANGE, GREEN, "#edebdb", "#8c99ad")
    wide = Image.new("RGB", (image.width + 60, image.height))
    wide.paste(image, (0, 0))
    for k, color in enumerate(kept):
        wide.paste(color, (image.width, k * image.height // len(kept), wide.width, wide.height))
    return wide.quantize(256, dither=Image.Dither.NONE).crop((0, 0, *image.size))


def save(figure, folder, name):
    """Writes name.png into folder and returns its path. 128 or 256 colors: a third of the size, the eye sees no difference; figure.shaded:
    those of small marks among them. figure.placed: it is drawn as it is, else its margins are cut off."""
    path, drawn, placed = os.path.join(folder, name + ".png"), io.BytesIO(), getattr(figure, "placed", False)
    if placed:
        figure.canvas.draw()
        drawn = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3])
    else:
        figure.savefig(drawn, format="png", dpi=150, bbox_inches="tight", pad_inches=0.12, pil_kwargs={"compress_level": 1})
        drawn = Image.open(drawn).convert("RGB")
    shaded = getattr(figure, "shaded", False)
    colors = fewer_colors(drawn) if shaded else drawn.quantize(128 if placed else 256, dither=Image.Dither.NONE)
    colors.save(path, pnginfo=MARK)
    return path


def key_below(axes, handles, columns, gap=0.13):
    """Key under the axes, where it covers nothing."""
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -gap), ncol=columns,
                columnspacing=1.4, handlelength=2.2)


def key_under_labels(axes, handles, columns, size=9):
    """The same at a fixed distance, whatever the height of the axes: below tick labels and axis label."""
    below = axes.transAxes + ScaledTranslation(0, -0.5, axes.figure.dpi_scale_trans)
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), bbox_transform=below, ncol=columns,
                columnspacing=1.4 if size > 8 else 0.8, handlelength=2.2 if size > 8 else 1.4, fontsize=size)


def key_of_both(axes, other, **where):
    """One key for the curves of two axes that share the picture (twinx)."""
    pairs = [pair for a in (axes, other) for pair in zip(*a.get_legend_handles_labels())]
    axes.legend(*zip(*pairs), **where).set_zorder(9)
    axes.set_zorder(other.get_zorder() + 1)  # the key lies over both
    axes.patch.set_visible(False)


def same_zero(axes, other):
    """Both scales from zero, at one height."""
    for a in (axes, other):
        a.set_ylim(0, 1.05 * a.dataLim.y1)


def arrows_along(axes, x, y, color, parts=(0.2, 0.5, 0.8)):
    """Arrow heads on a curve that show which way it is run, at these parts of its length in the picture; set the limits before."""
    places = axes.transData.transform(np.column_stack([x, y]))
    way = np.r_[0, np.cumsum(np.hypot(*np.diff(places, axis=0).T))]
    if not way[-1] > 0:
        return
    for part in parts:
        ends = [[np.interp(np.clip(part * way[-1] + d, 0, way[-1]), way, v) for v in (x, y)] for d in (-3, 3)]
        axes.annotate("", ends[1], ends[0], arrowprops={"arrowstyle": "-|>", "color": color, "shrinkA": 0, "shrinkB": 0,
                                                        "mutation_scale": 14})


def say_empty(axes, text):
    """Words in place of curves."""
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=GRAY)
