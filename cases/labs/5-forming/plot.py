#!/usr/bin/python3
"""Plot of lab 5: plot.py FOLDER [FILE [SWEEP]]
  FOLDER  results of lab.edp; SWEEP: folder of the runs of strip.edp, one folder each, FOLDER unless given"""
import math
import os
import sys
from pathlib import Path

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
from labs.labfigure import answers, main, option, table
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, RED, new_figure


def bending(axes, folder):
    history, given = table(folder / "history.csv", "bend_angle"), answers(folder)
    axes.plot(history["bend_angle"], history["punch_force"], color=BLUE, label="computed")
    end = given["bend_angle"]
    axes.plot(end - given["springback_theory"], 0, "o", color=ORANGE, markersize=9, label="pure bending, unloaded")
    axes.set(xlabel="bend angle [deg]", ylabel="punch force [N/mm]", xlim=(0, None),
             title=f"Bending to {end:.1f} deg, springback {given['springback']:.2f} deg")
    axes.legend(loc="lower center")


def grip(axes, runs):
    """Pusher's force over roll force, for equal rolls."""
    runs = [r for r in runs if option(r, "lowerV") == 1]
    if not runs:
        return axes.set_title("no runs of strip.edp with equal rolls")
    alpha = math.acos(1 - option(runs[0], "dh") / 2 / option(runs[0], "R"))
    line = [x / 100 for x in range(40, 101)]
    axes.plot(line, [math.tan(alpha - math.atan(x * math.tan(alpha))) for x in line], color=GRAY, label="Coulomb, rigid nose")
    for kind, color, mark in (("refused", RED, "s"), ("gripped", GREEN, "o")):
        some = [a for a in map(answers, runs) if bool(a["gripped"]) == (kind == "gripped")]
        axes.plot([a["mu_over_tan_alpha"] for a in some], [a["pusher_over_roll_force"] for a in some], mark, color=color,
                  markersize=8, label=kind)
    axes.axvline(1, color=GRAY, linestyle=":")
    axes.set(xlabel="friction coefficient / tan(bite angle) [-]", ylabel="pusher / roll force [-]",
             title=f"Grip: tan(bite angle) = {math.tan(alpha):.4f}")
    axes.legend()


def curl(axes, runs):
    """Torques and curvature for runs of the friction that has most speeds."""
    by_mu = {}
    for r in runs:
        if answers(r)["gripped"]:
            by_mu.setdefault(option(r, "mu"), []).append((option(r, "lowerV"), answers(r)))
    if not by_mu:
        return axes.set_title("no gripped strip")
    mu, some = max(by_mu.items(), key=lambda item: len(item[1]))
    some.sort(key=lambda pair: pair[0])
    speed = [s for s, _ in some]
    for name, color, mark in (("upper", BLUE, "o-"), ("lower", GREEN, "s-")):
        axes.plot(speed, [a["torque_" + name] for _, a in some], mark, color=color, label=f"torque, {name} roll")
    other = axes.twinx()
    other.plot(speed, [1e3 * a["curvature"] for _, a in some], "D--", color=RED, label="curvature")
    other.set_ylabel("curvature, upward [1/m]")
    other.grid(False)
    axes.set(xlabel="surface speed, lower / upper roll [-]", ylabel=r"torque [N$\cdot$mm/mm]", title=f"Unequal speeds, friction {mu:g}")
    for scale in (axes, other):    # room for the key
        scale.set_ylim(top=1.6 * scale.get_ylim()[1])
    axes.legend(*[a + b for a, b in zip(axes.get_legend_handles_labels(), other.get_legend_handles_labels())], loc="upper left")


def draw(folder, *sweeps):
    folder = Path(folder)
    runs = sorted(f.parent for sweep in sweeps or [folder] for f in Path(sweep).glob("*/answers.csv"))
    figure, axes = new_figure(6.4, 9.6, nrows=3)
    bending(axes[0], folder)
    grip(axes[1], runs)
    curl(axes[2], runs)
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:3], lambda folder: draw(folder, *sys.argv[3:]), scene=False))
