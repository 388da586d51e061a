"""Runs of one script on one and on several processes: the same steps and events, tool numbers that agree.

    run(processes, script, options, divided)  -> (status, output)
    difference(a, b)                          -> largest relative difference of the numbers of two lines that begin with "end"
"""
import os
import subprocess

BURNISH = os.environ["BURNISH"]
LIMIT = 120  # [s]
COUNTS = 3   # of an "end" line: steps, rejected steps, events


def command(processes, script, options):
    several = ["-np", str(processes)] if processes > 1 else []
    return [BURNISH, *several, script, *options]


def environment(divided):
    """divided: the work of bodies of any size is divided among the processes"""
    return {**os.environ, "BURNISH_DIVIDE_FROM": "1" if divided else "1000000000"}


def run(processes, script, options=(), divided=True):
    done = subprocess.run(command(processes, script, list(options)), env=environment(divided), timeout=LIMIT,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, done.stdout


def end_of(output):
    ends = [line.split()[1:] for line in output.splitlines() if line.startswith("end ")]
    if len(ends) != 1:
        raise SystemExit(f"FAILED: {len(ends)} lines \"end\" instead of one:\n{output}")
    return [int(word) for word in ends[0][:COUNTS]], [float(word) for word in ends[0][COUNTS:]]


def difference(one, other):
    (counts, numbers), (other_counts, other_numbers) = end_of(one), end_of(other)
    if counts != other_counts:
        raise SystemExit(f"FAILED: steps, rejected, events {other_counts} instead of {counts}")
    return max(abs(a - b) / max(abs(a), 1e-12) for a, b in zip(numbers, other_numbers))
