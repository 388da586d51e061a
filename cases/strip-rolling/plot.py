#!/usr/bin/python3
"""Pictures of strip rolling: plot.py OUTDIR reads what strip-rolling.edp wrote there and puts PNG files beside it."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from plotting.case import main
from plotting.figure import BLUE, GRAY, GREEN, ORANGE, RED, new_figure


def bite(run):
    """Path of nose, tail and pusher, forces along x on the strip, roll force and torques over the rolls' path."""
    history = run.history
    path, two = history["path"], "Q_lower.y" in history
    figure, axes = new_figure(8.0, 10.5, nrows=4, sharex=True)
    axes[0].plot(path, path, color=GRAY, linestyle=":", label="surface of the upper roll")
    axes[0].plot(path, history["nose"] - history["nose"][0], color=BLUE, label="nose")
    axes[0].plot(path, history["tail"] - history["tail"][0], color=GREEN, label="tail")
    axes[0].plot(path, history["pusher.x"] - history["pusher.x"][0], color=ORANGE, linestyle="--", label="pusher")
    axes[0].set_ylabel("path along x [mm]")
    axes[1].plot(path, history["Q_pusher.x"] / (1 + two), color=ORANGE,
                 label="half of the pusher's" if two else "pusher")
    axes[1].plot(path, history["pull"], color=BLUE, linestyle="--", label="mean of the rolls" if two else "roll")
    axes[1].set_ylabel("force along x [N/mm]")
    axes[2].plot(path, -history["Q_upper.y"], color=RED)
    axes[2].set_ylabel("roll force [N/mm]")
    axes[3].plot(path, history["Q_upper.angle"], color=BLUE, label="upper roll")
    if two:
        axes[3].plot(path, -history["Q_lower.angle"], color=ORANGE, linestyle=(0, (3, 3)), label="lower roll")
    axes[3].set_ylabel(r"torque [N$\cdot$mm/mm]")
    axes[3].set_xlabel("path of the roll's surface [mm]")
    for place in (axes[0], axes[1], axes[3]):
        place.legend()
    results = run.summary.get("results", {})
    verdict = results.get("gripped (1) or refused (0)", {"value": None})["value"]
    gripped = "stopped early" if verdict is None else "gripped" if verdict else "refused"
    axes[0].set_title(f"{gripped}: mu = {run.result('friction coefficient'):.3g}, "
                      f"tan(alpha) = {run.result('tan(alpha)'):.3g}")
    return figure


sys.exit(main(sys.argv[1:], pictures=(bite,),
              columns={"nose": ("nose", "mm", 1.0), "tail": ("tail", "mm", 1.0),
                       "path": ("path of the roll's surface", "mm", 1.0), "pull": ("pull of the roll", "N/mm", 1.0)}))
