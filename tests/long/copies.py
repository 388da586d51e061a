"""Cases and their copies, which must take the same steps and reject the same ones:  copies.py FOLDER [CASE ...]

No step is to be decided by rounding. A copy is the case's script with two or three lines changed: "renumbered", the halves of its
mesh put together in the other order, so that every sum is taken in another one; "turned" by 30 degrees with its tools, where its
supports hold both components (an inclined symmetry line cannot be held) and no load has a direction. Options: those of the first
run of tests/regression/CASE.json. Compared: steps, rejected steps (but for DECIDED), the largest equivalent stress at the end to 1e-6. Prints a table;
status 1 if a copy went another way."""
import glob
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
SAME = 1e-6
# Rejected steps that rounding decides, at most, where nothing better is known: in an iterate the holder's only node leaves, or the sheet folds
DECIDED = {"u-channel": 2}
OPTIONS = {"rolling": "-inner 6 -outer 60 -sides 10"}  # of cases whose regression test is another
TURN = math.radians(30)
LEFT_OUT = ("shear",)  # no contact, no steps
# polar coordinates stay: they are turned by the angle at which the program begins
ANGLES = {"rolling": (("(start - turn*t)", "(start + 30 - turn*t)"), ('place("phi", start', 'place("phi", (start + 30)'))}
HALVES = ("{ real[int] box(4); boundingbox(Th, box); real at = (box[0] + box[1])/2;"
          " Th = trunc(Th, x > at, label=98) + trunc(Th, x <= at, label=98); }")
TURNED = f"Th = movemesh(Th, [{math.cos(TURN)!r}*x - {math.sin(TURN)!r}*y, {math.sin(TURN)!r}*x + {math.cos(TURN)!r}*y]);"


def after_mesh(text, line):
    """The script with a line behind the statement that makes its mesh."""
    found = re.search(r"^mesh Th = ", text, re.M)
    if not found:
        return None
    statement = re.compile(r";[ \t]*(//[^\n]*)?\n").search(text, found.start())
    return text[:statement.end()] + line + "\n" + text[statement.end():]


def turned_coordinates(match):
    """The same coordinates of a tool in a plane that is turned: names and forces stay."""
    words = match[1]
    if words == '"cartesian"':
        words = '"x,y,angle", x="x", y="y", angle="angle"'
    kind = re.match(r'("[^"]*"), x="([^"]*)", y="([^"]*)", angle="([^"]*)"$', words)
    if not kind:
        return match[0]
    c, s = repr(math.cos(TURN)), repr(math.sin(TURN))
    return (f'.coordinates({kind[1]}, x="{c}*({kind[2]}) - {s}*({kind[3]})", y="{s}*({kind[2]}) + {c}*({kind[3]})", '
            f'angle="{TURN!r} + ({kind[4]})")')


def cannot_turn(text):
    """Why not; "" if it can be turned."""
    held = re.findall(r"\bon\([^)]*\)", text)
    if not held or any(len(re.findall(r"\b\w+=", h)) < 2 for h in held):
        return "a symmetry line is held" if held else "its scene is in another file"
    if "C.external" in text or "supportdisplacement" in text or "axisymmetric=true" in text:
        return "a load or a support has a direction"
    return ""


def counts(script, options, folder):
    """(steps, rejected, largest stress) of a run; None if it has left no summary."""
    os.makedirs(folder, exist_ok=True)
    command = [os.environ["BURNISH"], script, "-pictures", "0", "-series", "0", "-check", "0", *shlex.split(options),
               "-out", folder]
    with open(os.path.join(folder, "log.txt"), "w", encoding="utf-8") as log:
        subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, check=False, stdin=subprocess.DEVNULL)
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        return summary["counts"]["steps"], summary["counts"]["rejected_steps"], summary["final"]["stress_eq_max"]
    except (OSError, KeyError, ValueError):
        return None


def copy(case, kind, folder):
    """Path of the script of a copy, beside what the case has in files; or None and why there is none."""
    source = os.path.join(TOP, "cases", case)
    with open(os.path.join(source, case + ".edp"), encoding="utf-8") as file:
        text = file.read()
    if kind == "turned":
        why = cannot_turn(text)
        if why:
            return None, why
        for old, new in ANGLES.get(case, ()):
            text = text.replace(old, new)
        text = re.sub(r"\.coordinates\(([^\n]*?)\);", lambda m: turned_coordinates(m) + ";", text)
    text = after_mesh(text, HALVES if kind == "renumbered" else TURNED)
    if text is None:
        return None, "its mesh is made elsewhere"
    text = text.replace('include "../', f'include "{TOP}/cases/')
    os.makedirs(folder, exist_ok=True)
    for path in glob.glob(os.path.join(source, "*")):
        if os.path.isfile(path) and not path.endswith((".png", ".md", ".edp")):
            shutil.copy(path, folder)
    script = os.path.join(folder, case + ".edp")
    with open(script, "w", encoding="utf-8") as file:
        file.write(text)
    return script, ""


def row_of(case, options, folder):
    """Cells of the table, and whether every copy went the same way."""
    first = counts(os.path.join(TOP, "cases", case, case + ".edp"), options, os.path.join(folder, case, "case"))
    cells, good = [case, f"{first[0]} ({first[1]})" if first else "no result"], first is not None
    for kind in ("renumbered", "turned"):
        script, why = copy(case, kind, os.path.join(folder, case, kind))
        found = counts(script, options, os.path.join(folder, case, kind, "out")) if script else None
        if script and not found:
            why, good = "no result", False
        elif found:
            off = abs(found[2] / first[2] - 1) if first and first[2] else 0
            same = first and found[:2] == first[:2] and off < SAME
            bearable = first and abs(found[1] - first[1]) <= DECIDED.get(case, 0) and off < SAME
            why, good = f"{found[0]} ({found[1]})" + ("" if same else f", stress off by {off:.1g}"), good and (same or bearable)
        cells.append(why)
    return cells, good


def main(folder, *wanted):
    wrong = 0
    print("| Case | steps (rejected) | renumbered | turned by 30 degrees |\n|---|---|---|---|")
    for script in sorted(glob.glob(os.path.join(TOP, "cases/*/*.edp"))):
        case = os.path.basename(script)[:-len(".edp")]
        if case in LEFT_OUT or wanted and case not in wanted:
            continue
        options = OPTIONS.get(case)
        if options is None:
            with open(os.path.join(TOP, "tests/regression", case + ".json"), encoding="utf-8") as file:
                options = next(iter(json.load(file)["runs"].values())).get("options", "")
        cells, good = row_of(case, options, folder)
        wrong += not good
        print("| " + " | ".join(cells) + " |", flush=True)
    return wrong


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) > 0)
