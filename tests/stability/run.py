"""The map of what can go wrong: runs every danger of dangers.csv by every method, and judges each run.

run.py [--only TEXT] [--references] [--store]      see the Makefile's target stability
  right     the numbers are within their tolerance, and the run says that it finished
  detected  they are not, or there is no answer, and the run refused, stopped, or reported the cause by name
  silent    they are not, and no word of the cause
  slow      the article's literal scheme, which stops at every event of every element, or a method of others
            did not end within SLOW seconds
  failed    the run crashed, or did not end in time
Methods of others (rivals.edp) run the dangers whose line names one for them; a silent cell of theirs is shown as such.
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

HERE = os.path.dirname(os.path.abspath(__file__))
METHODS = [("implicit", "P2"), ("implicit", "P1"), ("event", "P2"), ("event", "P1"), ("article", "P2")]
RIVALS = [("penalty10", "P2"), ("penalty1000", "P2"), ("multiplier", "P2"), ("augmented", "P2")]
RANK = {"right": 0, "detected": 1, "slow": 2, "silent": 3, "failed": 4}
REFUSED = {3, 4, 20}
LIMIT = 200  # seconds of one run
SLOW = 15    # of the article's scheme
ANY = "does not come back to equilibrium|coarser than the stress gradient"  # causes of every danger


def dangers():
    with open(os.path.join(HERE, "dangers.csv")) as f:
        for line in f:
            if line.startswith("#") or not line.strip():
                continue
            name, script, values, reference, word, meaning, *rivals = (part.strip() for part in line.split(";"))
            yield {"name": name, "script": script.split(), "values": values.split(), "reference": reference.split(),
                   "word": word, "meaning": meaning, "rivals": rivals[0].split() if rivals else None}


def methods_of(danger):
    return METHODS + (RIVALS if danger["rivals"] else [])


def script_of(danger, method):
    return ["rivals", "-danger", *danger["rivals"]] if method in RIVALS else danger["script"]


def run(script, options, limit=LIMIT):
    """Exit status (None: killed after its limit, in seconds) and output of a run."""
    command = [os.environ["BURNISH"], os.path.join(HERE, script[0] + ".edp"), *script[1:], *options]
    try:
        done = subprocess.run(command, cwd=HERE, capture_output=True, text=True, timeout=limit, errors="replace")
    except subprocess.TimeoutExpired:
        return None, ""
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


def said(text):
    """The lines of a run that name what is wrong; what was modelled for nothing is nothing wrong."""
    aside = ("verdict", "lean:", "modelled and not needed:")
    return [line for line in text.splitlines() if line.strip() and not line.startswith(aside)]


def reported(text, word):
    """Is there a line of burnish's that names the cause?"""
    return any(re.search(word + "|" + ANY, line, re.IGNORECASE) for line in said(text))


def judge(danger, status, text, references):
    """Outcome and the largest error over its tolerance, or None."""
    if status is None or status not in REFUSED | {0}:
        return "failed", None
    found = verdicts(text)
    named = reported(text, danger["word"])
    if found is None or not found:
        # a run that stops early may not reach its verdict
        return ("detected" if status in REFUSED and text.strip() or named else "silent"), None
    worst = 0
    for name, value, reference, allowed, scale in found:
        if reference is None:
            reference = references.get(name)
        off = float("inf") if reference is None else error(value, reference, scale) / allowed
        worst = max(worst, off if off == off else float("inf"))
    if status == 0 and worst <= 1:
        return "right", worst
    return ("detected" if status in REFUSED or named else "silent"), worst


def filled(template, value, method):
    known = {"{x}": value, "{scheme}": method[0], "{element}": method[1]}
    return [known.get(word, word) for word in template]


def read_references():
    path = os.path.join(HERE, "references.csv")
    table = {}
    if os.path.exists(path):
        with open(path) as f:
            for row in csv.DictReader(f):
                table.setdefault((row["danger"], row["options"]), {})[row["name"]] = float(row["value"])
    return table


def make_references(chosen, jobs):
    """Runs the reference of every danger again; those of others stay."""
    wanted = {}
    for danger in chosen:
        for value in danger["values"] if danger["reference"] else []:
            for method in METHODS:
                options = filled(danger["reference"], value, method)
                wanted[danger["name"], " ".join(options)] = (danger["script"], options)
    table = read_references()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for key, (status, text) in zip(wanted, pool.map(lambda job: run(*job), wanted.values())):
            found = verdicts(text) or []
            print(f"  {key[0]}: {key[1]}: status {status}, " + ", ".join(f"{v[0]} {v[1]:.6g}" for v in found), flush=True)
            table[key] = {v[0]: v[1] for v in found if v[2] is None} if status in (0, 4) else {}
    with open(os.path.join(HERE, "references.csv"), "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(["danger", "options", "name", "value"])
        for key in sorted(table):
            for name, value in table[key].items():
                out.writerow([*key, name, f"{value:.8g}"])


FIELDS = ["danger", "scheme", "element", "x", "outcome", "error_over_tolerance", "status", "seconds", "last_line"]


def run_all(chosen, jobs, table):
    """Rows of FIELDS; each is written to the CSV table as soon as its run has ended."""
    references = read_references()
    tasks = [(d, scheme, element, x) for d in chosen for scheme, element in methods_of(d) for x in d["values"]]
    started, rows = time.time(), []

    def one(task):
        danger, scheme, element, x = task
        begun = time.time()
        slow = scheme == "article" or (scheme, element) in RIVALS
        status, text = run(script_of(danger, (scheme, element)), ["-x", x, "-element", element, "-scheme", scheme], SLOW if slow else LIMIT)
        known = references.get((danger["name"], " ".join(filled(danger["reference"], x, (scheme, element)))), {})
        outcome, off = ("slow", None) if status is None and slow else judge(danger, status, text, known)
        words = said(text)
        return {"danger": danger["name"], "scheme": scheme, "element": element, "x": x, "outcome": outcome,
                "error_over_tolerance": "" if off is None else f"{off:.4g}", "status": status,
                "seconds": f"{time.time() - begun:.2f}", "last_line": words[-1][:200] if words else ""}

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for k, row in enumerate(pool.map(one, tasks), 1):
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
        if key[1:3] not in RIVALS and RANK[row["outcome"]] >= RANK["silent"]:
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
    options = parser.parse_args()
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
