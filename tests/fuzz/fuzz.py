"""Scripts with mistakes by chance: each must end by itself, in time, without a crash.

fuzz.py SECONDS [SEED]: mutants of README.md's script, of cases and of error tests, run by $BURNISH in a folder of their own.
An exit status is right if it is one of Burnish's (0, 3, 4, 5, 20, 130) or of FreeFEM's own refusals (1 to 8). A signal, an
exit status of a crash and a run that does not end are findings: the mutant is kept in the folder that is printed, with its
command. Exit status 1 if there is one.
"""
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
RIGHT = {*range(9), 20, 130}
LONGEST = 60                 # s, of one run; they take a second
MEMORY = 6 << 30             # bytes
NUMBERS = "0 -1 1 2 1e-300 1e300 -1e300 1e9 2^31 2^32 2^40 -2^40 0.5 1e-9 (1e300*1e300) (1e300*1e300-1e300*1e300) 3 1000".split()
# FreeFEM itself crashes where an array or a text is larger than the memory: not ours to find, so none is made so large.
HUGE = {"2^31", "2^32", "2^40", "1e9", "1e300", "(1e300*1e300)"}
SIZES = re.compile(r"\[int[^\]]*\]|\bfor\s*\(|\.resize\(")
TEXTS = ["", " ", "x", "y", "angle", "nothing", "a,b", "../x", "/dev/null", "$(false)", "\xe4", "x" * 300, "x + ", "1/0*x"]
OPTIONS = {"rolling": "-element P1 -inner 4 -outer 20 -sides 4 -steps 10", "punch": "-n 4 -element P1", "cam": "-n 8 -element P1 -steps 5",
           "incline": "-nx 3 -steps 4", "damage": "-n 2 -element P1 -steps 10", "upsetting": "-n 3 -element P1 -steps 5",
           "crank-press": "-n 4 -element P1 -steps 5", "strip-rolling": "-ny 1 -element P1 -steps 5"}


def sources():
    """Name, lines and options of what is mutated."""
    readme = (TOP / "README.md").read_text().split("```freefem\n")[1].split("```")[0]
    yield "readme", readme.replace("square(60, 20,", "square(10, 4,").replace("dtmax=0.05", "dtmax=0.25"), []
    for name in ("test-tool", "test-contact", "test-step", "test-input"):
        yield name, (TOP / f"tests/errors/{name}.edp").read_text(), []
    for name, options in OPTIONS.items():
        yield name, (TOP / f"cases/{name}/{name}.edp").read_text(), f"{options} -pictures 0 -series 2 -check 0".split()


def mutated(text, chance):
    """One mistake: a number, a text, a word, a letter or a line."""
    lines = text.split("\n")
    for _ in range(chance.randint(1, 3)):
        k = chance.randrange(len(lines))
        if lines[k].startswith("Vh ["):     # FreeFEM itself crashes where the values are fewer than the components
            continue
        kind = chance.random()
        if kind < 0.45:
            found = [m for m in re.finditer(r"(?<![\w.])\d+(\.\d*)?(e[-+]?\d+)?", lines[k])]
            new = chance.choice([n for n in NUMBERS if n not in HUGE] if SIZES.search(lines[k]) else NUMBERS)
        elif kind < 0.55:
            found, new = list(re.finditer(r'(?<=")[^"]*(?=")', lines[k])), chance.choice(TEXTS)
        elif kind < 0.75:
            found, new = list(re.finditer(r"[A-Za-z]\w*", lines[k])), chance.choice(re.findall(r"[A-Za-z]\w*", text))
        elif kind < 0.85:
            found, new = list(re.finditer(r"[-+*/(),;.=<>\[\]]", lines[k])), chance.choice(["", "-", "*", "/", "+", ";", ","])
        else:
            other = chance.randrange(len(lines))
            if chance.random() < 0.5:
                lines[k], lines[other] = lines[other], lines[k]
            elif not lines[k].startswith("include"):
                lines[k] = lines[other] if chance.random() < 0.5 else ""
            continue
        # what would be FreeFEM's matter: an own shell command, another file
        if found and "exec" not in new and "load" not in new and "include" not in lines[k]:
            at = chance.choice(found)
            lines[k] = lines[k][:at.start()] + new + lines[k][at.end():]
    return "\n".join(lines)


def limits():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 28, 1 << 28))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(command, log):
    """Exit status as a shell has it; 124 for a run that did not end."""
    with open(log, "w") as out:
        process = subprocess.Popen(command, cwd=TOP, stdin=subprocess.DEVNULL, stdout=out, stderr=out, preexec_fn=limits,
                                   start_new_session=True)
        try:
            status = process.wait(LONGEST)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.wait()
            return 124
    return 128 - status if status < 0 else status


def main():
    seconds, seed = float(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else int(time.time())
    chance, all_sources = random.Random(seed), list(sources())
    folder = Path(tempfile.mkdtemp(prefix="burnish-fuzz-"))
    print(f"seed {seed}, findings in {folder}")
    end, number, findings, seen = time.time() + seconds, 0, 0, {}
    while time.time() < end:
        name, text, options = chance.choice(all_sources)
        script, log = folder / f"{name}-{number}.edp", folder / f"{name}-{number}.log"
        script.write_text(mutated(text, chance))
        command = [os.environ.get("BURNISH", str(TOP / "build/burnish")), str(script), *options]
        if options:
            command += ["-out", str(folder / "out")]
        status = run(command, log)
        number += 1
        seen[status] = seen.get(status, 0) + 1
        if status in RIGHT:
            script.unlink()
            log.unlink()
            continue
        findings += 1
        print(f"exit status {status}: {' '.join(command)}", flush=True)
        print("".join("    " + line for line in log.read_text(errors="replace").splitlines(True)[-3:]))
    print(f"{number} mutants, exit statuses {dict(sorted(seen.items()))}, {findings} findings")
    if findings == 0:
        shutil.rmtree(folder)
    return findings > 0


if __name__ == "__main__":
    sys.exit(main())
