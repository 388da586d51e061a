"""The leanest model that keeps the accuracy asked: what -model auto of a case runs after its own run.

leaner.py FOLDER SCRIPT     FOLDER: results of the run; $BURNISH runs scripts
Each way to make the model smaller is tried alone: linear elements, half the divisions of the mesh, half the steps, a looser
tolerance. Those whose results stay within the accuracy (-accuracy, else 1 %) of the run asked for are then taken together, the
ones that save most first. Prints error and CPU time side by side; writes FOLDER/model.csv. Exit status 1: the run itself has
no results to compare.
"""
import csv
import json
import os
import re
import subprocess
import sys

COMMON = {"out", "pictures", "series", "model", "check"}
ACCURACY = 0.01
REPEATS, SHORT = 3, 2.0       # runs of a model, as long as one takes less, CPU s


def read(folder):
    with open(os.path.join(folder, "summary.json")) as f:
        return json.load(f)


def results(summary):
    """{name: (value, scale)} of the finite results; scale: what a change counts against."""
    found = {}
    for name, item in summary.get("results", {}).items():
        value = item.get("value")
        if not isinstance(value, (int, float)):
            continue
        if item.get("expected") == 0:  # an error, or what should vanish: allowed up to its tolerance
            found[name] = (value, abs(item["tolerance"]) / ACCURACY)
        elif value != 0:
            found[name] = (value, abs(value))
    return found


def change(base, other):
    """Largest relative change of a result, and its name."""
    mine, worst = results(other), (0, "-")
    for name, (value, scale) in results(base).items():
        off = abs(mine[name][0] - value) / scale if name in mine else float("inf")
        worst = max(worst, (off, name))
    return worst


def divisions(script):
    """Names of the options whose meaning says that they divide the mesh."""
    text = subprocess.run([os.environ["BURNISH"], script, "-h"], capture_output=True, text=True).stdout
    found = []
    for line in text.splitlines():
        words = re.match(r"\s*-(\w+)\s", line)
        if words and re.search(r"\bdivisions?\b|\belements (over|along|across|under)\b", line):
            found.append(words.group(1))
    return found


def candidates(options, script):
    """[(what, {option: value})]"""
    found = []
    if options.get("element") == "P2":
        found.append(("linear elements", {"element": "P1"}))
    halves = {name: max(1, int(options[name]) // 2) for name in divisions(script) if int(options.get(name, 0)) > 1}
    if halves:
        found.append(("half the divisions of the mesh", halves))
    if options.get("steps", 0) >= 4:
        found.append(("half the steps", {"steps": options["steps"] / 2}))
    if options.get("tolerance", 1) <= 1e-3:
        found.append(("ten times the tolerance", {"tolerance": options["tolerance"] * 10}))
    return found


def words_of(options):
    return [word for name, value in options.items() if value != "" for word in (f"-{name}", f"{value:g}" if isinstance(value, float) else str(value))]


def run(script, options, changed, folder):
    """Summary of a run with some options changed; None if it did not reach its end."""
    words = words_of({k: v for k, v in {**options, **changed}.items() if k not in COMMON})
    command = [os.environ["BURNISH"], script, *words, "-out", folder, "-pictures", "0", "-check", "0", "-series", "0"]
    least = None
    for _ in range(REPEATS):      # a short run's time is noise by half on a busy machine: the least of some
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 4):
            return None
        summary = read(folder)
        if least is None or seconds_of(summary) < seconds_of(least):
            least = summary
        if seconds_of(summary) > SHORT:
            break
    return least


def seconds_of(summary):
    return summary["cpu_seconds"]["total"]


def main():
    folder, script = sys.argv[1:3]
    base = read(folder)
    options = base["options"]
    accuracy = options.get("accuracy", 0) or ACCURACY
    if not results(base):
        print("burnish: -model auto: the run has no results to compare", file=sys.stderr)
        return 1
    again = run(script, options, {}, os.path.join(folder, "model-0")) or base      # without files on the way, as the others
    table = [("as asked", {}, seconds_of(again), 0.0, "-", base["status"])]

    def attempt(what, changed):
        summary = run(script, options, changed, os.path.join(folder, f"model-{len(table)}"))
        off, name = change(base, summary) if summary else (float("inf"), "-")
        seconds = seconds_of(summary) if summary else float("nan")
        table.append((what, changed, seconds, off, name, summary["status"] if summary else "stopped early"))
        return off <= accuracy and summary["status"] == base["status"]

    kept = [(table[-1], what) for what, changed in candidates(options, script) if attempt(what, changed)]
    kept = sorted((row for row, _ in kept if row[2] < table[0][2]), key=lambda row: row[2])
    best = kept[0] if kept else table[0]
    together = dict(best[1])
    for row in kept[1:]:
        both = {**together, **row[1]}
        if attempt("together", both) and table[-1][2] < best[2]:
            together, best = both, table[-1]
    print(f"\n  leaner models, allowed change of the results {100 * accuracy:g} %")
    print(f"  {'':34}{'CPU s':>8}{'change':>11}   largest in")
    for what, changed, seconds, off, name, status in table:
        label = what if what != "together" else " ".join(words_of(changed))
        note = "" if off <= accuracy and status == base["status"] else f"   ({status})" if status != base["status"] else "   (too much)"
        print(f"  {label:34}{seconds:8.2f}{100 * off:9.3f} %   {name}{note}")
    if together:
        print(f"  leanest: {' '.join(words_of(together))}   ({table[0][2] / best[2]:.1f} times faster)")
    else:
        print("  leanest: the model as asked")
    with open(os.path.join(folder, "model.csv"), "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(["model", "options", "cpu_seconds", "largest_change", "of", "status"])
        out.writerows([what, " ".join(words_of(changed)), seconds, off, name, status] for what, changed, seconds, off, name, status in table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
