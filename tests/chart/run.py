"""Speed against accuracy: runs every scene by every method, element, mesh and step, and says what to use.

run.py [--quick] [--only TEXT] [--references] [--repeat N] [--again] [--store] [--medium] [--out FOLDER]
                                       see the Makefile's targets chart, chart-quick and references
Scenes are scripts that print `result NAME VALUE`, `curve NAME x value x value ...` and `field NAME value ...`; which methods, meshes and
steps: scenes.csv, methods.csv; peers, programs beside ours that are asked where they are installed, but not by --quick: peers.csv.
All runs of a repetition are done before the next one begins, every other one backwards, so that a machine that slows down does so for all. Seconds are CPU seconds from the space to the equilibrium, without the start of the script and its mesh; the
median is kept, and the spread, half of the largest minus the smallest over the median; megabytes are the peak of the whole process.
Quantities: NAME=0 is an error already, against the exact solution; NAME=run, NAME=1,2,4 (largest error over these quarters of
the program, each in the CSV, too; end: both ends of the contact), NAME=curve (relative L2 norm over the run's own nodes), NAME=field
(over the area, in points that all runs share) are relative, against references.csv, curves.csv and fields.csv: a fine run with the
difference to a coarser one as its own error, below which no error is given. A run that stops early, takes too long or is not to be trusted says so under outcome and has no place on a front.
Results in the folder, for scene hertz: hertz.csv (one row for a method, element, mesh and step), hertz.png, hertz.md (the tables). An error above WRONG (--quick: WRONG_QUICK) in an exact or a
global quantity of a finished run of a scene's last element on the finest mesh gives exit status 1.
"""
import argparse
import csv
import math
import os
import re
import shutil
import statistics
import sys
import time

import criterion
import draw
import report
from scene_files import (HERE, curve_error, field_error, installed, methods, peer_runs, read_curves, read_fields, read_references, run, scenes,
                         write_references)

ELEMENTS = ["P1", "P2"]
WRONG, WRONG_QUICK = 0.1, 0.4
GLOBAL = {"depth", "shift", "rotation", "torque", "a", "width"}
ONCE = 4  # [s]


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
    row = {"scene": scene["name"], "method": method["name"], "whose": method["whose"], "element": element, "n": n, "dtsteps": steps,
           "seconds": middle, "spread": (max(seconds) - min(seconds)) / 2 / max(middle, 1e-9), "repeats": len(results),
           "megabytes": statistics.median(r["megabytes"] for r in results), "outcome": results[0]["outcome"]}
    for name in ("dofs", "steps", "rejected", "factorizations", "solves"):
        row[name] = int(results[0].get(name, 0))
    return {**row, **errors_of(scene, results[0], *known)}


def write(path, rows):
    with open(path, "w", newline="") as f:
        table = csv.DictWriter(f, list(rows[0]), lineterminator="\n")
        table.writeheader()
        for row in rows:
            table.writerow({k: f"{v:.5g}" if isinstance(v, float) else v for k, v in row.items()})


def read(path):
    """Rows as they were written: whole numbers, numbers and words."""
    def value(word):
        for kind in (int, float):
            try:
                return kind(word)
            except ValueError:
                pass
        return word == "True" if word in ("True", "False") else word

    with open(path) as f:
        return [{k: v if k in ("factor", "method") else value(v) for k, v in row.items()} for row in csv.DictReader(f)]


def wrong_runs(scene, rows, bound):
    """Sentences of runs on the finest mesh that are off."""
    finest = max((row["n"], row["dtsteps"]) for row in rows if row["whose"] == "ours")
    return [f"{row['method']}, {row['element']}, n = {row['n']}: {q} off by {100 * row[q]:.3g} %"
            for row in rows if (row["n"], row["dtsteps"]) == finest and row["outcome"] == "finished"
            and row["element"] == scene["trusted"] for q, kind in scene["quantities"].items()
            if (kind == "0" or q in GLOBAL) and not row[q] < bound]


def peer_tasks(scene, medium):
    """Those of peers that are installed."""
    tasks = []
    for method in methods():
        asked = list(peer_runs(scene, method, medium)) if method["program"] else []
        if asked and installed(method):
            tasks += [(scene, method, *one) for one in asked]
        elif asked:
            print(f"{scene['name']}: {method['name']} is not installed and left out")
    return tasks


def measure(scene, options):
    """Runs the scene."""
    meshes, steps = scene["quick" if options.quick else "full"]
    able = [m for m in methods() if not m["program"] and (not scene["methods"] or m["name"] in scene["methods"])]
    tasks = [(scene, m, e, n, k) for n in meshes for k in steps for e in scene["elements"] for m in able
             if m["whose"] == "ours" or e not in scene["ours"]]
    if not options.quick:
        tasks += peer_tasks(scene, options.medium)
    found = repeat_all(tasks, options.repeat or (2 if options.quick else 3))
    known = read_references(), read_curves(), read_fields()
    write(os.path.join(options.out, scene["name"] + ".csv"), [row_of(t, results, *known) for t, results in zip(tasks, found)])
    if scene["name"] == criterion.SCENE and not options.quick:
        write(os.path.join(options.out, "criterion.csv"), criterion.measure(scene, options.medium))


def show(scene, folder):
    """Pictures and tables of what is in the folder; returns the rows."""
    rows, quantities = read(os.path.join(folder, scene["name"] + ".csv")), list(scene["quantities"])
    for (name, quantity), (_, uncertain) in read_references().items():
        base, _, quarter = quantity.partition("_")
        if name != scene["name"] or base not in quantities or (quarter and quarter not in scene["quantities"][base].split(",")):
            continue
        for row in rows:
            row[base] = max(row[base], uncertain)
    done = [r for r in rows if r["outcome"] == "finished" and all(r[q] == r[q] for q in quantities)]
    draw.chart(done, quantities, os.path.join(folder, scene["name"] + ".png"))
    text = report.report(scene["name"], rows, done, quantities)
    if scene["name"] == criterion.SCENE and os.path.exists(os.path.join(folder, "criterion.csv")):
        text += "\n".join(["", "## Criterion of convergence", "", *criterion.table(read(os.path.join(folder, "criterion.csv"))), ""])
    with open(os.path.join(folder, scene["name"] + ".md"), "w") as f:
        f.write(text)
    print(text)
    return rows, done


def store(scene, rows, done, folder):
    """Picture into this folder, tables into README.md beside it between <!-- chart NAME --> and <!-- end -->."""
    shutil.copy(os.path.join(folder, scene["name"] + ".png"), os.path.join(HERE, scene["name"] + ".png"))
    path = os.path.join(HERE, "README.md")
    with open(path) as f:
        text = f.read()
    tables = {"use": report.table(done, list(scene["quantities"])), "forms": report.costs(rows)}
    if scene["name"] == criterion.SCENE and os.path.exists(os.path.join(folder, "criterion.csv")):
        tables["criterion"] = criterion.table(read(os.path.join(folder, "criterion.csv")))
    for name, lines in tables.items():
        mark = f"<!-- chart {scene['name']} {name} -->"
        text, count = re.subn(re.escape(mark) + r"\n.*?<!-- end -->", lambda _: "\n".join([mark, *lines, "<!-- end -->"]), text,
                              flags=re.DOTALL)
        if count != 1:
            sys.exit(f"chart: README.md has {count} times {mark}, expected once")
    with open(path, "w") as f:
        f.write(text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true", help="coarse meshes, twice instead of three times")
    parser.add_argument("--only", default="", help="scenes whose name holds this pattern")
    parser.add_argument("--references", action="store_true", help="run the reference runs first")
    parser.add_argument("--none", action="store_true", help="with --references: nothing but them")
    parser.add_argument("--repeat", type=int, default=0, help="how often every run is made")
    parser.add_argument("--again", action="store_true", help="no runs: pictures and tables of the files in the folder")
    parser.add_argument("--store", action="store_true", help="picture and tables into README.md")
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
    complaints = []
    for scene in chosen:
        if not options.again:
            measure(scene, options)
        rows, done = show(scene, options.out)
        complaints += wrong_runs(scene, rows, WRONG_QUICK if options.quick else WRONG)
        if options.store:
            store(scene, rows, done, options.out)
    for line in complaints:
        print("wrong: " + line)
    sys.exit(bool(complaints))


if __name__ == "__main__":
    main()
