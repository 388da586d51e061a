"""Speed against accuracy: runs every scene by every method, element and mesh, and says what to use.

run.py [--quick] [--only TEXT] [--references] [--repeat N] [--again] [--store] [--out FOLDER]
                                                       see the Makefile's targets chart and chart-quick
Scenes are scripts that print `result NAME VALUE`; which meshes, elements and methods: scenes.csv, methods.csv. All runs of a
repetition are done before the next one begins, every other one backwards, so that a machine that slows down does so for all.
Seconds are CPU seconds from the space to the equilibrium, without the start of the script and its mesh; the median is kept,
and the spread, half of the largest minus the smallest over the median. Errors are relative, against the exact solution, or,
where there is none, against references.csv: numbers of a fine run with the difference to a coarser one as their own error, below which no error is given.
Results in the folder, for scene hertz: hertz.csv (one row for a method, element and mesh), hertz.png, hertz.md (the tables),
matrices.csv, matrices.png. A run that fails ends the chart; an error above WRONG on the finest mesh gives exit status 1.
"""
import argparse
import csv
import os
import re
import shutil
import statistics
import subprocess
import sys
import time

import draw
import matrices
import report

HERE = os.path.dirname(os.path.abspath(__file__))
ELEMENTS = ["P1", "P2"]
WRONG = 0.1


def rows_of(name, width):
    with open(os.path.join(HERE, name)) as f:
        for line in f:
            if not line.startswith("#") and line.strip():
                parts = [part.strip() for part in line.split(";")]
                if len(parts) != width:
                    sys.exit(f"chart: {name}: {len(parts)} entries instead of {width}: {line.strip()}")
                yield parts


def methods():
    return [{"name": n, "whose": w, "options": o.split(), "matrix": m == "matrix", "meaning": meaning}
            for n, w, o, m, meaning in rows_of("methods.csv", 5)]


def scenes():
    for name, script, quick, full, reference, quantities in rows_of("scenes.csv", 6):
        options, meshes = reference.split(":")
        yield {"name": name, "script": script, "quick": [int(n) for n in quick.split()], "full": [int(n) for n in full.split()],
               "reference": (options.split(), [int(n) for n in meshes.split()]),
               "quantities": dict(word.split("=") for word in quantities.split())}


def run(script, options):
    """Results of one run by name."""
    command = [os.environ["BURNISH"], os.path.join(HERE, script + ".edp"), *options]
    done = subprocess.run(command, cwd=HERE, capture_output=True, text=True, timeout=1000, errors="replace")
    found = dict(re.findall(r"^result (\S+) (\S+)$", done.stdout, re.MULTILINE))
    if done.returncode != 0 or "seconds" not in found:
        sys.exit(f"chart: exit status {done.returncode} of {' '.join(command)}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return {name: float(value) for name, value in found.items()}


def read_references():
    path = os.path.join(HERE, "references.csv")
    with open(path) as f:
        return {(row["scene"], row["quantity"]): (float(row["value"]), float(row["error"])) for row in csv.DictReader(f)}


def make_references():
    """A fine run of every scene; its own error is the difference to a coarser one."""
    with open(os.path.join(HERE, "references.csv"), "w", newline="") as f:
        table = csv.writer(f, lineterminator="\n")
        table.writerow(["scene", "quantity", "value", "error", "run"])
        for scene in scenes():
            options, meshes = scene["reference"]
            coarse, fine = (run(scene["script"], options + ["-n", str(n)]) for n in meshes)
            for quantity, kind in scene["quantities"].items():
                if kind == "run":
                    error = abs(coarse[quantity] / fine[quantity] - 1)
                    table.writerow([scene["name"], quantity, f"{fine[quantity]:.8g}", f"{error:.1e}",
                                    " ".join(options + ["-n", str(meshes[1])])])
                    print(f"  {scene['name']}: {quantity} {fine[quantity]:.8g}, differs from n = {meshes[0]} by {error:.1e}")


def repeat_all(tasks, times):
    """Results of every task, repeated in turns."""
    found = [[] for _ in tasks]
    begun, done = time.time(), 0
    for k in range(times):
        order = list(enumerate(tasks))
        for i, (scene, method, element, n) in order if k % 2 == 0 else reversed(order):
            found[i].append(run(scene["script"], method["options"] + ["-element", element, "-n", str(n)]))
            done += 1
            if sys.stderr.isatty():
                left = (time.time() - begun) * (times * len(tasks) - done) / done
                print(f"\r  {done} of {times * len(tasks)} runs, about {left:.0f} s left ", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    return found


def row_of(task, results, references):
    scene, method, element, n = task
    seconds = [r["seconds"] for r in results]
    middle = statistics.median(seconds)
    row = {"scene": scene["name"], "method": method["name"], "whose": method["whose"], "element": element, "n": n,
           "seconds": middle, "spread": (max(seconds) - min(seconds)) / 2 / middle}
    for name in ("dofs", "solves", "steps", "rejected"):
        row[name] = int(results[0][name])
    for quantity, kind in scene["quantities"].items():
        value = results[0][quantity]
        row[quantity] = abs(value)
        if kind == "run":
            row[quantity] = abs(value / references[scene["name"], quantity][0] - 1)
    return row


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


def wrong_runs(scene, rows):
    """Sentences of runs on the finest mesh that are off."""
    finest = max(row["n"] for row in rows)
    return [f"{row['method']}, {row['element']}, n = {row['n']}: {q} off by {100 * row[q]:.3g} %"
            for row in rows if row["n"] == finest for q in scene["quantities"] if not row[q] < WRONG]


def measure(scene, options):
    """Runs the scene and looks at its matrices."""
    tasks = [(scene, m, e, n) for n in scene["quick" if options.quick else "full"] for e in ELEMENTS for m in methods()]
    found = repeat_all(tasks, options.repeat or (2 if options.quick else 3))
    references = read_references()
    write(os.path.join(options.out, scene["name"] + ".csv"), [row_of(t, results, references) for t, results in zip(tasks, found)])
    write(os.path.join(options.out, "matrices.csv"),
          matrices.look(scene, [m for m in methods() if m["matrix"]], options.quick, options.out))


def show(scene, folder):
    """Pictures and tables of what is in the folder; returns the rows."""
    rows, looked = read(os.path.join(folder, scene["name"] + ".csv")), read(os.path.join(folder, "matrices.csv"))
    quantities = list(scene["quantities"])
    for (name, quantity), (_, uncertain) in read_references().items():
        for row in rows if name == scene["name"] else []:
            row[quantity] = max(row[quantity], uncertain)
    draw.chart(rows, quantities, os.path.join(folder, scene["name"] + ".png"))
    draw.matrices(looked, os.path.join(folder, "matrices.png"))
    text = report.report(scene["name"], rows, quantities) + report.matrices(looked)
    with open(os.path.join(folder, scene["name"] + ".md"), "w") as f:
        f.write(text)
    print(text)
    return rows


def store(scene, rows, folder):
    """Picture into this folder, tables into README.md between <!-- chart NAME --> and <!-- end -->."""
    for name in (scene["name"], "matrices"):
        shutil.copy(os.path.join(folder, name + ".png"), os.path.join(HERE, name + ".png"))
    path = os.path.join(os.path.dirname(os.path.dirname(HERE)), "README.md")
    with open(path) as f:
        text = f.read()
    for name, lines in (("use", report.table(rows, list(scene["quantities"]))), ("forms", report.same_forms(rows))):
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
    parser.add_argument("--repeat", type=int, default=0, help="how often every run is made")
    parser.add_argument("--again", action="store_true", help="no runs: pictures and tables of the files in the folder")
    parser.add_argument("--store", action="store_true", help="picture and tables into README.md")
    parser.add_argument("--out", default="out/chart")
    options = parser.parse_args()
    chosen = [s for s in scenes() if re.search(options.only, s["name"])]
    if not chosen:
        sys.exit(f"chart: no name of a scene holds \"{options.only}\"")
    os.makedirs(options.out, exist_ok=True)
    if options.references:
        make_references()
    complaints = []
    for scene in chosen:
        if not options.again:
            measure(scene, options)
        rows = show(scene, options.out)
        complaints += wrong_runs(scene, rows)
        if options.store:
            store(scene, rows, options.out)
    for line in complaints:
        print("wrong: " + line)
    sys.exit(bool(complaints))


if __name__ == "__main__":
    main()
