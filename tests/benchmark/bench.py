"""Times of kernels and whole scenes against those of the last release, as ratios to a yardstick of the same minute.

bench.py [--only TEXT] [--repeat N] [--kernels | --scenes | --growth] [--store] [--out FOLDER]
                                       BURNISH: wrapper, BENCHMARK: the program of tests/benchmark; see the Makefile's targets
Yardstick: the factorization of one fixed matrix by CHOLMOD alone (bench_yardstick.cpp). Kernels and yardstick are run in turns by
Google Benchmark. A scene is run between two yardsticks, all scenes in turns, CPU seconds of the process over the mean of both. The
median of all repetitions is kept, the spread is half of largest less smallest over it. ratios.csv has what --store has written: the
last release. A name is slower (faster) where the ratios differ by more than both spreads and LEAST together. Nothing passes or fails.
Of scenes, from their summary.json: the multiple is the CPU time of the run over that of its factorizations; megabytes the peak of the
process; kB/dof what it takes beyond a FreeFEM with the plugin and the factor, per degree of freedom.
--growth: one scene in the plane (growth.edp, to 270 000 unknowns) and one in space (growth-in-space.edp, to 200 000), ten steps or a
few more; the order is that of the time between two lines.
"""
import argparse
import csv
import json
import math
import os
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
STORED = os.path.join(HERE, "ratios.csv")
LEAST = 0.02
KERNELS = r"^(yardstick|stress_update|internal_force|tangent|factorization|whole_step|closest_point|ReadTriplets)$" \
          r"|^step/100$|/(Factorize|Solve|Flexibility|Analyze)/radial:20/along:52/candidates:105$|/(Bordered|Umfpack).*friction_rows:10$"
SCENES = {"rolling": "cases/rolling/rolling.edp", "rolling, coarse": "cases/rolling/rolling.edp -inner 5 -outer 75 -sides 10",
          "hertz": "cases/hertz/hertz.edp -meshes 0", "indentation": "cases/indentation/indentation.edp -half 1",
          "strip-rolling": "cases/strip-rolling/strip-rolling.edp", "bending": "cases/bending/bending.edp", "cup": "cases/cup/cup.edp",
          "u-channel": "cases/u-channel/u-channel.edp"}
GROWTH = (("growth.edp", [5, 10, 20, 37, 52], lambda n: 98 * n**2), ("growth-in-space.edp", [2, 3, 4, 5, 6], lambda n: 900 * n**3))


def middle(values):
    """Median and spread."""
    m = statistics.median(values)
    return m, (max(values) - min(values)) / 2 / m


def benchmark(pattern, repetitions, least):
    """CPU seconds of every repetition of the kernels that match, by name."""
    words = [os.environ["BENCHMARK"], f"--benchmark_filter={pattern}", "--benchmark_format=json", f"--benchmark_min_time={least}",
             f"--benchmark_repetitions={repetitions}", "--benchmark_enable_random_interleaving=true"]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0 or not done.stdout.strip():
        sys.exit(f"bench: exit status {done.returncode} of {' '.join(words)}: {done.stderr[-1000:]}")
    units, found = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}, {}
    for entry in json.loads(done.stdout)["benchmarks"]:
        if entry.get("error_occurred"):
            sys.exit(f"bench: {entry['name']}: {entry['error_message']}")
        if entry["run_type"] == "iteration":
            found.setdefault(entry["run_name"], []).append(entry["cpu_time"] * units[entry["time_unit"]])
    return found


def yardstick():
    return statistics.median(benchmark("^yardstick$", 1, 0.2)["yardstick"])


def process(words):
    """Output, CPU seconds and peak memory [kB] of a script that ends well."""
    path = os.path.join(os.environ["BENCH_OUT"], "log.txt")
    with open(path, "w") as log:
        child = subprocess.Popen([os.environ["BURNISH"], *words], stdout=log, stderr=subprocess.STDOUT, cwd=TOP)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    with open(path, errors="replace") as log:
        text = log.read()
    if child.returncode != 0:
        sys.exit(f"bench: exit status {child.returncode} of {' '.join(words)}:\n{text[-2000:]}")
    return text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def kernels(repetitions, only):
    found = benchmark(KERNELS, repetitions, 0.05)
    unit = statistics.median(found.pop("yardstick"))
    rows = []
    for name, seconds in found.items():
        if only in name:
            m, spread = middle([s / unit for s in seconds])
            rows.append({"name": name, "ratio": m, "spread": spread, "seconds": statistics.median(seconds)})
    return rows


def start_memory():
    path = os.path.join(os.environ["BENCH_OUT"], "start.edp")
    with open(path, "w") as f:
        f.write('include "burnish.idp"\n')
    return process([path])[2]


def scenes(repetitions, only):
    folder, start = os.path.join(os.environ["BENCH_OUT"], "scene"), start_memory()
    able = {name: words.split() for name, words in SCENES.items() if only in name}
    ratios, rows = {name: [] for name in able}, {}
    for k in range(repetitions):
        for name in list(able) if k % 2 == 0 else reversed(list(able)):
            before = yardstick()
            _, seconds, peak = process([*able[name], "-pictures", "0", "-check", "0", "-out", folder])
            ratios[name].append(seconds / ((before + yardstick()) / 2))
            with open(os.path.join(folder, "summary.json")) as f:
                summary = json.load(f)
            counts, cpu = summary["counts"], summary["cpu_seconds"]
            dofs = 2 * summary["mesh"]["nodes"]
            rows[name] = {"seconds": seconds, "factorizations": counts["factorizations"], "multiple": cpu["total"] / cpu["factorization"],
                          "megabytes": peak / 1024, "kB/dof": (peak - start - 8 * counts["factor_entries"] / 1024) / dofs}
            print(f"  {name}: {seconds:.2f} s", file=sys.stderr, flush=True)
    return [{"name": name, "ratio": middle(r)[0], "spread": middle(r)[1], **rows[name]} for name, r in ratios.items()]


def stored():
    if not os.path.exists(STORED):
        return {}
    with open(STORED) as f:
        return {row["name"]: (float(row["ratio"]), float(row["spread"])) for row in csv.DictReader(f)}


def verdict(row, old):
    """The change since the last release, and whether it is more than chance."""
    if row["name"] not in old:
        return "", "new"
    change = row["ratio"] / old[row["name"]][0] - 1
    chance = row["spread"] + old[row["name"]][1] + LEAST
    return f"{100 * change:+.0f} %", "slower" if change > chance else "faster" if change < -chance else ""


def show(rows, old):
    extra = [name for name in ("factorizations", "multiple", "megabytes", "kB/dof") if any(name in row for row in rows)]
    print(f"{'':48s}{'CPU':>10s}{'ratio':>10s}{'spread':>8s}{'change':>8s}{'':8s}" + "".join(f"{name:>15s}" for name in extra))
    slower = []
    for row in rows:
        change, word = verdict(row, old)
        seconds = f"{row['seconds']:.2f} s" if row["seconds"] > 0.1 else f"{1e3 * row['seconds']:.3g} ms"
        print(f"{row['name']:48s}{seconds:>10s}{row['ratio']:10.4g}{100 * row['spread']:6.0f} %{change:>8s}{word:>8s}"
              + "".join(f"{row[name]:15.4g}" if name in row else f"{'':15s}" for name in extra))
        slower += [row["name"]] if word == "slower" else []
    return slower


def store(rows):
    new = {**stored(), **{row["name"]: (row["ratio"], row["spread"]) for row in rows}}
    with open(STORED, "w", newline="") as f:
        writer = csv.writer(f, lineterminator="\n")
        writer.writerow(["name", "ratio", "spread"])
        writer.writerows([name, f"{r:.4g}", f"{s:.2g}"] for name, (r, s) in new.items())


def growth(most):
    for scene, sizes, unknowns in GROWTH:
        print(f"{scene}\n{'unknowns':>10s}{'CPU':>10s}{'order':>7s}{'steps':>7s}{'iterations':>12s}{'factors':>9s}{'one factor':>12s}{'multiple':>10s}"
              f"{'peak':>10s}{'factor':>10s}{'kB/dof':>8s}")
        before = None
        for n in (n for n in sizes if unknowns(n) <= most):
            text, _, _ = process([os.path.join(HERE, scene), "-n", str(n)])
            r = {w[1]: float(w[2]) for w in (line.split() for line in text.splitlines()) if len(w) == 3 and w[0] == "result"}
            r["kB/dof"] = (r["peak"] - r["start"] - r["factor"]) / r["dofs"]
            order = math.log(r["seconds"] / before["seconds"]) / math.log(r["dofs"] / before["dofs"]) if before else float("nan")
            one = r["factorization"] / r["factorizations"]
            print(f"{r['dofs']:10.0f}{r['seconds']:8.2f} s{order:7.2f}{r['steps']:7.0f}{r['iterations']:12.0f}{r['factorizations']:9.0f}"
                  f"{1e3 * one:9.1f} ms{r['seconds'] / r['factorization']:10.2f}{r['peak'] / 1024:7.0f} MB{r['factor'] / 1024:7.0f} MB"
                  f"{r['kB/dof']:8.2f}", flush=True)
            before = r


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", metavar="TEXT", help="names that contain TEXT")
    parser.add_argument("--repeat", type=int, default=5, metavar="N", help="repetitions")
    parser.add_argument("--kernels", action="store_true", help="no scenes")
    parser.add_argument("--scenes", action="store_true", help="no kernels")
    parser.add_argument("--growth", action="store_true", help="time and memory against the number of unknowns instead")
    parser.add_argument("--most", type=int, default=300000, metavar="N", help="--growth: no more unknowns than these")
    parser.add_argument("--store", action="store_true", help="these are the ratios of the release")
    parser.add_argument("--out", default="out/bench", metavar="FOLDER")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    os.environ["BENCH_OUT"] = os.path.abspath(options.out)
    if options.growth:
        growth(options.most)
        return
    old, rows, slower = stored(), [], []
    for skipped, measure in ((options.scenes, kernels), (options.kernels, scenes)):
        if skipped:
            continue
        found = measure(options.repeat, options.only)
        slower += show(found, old)
        rows += found
    if not rows:
        sys.exit(f"bench: nothing contains \"{options.only}\"")
    print("slower than the last release by more than its spread: " + (", ".join(slower) or "nothing"))
    if options.store:
        store(rows)


if __name__ == "__main__":
    main()
