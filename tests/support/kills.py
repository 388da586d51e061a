"""Kills a run at random instants, resumes it each time, and compares its files with those of a run that was left alone:
   kills.py NAME KILLS SCRIPT OPTIONS...
Works in $SCRATCH/NAME; the run writes a checkpoint after every step, so that kills fall into writes, too. Every file must have the same
bytes, but summary.json, which has CPU seconds, and the checkpoints. A run that ends before it is killed counts as none and begins anew.
A script without the option -out runs in a folder of its own, where it writes its files."""
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

BURNISH = os.environ["BURNISH"]
CHECKPOINT_ALWAYS = ["-checkpoint", "1e-9"]
LEFT_OUT = re.compile(r"summary\.json|run-\d+\.checkpoint(\.old)?|.*\.png|\.new\..*|(.*\.)?log")


def start(script, options, folder, more):
    """The run, in a process group of its own."""
    folder.mkdir(parents=True, exist_ok=True)
    case = "rcCaseOptions" in Path(script).read_text()
    command = [BURNISH, str(Path(script).resolve()), *options, *more]
    if case:
        command += ["-out", str(folder), "-pictures", "0"]
    with open(folder / "log", "a", encoding="utf-8") as log:
        return subprocess.Popen(command, cwd=Path.cwd() if case else folder, stdout=log, stderr=log, start_new_session=True)


def finish(script, options, folder, more):
    """@returns seconds that it took, exit status"""
    begin = time.monotonic()
    status = start(script, options, folder, more).wait()
    return time.monotonic() - begin, status


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*")
            if path.is_file() and not LEFT_OUT.fullmatch(path.name)}


def differences(whole, killed):
    a, b = files(whole), files(killed)
    if not a:
        return ["no files at all"]
    return [name for name in sorted(a.keys() | b.keys()) if a.get(name) != b.get(name)]


def main():
    name, kills, script, *options = sys.argv[1:]
    chance = random.Random(name)
    scratch = Path(os.environ["SCRATCH"]) / name
    whole, killed = scratch / "whole", scratch / "killed"
    seconds, status = finish(script, options, whole, ["-checkpoint", "0"])
    done = wrong = ends = 0
    begun = False
    while done < int(kills):
        process = start(script, options, killed, [*CHECKPOINT_ALWAYS, "-resume", "1"])
        begun = True
        time.sleep(chance.uniform(0, 1.2 * seconds))
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            done += 1
            process.wait()
            continue
        ends += 1
        wrong += report(name, whole, killed, status, process.returncode)
        shutil.rmtree(killed)
        begun = False
    if begun:
        _, last = finish(script, options, killed, [*CHECKPOINT_ALWAYS, "-resume", "1"])
        ends += 1
        wrong += report(name, whole, killed, status, last)
    resumed = killed.exists() and (killed / "log").read_text().count("burnish: goes on from")
    print(f"{name}: {done} kills, {ends} ends, {wrong} wrong; whole run {seconds:.1f} s, resumed {resumed} times in the last one")
    return 1 if wrong or not ends else 0


def report(name, whole, killed, expected, status):
    """@returns 1 if something is wrong"""
    off = differences(whole, killed)
    if status != expected:
        off.append(f"exit status {status} instead of {expected}")
    if off:
        print(f"FAILED: {name}: after kills differ: {', '.join(off[:8])}")
        print("".join((killed / "log").read_text().splitlines(keepends=True)[-12:]))
        shutil.copytree(killed, killed.with_name("wrong"), dirs_exist_ok=True)
    return 1 if off else 0


if __name__ == "__main__":
    sys.exit(main())
