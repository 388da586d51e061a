"""Cases in two unit systems, mm, N, MPa and m, N, Pa: the same steps and events, the same numbers after scaling.

    units_cases.py [CASE ...]        all of them unless some are named; needs $BURNISH, writes to $SCRATCH
Options that are lengths get 1e-3, stresses 1e6, forces per thickness 1e3; the event lists must agree in kind, node and
tool, their instants to 1e-6 of the run, and every column of history.csv after scaling to 1e-6 of the largest value in
its unit. Only cases whose meshes come from square(): FreeFEM's mesher numbers nodes differently in other units.
"""
import csv
import json
import os
import subprocess
import sys

# options of a coarse run; its lengths, stresses and forces per thickness; whether the case itself is in m, N, Pa
CASES = {
    "crank-press": ("-n 8 -steps 20", "e l R W height", "G sigY H", "", True),
    "upsetting": ("-n 6 -steps 20", "a h0", "E sigY H", "", False),
    "upsetting axisymmetric": ("-n 6 -steps 20 -axisymmetric 1 -law sticking", "a h0", "E sigY H", "", False),
    "strip-rolling": ("-ny 2 -rolls 1 -travel 4 -tolerance 5e-7", "R h0 dh length push travel", "E sigY H", "", False),
    "bending": ("-nx 24 -ny 2 -depth 3 -tolerance 1e-7", "thickness length die shoulder nose depth", "E sigY H", "",
                False),
}
POWERS = [10.0**k for k in (-6, -3, 0, 3, 6)]
TOLERANCE = 1e-6


def start(case, *options):
    command = [os.environ.get("BURNISH", "build/burnish"), "cases/{0}/{0}.edp".format(case.split()[0]), *options]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")


def run(case, label, options):
    """Rows of events.csv and columns of history.csv."""
    folder = os.path.join(os.environ.get("SCRATCH", "out/units"), f"{case.replace(' ', '-')}-{label}")
    done = start(case, "-out", folder, "-pictures", "0", "-series", "1", "-check", "0", *options)
    if done.returncode:
        sys.exit(f"{case} {label}: exit code {done.returncode}\n" + "\n".join(done.stdout.splitlines()[-8:]))
    with open(os.path.join(folder, "events.csv")) as file:
        events = list(csv.DictReader(file))
    with open(os.path.join(folder, "history.csv")) as file:
        rows = list(csv.DictReader(file))
    rows = [{name: value for name, value in row.items() if name != "factorizations"} for row in rows]
    return events, {name: [float(row[name]) for row in rows] for name in rows[0]}


def scaled(case, coarse, lengths, stresses, forces, metric):
    """Options of the same run in the other units, from the case's own defaults."""
    done = start(case, *coarse.split(), "-options", "list")
    values = json.loads(next(line for line in done.stdout.splitlines() if line.startswith("{")))
    options = coarse.split()
    for names, factor in ((lengths, 1e-3), (stresses, 1e6), (forces, 1e3)):
        for name in names.split():
            text = f"{values[name] * (1 / factor if metric else factor):.17g}"
            if f"-{name}" in options:
                options[options.index(f"-{name}") + 1] = text
            else:
                options += [f"-{name}", text]
    return options


def worst_column(one, other):
    """Largest difference of a column once the units agree, over the largest value of all columns in its unit; name."""
    size = {name: (max(map(abs, one[name])), max(map(abs, other[name]))) for name in one}
    unit = {name: min(POWERS, key=lambda power: abs(b - power * a) / power) for name, (a, b) in size.items()}
    known = [name for name, (a, b) in size.items() if abs(b - unit[name] * a) <= 1e-3 * b]  # others: only rounding
    largest = {power: max((size[name][0] for name in known if unit[name] == power), default=1) for power in POWERS}
    all_sizes = max(a for a, _ in size.values())
    off = {name: max(abs(y / unit[name] - x) for x, y in zip(one[name], other[name])) / (largest[unit[name]] or 1)
           for name in known}
    off.update({name: size[name][0] / all_sizes for name in one if name not in known})
    return max((value, name) for name, value in off.items())


def compare(case):
    coarse, *rest = CASES[case]
    events, history = run(case, "own", coarse.split())
    events2, history2 = run(case, "other", scaled(case, coarse, *rest))
    what = [[(e["event"], e["node"], e["tool"]) for e in list_] for list_ in (events, events2)]
    same = what[0] == what[1] and len(history["t"]) == len(history2["t"])
    late = max((abs(float(a["t"]) - float(b["t"])) for a, b in zip(events, events2)), default=0.0)
    difference, name = worst_column(history, history2) if same else (float("inf"), "")
    print(f"{case}: {len(events)} and {len(events2)} events, {len(history['t'])} and {len(history2['t'])} rows, "
          f"instants differ by {late:.1e}, {name or 'numbers'} by {difference:.1e}")
    return same and late <= TOLERANCE and difference <= TOLERANCE


if __name__ == "__main__":
    failed = [case for case in sys.argv[1:] or CASES if not compare(case)]
    sys.exit("differ: " + ", ".join(failed) if failed else 0)
