"""What friction in the matrix costs and gains: consistent, or on the right-hand side.

tangents.py [--quick] [--only TEXT] [--ways TEXT] [--mu LIST] [--repeat N] [--fine] [--store NAME] [--out FOLDER]
                                       BURNISH=build/burnish
Every scene by the core's solver (a symmetric factor of the body, kept for several iterations, and the dense block of the contact)
and by the condensed matrix, anew in every iteration: UMFPACK; rows that are not symmetric as a dense border (BURNISH); lagged by
CHOLMOD, see METHOD.md 3.21.
Runs of a repetition are done in turns, those longer than ONCE once; CPU seconds of the whole process, median and spread (half of
largest less smallest over the median). `off`: largest difference of a result from that of the first way, over the result. Writes
tangents.csv and tangents.md; --store puts the table into tests/chart/matrices.md, between the marks of NAME.
Exit status 1 if a run that says it has finished is off by more than WRONG with the same steps, none rejected; with others the
result is that of other steps.
"""
import argparse
import csv
import json
import os
import re
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
WRONG = 1e-2
ONCE = 3  # [s]
WAYS = [("block, consistent", ""), ("block, lagged", "-frictiontangent lagged"),
        ("sparse, consistent", "-solver UMFPACK"), ("sparse, border", "-solver BURNISH"),
        ("sparse, lagged", "-frictiontangent lagged -solver CHOLMOD")]
SCENES = [  # name, script, options, of --quick
    ("hertz", "tests/chart/tangents.edp", "-n 6 -steps 10", "-element P1 -n 6 -steps 8"),
    ("partial-slip", "cases/partial-slip/partial-slip.edp", "-n 6 -steps 8 -nu 0.3 -split 2",
     "-element P1 -n 5 -steps 4 -nu 0.3 -split 2"),
    ("indentation", "cases/indentation/indentation.edp", "-half 1 -fine 25", "-element P1 -half 1 -fine 16 -steps 8"),
    ("rolling", "cases/rolling/rolling.edp", "-inner 5 -outer 75 -sides 10 -M0 {M0}",
     "-element P1 -inner 4 -outer 40 -sides 6 -steps 20 -width 4 -M0 {M0}"),
    ("rolling, default", "cases/rolling/rolling.edp", "-M0 {M0}", "-M0 {M0}")]
FRICTION = ["0.1", "0.2", "0.5"]  # M0: the braking moment of rolling, the same part of what friction bears


def run(script, words, folder):
    command = [os.environ["BURNISH"], os.path.join(TOP, script), *words, "-pictures", "0", "-series", "0",
               "-check", "0", "-out", folder]
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=1200)
    path = os.path.join(folder, "summary.json")
    stopped = re.search(r"^burnish: stopped early at (.*)$", done.stdout, re.MULTILINE)
    summary = {}
    if os.path.exists(path):
        with open(path) as f:
            summary = json.load(f)
        os.remove(path)
    if stopped and summary.get("status", "running") == "running":  # the script asks for the end of its program
        return {"status": "stopped", "reason": stopped.group(1), "results": {}, "cpu_seconds": {"total": float("nan")},
                "counts": dict.fromkeys(("steps", "rejected_steps", "iterations", "factorizations"), 0)}
    if done.returncode not in (0, 3, 4) or not summary:
        sys.exit(f"tangents: exit status {done.returncode} of {' '.join(command)}:\n{done.stdout[-2000:]}{done.stderr[-1000:]}")
    return summary


def off(results, expected):
    """Largest difference of a result, over its value; those that are errors themselves, where 0 is expected, do not count."""
    return max((abs(results[name]["value"] / item["value"] - 1) for name, item in expected.items()
                if item["value"] and name in results and item.get("expected") != 0), default=float("nan"))


def measure(scenes, ways, frictions, repeat, quick, folder):
    rows = []
    for name, script, full, short in scenes:
        for mu in frictions:
            found = {way: [] for way, _ in ways}
            for _ in range(repeat):
                for way, options in ways:
                    if found[way] and (found[way][0]["status"] != "finished" or found[way][0]["cpu_seconds"]["total"] > ONCE):
                        continue
                    words = (short if quick else full).format(M0=f"{1e4 * float(mu):g}")
                    found[way].append(run(script, f"{words} -mu {mu} {options}".split(), folder))
                    print(f"  {name}, mu {mu}, {way}: {found[way][-1]['cpu_seconds']['total']:.2f} s", file=sys.stderr, flush=True)
            first = found[ways[0][0]][0]
            for way, _ in ways:
                one, seconds = found[way][0], [s["cpu_seconds"]["total"] for s in found[way]]
                middle = statistics.median(seconds)
                counts = one["counts"]
                rows.append({"scene": name, "mu": mu, "way": way, "outcome": one["status"], "steps": counts["steps"],
                             "rejected": counts["rejected_steps"], "iterations": counts["iterations"],
                             "factorizations": counts["factorizations"], "seconds": middle,
                             "spread": (max(seconds) - min(seconds)) / 2 / middle, "off": off(one["results"], first["results"]),
                             "reason": one["reason"] or one["steps"]["last_rejection"],
                             "asymmetry": one.get("way", {}).get("matrix_asymmetry", "")})
    return rows


def table(rows):
    lines = ["| Scene | μ | Way | steps | rejected | iterations | factors | CPU s | over block | off |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for row in rows:
        base = next(r for r in rows if (r["scene"], r["mu"]) == (row["scene"], row["mu"]))
        if row["outcome"] == "finished":
            spread = f" ± {100 * row['spread']:.0f} %" if row["spread"] else ""
            end = f"{row['seconds']:.2f}{spread} | {row['seconds'] / base['seconds']:.2f} | {row['off']:.0e}"
        else:
            end = f"{row['outcome']} | | "
        first = row is base
        lines.append(f"| {row['scene'] if first else ''} | {row['mu'] if first else ''} | {row['way']} | {row['steps']} | "
                     f"{row['rejected']} | {row['iterations']} | {row['factorizations']} | {end} |")
    return "\n".join(lines) + "\n"


def store(name, text):
    """The table between the marks of tests/chart/matrices.md."""
    path = os.path.join(HERE, "matrices.md")
    with open(path) as f:
        page = f.read()
    marks = rf"(<!-- tangents {re.escape(name)} -->\n).*?(<!-- end -->)"
    new, number = re.subn(marks, lambda m: m.group(1) + text + m.group(2), page, flags=re.S)
    if number != 1:
        sys.exit(f"tangents: {path} has no marks <!-- tangents {name} -->")
    with open(path, "w") as f:
        f.write(new)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="coarse meshes, one friction coefficient")
    parser.add_argument("--fine", action="store_true", help="the default mesh of rolling, too")
    parser.add_argument("--only", default="", metavar="TEXT", help="scenes whose name contains TEXT")
    parser.add_argument("--ways", default="", metavar="TEXT", help="the first way, and those whose name contains TEXT")
    parser.add_argument("--mu", default="", help="friction coefficients, as 0.1,0.5")
    parser.add_argument("--repeat", type=int, default=3, metavar="N")
    parser.add_argument("--store", default="", metavar="NAME", help="put the table into tests/chart/matrices.md")
    parser.add_argument("--out", default="out/tangents", metavar="FOLDER")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    frictions = options.mu.split(",") if options.mu else ["0.2"] if options.quick else FRICTION
    scenes = [s for s in SCENES if options.only in s[0] and (options.fine or "default" not in s[0])]
    if not scenes:
        sys.exit(f"tangents: no scene contains \"{options.only}\", expected one of {', '.join(s[0] for s in SCENES)}")
    ways = WAYS[:1] + [w for w in WAYS[1:] if options.ways in w[0]]
    rows = measure(scenes, ways, frictions, 1 if options.quick else options.repeat, options.quick, os.path.join(options.out, "run"))
    with open(os.path.join(options.out, "tangents.csv"), "w", newline="") as f:
        writer = csv.DictWriter(f, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: f"{v:.5g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows)
    text = table(rows)
    with open(os.path.join(options.out, "tangents.md"), "w") as f:
        f.write(text)
    print(text)
    if options.store:
        store(options.store, text)
    for row in rows:
        if row["rejected"] or row["outcome"] != "finished":
            print(f"{row['scene']}, mu {row['mu']}, {row['way']}: {row['reason']}")
    base = {(row["scene"], row["mu"]): row for row in reversed(rows)}
    same = [row for row in rows if not row["rejected"] and row["steps"] == base[row["scene"], row["mu"]]["steps"]]
    wrong = [row for row in same if row["outcome"] == "finished" and not row["off"] < WRONG]
    for row in wrong:
        print(f"WRONG: {row['scene']}, mu {row['mu']}, {row['way']}: a result is off by {100 * row['off']:.2g} %")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
