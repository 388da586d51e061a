#!/usr/bin/python3
"""Plot of lab 6: plot.py FOLDER [FILE]; FOLDER: results of lab.edp and danger.edp in folders of their own, out/6-accuracy"""
import os
import sys
from pathlib import Path

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
from labs.labfigure import answers, main, option, table
from matplotlib.ticker import FormatStrFormatter
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, PURPLE, RED, SKY, new_figure

COLORS = {"condensed": BLUE, "multiplier": GREEN, "penalty 1": ORANGE, "penalty 10": RED, "penalty 100": PURPLE}


def chart(axes, files):
    """Error of the pressure against CPU time, a line for each method and element."""
    for file in files:
        rows = table(file, texts=("method", "element"))
        if rows:
            method, element = rows["method"][0], rows["element"][0]
            axes.loglog(rows["seconds"], [100 * e for e in rows["pressure"]], "o-" if element == "P1" else "s--",
                        color=COLORS.get(method, SKY), markersize=7 if element == "P1" else 5, label=f"{method}, {element}")
    axes.set(xlabel="CPU time [s]", ylabel="error of the pressure [%]", title="Hertz: speed against accuracy")
    axes.grid(True, which="both")
    for axis, ticks in ((axes.xaxis, (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2)), (axes.yaxis, (0.5, 1, 2, 5, 10, 20))):
        low, high = axis.get_view_interval()
        axis.set_ticks([tick for tick in ticks if low <= tick <= high])
        axis.set_major_formatter(FormatStrFormatter("%g"))
        axis.set_minor_formatter("")
    if files:
        axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))


def locking(axes, runs):
    """Depth over the one of the fine mesh; hollow: the run has told of the cause."""
    for element, color, mark in (("P1", RED, "o"), ("P2", BLUE, "s")):
        some = sorted((0.5 - option(r, "nu"), answers(r)["depth"] / option(r, "known"), answers(r)["told"])
                      for r in runs if option(r, "element") == element and option(r, "known") > 0)
        axes.semilogx([s[0] for s in some], [s[1] for s in some], "-", color=color)
        for told, fill, word in ((0, color, ""), (1, "white", ", with a report")):
            points = [s for s in some if s[2] == told]
            if points:
                axes.plot([s[0] for s in points], [s[1] for s in points], mark, color=color, markerfacecolor=fill,
                          markersize=9, label=element + word)
    axes.axhspan(0.95, 1.05, color=GRAY, alpha=0.25, label="called right")
    axes.set(xlabel="0.5 - Poisson's ratio [-]", ylabel="depth / fine mesh [-]", title="Danger: nearly incompressible",
             ylim=(0, 1.15))
    axes.invert_xaxis()
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))


def draw(folder):
    folder = Path(folder)
    figure, axes = new_figure(8.4, 7.6, nrows=2)
    chart(axes[0], sorted([*folder.glob("chart.csv"), *folder.glob("*/chart.csv")]))
    locking(axes[1], sorted(f.parent for f in folder.glob("*/summary.json")))
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw, scene=False))
