"""A lab of cases/labs: it is solved by its key, its scripts are run, the answers of its solution compared, its plot drawn.

lab.py NAME: reads cases/labs/NAME/lab.json:
  "runs": [{"script": "solution.edp", "options": "-n 8", "status": 0, "text": ["words of the output"]}, ...]
    "numbers": {"words of the output before a number": [value, tolerance]} as for answers
    a run may have "folder": that of its results, its script's name unless given ("solution/mu=0.1" lies where the plot finds
    it), and "answers" of its own
  "answers": {"name": [value, tolerance], ...}   of solution.edp; relative tolerance, absolute where 0 is expected
A script with gaps ends with status 20 and "gap 1 is open"; solution.edp, solution-*.edp, mended/*.edp are what cases/labs/solve.py
makes of lab.edp, other scripts, broken*.edp and key.md, which has a value for every gap; gaps are numbered through the lab.
plot.py FOLDER FILE draws the answers' plot from the results of solution.edp; expected.png beside it is one.

lab.py NAME FILE... [--against CSV]: compares answers.csv files that were handed in, with lab.json, or with the values of another
answers.csv, that of a run of solution.edp with other options; prints a line for each, exit status 1 if one is off.
"""
import contextlib
import csv
import io
import json
import os
import re
import resource
import struct
import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "cases/labs"))
import solve
SECTIONS = ["Objectives", "Theory", "Predict first", "Steps", "Questions", "What the plot must show", "Limits"]
MINUTES = 20                 # CPU, of all runs of a lab
SOLVED = "solved"            # folder of the solution's scripts, in that of the results


def run(folder, job, out):
    """Errors of one run: wrong exit status, missing words."""
    script = folder / job["script"]
    if not script.is_file():
        script = out / SOLVED / job["script"]
    words = [os.environ["BURNISH"], os.path.relpath(script, TOP), *job.get("options", "").split()]
    name = job.get("folder", script.stem)
    if job.get("out", True):
        words += ["-out", str(out / name)]
    done = subprocess.run(words, cwd=TOP, stdin=subprocess.DEVNULL, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    (out / f"{name.replace('/', '-')}.txt").write_text(done.stdout)
    if done.returncode != job.get("status", 0):
        yield f"{job['script']}: exit status {done.returncode} instead of {job.get('status', 0)}:\n{done.stdout[-1500:]}"
    for text in job.get("text", []):
        if text not in done.stdout:
            yield f"{job['script']}: the output lacks \"{text}\":\n{done.stdout[-1500:]}"
    for text, (value, tolerance) in job.get("numbers", {}).items():
        found = re.search(re.escape(text) + r"[ =]+([-+.\de]+)", done.stdout)
        if not found or not abs(float(found[1]) - value) <= tolerance * (abs(value) or 1):
            yield f"{job['script']}: \"{text}\" {found[1] if found else 'is missing'}, expected {value:.6g} within {tolerance:.1e}"
    file = out / name / "answers.csv"
    if "answers" in job:
        yield from answers_off(job["answers"], file) if file.is_file() else [f"{file} is not there"]


def answers_off(expected, file):
    """Answers that are missing, unexpected or outside their tolerance."""
    given = {row["name"]: float(row["value"]) for row in csv.DictReader(open(file))}
    for name in sorted(set(expected) ^ set(given)):
        yield f"answer \"{name}\" is {'missing' if name in expected else 'not in lab.json'}"
    for name in sorted(set(expected) & set(given)):
        value, tolerance = expected[name]
        error = abs(given[name] - value) / (abs(value) or 1)
        print(f"  {name}: {given[name]:.6g}, expected {value:.6g}, error {error:.1e}, allowed {tolerance:.1e}")
        if not error <= tolerance:
            yield f"answer \"{name}\" is {given[name]:.6g}, expected {value:.6g} within {tolerance:.1e}"


def gaps_off(folder):
    """Gaps that are numbered with holes; a solution that stands in the folder beside its key."""
    known = set()
    for script in sorted(folder.glob("**/*.edp")):
        known |= {int(n) for n in solve.NUMBER.findall(script.read_text())}
        if script.name.startswith("solution") or script.parent != folder:
            yield f"{script.relative_to(folder)}: solutions are made by solve.py"
    if known and known != set(range(1, len(known) + 1)):
        yield f"gaps {sorted(known)}, expected 1 to their number"


def size(png):
    """Width and height of a PNG file, pixels."""
    return struct.unpack(">II", png.read_bytes()[16:24])


def plot_off(folder, out):
    """The plot of the solution: drawn, of the size of the expected one."""
    picture = out / "plot.png"
    done = subprocess.run([os.environ["PYTHON"], str(folder / "plot.py"), str(out / "solution"), str(picture)], cwd=TOP, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode or not picture.is_file():
        yield f"plot.py: exit status {done.returncode}:\n{done.stdout[-1500:]}"
    elif size(picture) != size(folder / "expected.png"):
        yield f"plot.py: {size(picture)} pixels, expected.png has {size(folder / 'expected.png')}"


def text_off(folder):
    """Sections that the lab's text lacks."""
    heads = re.findall(r"^## (.*)$", (folder / "README.md").read_text(), re.MULTILINE)
    return [f"README.md lacks the section \"{name}\"" for name in SECTIONS if name not in heads]


def mark(name, files, against):
    """Answers handed in: how many of each file are right, and those that are not."""
    expected = json.loads((TOP / "cases/labs" / name / "lab.json").read_text())["answers"]
    if against:
        given = {row["name"]: float(row["value"]) for row in csv.DictReader(open(against))}
        expected = {key: [given[key], tolerance] for key, (_, tolerance) in expected.items()}
    off = 0
    for file in files:
        with contextlib.redirect_stdout(io.StringIO()):
            wrong = list(answers_off(expected, file))
        print(f"{file}: {len(expected) - len(wrong)} of {len(expected)} answers", *wrong, sep="\n  ")
        off += len(wrong)
    return 1 if off else 0


def main(name):
    folder, out = TOP / "cases/labs" / name, Path(os.environ["SCRATCH"])
    lab = json.loads((folder / "lab.json").read_text())
    wrong = text_off(folder) + list(gaps_off(folder))
    try:
        solve.write(folder, out / SOLVED)
    except solve.KeyFault as fault:
        print("FAILED:", fault)
        return 1
    for job in lab["runs"]:
        wrong += run(folder, job, out)
    if (out / "solution/answers.csv").is_file():
        wrong += answers_off(lab["answers"], out / "solution/answers.csv")
    else:
        wrong.append("solution.edp has written no answers.csv")
    wrong += plot_off(folder, out)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = used.ru_utime + used.ru_stime
    if seconds > 60 * MINUTES:
        wrong.append(f"{seconds / 60:.1f} CPU minutes, at most {MINUTES} are a lab's")
    print(f"{name}: {seconds:.0f} CPU s, {len(lab['answers'])} answers")
    for line in wrong:
        print("FAILED:", line)
    return 1 if wrong else 0


if __name__ == "__main__":
    words = sys.argv[2:]
    other = words.pop(words.index("--against") + 1) if "--against" in words else None
    sys.exit(mark(sys.argv[1], [w for w in words if w != "--against"], other) if words else main(sys.argv[1]))
