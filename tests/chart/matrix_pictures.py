"""Condition of all matrices against the mesh and against the penalty factor, for matrices.md."""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 2, "cases"))
from matplotlib.lines import Line2D
from matplotlib.ticker import NullFormatter
from plotting.figure import new_figure, save

COLORS = {"K": "k", "condensed": "#238b45", "condensed, coordinates scaled": "#74c476", "penalty 10": "#fdbe85", "penalty 1000": "#d94701",
          "multipliers": "#6a3d9a", "augmented 10": "#c51b8a"}
SCENES = ("hertz", "rolling", "indentation")


def conditions(rows, path):
    """As handed to a solver: full lines; rows and columns over the root of the diagonal: dashed. Quadratic elements, last state."""
    fig, axes = new_figure(13.5, 8, nrows=2, ncols=3, sharey="col", squeeze=False)
    for column, scene in enumerate(SCENES):
        mine = [r for r in rows if r["scene"] == scene and r["element"] == "P2" and r["state"] == max(s["state"] for s in rows if s["scene"] == scene)]
        top, bottom = axes[0][column], axes[1][column]
        for name, color in COLORS.items():
            line = sorted((r["n"], r["condition"], r["condition_scaled"]) for r in mine if r["matrix"] == name)
            top.plot([k for k, _, _ in line], [c for _, c, _ in line], "o-", color=color, ms=4, label=name)
            top.plot([k for k, _, _ in line], [s for _, _, s in line], "--", color=color, lw=1)
        finest = [r for r in mine if r["n"] == max(s["n"] for s in mine)]
        sweep = sorted((float(r["matrix"].split()[1]), r["condition"], r["condition_scaled"]) for r in finest if r["matrix"].startswith("penalty"))
        bottom.plot([f for f, _, _ in sweep], [c for _, c, _ in sweep], "o-", color=COLORS["penalty 1000"], ms=4)
        bottom.plot([f for f, _, _ in sweep], [s for _, _, s in sweep], "--", color=COLORS["penalty 1000"], lw=1)
        for name in ("K", "condensed", "condensed, coordinates scaled", "multipliers"):
            r = next(r for r in finest if r["matrix"] == name)
            bottom.axhline(r["condition"], color=COLORS[name], lw=1.3)
            bottom.axhline(r["condition_scaled"], color=COLORS[name], lw=0.9, ls="--")
        top.set_xscale("log")
        top.set_xticks(sorted({r["n"] for r in mine}), sorted({r["n"] for r in mine}))
        top.xaxis.set_minor_formatter(NullFormatter())
        bottom.set_xscale("log")
        for ax in (top, bottom):
            ax.set_yscale("log")
            ax.grid(True, which="major", color="0.92", lw=0.6)
        top.set_title(scene)
        top.set_xlabel("divisions n of the mesh")
        bottom.set_xlabel("penalty factor")
    for row in axes:
        row[0].set_ylabel("condition number")
    handles = axes[0][0].get_legend_handles_labels()[0]
    handles += [Line2D([], [], color="k", label="as it is"), Line2D([], [], color="k", ls="--", label="scaled by its diagonal")]
    fig.legend(handles=handles, frameon=False, loc="upper center", bbox_to_anchor=(0.5, 0.01), ncol=5)
    fig.tight_layout()
    save(fig, os.path.dirname(path), os.path.splitext(os.path.basename(path))[0])
