#!/usr/bin/python3
"""check.py test|long: runs the scenes of bounds.csv beside it that are marked so, and compares. Every scene has to end with
status 0 and an imbalance below 1e-3, within its steps; work and force to 1 %, the value to its tolerance (mm, deg; see the
scene's last line). A row with "same as", a copy turned or in another unit of length and stress, has to take the same steps."""
import csv
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
RELATIVE, IMBALANCE, COPY = 0.01, 1e-3, 1e-6
LINE = re.compile(r"^forming (.*)$", re.M)


def run(scene, options):
    """What the scene's last line says: {name: number}, the value under "value"."""
    command = [os.environ["BURNISH"], os.path.join(HERE, scene + ".edp"), *options.split()]
    out = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    words = LINE.findall(out)
    if not words:
        sys.exit(f"{scene} {options}: no result\n{out[-2000:]}")
    words = words[-1].split()
    found = {words[k]: float(words[k + 1]) for k in range(0, len(words) - 2, 2)}
    found["value"] = float(words[-1])
    return found


def faults(row, found, others):
    if found["t"] < 1 - 1e-9 or found["status"] != 0:
        yield f"ended at t = {found['t']:g} with status {found['status']:g}"
    if not found["imbalance"] < IMBALANCE:
        yield f"imbalance {found['imbalance']:g}"
    for name, column in (("steps", "most steps"), ("rejected", "most rejected")):
        if found[name] > float(row[column]):
            yield f"{found[name]:g} {name}, expected at most {row[column]}"
    for name in ("work", "force"):
        if row[name] and abs(found[name] / float(row[name]) - 1) > RELATIVE:
            yield f"{name} {found[name]:g}, expected {row[name]} within {RELATIVE:g} of it"
    if row["value"] and abs(found["value"] - float(row["value"])) > float(row["tolerance of it"]):
        yield f"value {found['value']:g}, expected {row['value']} +- {row['tolerance of it']}"
    if row["same as"]:
        other = others.get(row["same as"]) or run(*row["same as"].split(" ", 1))
        for name in ("steps", "rejected"):
            if found[name] != other[name]:
                yield f"{found[name]:g} {name}, those of \"{row['same as']}\" are {other[name]:g}"
        for name in ("work", "force", "value"):
            if abs(found[name] - other[name]) > COPY * max(1, abs(other[name])):
                yield f"{name} {found[name]:.9g}, that of \"{row['same as']}\" is {other[name]:.9g}"


def main(kind):
    with open(os.path.join(HERE, "bounds.csv"), encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["run"] == kind]
    results, wrong = {}, 0
    for row in rows:
        name = f"{row['scene']} {row['options']}"
        found = results[name] = run(row["scene"], row["options"])
        found_faults = list(faults(row, found, results))
        wrong += bool(found_faults)
        print(f"{name}: {found['steps']:g} steps ({found['rejected']:g} rejected), force {found['force']:g}, work {found['work']:g}, "
              f"value {found['value']:g}" + "".join("\n  " + text for text in found_faults), flush=True)
    return wrong > 0 or not rows


sys.exit(main(*sys.argv[1:]))
