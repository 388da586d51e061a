"""Runs a case coarsely and compares its numbers with stored ones:  case.py NAME [--store]

A test of a case is tests/regression/NAME.sh with this line and a file NAME.json beside it:
    exec "$PYTHON" tests/regression/case.py NAME
NAME.json:
    {"about": "what is run, units of the numbers",
     "relative_tolerance": {"default": 0.01, "depth": 0.002, "angle": {"absolute": 1e-6}},
     "why": {"default": "the reason of each tolerance", "depth": "...", "angle": "..."},
     "runs": {"p2": {"options": "-steps 20 -R 0.01", "values": {"depth": 9.5e-05, "Q_y": -4e5, "counts.steps": 40}},
              "p1": {"options": "-steps 20 -element P1", "pictures": ["stress"], "values": {...}}}}
A name is looked for in the summary's "results", then in its "final"; "part.name" looks into that part. Every run must
finish with exit code 0 (so rcExpect holds), with one line of history for each step; "pictures": the names of the PNG files
that plot.py must draw, each with something in it (tests/support/picture.py); without it none are drawn.
From the top folder, after make:  python3 tests/regression/case.py NAME --store  puts the computed numbers into NAME.json in
place of the stored ones (start with any); look at the difference before committing.
"""
import csv
import glob
import json
import os
import shlex
import subprocess
import sys

from run import Checks

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "support"))
from picture import faults


def number(summary, name):
    """The number that a name means; None if the summary has none."""
    part, _, rest = name.partition(".")
    places = [(summary.get(part), rest)] if rest and part in summary else []
    places += [(summary.get("results"), name), (summary.get("final"), name)]
    for values, key in places:
        if isinstance(values, dict) and key in values:
            value = values[key]
            return value.get("value") if isinstance(value, dict) else value
    return None


def compare_pictures(folder, label, expected, checks):
    """Those drawn are those expected, with something in each."""
    drawn = sorted(os.path.basename(path)[:-len(".png")] for path in glob.glob(os.path.join(folder, "*.png")))
    checks.that(f"{label} pictures", drawn == sorted(expected), f"{drawn}, expected {sorted(expected)}")
    for name in drawn:
        wrong = faults(os.path.join(folder, name + ".png"))
        checks.that(f"{label} picture {name}", not wrong, "; ".join(wrong) or "something is drawn")


def run(case, label, options, pictures, checks):
    """Runs the case into $SCRATCH/LABEL; its summary, None if there is none."""
    folder = os.path.join(os.environ.get("SCRATCH", f"out/regression/{case}"), label)
    command = [os.environ.get("BURNISH", "build/burnish"), f"cases/{case}/{case}.edp", "-out", folder,
               *([] if case == "shear" else ["-series", "1"]),    # points only, no fields
               "-pictures", "2" if pictures else "0", *shlex.split(options)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    tail = "\n".join(done.stdout.splitlines()[-25:])
    checks.that(f"{label} exit code", done.returncode == 0,
                f"{done.returncode}" + ("" if done.returncode == 0 else "\n" + tail))
    try:
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
    except OSError as error:
        checks.that(f"{label} summary", False, str(error))
        return None
    checks.that(f"{label} status", summary["status"] == "finished", f"{summary['status']} {summary['reason']}")
    with open(os.path.join(folder, "history.csv")) as file:
        lines = len(list(csv.DictReader(file)))
    steps = summary["counts"]["steps"]
    checks.that(f"{label} history", lines == steps + 1, f"{lines} lines, {steps} steps")
    if pictures:
        compare_pictures(folder, label, pictures, checks)
    return summary


def compare(checks, label, name, computed, expected, tolerance):
    if computed is None:
        checks.that(f"{label} {name}", False, "not in the summary's results or final")
    elif isinstance(tolerance, dict):
        error = abs(computed - expected)
        checks.that(f"{label} {name}", error <= tolerance["absolute"],
                    f"computed {computed:.7g}, expected {expected:.7g}, error {error:.3g}, "
                    f"allowed {tolerance['absolute']:g}")
    elif expected == 0:
        checks.that(f"{label} {name}", False, 'expected 0: give {"absolute": ...} as its tolerance')
    else:
        checks.near(f"{label} {name}", computed, expected, tolerance)


def main(arguments):
    if not arguments or arguments[0].startswith("-") or arguments[1:] not in ([], ["--store"]):
        sys.exit("usage: case.py NAME [--store]")
    case, store = arguments[0], arguments[1:]
    reference = os.path.join(HERE, case + ".json")
    with open(reference) as file:
        stored = json.load(file)
    tolerances = stored["relative_tolerance"]
    checks, compared = Checks(), 0
    silent = [name for name in tolerances if not stored["why"].get(name)]
    checks.that("a reason for each tolerance", not silent, ", ".join(silent) or f"{len(tolerances)} reasons")
    for label, entry in stored["runs"].items():
        summary = run(case, label, entry.get("options", ""), entry.get("pictures", []), checks)
        for name, expected in entry["values"].items() if summary else ():
            computed = number(summary, name)
            if store and computed is not None:
                entry["values"][name] = float(f"{computed:.8g}")
            else:
                compare(checks, label, name, computed, expected, tolerances.get(name, tolerances["default"]))
            compared += 1
    checks.that("numbers", compared > 0, f"{compared} compared")
    if store:
        with open(reference, "w") as file:
            json.dump(stored, file, indent=1, ensure_ascii=False)
            file.write("\n")
    checks.done()


if __name__ == "__main__":
    main(sys.argv[1:])
