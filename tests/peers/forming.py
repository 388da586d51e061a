"""The V-bend and the cup of tests/support/forming by CalculiX, on the meshes that they save, beside ours: forming.csv, table
"forming" of README.md. bench.py runs it; one deck alone:

forming.py SCENE [--ways "SURFACE TO SURFACE 1 4"] [--keep FOLDER]
Plane strain or axisymmetric quadratic triangles; tools: bands of quadrilaterals whose nodes are all led, arcs by chords of 3
degrees; linear penalty in units of E over the length of an edge, a tenth of it for friction. Strokes, friction, material, holder,
longest steps as in the scene's script. Seconds: CPU of the process, ours that of the FreeFEM process; force: the punch's, mean over the
last tenth.
"""
import argparse
import csv
import math
import os
import re
import resource
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from mesh import Mesh

FORMING = os.path.join(os.path.dirname(HERE), "support/forming")
BAND, CHORD, LIMIT = 0.3, math.radians(3), 100  # mm, -, CPU seconds of a run
E, NU, YIELD, FRICTION = 2.1e5, 0.3, 250, 0.1
# kind of contact, slope of its penalty, steps over ours
WAYS = ("SURFACE TO SURFACE 1 1", "SURFACE TO SURFACE 1 4", "SURFACE TO SURFACE 5 1", "NODE TO SURFACE 5 1")
OPTIONS = {"vbend": "-steps 50", "cup": "-steps 100"}
STORED = os.path.join(HERE, "forming.csv")
COLUMNS = ["scene", "options", "program", "contact", "outcome", "t", "steps", "rejected", "force", "seconds"]


def fillet(before, corner, after, radius):
    """Points of the arc that rounds a corner."""
    a, b = (math.atan2(p[1] - corner[1], p[0] - corner[0]) for p in (before, after))
    between = (b - a + math.pi) % (2 * math.pi) - math.pi
    middle, far = a + between / 2, radius / math.sin(abs(between) / 2)
    center = corner[0] + far * math.cos(middle), corner[1] + far * math.sin(middle)
    turn = math.pi - abs(between)
    first = a - math.copysign(math.pi / 2, between)
    number = max(2, math.ceil(turn / CHORD))
    return [(center[0] + radius * math.cos(w), center[1] + radius * math.sin(w))
            for w in (first - math.copysign(turn, between) * k / number for k in range(number + 1))]


def chain(*corners):
    """Points of a line of corners (x, y, radius), the sheet on its left."""
    points = []
    for k, (x, y, radius) in enumerate(corners):
        points += fillet(corners[k - 1], (x, y), corners[k + 1], radius) if radius else [(x, y)]
    return points


CUTBACKS = ["*CONTROLS, PARAMETERS=TIME INCREMENTATION", "4, 8, 9, 40, 20, 4, , 25"]  # 25 in a row for 5, 40 iterations for 16
SECTOR = {"CPE6": 1, "CAX6": 180}  # what CalculiX prints of a ring is the reaction of 2 degrees; loads are of the whole

SCENES = {  # kind of element, hardening, tools (name, label of the sheet, points), way of the punch, force of the holder
    "vbend": ("CPE6", 1000, (("DIE", 1, chain((12, -20, 0), (12, 0, 2), (40, 0, 0))),
                             ("PUNCH", 3, [(x, y + 1 - 0.6) for x, y in chain((20, 20 * math.sqrt(3), 0), (0, 0, 0.6), (-20, 20 * math.sqrt(3), 0))])), 10, 0),
    "cup": ("CAX6", 800, (("DIE", 1, chain((21.4, -30, 0), (21.4, 0, 5), (60, 0, 0))),
                          ("PUNCH", 3, [(x, y + 1) for x, y in chain((20, 30, 0), (20, 0, 5), (0, 0, 0))]),
                          ("HOLDER", 3, [(x, y + 1) for x, y in chain((60, 0, 0), (22.4, 0, 2), (22.4, 30, 0))])), 15, 8000),
}


class Deck:
    def __init__(self, path, mesh, scene, way, steps):
        self.mesh, self.kind, self.lines, self.nodes = mesh, SCENES[scene][0], [], len(mesh.xy)
        self.elements = len(mesh.elements)
        self.sheet()
        tools = SCENES[scene][2]
        for name, label, points in tools:
            self.tool(name, points)
        kind, slope, finer = way.rsplit(" ", 2)
        self.materials(SCENES[scene][1], tools)
        self.contact(kind, float(slope) * E / mesh.spacing(3), tools)
        self.program(*SCENES[scene][3:], 1 / (steps * int(finer)))
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(self.lines) + "\n")

    def sheet(self):
        self.lines += ["*NODE", *(f"{k + 1}, {x:.10e}, {y:.10e}, 0" for k, (x, y) in enumerate(self.mesh.xy))]
        self.lines += [f"*ELEMENT, TYPE={self.kind}, ELSET=SHEET",
                       *(f"{k + 1}, " + ", ".join(str(n + 1) for n in e) for k, e in enumerate(self.mesh.elements))]
        for label in (1, 3):
            self.lines += [f"*SURFACE, NAME=FACE{label}, TYPE=ELEMENT", *(f"{e + 1}, S{k + 1}" for e, k in self.mesh.edges[label])]
        self.lines += ["*NSET, NSET=MIDDLE", *(f"{n + 1}" for n in self.mesh.nodes(4))]

    def tool(self, name, points):
        """A band behind the points; its set, its faces, its first node as the reference of all."""
        base, number = self.nodes, len(points)
        self.lines.append("*NODE")
        normals = []
        for k in range(number):
            (x0, y0), (x1, y1) = points[max(k - 1, 0)], points[min(k + 1, number - 1)]
            length = math.hypot(x1 - x0, y1 - y0)
            normals.append(((y1 - y0) / length, (x0 - x1) / length))     # to the right: into the tool
        for depth in (0, BAND):
            for k, ((x, y), (a, b)) in enumerate(zip(points, normals)):
                self.nodes += 1
                self.lines.append(f"{self.nodes}, {x + depth * a:.10e}, {y + depth * b:.10e}, 0")
        self.lines.append(f"*ELEMENT, TYPE={self.kind[:3]}4, ELSET={name}")
        first = self.elements
        for k in range(number - 1):
            self.elements += 1
            a = base + k + 1
            self.lines.append(f"{self.elements}, {a + 1}, {a}, {a + number}, {a + number + 1}")
        self.lines += [f"*SURFACE, NAME=OF{name}, TYPE=ELEMENT", *(f"{first + k + 1}, S1" for k in range(number - 1))]
        self.lines += [f"*NSET, NSET=N{name}", *(str(n) for n in range(base + 1, self.nodes + 1))]
        if name == "HOLDER":
            self.holder = base + 1
            self.lines.append("*EQUATION")
            for n in range(base + 2, self.nodes + 1):
                self.lines += ["2", f"{n}, 2, 1., {base + 1}, 2, -1."]

    def materials(self, hardening, tools):
        self.lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{E}, {NU}", "*PLASTIC", f"{YIELD}, 0", f"{YIELD + 5 * hardening}, 5",
                       "*SOLID SECTION, ELSET=SHEET, MATERIAL=STEEL", "1.", "*MATERIAL, NAME=TOOL", "*ELASTIC", f"{E}, {NU}"]
        for name, _, _ in tools:
            self.lines += [f"*SOLID SECTION, ELSET={name}, MATERIAL=TOOL", "1."]

    def contact(self, kind, slope, tools):
        self.lines += ["*SURFACE INTERACTION, NAME=CONTACT", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{slope:g}",
                       "*FRICTION", f"{FRICTION}, {slope / 10:g}"]
        for name, label, _ in tools:
            self.lines += [f"*CONTACT PAIR, INTERACTION=CONTACT, TYPE={kind}", f"FACE{label}, OF{name}"]
        self.lines += ["*BOUNDARY", "MIDDLE, 1, 1", *(f"N{name}, 1, 1" for name, _, _ in tools), "NDIE, 2, 2"]

    def program(self, depth, press, longest):
        wanted = ["*NODE PRINT, NSET=NPUNCH, TOTALS=ONLY", "RF"]
        if press:
            self.lines += ["*STEP, NLGEOM, INC=20000", "*STATIC", f"{longest / 2}, 0.05, 1e-8, {longest}", *CUTBACKS, "*BOUNDARY",
                           "NPUNCH, 2, 2, 0.", "*CLOAD", f"{self.holder}, 2, {-press}", *wanted, "*END STEP"]
        length = 0.95 if press else 1
        self.lines += ["*STEP, NLGEOM, INC=20000", "*STATIC", f"{longest / 2}, {length}, 1e-8, {longest}", *CUTBACKS, "*BOUNDARY",
                       f"NPUNCH, 2, 2, {-depth}", *wanted, "*END STEP"]


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))


def cpu(command, folder, log):
    """CPU seconds of a process, and whether it ended well within the limit."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1")
    with open(log, "w", encoding="utf-8") as file:
        code = subprocess.run(command, cwd=folder, stdout=file, stderr=subprocess.STDOUT, env=environment, preexec_fn=limited, check=False).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, code


def last_tenth(way):
    """Mean of the force over the last tenth of the time, [(t, force)]."""
    total, last = 0, 0
    for t, force in way:
        total, last = total + force * max(0, t - max(last, 0.9)) / 0.1, t
    return total if last > 1 - 1e-6 else math.nan


def calculix(scene, options, way, folder):
    mesh = Mesh(os.path.join(folder, "mesh.msh"), True)
    Deck(os.path.join(folder, "scene.inp"), mesh, scene, way, int(re.search(r"-steps (\d+)", options)[1]))
    seconds, code = cpu(["ccx", "scene"], folder, os.path.join(folder, "log.txt"))
    with open(os.path.join(folder, "scene.dat"), encoding="utf-8", errors="replace") as file:
        found = re.findall(r"time\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)", file.read())
    forces = [(float(t), -SECTOR[SCENES[scene][0]] * float(fy)) for t, _, fy, _ in found]
    with open(os.path.join(folder, "scene.sta"), encoding="utf-8", errors="replace") as file:
        tries = [words for words in map(str.split, file) if words and words[0].isdigit()]
    rejected = sum(t[2].endswith("U") for t in tries)
    t = forces[-1][0] if forces else 0
    outcome = "finished" if t > 1 - 1e-6 else "out of time" if seconds > 0.98 * LIMIT else "stopped"
    return {"scene": scene, "options": options, "program": "CalculiX", "contact": way, "outcome": outcome, "t": t,
            "steps": len(tries) - rejected, "rejected": rejected, "force": last_tenth(forces), "seconds": seconds}


def ours(scene, options, folder):
    log = os.path.join(folder, "ours.txt")
    words = [os.environ["BURNISH"], os.path.join(FORMING, scene + ".edp"), *options.split(), "-mesh", os.path.join(folder, "mesh.msh")]
    seconds, _ = cpu(words, folder, log)
    with open(log, encoding="utf-8", errors="replace") as file:
        text = file.read()
    found = re.search(r"^forming (.*)$", text, re.M)
    if not found:
        sys.exit(f"forming.py: {' '.join(words)}:\n{text[-2000:]}")
    words = found[1].split()
    told = {words[k]: float(words[k + 1]) for k in range(0, len(words) - 2, 2)}
    return {"scene": scene, "options": options, "program": "Burnish", "contact": "", "t": told["t"],
            "outcome": "finished" if told["status"] == 0 else "stopped", "steps": int(told["steps"]), "rejected": int(told["rejected"]),
            "force": told["late"], "seconds": seconds}


def measure(scene, ways, folder):
    """Rows of a scene: ours, then CalculiX by every way."""
    options = OPTIONS[scene]
    os.makedirs(folder, exist_ok=True)
    yield ours(scene, options, folder)
    for way in ways:
        yield calculix(scene, options, way, folder)


def told(row):
    return ", ".join(f"{name} {row[name]:.4g}" if isinstance(row[name], float) else f"{name} {row[name]}" for name in COLUMNS)


def rows_of(scenes):
    """All ways of the scenes; those stored of the other scenes."""
    rows = []
    for scene in SCENES:
        if scene not in scenes and os.path.exists(STORED):
            with open(STORED, encoding="utf-8") as file:
                rows += [row for row in csv.DictReader(file) if row["scene"] == scene]
        if scene in scenes:
            with tempfile.TemporaryDirectory() as folder:
                for row in measure(scene, WAYS, folder):
                    print("  " + told(row), flush=True)
                    rows.append({k: f"{v:.4g}" if isinstance(v, float) else str(v) for k, v in row.items()})
    return rows


def write(rows, path):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def table(rows):
    """Lines of README.md."""
    lines = ["| Scene | Program, contact | Penalty, E/h | Steps over ours | Outcome | Steps (rejected) | Force, last tenth, N | CPU s | times |", "|" + "---|" * 9]
    for row in rows:
        if row["program"] == "Burnish":
            own = float(row["seconds"])
        ended = row["outcome"] == "finished"
        kind, slope, finer = row["contact"].rsplit(" ", 2) if row["contact"] else ("", "", "")
        outcome = row["outcome"] + ("" if ended else f" at t = {float(row['t']):.3f}")
        lines.append(f"| {row['scene']} `{row['options']}` | {row['program']} {kind.lower()} | {slope} | {finer} | {outcome} | {row['steps']} ({row['rejected']}) | "
                     f"{row['force'] if ended else ''} | {row['seconds']} | {float(row['seconds']) / own:.0f} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", choices=list(SCENES))
    parser.add_argument("--ways", default=",".join(WAYS))
    parser.add_argument("--keep", default="out/bench-peers/forming")
    options = parser.parse_args()
    for row in measure(options.scene, options.ways.split(","), options.keep):
        print(told(row), flush=True)


if __name__ == "__main__":
    main()
