#!/usr/bin/python3
"""Plot of lab 6: plot.py FOLDER [FILE]; FOLDER: results of lab.edp and danger.edp in folders of their own, out/6-accuracy"""
import csv
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(os.environ.get("BURNISH_TOP") or Path(__file__).resolve().parents[3]) / "cases/labs"))
from lab_plot import answers, folder_and_file, option, save  # noqa: E402
from matplotlib.ticker import FormatStrFormatter  # noqa: E402
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, PURPLE, RED, SKY, new_figure  # noqa: E402

COLORS = {"condensed": BLUE, "multiplier": GREEN, "penalty 1": ORANGE, "penalty 10": RED, "penalty 100": PURPLE}


def chart(axes, files):
    """Error of the pressure against CPU time, a line for each method and element."""
    for file in files:
        with open(file, encoding="utf-8") as text:
            rows = list(csv.DictReader(text))
        if rows:
            first = rows[0]
            axes.loglog([float(r["seconds"]) for r in rows], [100 * float(r["pressure"]) for r in rows],
                        "o-" if first["element"] == "P1" else "s--", color=COLORS.get(first["method"], SKY),
                        markersize=7 if first["element"] == "P1" else 5, label=f"{first['method']}, {first['element']}")
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


def main():
    folder, file = folder_and_file()
    figure, axes = new_figure(8.4, 7.6, nrows=2)
    chart(axes[0], sorted([*folder.glob("chart.csv"), *folder.glob("*/chart.csv")]))
    locking(axes[1], sorted(f.parent for f in folder.glob("*/summary.json")))
    save(figure, file)


if __name__ == "__main__":
    main()
