"""CalculiX and Ipopt against Burnish on the same meshes in interleaved pairs, as ratios of CPU time.

bench.py [--only TEXT] [--repeat N] [--medium] [--exact] [--store] [--out FOLDER]      see the Makefile's target bench-peers
A pair is one run of ours (rcRun with a material, `implicit`) and one of the peer on the mesh and steps of a line of
tests/chart/runs.csv, one after the other, every other pair the other way round; a peer that takes longer than ONCE is asked once,
between two of ours. Ratios are those of the medians. The same error: the fastest of ours, on any mesh of LADDER, whose error is not above the peer's. Seconds: CPU
without the start of a script and its mesh; with reading its deck and writing its results for CalculiX. Results: bench.csv, all quantities
of the scene; table of the quantities SHOWN; --store: both into this folder.
"""
import argparse
import csv
import os
import re
import shutil
import statistics
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "chart"))
import forming  # noqa: E402
from report import MEANING  # noqa: E402
from run import errors_of  # noqa: E402
from scene_files import installed, methods, own_runs, read_curves, read_fields, read_references, run, scenes  # noqa: E402

ONCE, LONGEST = 10, 3000  # [s]
SHOWN = {"hertz": ["pressure", "pressure_inner"], "ball": ["pressure_inner", "depth"], "indentation": ["depth", "strain"], "rolling": ["depth", "torque", "strain"]}
LADDER = {"hertz": [("P1", n, 0) for n in (4, 6, 8, 12, 16, 24, 32)] + [("P2", n, 0) for n in (2, 4, 8, 10, 12, 16, 20, 24, 32, 40)],
          "ball": [(e, n, 0) for e in ("P1", "P2") for n in (2, 3, 4, 5, 6, 8, 10)] + [("P1", 12, 0), ("P1", 16, 0)],
          "indentation": [(e, n, k) for e in ("P1", "P2") for n, k in ((10, 5), (10, 10), (20, 10), (20, 30), (40, 30))],
          "rolling": [(e, n, k) for e in ("P1", "P2") for n, k in ((20, 30), (30, 60), (60, 60), (90, 90))]}
# with --exact, and ours for the same error: where the peer comes to 0.2 % in the pressure of Hertz
EXACT = {("Ipopt", "hertz"): (("P2", 76, 0), ("P2", 104, 0))}
NUMBERS = ["seconds", "megabytes", "seconds_ours", "megabytes_ours", "ratio", "error", "error_ours", "seconds_same_error", "ratio_same_error"]


def once(scene, method, task, known):
    element, n, steps = task
    options = [*method["options"], "-element", element, "-n", str(n)] + (["-steps", str(steps)] if steps else [])
    found = run(scene, options, method["program"], LONGEST)
    return {**{name: found[name] for name in ("seconds", "megabytes", "outcome")}, "errors": errors_of(scene, found, *known)}


def middle(results):
    return {**results[0], "seconds": statistics.median(r["seconds"] for r in results)}


def pair(scene, own, peer, task, repeat, known):
    """Medians of ours and of the peer."""
    ours, theirs = [], []
    for k in range(repeat):
        long = bool(theirs) and theirs[0]["seconds"] > ONCE
        for who in (own, peer) if k % 2 == 0 else (peer, own):
            if who is peer and not long:
                theirs.append(once(scene, peer, task, known))
            elif who is own and (not long or k == 1):
                ours.append(once(scene, own, task, known))
    return middle(ours), middle(theirs)


def text(task):
    return f"{task[0]}, n = {task[1]}" + (f", {task[2]} steps" if task[2] else "")


def rows_of(scene, own, peer, tasks, ladder, repeat, known):
    """One row for every pair and quantity."""
    for task in tasks:
        ours, theirs = pair(scene, own, peer, task, repeat, known)
        ladder[task] = ours
        print(f"  {peer['name']}, {scene['name']}, {text(task)}: {theirs['seconds']:.2f} s, {theirs['outcome']}; ours "
              f"{ours['seconds']:.2f} s", flush=True)
        for quantity in scene["quantities"]:
            error = theirs["errors"].get(quantity, float("nan"))
            good = [t for t, r in ladder.items() if r["outcome"] == "finished" and r["errors"][quantity] <= error]
            best = min(good, key=lambda t: ladder[t]["seconds"], default=None)
            yield {"peer": peer["name"], "scene": scene["name"], "element": task[0], "n": task[1], "steps": task[2],
                   "outcome": theirs["outcome"], "seconds": theirs["seconds"], "megabytes": theirs["megabytes"], "seconds_ours": ours["seconds"],
                   "megabytes_ours": ours["megabytes"], "ratio": theirs["seconds"] / ours["seconds"], "quantity": quantity, "error": error,
                   "error_ours": ours["errors"][quantity], "same_error": text(best) if best else "",
                   "seconds_same_error": ladder[best]["seconds"] if best else float("nan"),
                   "ratio_same_error": theirs["seconds"] / ladder[best]["seconds"] if best else float("nan")}


def measure(options):
    known, found = (read_references(), read_curves(), read_fields()), []
    own = next(m for m in methods() if m["name"] == "implicit")
    for scene in scenes():
        sizes = ["full", "medium"] if options.medium else ["full"]
        wanted = {m["name"]: (m, list(own_runs(scene, m, *sizes))) for m in methods() if m["program"]}
        wanted = {n: w for n, w in wanted.items() if w[1] and re.search(options.only, f"{n} {scene['name']}")}
        for name in [n for n, w in wanted.items() if not installed(w[0])]:
            print(f"{scene['name']}: {name} is not installed and left out")
            del wanted[name]
        if options.exact:
            wanted = {n: (w[0], [EXACT[n, scene["name"]][0]]) for n, w in wanted.items() if (n, scene["name"]) in EXACT}
        ladder, steps = {}, [EXACT[n, scene["name"]][1] for n in wanted] if options.exact else LADDER.get(scene["name"], [])
        for task in steps if wanted else []:
            ladder[task] = middle([once(scene, own, task, known) for _ in range(options.repeat)])
        for name, (peer, tasks) in wanted.items():
            found += rows_of(scene, own, peer, tasks, ladder, options.repeat, known)
    return found


def percent(x):
    return f"{100 * x:.2g} %" if x == x else "-"


def table(rows):
    lines = ["| Scene, mesh | Peer | s | ours, s | times | Error in | peer | ours | Ours with at most the peer's error | times |",
             "|" + "---|" * 10]
    for r in rows:
        if r["quantity"] in SHOWN[r["scene"]]:
            task = text((r["element"], r["n"], int(r["steps"])))
            best = f"{r['same_error']}: {r['seconds_same_error']:.2f} s" if r["same_error"] else "none of the meshes tried"
            name = r["peer"] + ("" if r["outcome"] == "finished" else f" ({r['outcome']})")
            lines.append(f"| {r['scene']}, {task} | {name} | {r['seconds']:.2f} | {r['seconds_ours']:.2f} | {r['ratio']:.1f} | "
                         f"{MEANING.get(r['quantity'], r['quantity'])} | {percent(r['error'])} | {percent(r['error_ours'])} | {best} | "
                         + (f"{r['ratio_same_error']:.1f} |" if r["same_error"] else "- |"))
    return lines


def store(lines, name):
    """Into README.md between <!-- table NAME --> and <!-- end -->."""
    path = os.path.join(HERE, "README.md")
    with open(path) as f:
        before = f.read()
    mark = f"<!-- table {name} -->"
    after, count = re.subn(re.escape(mark) + r"\n.*?<!-- end -->", lambda _: "\n".join([mark, *lines, "<!-- end -->"]), before, flags=re.DOTALL)
    if count != 1:
        sys.exit(f"README.md has {count} times {mark}, expected once")
    with open(path, "w") as f:
        f.write(after)


def kept(rows):
    """Rows stored before of pairs that are not among these, then these."""
    key = ("peer", "scene", "element", "n", "steps")
    new, path = {tuple(str(r[k]) for k in key) for r in rows}, os.path.join(HERE, "bench.csv")
    if not os.path.exists(path):
        return rows
    with open(path) as f:
        old = [{k: float(v) if k in NUMBERS and v else v for k, v in r.items()} for r in csv.DictReader(f)]
    order = {name: k for k, name in enumerate(s["name"] for s in scenes())}
    return sorted([r for r in old if tuple(r[k] for k in key) not in new] + rows,
                  key=lambda r: (order[r["scene"]], r["peer"], r["element"], int(r["n"]), int(r["steps"])))


def form(scenes, options):
    """Sheets: forming.csv and its table."""
    rows = forming.rows_of(scenes)
    os.makedirs(options.out, exist_ok=True)
    forming.write(rows, os.path.join(options.out, "forming.csv"))
    lines = forming.table(rows)
    print("\n".join(lines))
    if options.store:
        forming.write(rows, forming.STORED)
        store(lines, "forming")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="", help="pairs whose peer and scene, as in \"Ipopt hertz\", \"CalculiX forming cup\", match this pattern")
    parser.add_argument("--repeat", type=int, default=3, help="pairs of each")
    parser.add_argument("--medium", action="store_true", help="finer meshes, too")
    parser.add_argument("--exact", action="store_true", help="nothing but Hertz to 0.2 % in pressure: minutes")
    parser.add_argument("--store", action="store_true", help="table into README.md, bench.csv beside it; what is not measured now is kept")
    parser.add_argument("--out", default="out/bench-peers")
    options = parser.parse_args()
    sheets = [scene for scene in forming.SCENES if re.search(options.only, f"CalculiX forming {scene}")] if shutil.which("ccx") else []
    if sheets:
        form(sheets, options)
    rows = measure(options)
    if not rows:
        sys.exit(None if sheets else "bench-peers: nothing was run")
    if options.store:
        rows = kept(rows)
    os.makedirs(options.out, exist_ok=True)
    for folder in [options.out] + ([HERE] if options.store else []):
        with open(os.path.join(folder, "bench.csv"), "w", newline="") as f:
            sheet = csv.DictWriter(f, list(rows[0]), lineterminator="\n")
            sheet.writeheader()
            for row in rows:
                sheet.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()})
    lines = table(rows)
    print("\n".join(lines))
    if options.store:
        store(lines, "bench")


if __name__ == "__main__":
    main()
