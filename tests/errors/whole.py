"""Are the results of a rolling run that ended early whole, and do they show its last accepted state?

whole.py FOLDER STATUS "words of the reason" STEPS RADIUS: history.csv, events.csv, surface.csv, summary.json and final.vtu
are read to their ends; the last line of the history, the summary, the nodes of the surface, which must lie on the roller of
RADIUS where they touch it, and the displacements of final.vtu must belong together. At least STEPS steps were accepted.
"""
import csv
import json
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cases"))
from plotting.vtu import read_vtu


def fail(text):
    sys.exit(f"{sys.argv[1]}: {text}")


def table(path):
    """Rows of a CSV file as dictionaries; every line complete."""
    text = path.read_text()
    if not text.endswith("\n"):
        fail(f"{path.name} ends in the middle of a line")
    rows = list(csv.reader(text.splitlines()))
    for number, row in enumerate(rows, 1):
        if len(row) != len(rows[0]):
            fail(f"{path.name} line {number}: {len(row)} columns instead of {len(rows[0])}")
    return [dict(zip(rows[0], row)) for row in rows[1:]]


def close(name, computed, expected, tolerance):
    if not abs(computed - expected) <= tolerance:
        fail(f"{name}: {computed}, expected {expected} within {tolerance}")


def main():
    folder, status, words, steps, radius = Path(sys.argv[1]), sys.argv[2], sys.argv[3], int(sys.argv[4]), float(sys.argv[5])

    def refuse(name):
        raise ValueError(f"{name} is no JSON")

    summary = json.loads((folder / "summary.json").read_text(), parse_constant=refuse)
    if summary["status"] != status or words not in summary["reason"]:
        fail(f'summary: status "{summary["status"]}", reason "{summary["reason"]}", expected "{status}", "{words}"')
    history, surface, events = (table(folder / f"{name}.csv") for name in ("history", "surface", "events"))
    if len(history) - 1 != summary["counts"]["steps"] or summary["counts"]["steps"] < steps:
        fail(f'{len(history)} lines of history, {summary["counts"]["steps"]} steps, expected at least {steps}')
    if len(events) != sum(summary["counts"]["events"].values()):
        fail(f'{len(events)} lines of events, the summary counts {summary["counts"]["events"]}')
    last = {name: float(value) for name, value in history[-1].items()}
    for name in ("t", "r", "phi", "theta", "Q_r", "Q_phi", "Q_theta", "stress_eq_max", "plastic_strain_eq_max"):
        close(f"summary {name}", summary["final"][name], last[name], 1e-9 * max(1e-3, abs(last[name])))

    # touching nodes lie on the roller of the last line
    center = last["r"] * math.cos(last["phi"]), last["r"] * math.sin(last["phi"])
    touching = [node for node in surface if node["state"] in ("touched", "sliding", "sticking")]
    if not touching:
        fail("no node of the surface touches the roller")
    spacing = math.hypot(float(surface[1]["X"]) - float(surface[0]["X"]), float(surface[1]["Y"]) - float(surface[0]["Y"]))
    # mid nodes stand for places on the outer arc, and lie on the chords of its edges (METHOD.md 3.18), which deform
    ring = math.hypot(float(surface[0]["X"]), float(surface[0]["Y"]))
    for node in touching:
        chord = ring - math.hypot(float(node["X"]), float(node["Y"]))
        distance = math.hypot(float(node["x"]) - center[0], float(node["y"]) - center[1])
        close(f'distance of node {node["node"]} from the roller\'s center', distance, radius + chord, 1e-4 * spacing + 0.25 * chord)

    # the fields show the same displacements (single precision)
    field = read_vtu(folder / "final.vtu", ["displacement", "stress_eq", "plastic_strain_eq"])
    points = {(round(x, 6), round(y, 6)): k for k, (x, y) in enumerate(field.points[:, :2])}
    found = 0
    for node in surface:
        k = points.get((round(float(node["X"]), 6), round(float(node["Y"]), 6)))
        if k is None:
            continue
        found += 1
        for axis, reference, present in ((0, "X", "x"), (1, "Y", "y")):
            moved = float(node[present]) - float(node[reference])
            close(f'final.vtu displacement {axis} of node {node["node"]}', field.data["displacement"][k][axis], moved, 1e-8)
    if found < 0.9 * len(surface):
        fail(f"only {found} of {len(surface)} surface nodes found in final.vtu")
    print(f"{folder.name}: {status}, {len(history) - 1} steps, {len(events)} events, {len(touching)} touching nodes: whole")


main()
