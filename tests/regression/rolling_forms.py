"""Compares the ways of a run: python3 rolling_forms.py FOLDER"""
import json
import sys
from run import Checks

folder = sys.argv[1]
checks = Checks()


def summary(name):
    with open(f"{folder}/{name}/summary.json") as f:
        return json.load(f)


def compare(name, other, tolerance, events):
    a, b = summary(name), summary(other)
    if events:
        checks.that(f"{other} events", a["counts"]["events"] == b["counts"]["events"], b["counts"]["events"])
    for key, value in a["final"].items():
        scale = max(abs(value), 1e-3 if key.startswith("Q_") else 1e-12)
        difference = abs(b["final"][key] - value) / scale
        checks.that(f"{other} {key}", difference <= tolerance, f"{difference:.1e}, allowed {tolerance:.0e}")
    return b


compare("implicit", "implicit-law", 1e-9, True)
compare("event", "event-law", 1e-9, True)
forms = compare("implicit", "implicit-forms", 1e-9, True)
checks.that("says whose law", forms["way"]["law and assembly"] == "law and forms of the script", forms["way"])
checks.that("tangent checked", 0 < forms["way"]["tangent_check"] < 1e-5, forms["way"]["tangent_check"])
for other in ("umfpack-law", "umfpack-forms", "burnish-forms"):
    run = compare("umfpack", other, 1e-7 if "burnish" in other else 1e-9, True)
    checks.that(other + " solver", run["way"]["solver"] == ("BURNISH" if "burnish" in other else "UMFPACK"), run["way"])
checks.done()
