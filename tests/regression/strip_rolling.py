"""Runs of strip-rolling.json beside one another: strip_rolling.py FOLDER. The whole strip against its upper half, upper
against lower roll, guided against free, and a pair of runs that are mirror images (the faster roll below, above)."""
import json
import os
import sys

from case import number
from run import Checks


def main(folder):
    summaries = {}
    for name in ("grip", "refuse", "half-grip", "half-refuse", "free", "faster-below", "slower-below"):
        with open(os.path.join(folder, name, "summary.json")) as file:
            summaries[name] = json.load(file)
    checks = Checks()

    def same(name, one, other, tolerance, another=None, factor=1.0):
        checks.near(f"{name}: {one} against {other}", number(summaries[one], name),
                    factor * number(summaries[other], another or name), tolerance)

    for name, tolerance in (("roll force", 2e-3), ("roll torque", 5e-3), ("thickness behind the rolls", 1e-4),
                            ("forward slip", 0.01), ("neutral angle / alpha", 0.02)):
        same(name, "grip", "half-grip", tolerance)
    same("work of the drives", "grip", "half-grip", 5e-3, factor=2)
    for name in ("roll force at the end", "roll torque at the end", "pusher's force at the end"):
        same(name, "refuse", "half-refuse", 2e-3)
    same("roll torque", "grip", "grip", 2e-3, another="torque of the lower roll")
    for name in ("roll force", "roll torque"):
        same(name, "grip", "free", 5e-3)
    same("roll force", "faster-below", "slower-below", 5e-3)
    same("roll torque", "faster-below", "slower-below", 0.02, another="torque of the lower roll")
    same("torque of the lower roll", "faster-below", "slower-below", 0.01, another="roll torque")
    same("curvature", "faster-below", "slower-below", 0.05, factor=-1)  # with the steps it scatters by 4 %
    slip = {name: 1 + number(summaries[name], "forward slip") / 100 for name in ("faster-below", "slower-below")}
    checks.near("nose over the faster roll, mirror images", slip["faster-below"] / 1.05, slip["slower-below"], 1e-3)
    checks.done()


main(sys.argv[1])
