"""A run whose system clock is set back by a day on its way (clock_back.c) goes on writing checkpoints at its interval, is killed, resumes,
and ends with the same bytes as one that was left alone:   clock_back.py NAME SCRIPT OPTIONS...     Works in $SCRATCH/NAME."""
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import kills

INTERVAL = ["-checkpoint", "5e-4"]   # minutes: several in a run
PATIENCE = 120                       # seconds


def preload(scratch):
    """Compiles the clock; `date` shows that it can be set back."""
    library, back = scratch / "clock_back.so", scratch / "back"
    subprocess.run([os.environ.get("CXX", "clang++"), "-x", "c", "-shared", "-fPIC", "-o", library, Path(__file__).with_suffix(".c")], check=True)
    os.environ.update(LD_PRELOAD=str(library), CLOCK_BACK=str(back))
    before = int(subprocess.check_output(["date", "+%s"]))
    back.touch()
    after = int(subprocess.check_output(["date", "+%s"]))
    back.unlink()
    if not -86400 <= after - before < -86000:
        sys.exit(f"FAILED: the clock was not set back: {after - before} s")
    return back


def written(file, process, other_than=None):
    """Waits until the file is there with another identity (a checkpoint is renamed into its place): that; None if it does not come."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end and process.poll() is None:
        if file.exists() and (found := (file.stat().st_ino, file.stat().st_mtime_ns)) != other_than:
            return found
        time.sleep(0.002)
    return None


def main():
    name, script, *options = sys.argv[1:]
    scratch = Path(os.environ["SCRATCH"]) / name
    scratch.mkdir(parents=True)
    _, status = kills.finish(script, options, scratch / "whole", ["-checkpoint", "0"])
    back, killed = preload(scratch), scratch / "killed"
    process = kills.start(script, options, killed, [*INTERVAL, "-resume", "1"])
    file = killed / "run-1.checkpoint"
    first = written(file, process)
    back.touch()
    second = written(file, process, first)  # may have been under way
    third = written(file, process, second)
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    if None in (first, second, third):
        print(f"FAILED: {name}: no checkpoint after the clock was set back: {first}, {second}, {third}")
        return 1
    _, last = kills.finish(script, options, killed, [*INTERVAL, "-resume", "1"])
    wrong = kills.report(name, scratch / "whole", killed, status, last)
    if "burnish: goes on from" not in (killed / "log").read_text():
        print(f"FAILED: {name}: did not resume")
        wrong = 1
    print(f"{name}: clock set back, killed after two more checkpoints, resumed: {wrong} wrong")
    return wrong


if __name__ == "__main__":
    sys.exit(main())
