"""Histories of the variants for the page: columns that the script records first, thinned."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from gather import read_summary
from plotting import units
from plotting.inputs import InputError, read_whole_table

MOST_NUMBERS = 300000   # of all curves together
FEWEST, MOST = 20, 300  # points of a curve
MOST_COLUMNS = 40


def plain_text(label):
    """A label of matplotlib without its marks of a formula."""
    label = label.replace(r"$\mu$m", "um").replace(r"$\cdot$", " ")
    for mark in ("$", "{", "}", "\\"):
        label = label.replace(mark, "")
    return label.replace("10^", "1e")


class Run:
    """History of a run and what its columns are."""

    def __init__(self, folder):
        self.summary = read_summary(folder)
        self.history = read_whole_table(os.path.join(folder, "history.csv"))
        said, ring = self.summary.get("units"), self.summary.get("mesh", {}).get("axisymmetric")
        if said:
            self.columns = units.describe(list(self.history), units.named(said["length"], said["stress"], whole=ring))
        else:
            self.columns = units.describe(list(self.history), units.neutral(1.0, 1.0, ring), None, units.LENGTHS)


def runs_of(folders):
    """{number: Run} of the variants whose history can be read."""
    found = {}
    for number, folder in enumerate(folders):
        try:
            run = Run(folder)
        except InputError:
            continue
        if run.summary and len(run.history.get("t", ())) > 1:
            found[number] = run
    return found


def varies(runs, name):
    known = [v for v in (run.history[name][np.isfinite(run.history[name])] for run in runs if name in run.history) if len(v)]
    return any(np.ptp(values) > 0 for values in known)


def chosen(runs):
    """Columns that change, those first that only the script records."""
    names = list(dict.fromkeys(n for run in runs for n in run.history))
    tools = {n for run in runs for n in run.summary.get("final", {})}
    coordinates = {n[2:] for n in names if n.startswith("Q_")}
    own = [n for n in names if n not in tools and n not in coordinates and not n.startswith(("Q_", "support_", "factorizations"))
           and not n.endswith(("_Fx", "_Fy", "_Fz", "_Mx", "_My", "_Mz"))]
    return [n for n in own + [n for n in names if n not in own] if n == "t" or varies(runs, n)][:MOST_COLUMNS]


def described(run, name):
    """(label, factor) of a column in the units of the pictures."""
    column = run.columns.get(name)
    if column is None or column.kind == units.OTHER:
        return name, 1.0
    return plain_text(column.axis()), column.factor


def numbers(values):
    return [float(f"{v:.5g}") if np.isfinite(v) else None for v in values]


def curves_of(variants, folders):
    """Adds "curves", {column: numbers}, to each variant. @returns [{name, label, factor}] of the columns"""
    runs = runs_of(folders)
    for variant in variants:
        variant["curves"] = {}
    if not runs:
        return []
    names = chosen(list(runs.values()))
    points = int(np.clip(MOST_NUMBERS / (len(runs) * len(names)), FEWEST, MOST))
    last = list(runs.values())[-1]
    columns = [{"name": n, "label": described(last, n)[0], "factor": described(last, n)[1]} for n in names if n in last.history]
    for number, run in runs.items():
        kept = np.unique(np.linspace(0, len(run.history["t"]) - 1, min(points, len(run.history["t"]))).astype(int))
        variants[number]["curves"] = {c["name"]: numbers(c["factor"] * run.history[c["name"]][kept]) for c in columns if c["name"] in run.history}
    return columns
