"""Order of convergence of a case's errors in its mesh size:  case_order.py CASE "OPTIONS" "N1 N2 ..." NAME ORDER WITHIN ...

Runs cases/CASE with OPTIONS -n N for each N, each twice the one before, into $SCRATCH; the error of each result NAME is
taken from summary.json; the slope of -log2(error), by least squares, must be ORDER up to WITHIN. A test is a .sh with
    exec "$PYTHON" tests/verification/case_order.py punch "-element P1" "8 16 32" "tilt, e = a/4" 1 0.2
"""
import json
import math
import os
import shlex
import subprocess
import sys


def errors(case, options, n, names):
    """Errors of the results of one run."""
    folder = os.path.join(os.environ.get("SCRATCH", "out/order"), f"{case}-{abs(hash(options)) % 10**6}-{n}")
    command = [os.environ.get("BURNISH", "build/burnish"), f"cases/{case}/{case}.edp", "-out", folder, "-n", str(n),
               "-series", "0", "-pictures", "0", *shlex.split(options)]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode:
        sys.exit("\n".join(done.stdout.splitlines()[-25:] + [f"exit code {done.returncode}: {' '.join(command)}"]))
    with open(os.path.join(folder, "summary.json")) as file:
        results = json.load(file)["results"]
    return [abs(results[name]["error"]) for name in names]


def slope(values):
    """Of -log2 of the values against their number, by least squares."""
    middle = 0.5 * (len(values) - 1)
    top = sum((k - middle) * math.log2(v) for k, v in enumerate(values))
    return -top / sum((k - middle) ** 2 for k in range(len(values)))


def main(case, options, divisions, *expected):
    names, failed = expected[::3], 0
    found = [errors(case, options, n, names) for n in map(int, divisions.split())]
    for name, order, within, values in zip(names, map(float, expected[1::3]), map(float, expected[2::3]), zip(*found)):
        ok = abs(slope(values) - order) <= within
        failed += not ok
        print(f"{'ok  ' if ok else 'FAIL'} {case} {options}: {name}: errors {', '.join(f'{v:.4g}' for v in values)}, "
              f"order {slope(values):.3f}, expected {order:g} within {within:g}")
    sys.exit(failed > 0)


if __name__ == "__main__":
    if len(sys.argv) < 7 or (len(sys.argv) - 4) % 3:
        sys.exit("usage: case_order.py CASE OPTIONS DIVISIONS (NAME ORDER WITHIN)...")
    main(*sys.argv[1:])
