"""The whole ring of planetary.json beside its half: planetary_whole.py FOLDER. The same steps; results at the end; the four
rollers mirror each other, and so does the plastic strain, in every step."""
import csv
import json
import os
import sys

from case import number
from run import Checks

PAIRS = (("half", "whole", True), ("p1-coarse", "p1-whole", True), ("p1-coarse", "p1-free", False))  # half, whole, geared
ALLOWED = 1e-4  # residual / load of the runs; measured: up to 3e-5 in the results, 8e-6 between mirror images
SIGNS = {"roller 1.r": 1, "roller 1.phi": -1, "roller 1.theta": -1, "roller 2.advance": 1, "roller 2.beta": 1, "roller 2.turn": 1}
IMAGE = {"roller 1": "roller 3", "roller 2": "roller 4"}


def read(folder, name):
    with open(os.path.join(folder, name, "summary.json")) as file:
        summary = json.load(file)
    with open(os.path.join(folder, name, "history.csv")) as file:
        return summary, list(csv.DictReader(file))


def same_results(checks, label, half, whole):
    """Every result of the half, by name, and the strain of the lower half beside that of the upper one."""
    checks.that(f"{label} steps", half["counts"]["steps"] == whole["counts"]["steps"],
                f"half {half['counts']['steps']}, whole {whole['counts']['steps']}")
    for name in half["results"]:
        if name.startswith("forces"):
            continue
        pairs = [(name, number(half, name))] + ([(name + ", mirrored", number(half, name))] if name.startswith("ep, ") else [])
        for other, expected in pairs:
            off = abs(number(whole, other) - expected)
            checks.that(f"{label} {other}", off <= ALLOWED * abs(expected),
                        f"half {expected:.7g}, difference {off:.2g}, allowed {ALLOWED * abs(expected):.2g}")


def mirrored(checks, label, history, geared):
    for name, sign in SIGNS.items():
        for column in (name, "Q_" + name):
            if geared and column == "Q_roller 1.theta":  # holds the moments of both
                continue
            image = column.replace(name[:8], IMAGE[name[:8]])
            off = max(abs(float(line[column]) - sign * float(line[image])) for line in history)
            largest = max(abs(float(line[column])) for line in history)
            checks.that(f"{label} {column} mirrored", off <= ALLOWED * largest,
                        f"largest {largest:.4g}, difference {off:.2g}, allowed {ALLOWED * largest:.2g}")


def main(folder):
    checks = Checks()
    for name, image, geared in PAIRS:
        half, _ = read(folder, name)
        whole, history = read(folder, image)
        same_results(checks, image, half, whole)
        mirrored(checks, image, history, geared)
    checks.done()


main(sys.argv[1])
