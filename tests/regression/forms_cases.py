"""Compares runs with the law of the core and of the script: python3 forms_cases.py FOLDER NAME..."""
import json
import sys
from run import Checks

folder, *names = sys.argv[1:]
checks = Checks()
for name in names:
    runs = []
    for kind in ("", "-forms"):
        with open(f"{folder}/{name}{kind}/summary.json") as f:
            runs.append(json.load(f))
    core, forms = runs
    if not name.startswith("ring"):  # upsetting has a second run, with the law of the core
        checks.that(name + " way", "of the script" in forms["way"]["law and assembly"], forms["way"])
    largest = max(abs(v) for k, v in core["final"].items() if k.startswith("Q_") and not k.endswith(("angle", "theta")))
    for key, value in core["final"].items():
        if key.startswith("Q_") and not key.endswith(("angle", "theta")):
            difference = abs(forms["final"][key] - value)/largest
            checks.that(f"{name} {key}", difference <= 0.02, f"{difference:.1e} of the largest force, allowed 0.02")
    if name == "rolling":
        yields = [r["counts"]["events"]["yield"] for r in runs]
        checks.that("rolling yields", yields[0] > 100 and yields[1] == yields[0], yields)
checks.done()
