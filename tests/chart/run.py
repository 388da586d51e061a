"""Speed against accuracy: runs every scene by every method, element, mesh and step, and says what to use.

run.py [--quick] [--only TEXT] [--references] [--repeat N] [--again] [--store] [--medium] [--out FOLDER]
                                       see the Makefile's targets chart, chart-quick and references
Scenes are scripts that print `result NAME VALUE`, `curve NAME x value ...` and `field NAME value ...`; which methods, meshes and
steps: scenes.csv, methods.csv, runs.csv; peers, programs beside ours, are asked where they are installed, but not by --quick.
All runs of a repetition are done before the next one begins, every other one backwards, so that a machine that slows down does so for all.
Seconds are CPU seconds from the space to the equilibrium, without the start of the script and its mesh; the
median is kept, and the spread, half of the largest minus the smallest over the median; megabytes are the peak of the whole process.
Quantities: NAME=0 is an error already, against the exact solution; NAME=run, NAME=1,2,4 (largest error over these quarters of
the program, each in the CSV, too; end: both ends of the contact), NAME=curve (relative L2 norm over the run's own nodes), NAME=field
(over the area, in points that all runs share) are relative, against references.csv, curves.csv and fields.csv: a fine run with the
difference to a coarser one as its own error, below which no error is given and no level answered. A run that stops early, takes too
long or is not to be trusted says so under outcome and has no place on a front.
Results in the folder, for scene hertz: hertz.csv (one row for a method, element, mesh and step), hertz.png (the first quantity),
hertz-all.png (the others), hertz.md (the tables); --store: all of it into this folder (store.py). An error above WRONG (--quick:
WRONG_QUICK) in an exact or a global quantity of a method's finished run of a scene's last element on its finest mesh is said, one of
ours gives exit status 1.
"""
import argparse
import csv
import math
import os
import re
import statistics
import sys
import time

import criterion
import draw
import report
from scene_files import (curve_error, field_error, installed, methods, own_runs, read_curves, read_fields, read_references, run, scenes,
                         write_references)
from store import read, store, write

WRONG, WRONG_QUICK = 0.1, 0.4
GLOBAL = {"depth", "shift", "rotation", "torque", "a", "width"}
ONCE = 4  # [s]
PAIRED = {"ball"}  # scenes whose peers stand beside ours here, the others' in tests/peers/README.md


def repeat_all(tasks, times):
    """Results of every task, repeated in turns; a run that takes longer than ONCE is not repeated."""
    found = [[] for _ in tasks]
    begun, done = time.time(), 0
    for k in range(times):
        order = list(enumerate(tasks))
        for i, (scene, method, element, n, steps) in order if k % 2 == 0 else reversed(order):
            if k == 0 or found[i][0]["seconds"] < ONCE:
                extra = ["-steps", str(steps)] if steps else []
                found[i].append(run(scene, method["options"] + ["-element", element, "-n", str(n)] + extra, method["program"]))
            done += 1
            if sys.stderr.isatty():
                left = (time.time() - begun) * (times * len(tasks) - done) / done
                print(f"\r  {done} of {times * len(tasks)} runs, about {left:.0f} s left ", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    return found


def errors_of(scene, result, references, curves, fields):
    """Errors by name of the quantity, and at every quarter; none where the run did not come so far."""
    found = {}
    for quantity, kind in scene["quantities"].items():
        if kind == "0":
            found[quantity] = abs(result[quantity]) if quantity in result else math.nan
        elif kind == "curve":
            found[quantity] = curve_error(result["curves"].get(quantity), curves[scene["name"], quantity])
        elif kind == "field":
            found[quantity] = field_error(result["fields"].get(quantity), fields[scene["name"], quantity])
        else:
            names = [quantity] if kind == "run" else [f"{quantity}_{k}" for k in kind.split(",")]
            parts = {n: abs(result[n] / references[scene["name"], n][0] - 1) if n in result else math.nan for n in names}
            found.update(parts)
            found[quantity] = max(parts.values()) if all(v == v for v in parts.values()) else math.nan
    return found


def row_of(task, results, *known):
    scene, method, element, n, steps = task
    seconds = [r["seconds"] for r in results]
    middle = statistics.median(seconds)
    row = {"method": method["name"], "whose": method["whose"], "kernel": method["kernel"], "element": element, "n": n, "dtsteps": steps,
           "seconds": middle, "spread": (max(seconds) - min(seconds)) / 2 / max(middle, 1e-9), "repeats": len(results),
           "megabytes": statistics.median(r["megabytes"] for r in results), "outcome": results[0]["outcome"]}
    for name in ("dofs", "steps", "rejected", "factorizations", "solves"):
        row[name] = int(results[0].get(name, 0))
    return {**row, **errors_of(scene, results[0], *known)}


def wrong_runs(scene, rows, bound):
    """{sentence: is it ours} of runs that are off on the finest mesh of their method."""
    last = {row["method"]: row for row in sorted(rows, key=lambda r: (r["n"], r["dtsteps"])) if row["element"] == scene["trusted"]}
    return {f"{report.run_name(row)}: {q} off by {100 * row[q]:.3g} %": row["whose"] == "ours"
            for row in last.values() if row["outcome"] == "finished" for q, kind in scene["quantities"].items()
            if (kind == "0" or q in GLOBAL) and not row[q] < bound}


def tasks_of(scene, options):
    """(scene, method, element, n, steps) of all runs, coarse meshes first; peers if they are installed."""
    size = "quick" if options.quick else "full"
    (meshes, steps), tasks = scene[size], []
    for method in methods():
        asked = [(e, n, k) for e in scene["elements"] for n in meshes for k in steps] if method["name"] in scene["methods"] else []
        asked += own_runs(scene, method, size, *["medium"] * (options.medium and not options.quick))
        if asked and not installed(method):
            print(f"{scene['name']}: {method['name']} is not installed and left out")
            continue
        tasks += [(scene, method, *one) for one in asked]
    return sorted(tasks, key=lambda task: task[3:])


def measure(scene, options):
    """Runs the scene."""
    tasks = tasks_of(scene, options)
    found = repeat_all(tasks, options.repeat or (2 if options.quick else 3))
    known = read_references(), read_curves(), read_fields()
    write(os.path.join(options.out, scene["name"] + ".csv"), [row_of(t, results, *known) for t, results in zip(tasks, found)])
    if scene["name"] == criterion.SCENE and not options.quick:
        write(os.path.join(options.out, "criterion.csv"), criterion.measure(scene, options.medium))


def uncertainties(scene):
    """Error of the reference by quantity, the largest of the quarters; none for what is exact."""
    found = {}
    for (name, quantity), (_, uncertain) in read_references().items():
        base, _, quarter = quantity.partition("_")
        if name == scene["name"] and base in scene["quantities"] and (not quarter or quarter in scene["quantities"][base].split(",")):
            found[base] = max(found.get(base, 0), uncertain)
    return found


def show(scene, folder, bound):
    """Pictures and tables of what is in the folder; returns the tables by name, and what is wrong."""
    rows, quantities, known = read(os.path.join(folder, scene["name"] + ".csv")), list(scene["quantities"]), uncertainties(scene)
    for row in rows:
        row.update({q: max(row[q], known[q]) for q in known})
    done = [r for r in rows if r["outcome"] == "finished" and all(r[q] == r[q] for q in quantities)]
    draw.chart(done, quantities[:1], os.path.join(folder, scene["name"] + ".png"))
    draw.chart(done, quantities[1:], os.path.join(folder, scene["name"] + "-all.png"))
    wrong = wrong_runs(scene, rows, bound)
    parts = {q: e for (name, q), (_, e) in read_references().items() if name == scene["name"] and q.startswith(quantities[0] + "_")}
    tables = {"use": report.table(done, quantities, known), "forms": report.costs(rows)}
    tables["forms"] += ["", f"Finished, and off by more than {100 * bound:g} %: {'; '.join(wrong)}."] if wrong else []
    if len(parts) > 2:
        tables["quarters"] = report.quarters(done, parts)
    if scene["name"] in PAIRED:
        tables["peers"] = report.peers(done, quantities)
    text = report.report(scene["name"], rows, done, quantities, tables)
    if scene["name"] == criterion.SCENE and os.path.exists(os.path.join(folder, "criterion.csv")):
        tables["criterion"] = criterion.table(read(os.path.join(folder, "criterion.csv")))
        text += "\n".join(["", "## Criterion of convergence", "", *tables["criterion"], ""])
    with open(os.path.join(folder, scene["name"] + ".md"), "w") as f:
        f.write(text)
    print(text)
    return tables, wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true", help="coarse meshes, twice instead of three times")
    parser.add_argument("--only", default="", help="scenes whose name holds this pattern")
    parser.add_argument("--references", action="store_true", help="run the reference runs first")
    parser.add_argument("--none", action="store_true", help="with --references: nothing but them")
    parser.add_argument("--repeat", type=int, default=0, help="how often every run is made")
    parser.add_argument("--again", action="store_true", help="no runs: pictures and tables of the files in the folder")
    parser.add_argument("--store", action="store_true", help="rows, pictures and tables into this folder and README.md")
    parser.add_argument("--medium", action="store_true", help="peers on finer meshes, too: a quarter of an hour more")
    parser.add_argument("--out", default="out/chart")
    options = parser.parse_args()
    chosen = [s for s in scenes() if re.search(options.only, s["name"])]
    if not chosen:
        sys.exit(f"chart: no name of a scene holds \"{options.only}\"")
    os.makedirs(options.out, exist_ok=True)
    if options.references:
        write_references(chosen)
        if options.none:
            sys.exit(0)
    ours = False
    for scene in chosen:
        if not options.again:
            measure(scene, options)
        tables, wrong = show(scene, options.out, WRONG_QUICK if options.quick else WRONG)
        ours = ours or any(wrong.values())
        if options.store:
            store(scene, tables, options.out)
    sys.exit(ours)


if __name__ == "__main__":
    main()
