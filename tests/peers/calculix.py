"""A scene of the chart by CalculiX: same options, same lines `result NAME VALUE`, `curve NAME x value ...`, `field NAME value ...`.

calculix.py SCENE [-element P1|P2] [-n N] [-steps N] [-slope S] [-roll R] [-nodes] [-dense N] [-keep FOLDER]
The scene's script saves the mesh and prints its numbers; -slope: of the penalty, in units of E over the distance of surface nodes;
-roll: of rolling, elements in an increment; -nodes: of the ball, ball.py; -keep: folder for the deck and what CalculiX writes. seconds, megabytes: of the process
ccx, which reads the deck and writes results, too.
"""
import argparse
import math
import os
import re
import subprocess
import sys
import tempfile
import time

import numpy as np

import answers
import ball
import scenes
from deck import Deck
from mesh import Mesh

CHART = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "chart")
THICKNESS = 10  # of the layer over the distance of surface nodes


def result(name, value):
    print(f"result {name} {value:.10g}")


def line(kind, name, values):
    print(kind, name, *(f"{v:.8g}" for v in values))


def scene_numbers(options, path):
    """Mesh into the file; numbers of the scene, points where fields are compared."""
    command = [os.environ["BURNISH"], os.path.join(CHART, options.scene + ".edp"), "-n", str(options.n), "-mesh", path]
    if options.dense > 1:
        command += ["-dense", str(options.dense)]
    out = subprocess.run(command, stdout=subprocess.PIPE, text=True).stdout
    fields = {name: np.array(values.split(), float) for name, values in re.findall(r"^field (\S+) (.*)$", out, re.MULTILINE)}
    numbers = {name: float(value) for name, value in re.findall(r"^result (\S+) (\S+)$", out, re.MULTILINE)}
    if not numbers:
        sys.exit(f"calculix.py: {' '.join(command)}:\n{out[-2000:]}")
    return numbers, fields.get("x"), fields.get("y")


def memory(process):
    """Peak so far [MB]."""
    try:
        with open(f"/proc/{process}/status") as f:
            found = re.search(r"VmHWM:\s*(\d+)", f.read())
        return int(found[1]) / 1024 if found else 0
    except OSError:
        return 0


def solve(folder):
    """Runs CalculiX on scene.inp; prints what it took; whether it finished."""
    # threads: of BLAS, of CalculiX
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1")
    with open(os.path.join(folder, "log.txt"), "w+", errors="replace") as log:
        process = subprocess.Popen(["ccx", "scene"], cwd=folder, stdout=log, stderr=subprocess.STDOUT, env=environment)
        done, most = 0, 0
        while not done:  # the peak that the system tells of a child in the end is not below that of its parent
            time.sleep(0.02)
            most = max(most, memory(process.pid))
            done, status, usage = os.wait4(process.pid, os.WNOHANG)
        process.returncode = os.waitstatus_to_exitcode(status)
        log.seek(0)
        text = log.read()
    result("seconds", usage.ru_utime + usage.ru_stime)
    result("megabytes", most)
    with open(os.path.join(folder, "scene.sta")) as f:
        tries = [words for words in map(str.split, f) if words and words[0].isdigit()]
    rejected = [t for t in tries if t[2].endswith("U")]
    result("steps", len(tries) - len(rejected))
    result("rejected", len(rejected))
    for name in ("solves", "factorizations"):
        result(name, sum(int(t[3]) for t in tries))
    finished = process.returncode == 0 and "Job finished" in text
    result("outcome", 0 if finished else 3)
    if not finished:
        print("calculix.py: " + "; ".join(dict.fromkeys(s.strip() for s in text.splitlines() if "*ERROR" in s)), file=sys.stderr)
    return finished


class Surface:
    """Nodes of the surface: places x, y, tributary lengths, normal and tangential forces by a round tool at a center."""

    def __init__(self, state, center):
        length = answers.lengths(state.mesh, 3)
        nodes = np.array(sorted(length, key=lambda n: state.mesh.xy[n, 0]))
        self.reference, self.xy = state.mesh.xy[nodes], state.xy[nodes]
        self.length = np.array([length[n] for n in nodes])
        F, n = state.forces()[nodes], self.xy - center
        n /= np.hypot(*n.T)[:, None]
        self.N, self.T = (F * n).sum(axis=1), F[:, 1] * n[:, 0] - F[:, 0] * n[:, 1]
        self.touches = self.N > answers.LEAST * self.N.max()
        self.N, self.T = np.where(self.touches, self.N, 0), np.where(self.touches, self.T, 0)
        self.p = answers.pressures(self.N, self.length, len(state.mesh.elements[0]) > 3)


def hertz(states, s, x, y):
    state, a = states[1.0], s["half"]
    surface = Surface(state, (0, s["radius"] + state.place[1]))
    result("depth", -state.place[1])
    N, X = surface.N, surface.reference[:, 0]
    result("a", 2 * math.sqrt((N * X**2).sum() / N.sum()) / a - 1)
    parts = 16  # of the way between two nodes, as in cases/hertz/hertz.idp
    at, l = (X[:-1, None] + (np.arange(parts) + 0.5) / parts * np.diff(X)[:, None]).ravel(), np.repeat(np.diff(X), parts)
    exact = 2 * s["force"] / (math.pi * a) * np.sqrt(np.maximum(0, 1 - (at / a)**2))
    for name, here in (("pressure", 1), ("pressure_inner", abs(at) < 0.8 * a)):
        result(name, math.sqrt((here * l * (np.interp(at, X, surface.p) - exact)**2).sum() / (l * exact**2).sum()))
    result("end", max((abs(X) + surface.length / 2)[surface.touches]) / a - 1)
    line("field", "stress", state.at(state.mean(state.mises), x, y))


def percentiles(state, quarter):
    result(f"p99_{quarter}", state.percentile(state.strain, 1e-4))
    result(f"nodal_{quarter}", state.nodal(state.strain).max())
    result(f"stress99_{quarter}", state.percentile(state.mises, 0.1 * state.mises.max()))


def last_fields(states, x, y):
    end = states[max(states)]
    for name, values in (("strain", end.strain), ("stress", end.mises)):
        line("field", name, end.at(end.nodal(values), x, y))


def indentation(states, s, x, y):
    for quarter, t in ((1, 0.5), (2, 1.0), (3, 1.5)):
        if t not in states:
            return
        result(f"depth_{quarter}", -states[t].place[1])
        if quarter < 3:
            percentiles(states[t], quarter)
        if t == 1:
            surface = Surface(states[t], (0, s["radius"] + states[t].place[1]))
            X, N = surface.reference[:, 0], surface.N
            result("width", math.sqrt((N * X**2).sum() / N.sum()))
            result("end", max((X + surface.length / 2)[surface.touches]))
            line("curve", "pressure", np.column_stack([X, surface.p])[X <= s["zone"]].ravel())
    last_fields(states, x, y)


def rolling(states, s, x, y):
    turn, R, Ro = math.radians(s["turn"]), s["radius"], s["outer"]
    top = next(iter(states.values())).mesh
    top = top.xy[top.nodes(3)]
    touch = max(y + math.sqrt(R**2 - x**2) for x, y in top if abs(x) < R)
    for quarter, t in ((1, 0.25), (2, 0.5), (3, 0.75), (4, 1.0)):
        if t not in states:
            return
        state = states[t]
        r = Ro + R + state.place[1]
        result(f"depth_{quarter}", touch - r)
        result(f"rotation_{quarter}", state.turn[2] - turn * t)
        result(f"torque_{quarter}", -r * state.force[0] / s["thickness"])
        percentiles(state, quarter)
    surface = Surface(state, (0, r))
    N, X = surface.N, Ro * (np.arctan2(surface.xy[:, 1], surface.xy[:, 0]) - math.pi / 2)
    order = np.argsort(X)
    width = math.sqrt((N * (X - (N * X).sum() / N.sum())**2).sum() / N.sum())
    result("sticking", N[abs(surface.T) < 0.99 * s["friction"] * N].sum() / N.sum())
    result("width", width)
    result("end_1", min((X - surface.length / 2)[surface.touches]))
    result("end_2", max((X + surface.length / 2)[surface.touches]))
    curve = np.column_stack([X, surface.p])[order]
    line("curve", "pressure", curve[abs(curve[:, 0]) <= 4 * width].ravel())
    last_fields(states, *scenes.turned(x, y, s))


def run(options, folder):
    s, x, y = scene_numbers(options, os.path.join(folder, "scene.msh"))
    if options.scene == "ball":
        return run_ball(options, folder, s)
    mesh = Mesh(os.path.join(folder, "scene.msh"), options.element == "P2")
    if options.scene == "rolling":
        mesh.xy = np.column_stack(scenes.turned(*mesh.xy.T, s))
    s["roll"], s["thickness"] = options.roll, THICKNESS * mesh.spacing(3)
    deck = Deck(os.path.join(folder, "scene.inp"), mesh, s["thickness"])
    scenes.WRITE[options.scene](deck, s, options.steps, options.slope)
    deck.close()
    result("dofs", 2 * len(mesh.xy))
    solve(folder)
    blocks = answers.read(os.path.join(folder, "scene.dat")) if os.path.exists(os.path.join(folder, "scene.dat")) else {}
    # the press takes the time from 0 to 1
    states = {round(t - 1, 4): answers.State(mesh, block, options.scene != "hertz") for t, block in blocks.items()}
    if states:
        {"hertz": hertz, "indentation": indentation, "rolling": rolling}[options.scene](states, s, x, y)


def run_ball(options, folder, s):
    mesh = ball.prepare(options, folder, s)
    result("dofs", 3 * len(mesh.xyz))
    if solve(folder):
        for name, value in ball.measures(folder, mesh, s, options.nodes).items():
            result(name, value)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene", choices=sorted([*scenes.WRITE, "ball"]))
    parser.add_argument("-element", choices=["P1", "P2"], default="P1")
    parser.add_argument("-n", type=int, default=8)
    parser.add_argument("-steps", type=int, default=10)
    parser.add_argument("-slope", type=float, default=0)
    parser.add_argument("-roll", type=float, default=0.25, help="rolling: elements of roll in an increment, at most")
    parser.add_argument("-nodes", action="store_true", help="ball: nodes against faces instead of faces against faces")
    parser.add_argument("-dense", type=int, default=1, help="points where fields are compared: so many times more each way")
    parser.add_argument("-keep", default="")
    options = parser.parse_args()
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
        return run(options, options.keep)
    with tempfile.TemporaryDirectory() as folder:
        run(options, folder)


if __name__ == "__main__":
    main()
