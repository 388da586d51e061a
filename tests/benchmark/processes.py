"""Many processes: seconds of a step and memory by a model of what was counted, and what one and two processes measure.

processes.py [--measure] [--space OPTIONS ...] [--plane OPTIONS ...]        BURNISH: wrapper; see make bench-processes
The model, a block in space as in growth-in-space.edp. Counted there at 27 417, 62 475 and 202 575 unknowns: flops and numbers of a factor
and unknowns of the top that two ranks share, the separator and the window; between and beyond them all grow by the powers of the two next
to them. Counted with MUMPS at 62 475 on 2, 4 and 8 ranks: flops of the busiest rank, bytes and messages. Measured there on one and two
processes: the constants with units below. Assumed: the memory is as fast for every rank as for one alone, 4 GB/s and 2 us a message between any
two; more than 8 ranks are as much worse than 8 at each doubling as 8 are than 4.
--measure: the runs themselves in turns on one and two processes, on the clock, which is worth something on two quiet cores only.
"""
import argparse
import math
import os
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
# unknowns: flops of a factor, its numbers, unknowns of the top, flops a second of CHOLMOD
COUNTED = {27417: (8.06e9, 1.065e7, 832, 28e9), 62475: (4.64e10, 3.63e7, 1396, 31e9), 202575: (5.74e11, 2.031e8, 2972, 45e9)}
FASTEST = 50e9           # [flops/s] that the rate grows to
MUMPS = 1.29             # times the seconds of CHOLMOD: 1.035 the flops, 1.25 the seconds of each
HALF = 0.50              # of the flops of the whole, those of each half without the top's own
BUSIEST = {4: 1.07, 8: 1.35}   # flops of MUMPS's busiest rank, times the ranks, over all
SENT = {4: 9.3e7, 8: 1.06e8}   # [bytes] by it, of SENT_AT unknowns; they grow as the numbers of the top
SENT_AT = 62475
MESSAGES = {4: 351, 8: 687}
SOLVE = 10e9             # [bytes/s] of the factor, read twice
ELEMENTS = 7e-8          # [s] of forces and tangent per unknown and iteration, on one rank
SHARED = 1e-8            # [s] per unknown and iteration, to pack, send and unpack them
REST = 6.2e-7            # [s] per unknown and iteration of what every rank does: stress 2.7e-7, contact, searches, permutations, script
STATE = 3100             # [bytes] per unknown on every rank, beside the factor
LINK, LATENCY = 4e9, 2e-6  # [bytes/s], [s]
FACTORS, ITERATIONS = 1.6, 10.  # per step
RANKS = [1, 2, 4, 8, 16, 32, 64]


def grown(n, column):
    """A counted column at n unknowns."""
    sizes = sorted(COUNTED)
    a, b = (sizes[0], sizes[1]) if n < sizes[1] else (sizes[1], sizes[2])
    power = math.log(COUNTED[b][column] / COUNTED[a][column]) / math.log(b / a)
    return COUNTED[b][column] * (n / b)**power


def on(table, ranks):
    """A count at ranks; beyond 8 it grows as from 4 to 8."""
    return table[ranks] if ranks in table else table[8] * (table[8] / table[4])**math.log2(ranks / 8)


def factor(n, ranks):
    """Seconds."""
    flops, top, rate = grown(n, 0), grown(n, 2), min(grown(n, 3), FASTEST)
    if ranks == 1:
        return flops / rate
    if ranks == 2:
        return (HALF * flops + top**3) / rate + 8 * top**2 / LINK
    sent = on(SENT, ranks) * (top / grown(SENT_AT, 2))**2
    return MUMPS * flops * on(BUSIEST, ranks) / ranks / rate + sent / LINK + on(MESSAGES, ranks) * LATENCY


def iteration(n, ranks):
    """Seconds of a solve, the elements and the rest."""
    top = 4 * 8 * grown(n, 2)**2 if ranks == 2 else 0
    solve = (2 * 8 * grown(n, 1) / ranks + top) / SOLVE
    return solve + (ELEMENTS / ranks + (SHARED if ranks > 1 else 0) + REST) * n


def step(n, ranks):
    return FACTORS * factor(n, ranks) + ITERATIONS * iteration(n, ranks)


def memory(n, ranks):
    """Bytes of a rank."""
    return STATE * n + 8 * grown(n, 1) / ranks + (2 * 8 * grown(n, 2)**2 if ranks == 2 else 0)


def model():
    """A table for edp/manual/processes.md."""
    print("| Unknowns | " + " | ".join(map(str, RANKS)) + " |\n" + "|---" * (len(RANKS) + 1) + "|")
    for n in (62475, 202575, 300000, 1000000, 3000000, 10000000):
        cells = [f"{step(n, p):.{0 if step(n, p) > 100 else 1}f} s, {step(n, 1) / step(n, p):.1f}, {memory(n, p) / 1e9:.3g} GB" for p in RANKS]
        print(f"| {n} | " + " | ".join(cells) + " |")


def run(processes, script, options):
    """Seconds on the clock and CPU seconds of a process, of a scene that ends well, and what it prints."""
    words = [os.environ["BURNISH"], *(["-np", str(processes)] if processes > 1 else []), os.path.join(HERE, script), *options.split()]
    before, start = os.times(), time.perf_counter()
    done = subprocess.run(words, capture_output=True, text=True, cwd=TOP, env={**os.environ, "BURNISH_DIVIDE_FROM": "1"}, check=False)
    clock, after = time.perf_counter() - start, os.times()
    if done.returncode != 0:
        sys.exit(f"processes: exit status {done.returncode} of {' '.join(words)}: {done.stdout[-1000:]}{done.stderr[-1000:]}")
    lines = (line.split() for line in done.stdout.splitlines())
    found = {w[1]: float(w[2]) for w in lines if len(w) == 3 and w[0] == "result"}
    cpu = sum(after[2:4]) - sum(before[2:4])
    return {**found, "clock": clock, "cpu": cpu / processes}


def measure(script, sizes):
    """Rows of the table of runs in edp/manual/processes.md."""
    for options in sizes:
        both = {p: run(p, script, options) for p in (1, 2)}
        for p, r in both.items():
            scene = f"{script} {options}, {r['steps']:.0f} steps, {r['factorizations']:.0f} factors, {r['iterations']:.0f} iterations"
            cells = [scene if p == 1 else "", f"{r['dofs']:.0f}" if p == 1 else "", p, f"{r['clock']:.1f}",
                     f"{both[1]['clock'] / r['clock']:.2f}", f"{r['cpu']:.1f}", *(f"{r[name]:.1f}" for name in PHASES),
                     f"{r['peak'] / 1024:.0f}"]
            print("| " + " | ".join(map(str, cells)) + " |", flush=True)
        if any(both[1][name] != both[2][name] for name in ("steps", "iterations", "factorizations")):
            print("other steps, iterations or factors on two processes")


SPACE = ["-n 3", "-n 4", "-n 6 -end 0.2", "-n 7 -end 0.2", "-n 23 -layers 4 -end 0.05"]  # the last a plate of 1 039 581 unknowns
PLANE = ["-n 37", "-n 52"]
PHASES = ("factorization", "solve", "update", "assembly")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measure", action="store_true", help="run on one and two processes, beside the model")
    parser.add_argument("--space", nargs="*", default=SPACE, metavar="OPTIONS", help="of growth-in-space.edp: -n N, 930 N^3 unknowns")
    parser.add_argument("--plane", nargs="*", default=PLANE, metavar="OPTIONS", help="of growth.edp: -n N, 98 N^2 unknowns")
    options = parser.parse_args()
    model()
    if options.measure:
        print("\n| | Unknowns | Processes | Clock, s | Times as fast | CPU s of each | factors | solves | stress | tangent | Memory of each, MB |\n"
              + "|---" * 11 + "|")
        measure("growth-in-space.edp", options.space)
        measure("growth.edp", options.plane)


if __name__ == "__main__":
    main()
