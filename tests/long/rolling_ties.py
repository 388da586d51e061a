"""Tied edges on example 1:  python3 rolling_ties.py FOLDER, with the runs plain, tied and, if there, event in it.
Prints a table: stick and slip events of all nodes; frames (t > 0.25) in which the sticking corners are one run; share of the contact
that sticks by shared forces, at the end and its mean over the frames; depth, torque, plastic strain and their change."""
import glob
import json
import os
import sys
from collections import namedtuple

import numpy as np
from plotting.vtp import read_vtp
from plotting.vtu import read_vtu
from run import Checks, Run

STICKING = (1, 3)  # states touched, sticking
TOUCHING = (1, 2, 3)
Row = namedtuple("Row", "name steps changes one_run runs share depth torque point node p99 field")


def runs_of_corners(path):
    """Number of runs of sticking corners in a frame; the nodes lie one after another, every second is a corner."""
    surface = read_vtp(path)
    order = np.argsort(np.arctan2(surface.points[:, 1], surface.points[:, 0]))
    state = surface.data["state"][order].astype(int)[::2]
    state = state[np.isin(state, TOUCHING)]
    sticks = np.isin(state, STICKING).astype(int)
    return int(np.sum(np.diff(np.concatenate(([0], sticks))) == 1))


def result(run, name):
    return next(v["value"] for k, v in run.summary["results"].items() if k.strip().startswith(name))


def row_of(folder, name):
    path = os.path.join(folder, name)
    run = Run(path)
    frames = len(glob.glob(os.path.join(path, "surface-*.vtp")))
    counts = [runs_of_corners(os.path.join(path, f"surface-{k}.vtp")) for k in range(frames // 4, frames)]
    events = run.summary["counts"]["events"]
    field = read_vtu(os.path.join(path, "final.vtu"), ["plastic_strain_eq"]).data["plastic_strain_eq"]
    return Row(name, run.summary["counts"]["steps"], events["slip-to-stick"] + events["stick-to-slip"],
               float(np.mean(np.array(counts) <= 1)), float(np.mean(counts)), run.summary["final"]["stick_share"],
               result(run, "depth"), result(run, "moment Q_phi"), result(run, "largest plastic"), run.summary["final"]["plastic_strain_eq_nodal_max"],
               result(run, "99 %"), field)


def main(folder):
    names = [n for n in ("plain", "tied", "event") if os.path.exists(os.path.join(folder, n, "summary.json"))]
    rows = {n: row_of(folder, n) for n in names}
    base = rows["plain"]
    change = lambda row, key: 100 * abs(getattr(row, key) / getattr(base, key) - 1)
    print("run    steps  stick/slip  one run %  runs  share %   change of depth, torque, ep point, node, p99, L2 %")
    for row in rows.values():
        l2 = 100 * np.linalg.norm(row.field - base.field) / np.linalg.norm(base.field)
        print(f"{row.name:6} {row.steps:5} {row.changes:11} {100 * row.one_run:10.1f} {row.runs:5.2f} {100 * row.share:8.1f}   "
              + " ".join(f"{change(row, key):.3f}" for key in ("depth", "torque", "point", "node", "p99")) + f" {l2:.2f}")
    with open(os.path.join(folder, "tied", "summary.json")) as f:
        options = json.load(f)["options"]
    if (options["inner"], options["outer"], options["sides"], options["steps"]) != (10, 150, 20, 200) or "event" not in rows:
        return
    checks, tied, event = Checks(), rows["tied"], rows["event"]
    checks.that("one run, implicit", tied.one_run >= 0.95, f"{100 * tied.one_run:.1f} % of the frames, at least 95")
    checks.that("stick and slip, implicit", tied.changes <= 0.6 * base.changes, f"{tied.changes} of {base.changes}")
    checks.that("one run, event", event.one_run >= 0.9, f"{100 * event.one_run:.1f} % of the frames, at least 90")
    checks.that("stick and slip, event", event.changes <= 2 * tied.changes, f"{event.changes}, at most twice {tied.changes}")
    checks.near("depth, tied", tied.depth, base.depth, 0.001)
    checks.near("torque, tied", tied.torque, base.torque, 0.002)
    checks.near("p99, tied", tied.p99, base.p99, 0.01)
    checks.near("depth, event", event.depth, tied.depth, 0.004)
    checks.near("torque, event", event.torque, tied.torque, 0.004)
    checks.near("p99, event", event.p99, tied.p99, 0.015)
    checks.done()


main(sys.argv[1])
