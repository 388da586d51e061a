"""Compares coarse runs with stored numbers: python3 rolling_coarse.py FOLDER REFERENCE.json"""
import json
import sys
from run import HEADER, Checks, Run

folder, reference = sys.argv[1:3]
with open(reference) as f:
    stored = json.load(f)
checks = Checks()
for name, expected in stored["runs"].items():
    run = Run(f"{folder}/{name}")
    checks.that(name + " status", run.summary["status"] == "finished", run.summary["status"])
    checks.that(name + " header", run.header == HEADER, run.header)
    for key, value in run.values().items():
        checks.near(f"{name} {key}", value, expected[key], stored["relative_tolerance"][key])
    imbalance = run.largest_imbalance(7.5e5, 2e3, 15e-3)
    checks.that(name + " resultants", imbalance <= 1.1e-4, f"largest imbalance {imbalance:.2e} of the load, allowed 1.1e-4")
checks.done()
