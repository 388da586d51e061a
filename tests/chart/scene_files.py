"""Scenes and methods of the chart, one run, and the references."""
import bisect
import csv
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
PEERS = os.path.join(os.path.dirname(HERE), "peers")
LONGEST = 500  # [s] of a run
POINTS = 81  # of a stored curve
SIZES = ["quick", "full", "medium"]


def rows_of(name, width):
    with open(os.path.join(HERE, name)) as f:
        for line in f:
            if not line.startswith("#") and line.strip():
                parts = [part.strip() for part in line.split(";")]
                if len(parts) != width:
                    sys.exit(f"chart: {name}: {len(parts)} entries instead of {width}: {line.strip()}")
                yield parts


def methods():
    """Peers, other programs, are rivals with a program."""
    return [{"name": n, "whose": "rival" if w == "peer" else w, "kernel": k, "program": o.split()[0] if w == "peer" else "",
             "options": o.split()[w == "peer":], "meaning": meaning}
            for n, w, k, o, meaning in rows_of("methods.csv", 5)]


def installed(method):
    """Is the program of a peer there?"""
    if not method["program"]:
        return True
    if method["program"].endswith(".py"):
        return shutil.which("ccx") is not None
    folders = os.environ.get("FF_LOADPATH", "/usr/lib/freefem++").split(";")
    return any(os.path.exists(os.path.join(folder, "ff-Ipopt.so")) for folder in folders)


def own_runs(scene, method, *sizes):
    """(element, n, steps) of the lines of runs.csv for a method in a scene; sizes: of SIZES."""
    for name, where, element, *grids in rows_of("runs.csv", 6):
        if (name, where) == (method["name"], scene["name"]):
            for size in sizes:
                meshes, steps = grid(grids[SIZES.index(size)])
                yield from ((element, n, k) for n in meshes for k in steps)


def grid(text):
    """Meshes and steps of "4 8 / 10 20"; without steps the scene's own."""
    meshes, _, steps = text.partition("/")
    return [int(n) for n in meshes.split()], [int(n) for n in steps.split()] or [0]


def scenes():
    for name, chosen, elements, quick, full, reference, quantities in rows_of("scenes.csv", 7):
        yield {"name": name, "methods": [m.strip() for m in chosen.split(",")],
               "elements": elements.split(), "trusted": elements.split()[-1], "quick": grid(quick), "full": grid(full),
               "reference": [r.split() for r in reference.split("|")],
               "quantities": dict(word.split("=") for word in quantities.split())}


def command_of(scene, program):
    """Script of the scene, or a peer's: a script for Hertz only, or a program that is told the scene."""
    if not program:
        return [os.environ["BURNISH"], os.path.join(HERE, scene["name"] + ".edp")]
    path = os.path.join(PEERS, program)
    return [sys.executable, "-B", path, scene["name"]] if program.endswith(".py") else [os.environ["BURNISH"], path]


def run(scene, options, program="", longest=LONGEST):
    """Results of one run by name, its curves and fields, outcome and peak memory [MB]; longest: seconds before it is stopped."""
    command = ["timeout", str(longest), *command_of(scene, program), *options]
    with tempfile.TemporaryFile("w+", errors="replace") as out, tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(command, cwd=folder, stdout=out, stderr=subprocess.STDOUT)  # Ipopt leaves a file there
        _, status, usage = os.wait4(process.pid, 0)
        code = process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        text = out.read()
    found = {n: float(v) for n, v in re.findall(r"^result (\S+) (\S+)$", text, re.MULTILINE)}
    stopped = found.pop("outcome", 0) != 0
    if code not in (0, 4, 124) or (code != 124 and "seconds" not in found):
        sys.exit(f"chart: exit status {code} of {' '.join(command)}:\n{text[-3000:]}")
    fields = {name: [float(word) for word in words.split()] for name, words in re.findall(r"^field (\S+) (.*)$", text, re.MULTILINE)}
    curves = {}
    for name, numbers in re.findall(r"^curve (\S+)(.*)$", text, re.MULTILINE):
        values = [float(word) for word in numbers.split()]
        curves[name] = sorted(zip(values[::2], values[1::2]))
    outcome = "too long" if code == 124 else "stopped" if stopped else "not to be trusted" if code == 4 else "finished"
    found.setdefault("megabytes", usage.ru_maxrss / 1024)  # of a script that does not say it; not less than that of this program
    found.setdefault("seconds", usage.ru_utime + usage.ru_stime)
    return {**found, "curves": curves, "fields": fields, "outcome": outcome}


def at(curve, x):
    """Linear between the points, zero outside."""
    k = bisect.bisect_right(curve, (x, math.inf))
    if k == 0 or k == len(curve):
        return 0.0
    (x0, y0), (x1, y1) = curve[k - 1], curve[k]
    return y0 + (y1 - y0) * (x - x0) / max(x1 - x0, 1e-300)


def curve_error(curve, reference):
    """L2 norm of the difference at the points of the curve over that of the reference there."""
    if not curve or len(curve) < 3:
        return math.nan
    off = norm = 0.0
    for (left, _), (x, y), (right, _) in zip(curve, curve[1:], curve[2:]):
        expected, length = at(reference, x), (right - left) / 2
        off += length * (y - expected) ** 2
        norm += length * expected ** 2
    return math.sqrt(off / norm) if norm > 0 else math.nan


def field_error(values, reference):
    """L2 norm of the difference from the reference, [(area, value)] in the same points, over that of the reference."""
    if not values or len(values) != len(reference):
        return math.nan
    return math.sqrt(sum(a * (v - r)**2 for v, (a, r) in zip(values, reference)) / sum(a * r**2 for a, r in reference))


def thinned(curve):
    """Means over equal intervals: what a coarse run can be held against."""
    first, last = curve[0][0], curve[-1][0]
    length = (last - first) / (POINTS - 1)
    found = []
    for k in range(POINTS):
        x = first + k * length
        found.append((x, sum(at(curve, x + (j - 3.5) / 8 * length) for j in range(8)) / 8))
    return found


def read_references():
    with open(os.path.join(HERE, "references.csv")) as f:
        return {(row["scene"], row["quantity"]): (float(row["value"]), float(row["error"])) for row in csv.DictReader(f)}


def read_curves():
    curves = {}
    with open(os.path.join(HERE, "curves.csv")) as f:
        for row in csv.DictReader(f):
            curves.setdefault((row["scene"], row["quantity"]), []).append((float(row["x"]), float(row["value"])))
    return curves


def read_fields():
    """(scene, quantity): [(area, value)]"""
    fields = {}
    for scene, quantity, area, value in read_rows("fields.csv"):
        fields.setdefault((scene, quantity), []).append((float(area), float(value)))
    return fields


def read_rows(name):
    with open(os.path.join(HERE, name)) as f:
        return [list(row.values()) for row in csv.DictReader(f)]


def areas(scene, options=()):
    """Of the points where the scene's fields are compared."""
    with tempfile.TemporaryDirectory() as folder:
        out = subprocess.run([*command_of(scene, ""), "-mesh", os.path.join(folder, "scene.msh"), *options], stdout=subprocess.PIPE,
                             text=True).stdout
    return [float(word) for word in re.search(r"^field area (.*)$", out, re.MULTILINE)[1].split()]


def write_references(chosen):
    """A fine run of every scene chosen; its own error is the difference to a coarser one. Other scenes keep theirs."""
    names = {scene["name"] for scene in chosen}
    table = [row for row in read_rows("references.csv") if row[0] not in names]
    curves, fields = ([row for row in read_rows(name) if row[0] not in names] for name in ("curves.csv", "fields.csv"))
    for scene in chosen:
        coarse, fine = (run(scene, options, longest=10 * LONGEST) for options in scene["reference"])
        words = " ".join(scene["reference"][1])
        for quantity, kind in scene["quantities"].items():
            if kind == "0":
                continue
            if kind == "curve":
                reference = thinned(fine["curves"][quantity])
                error = curve_error(thinned(coarse["curves"][quantity]), reference)
                curves += [[scene["name"], quantity, f"{x:.6g}", f"{y:.6g}"] for x, y in reference]
                table.append([scene["name"], quantity, "1", f"{error:.1e}", words])
            if kind == "field":
                reference = list(zip(areas(scene), fine["fields"][quantity]))
                fields += [[scene["name"], quantity, f"{a:.5g}", f"{v:.5g}"] for a, v in reference]
                table.append([scene["name"], quantity, "1", f"{field_error(coarse['fields'][quantity], reference):.1e}", words])
            if kind in ("curve", "field"):
                continue
            for name in [quantity] if kind == "run" else [f"{quantity}_{k}" for k in kind.split(",")]:
                error = abs(coarse[name] / fine[name] - 1)
                table.append([scene["name"], name, f"{fine[name]:.8g}", f"{error:.1e}", words])
        for row in table:
            if row[0] == scene["name"]:
                print(f"  {row[0]}: {row[1]} {row[2]}, differs from the coarser run by {row[3]}")
    order = [scene["name"] for scene in scenes()]
    for name, head, rows in (("references.csv", ["scene", "quantity", "value", "error", "run"], table),
                             ("curves.csv", ["scene", "quantity", "x", "value"], curves),
                             ("fields.csv", ["scene", "quantity", "area", "value"], fields)):
        with open(os.path.join(HERE, name), "w", newline="") as f:
            csv.writer(f, lineterminator="\n").writerows([head, *sorted(rows, key=lambda row: order.index(row[0]))])
