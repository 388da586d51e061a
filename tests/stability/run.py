"""The map of what can go wrong: runs every danger of dangers.csv by every method, and judges each run.

run.py [--only TEXT] [--references] [--store]      see the Makefile's target stability
  right     the numbers are within their tolerance, and the run says that it finished
  detected  they are not, or there is no answer, and the run names the cause: a finding by the name of its check, a refusal or
            a stop by the words of causes.csv; dangers.csv says which of them are causes of the danger
  slow      the article's literal scheme, which stops at every event of every element, or a method of others did not end
            within SLOW seconds; "needs" of results.csv estimates from the share done how long it takes, "" where it stops
  unnamed   wrong or no answer, and the run refused, stopped or is not to be trusted, but for another cause than the danger's
  silent    they are not, and no word of it
  failed    the run crashed, or did not end in time
Columns that a line leaves out (words behind "not:") and methods of others (rivals.edp) that it does not name stay white; a silent
cell of theirs is shown as such.
expected.csv holds what every cell came to when it was stored; a run that comes to less, or any silent or failed cell of
our methods, ends with status 1. references.csv holds the numbers of the reference runs.
"""
import argparse
import concurrent.futures
import csv
import os
import re
import subprocess
import sys
import time

import draw
from tables import HERE, causes, dangers, unknown_names

METHODS = [("implicit", "P2"), ("implicit", "P1"), ("event", "P2"), ("event", "P1"), ("UMFPACK", "P2"), ("CHOLMOD", "P2"),
           ("forms", "P2"), ("tied", "P2"), ("article", "P2")]
WAYS = {"implicit": [], "UMFPACK": ["-solver", "UMFPACK"], "CHOLMOD": ["-solver", "CHOLMOD"], "forms": ["-forms", "1"],
        "tied": ["-tied", "1"]}   # options of a column; the others are a -scheme
RIVALS = [("penalty10", "P2"), ("penalty1000", "P2"), ("multiplier", "P2"), ("augmented", "P2")]
RANK = {name: k for k, name in enumerate(draw.COLORS)}
REFUSED = {3, 4, 20}
LIMIT = 200  # seconds of one run
SLOW = 15    # of the article's scheme and the rivals


def methods_of(danger):
    return [one for one in METHODS if one[0] not in danger["without"]] + (RIVALS if danger["rivals"] else [])


def way_of(method):
    return WAYS.get(method[0], ["-scheme", method[0]])


def script_of(danger, method):
    return ["rivals", "-danger", *danger["rivals"]] if method in RIVALS else danger["script"]


def run(script, options, limit=LIMIT):
    """Exit status (None: killed after its limit, in seconds) and output of a run, until then."""
    command = [os.environ["BURNISH"], os.path.join(HERE, script[0] + ".edp"), *script[1:], *options]
    try:
        done = subprocess.run(command, cwd=HERE, capture_output=True, text=True, timeout=limit, errors="replace")
    except subprocess.TimeoutExpired as late:
        return None, (late.stdout or b"").decode(errors="replace")
    return done.returncode, done.stdout + done.stderr


def verdicts(text):
    """[(name, value, reference, tolerance, scale)] of a run, reference None: that of another run; scale None: the reference.

    None: there is no answer."""
    found = []
    for line in text.splitlines():
        words = line.split()
        if words[:1] != ["verdict"]:
            continue
        if words[1] == "none":
            return None
        reference = None if words[3] == "run" else float(words[3])
        found.append((words[1], float(words[2]), reference, float(words[4]), float(words[5]) if words[5:] else None))
    return found


def error(value, reference, scale):
    return abs(value - reference) / (abs(reference if scale is None else scale) or 1)


def reached(text):
    """Share of the program that was run."""
    shares = [line.split()[1] for line in text.splitlines() if line.startswith("reached ") and len(line.split()) == 2]
    return float(shares[-1]) if shares else 0


def findings(text):
    return [line.removeprefix("finding ") for line in text.splitlines() if line.startswith("finding ")]


def said(text):
    """The lines of a run that name what is wrong; what was modelled for nothing is nothing wrong."""
    aside = ("verdict", "reached", "finding", "lean:", "modelled and not needed:")
    return [line for line in text.splitlines() if line.strip() and not line.startswith(aside)]


def names_cause(danger, text, words):
    """Does the run name a cause of the danger: a finding by the name of its check, a stop or a refusal by its fixed words?"""
    if any(name in danger["causes"] for name in findings(text)):
        return True
    return any(words[name] in line for name in danger["causes"] if name in words for line in said(text))


def judge(danger, status, text, references, words):
    """Outcome and the largest error over its tolerance, or None."""
    if status is None or status not in REFUSED | {0}:
        return "failed", None
    found = verdicts(text)
    wrong = "detected" if names_cause(danger, text, words) else "unnamed" if status in REFUSED else "silent"
    if not found:
        return wrong, None  # there is no answer, or a run that stops early may not reach its verdict
    worst = 0
    for name, value, reference, allowed, scale in found:
        if reference is None:
            reference = references.get(name)
        off = float("inf") if reference is None else error(value, reference, scale) / allowed
        worst = max(worst, off if off == off else float("inf"))
    return ("right" if status == 0 and worst <= 1 else wrong), worst


def tolerances(text):
    """What the verdicts of a run allow, in words; where 0 is expected it is a number itself."""
    return ", ".join(f"{name.replace('_', ' ')} {f'{100 * allowed:g} %' if reference != 0 else f'{allowed:g}'}"
                     for name, _, reference, allowed, _ in verdicts(text) or [])


def filled(template, value, method):
    known = {"{x}": [value], "{way}": way_of(method), "{element}": [method[1]]}
    return [option for word in template for option in known.get(word, [word])]


def read_references():
    path = os.path.join(HERE, "references.csv")
    table = {}
    if os.path.exists(path):
        with open(path) as f:
            for row in csv.DictReader(f):
                table.setdefault((row["danger"], row["options"]), {})[row["name"]] = float(row["value"])
    return table


def reference_run(script, options):
    """By events where implicit steps are refused."""
    found = run(script, options)
    again = found[0] not in (0, 4) and "-scheme" not in options
    return run(script, [*options, "-scheme", "event"], 5 * LIMIT) if again else found


def make_references(chosen, jobs):
    """Runs the reference of every danger again; those of others stay."""
    wanted = {}
    for danger in chosen:
        for value in danger["values"] if danger["reference"] else []:
            for method in methods_of(danger):
                options = filled(danger["reference"], value, method)
                wanted[danger["name"], " ".join(options)] = (danger["script"], options)
    table = {key: found for key, found in read_references().items() if key[0] not in {d["name"] for d in chosen}}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for key, (status, text) in zip(wanted, pool.map(lambda job: reference_run(*job), wanted.values())):
            found = verdicts(text) or []
            print(f"  {key[0]}: {key[1]}: status {status}, " + ", ".join(f"{v[0]} {v[1]:.6g}" for v in found), flush=True)
            table[key] = {v[0]: v[1] for v in found if v[2] is None} if status in (0, 4) else {}
    with open(os.path.join(HERE, "references.csv"), "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(["danger", "options", "name", "value"])
        for key in sorted(table):
            for name, value in table[key].items():
                out.writerow([*key, name, f"{value:.8g}"])


FIELDS = ["danger", "scheme", "element", "x", "outcome", "error_over_tolerance", "status", "seconds", "reached", "needs", "allowed",
          "findings", "last_line"]


def run_one(danger, method, x, references, words):
    """A row of FIELDS."""
    begun = time.time()
    slow = method[0] == "article" or method in RIVALS
    status, text = run(script_of(danger, method), ["-x", x, "-element", method[1], *way_of(method)], SLOW if slow else LIMIT)
    seconds, share = time.time() - begun, reached(text)
    known = references.get((danger["name"], " ".join(filled(danger["reference"], x, method))), {})
    late = status is None and slow
    outcome, off = ("slow", None) if late else judge(danger, status, text, known, words)
    lines = said(text)
    return {"danger": danger["name"], "scheme": method[0], "element": method[1], "x": x, "outcome": outcome,
            "error_over_tolerance": "" if off is None else f"{off:.4g}", "status": status, "seconds": f"{seconds:.2f}",
            "reached": f"{share:.4g}", "needs": f"{seconds / share:.3g}" if share > (0 if late else 0.999) else "",
            "allowed": tolerances(text), "findings": "|".join(findings(text)), "last_line": lines[-1][:200] if lines else ""}


def run_all(chosen, jobs, table):
    """Rows of FIELDS; each is written to the CSV table as soon as its run has ended."""
    references, words = read_references(), causes()
    tasks = [(d, method, x) for d in chosen for method in methods_of(d) for x in d["values"]]
    started, rows = time.time(), []

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for k, row in enumerate(pool.map(lambda task: run_one(*task, references, words), tasks), 1):
            rows.append(row)
            table.writerow(row)
            left = (time.time() - started) * (len(tasks) - k) / k
            if sys.stderr.isatty():
                print(f"\r  {k} of {len(tasks)} runs, about {left:.0f} s left ", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    return rows


def compare(rows, store):
    """Complaints of cells that are silent, or came to less than what is stored."""
    path = os.path.join(HERE, "expected.csv")
    stored = {}
    if os.path.exists(path):
        with open(path) as f:
            stored = {tuple(row[:4]): row[4] for row in csv.reader(f)}
    complaints, known = [], bool(stored)
    for row in rows:
        key = (row["danger"], row["scheme"], row["element"], row["x"])
        expected = stored.get(key)
        if key[1:3] not in RIVALS and row["outcome"] in ("silent", "failed"):
            complaints.append(f"{row['outcome']}: {', '.join(key)}: error over tolerance {row['error_over_tolerance'] or '-'}, "
                              f"status {row['status']}: {row['last_line']}")
        elif row["outcome"] == "slow" or expected == "slow":
            pass  # depends on the machine
        elif expected and RANK[row["outcome"]] > RANK.get(expected, 0):
            complaints.append(f"{row['outcome']}, expected {expected}: {', '.join(key)}: {row['last_line']}")
        elif not store and known and expected is None:
            complaints.append(f"not in expected.csv: {', '.join(key)}")
        stored[key] = row["outcome"]
    if store:
        with open(path, "w", newline="") as f:
            csv.writer(f, lineterminator="\n").writerows([*key, stored[key]] for key in sorted(stored))
    return complaints


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="", help="dangers whose name holds this pattern")
    parser.add_argument("--references", action="store_true", help="run the reference runs first")
    parser.add_argument("--store", action="store_true", help="store the outcomes as expected")
    parser.add_argument("--out", default="out/stability")
    parser.add_argument("--names", action="store_true", help="only look whether the program has all names of causes")
    options = parser.parse_args()
    if (unknown := list(unknown_names())) or options.names:
        sys.exit("\n".join(unknown) or None)
    jobs = int(os.environ.get("JOBS", os.cpu_count()))
    chosen = [d for d in dangers() if re.search(options.only, d["name"])]
    if not chosen:
        sys.exit(f"stability: no name of a danger holds \"{options.only}\"")
    os.makedirs(options.out, exist_ok=True)
    if options.references:
        make_references(chosen, jobs)
    with open(os.path.join(options.out, "results.csv"), "w", newline="", buffering=1) as f:
        table = csv.DictWriter(f, FIELDS, lineterminator="\n")
        table.writeheader()
        rows = run_all(chosen, jobs, table)
    draw.draw(chosen, METHODS, RIVALS, rows, options.out)
    for whose, methods in (("ours", METHODS), ("rivals", RIVALS)):
        mine = [row for row in rows if (row["scheme"], row["element"]) in methods]
        count = {name: sum(row["outcome"] == name for row in mine) for name in RANK}
        print(f"{whose}: {len(mine)} runs: " + ", ".join(f"{count[name]} {name}" for name in RANK))
    print(f"pictures in {options.out}")
    complaints = compare(rows, options.store)
    for line in complaints:
        print("  " + line)
    sys.exit(bool(complaints))


if __name__ == "__main__":
    main()
