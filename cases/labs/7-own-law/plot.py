#!/usr/bin/python3
"""Plot of lab 7: plot.py FOLDER [FILE]; FOLDER: results of lab.edp, in it hardening/ and history/ with those of hardening.edp
and history.edp"""
import os
import sys
from pathlib import Path

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
from labs.labfigure import main, table
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, new_figure


def rubber(axes, history):
    axes.plot(history["t"], history["work"], color=BLUE, label="work of the roller")
    axes.plot(history["t"], history["energy"], color=ORANGE, linestyle="--", label="energy of the block")
    axes.plot(history["t"], [-f for f in history["Q_y"]], color=GREEN, label="pressing force [N/mm]")
    axes.axvline(0.5, color=GRAY, linestyle=":")
    axes.set(xlabel="t [-]: pressed until 0.5, then drawn along", ylabel="work, energy [N], force [N/mm]",
             title="Rubber by forms of the script")
    axes.legend(loc="lower right")


def hardening(axes, folder):
    file = folder / "hardening/history.csv"
    if not file.is_file():
        return axes.set_title(f"{file} is not there yet: hardening.edp")
    history = table(file)
    start = max(history["height"][0], 1e-300)
    squeezed = [100 * (1 - h / start) for h in history["height"]]
    axes.plot(squeezed, history["force"], color=BLUE, label="computed")
    axes.plot(squeezed, history["theory"], color=ORANGE, linestyle="--", label="homogeneous compression, rigid-plastic")
    axes.set(xlabel="reduction of the height [%]", ylabel="force [N/mm]", title="Hardening by a formula of one's own")
    axes.legend(loc="lower right")


def memory(axes, folder):
    file = folder / "history/history.csv"
    if not file.is_file():
        return axes.set_title(f"{file} is not there yet: history.edp")
    history = table(file)
    axes.plot(history["pressed"], history["force"], color=BLUE)
    axes.set(xlabel="way of the platen [mm]", ylabel="force [N/mm]", title="A law that remembers: pressed, released, pressed again")


def draw(folder):
    folder = Path(folder)
    figure, axes = new_figure(6.4, 10.4, nrows=3)
    rubber(axes[0], table(folder / "history.csv", "work", "Q_y"))
    hardening(axes[1], folder)
    memory(axes[2], folder)
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw, scene=False))
