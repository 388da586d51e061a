"""What the article claims of its matrix, measured: conditions, rows, zeros, inertia, nonsymmetry, memory of the matrices of all methods at the same
states; what its nonsymmetric part of geometry is and does; its surface integrals beside nodal forces.

matrices.py [--quick] [--again] [--store] [--out FOLDER]      BURNISH=build/burnish; see the Makefile's target matrices
--again: from the files in the folder, no runs; --store: tables and pictures into tests/chart/matrices.md. States come from runs of hertz
(tangents.edp), rolling and indentation by states.idp, matrices of rivals are built of them (contact_matrices.py). Exit status 1 if a claim that
the page states as measured does not hold any more (claims()).
"""
import argparse
import os
import re
import subprocess
import sys

import numpy as np

import contact_matrices as cm
import matrix_pictures
import matrix_tables
import measures
import surface_integrals
from store import read, write

HERE = os.path.dirname(os.path.abspath(__file__))
FACTORS = [1, 10, 100, 1000, 10000]
AUGMENTED = 10
MESHES, QUICK = (8, 16, 32), (8, 12)
SCENES = {  # script, options, states, coordinates, those under force, radius, friction, pivot
    "hertz": ("tangents.edp", "-mu 0 -steps 2 -block 2", 1, ("x", "y", "angle"), ("y",), 100, 0.0, (0, 0)),
    "rolling": ("rolling.edp", "-method implicit -steps 40", 4, ("r", "phi", "theta"), ("r", "theta"), 15e-3, 0.2, (0, 0)),
    "indentation": ("indentation.edp", "-method implicit -steps 20", 4, ("x", "y", "angle"), ("y",), 15e-3, 0.2, (0, 0))}
WAYS = [  # of the study of what geometry makes nonsymmetric: name, options of rolling.edp
    ("all of it", "-body full -terms complete"),
    ("body symmetric", "-body symmetric -terms complete"),
    ("body symmetric, the article's terms", "-body symmetric -terms article"),
    ("body symmetric, no terms of contact", "-body symmetric -terms none"),
    ("body symmetric, friction lagged", "-body symmetric -terms complete -frictiontangent lagged -solver CHOLMOD"),
    ("nothing nonsymmetric", "-body symmetric -terms none -frictiontangent lagged -solver CHOLMOD"),
    ("core's block, all terms", "-terms complete"),
    ("core's block, no terms of contact", "-terms none")]


def run(script, options, log):
    command = [os.environ["BURNISH"], os.path.join(HERE, script), *options.split()]
    done = subprocess.run(["/usr/bin/env", "python3", "-c", WATCH, *command], capture_output=True, text=True, errors="replace")
    with open(log, "w") as f:
        f.write(done.stdout + done.stderr)
    if done.returncode not in (0, 3, 4):
        sys.exit(f"matrices: exit status {done.returncode} of {' '.join(command)}, see {log}")
    found = {n: float(v) for n, v in re.findall(r"^result (\S+) (\S+)$", done.stdout, re.MULTILINE)}
    seconds, megabytes = re.findall(r"^watched (\S+) (\S+)$", done.stdout, re.MULTILINE)[-1]
    stopped = re.search(r"stopped early at t = (\S+)", done.stdout)
    return {**found, "cpu": float(seconds), "megabytes": float(megabytes), "stopped": stopped.group(1) if stopped else ""}


WATCH = """import resource, subprocess, sys
code = subprocess.run(sys.argv[1:]).returncode
usage = resource.getrusage(resource.RUSAGE_CHILDREN)
print("watched", usage.ru_utime + usage.ru_stime, usage.ru_maxrss/1024)
sys.exit(code)"""


def state_of(scene, folder, k):
    _, _, _, coordinates, free, radius, _, pivot = SCENES[scene]
    return cm.State(os.path.join(folder, f"{k}-"), coordinates, free, radius, pivot)


def matrices_of(state, mu, sweep):
    """Names, matrices, and number of rows at the end that may have zeros on the diagonal."""
    coordinates = len(state.free)
    yield "K", cm.free_body(state), 0
    yield "condensed", cm.condensed(state), coordinates
    yield "condensed, coordinates scaled", cm.condensed(state, scale_coordinates=True), coordinates
    for factor in FACTORS if sweep else (10, 1000):
        yield f"penalty {factor}", cm.penalty(state, factor, mu), coordinates
    for name, factor in (("multipliers", 0), (f"augmented {AUGMENTED}", AUGMENTED)):
        A = cm.multiplier(state, mu, factor)
        yield name, A, A.shape[0] - len(state.kept)


def look(folder, quick, keep=False):
    rows = []
    for scene, (script, options, states, *_rest, mu, _) in SCENES.items():
        for element in ("P1", "P2"):
            meshes = QUICK if quick else MESHES
            for n in meshes:
                where = os.path.join(folder, f"{scene}-{element}-{n}")
                os.makedirs(where, exist_ok=True)
                extra = f" -pictures 0 -series 0 -check 0 -out {where}/run" if scene == "hertz" else ""
                if not keep or not os.path.exists(os.path.join(where, f"{states}-q")):
                    run(script, f"{options} -element {element} -n {n} -states {where}{extra}", os.path.join(where, "log.txt"))
                for k in range(1 if n == meshes[-1] else states, states + 1):
                    state = state_of(scene, where, k)
                    for name, A, border in matrices_of(state, mu, k == states):
                        rows.append({"scene": scene, "element": element, "n": n, "state": k, "matrix": name, "contact": len(state.active),
                                     **measures.measure(A, border)})
                print(f"  {scene}, {element}, n = {n}: {rows[-1]['size']} unknowns", file=sys.stderr, flush=True)
    return rows


def rivals(folder, quick):
    """How far a penalty matrix made here is from the last one of the rival's own loop, Hertz's contact on a small mesh."""
    where, rows = os.path.join(folder, "rivals"), []
    os.makedirs(where, exist_ok=True)
    run("tangents.edp", f"-mu 0 -steps 2 -block 1 -element P1 -n 4 -states {where} -pictures 0 -series 0 -check 0 -out {where}/run",
        os.path.join(where, "log.txt"))
    state = state_of("hertz", where, 1)
    for factor in FACTORS[1::2]:
        run("hertz.edp", f"-method penalty -factor {factor} -block 1 -element P1 -n 4 -matrix {where}/matrix", os.path.join(where, "log.txt"))
        own = cm.read_matrix(os.path.join(where, "matrix"))
        own = own[own.diagonal() < 1e25][:, own.diagonal() < 1e25]
        rows.append({"matrix": f"penalty {factor}", "off": float(measures.sla.norm(own - cm.penalty(state, factor, 0)) / measures.sla.norm(own))})
    return rows


def parts(folder, quick):
    """Sizes of what is nonsymmetric over the run of example 1, Frobenius norms over that of the condensed matrix."""
    n, rows = (QUICK if quick else MESHES)[-1], []
    where = os.path.join(folder, f"parts-P2-{n}")
    os.makedirs(where, exist_ok=True)
    found = run("rolling.edp", f"-method implicit -element P2 -n {n} -steps 40 -body full -terms complete -states {where}",
                os.path.join(where, "log.txt"))
    for k in range(1, 5):
        state = state_of("rolling", where, k)
        A = {name: cm.condensed(state, name) for name in ("complete", "article", "none", "lagged")}
        norm = measures.sla.norm
        stress = cm.read_matrix(state.base + "stress")
        rows.append({"t": k / 4, "body, finite step": found[f"part_{k}"], "body, article (1.11)": norm(stress - stress.T) / 2 / norm(state.K),
                     "contact, all terms": anti(A["complete"] - A["none"]) / norm(A["complete"]),
                     "contact, the article's": anti(A["article"] - A["none"]) / norm(A["complete"]),
                     "friction": anti(A["none"]) / norm(A["complete"]),
                     "terms of contact, whole": norm(A["complete"] - A["none"]) / norm(A["complete"])})
    return rows


def anti(A):
    return measures.sla.norm(A - A.T) / 2


def ways(folder, quick):
    rows = []
    for name, options in WAYS:
        mesh = "-element P1 -n 30 -steps 24" if quick else "-element P2 -n 60 -steps 60"
        found = run("rolling.edp", f"-method implicit {mesh} {options}", os.path.join(folder, "way.txt"))
        rows.append({"way": name, "outcome": f"stops at {found['stopped']}" if found["stopped"] else "finished",
                     **{k: int(found.get(k, 0)) for k in ("steps", "rejected", "iterations", "condensations", "factorizations")},
                     "seconds": found["seconds"], "megabytes": found["megabytes"], "depth": found.get("depth_4", float("nan"))})
        print(f"  {name}: {rows[-1]['seconds']:.1f} s", file=sys.stderr, flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="coarse meshes, a minute")
    parser.add_argument("--again", action="store_true", help="no runs: tables and pictures of the files in the folder")
    parser.add_argument("--keep", action="store_true", help="states that are in the folder are measured anew, not made")
    parser.add_argument("--store", action="store_true", help="into tests/chart/matrices.md")
    parser.add_argument("--out", default="out/matrices")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    made = {"matrices": lambda folder, quick: look(folder, quick, options.keep), "rivals": rivals, "parts": parts, "ways": ways,
            "integrals": lambda folder, quick: surface_integrals.measure(
                [state_of("rolling", os.path.join(folder, f"rolling-{e}-{(QUICK if quick else MESHES)[-1]}"), k)
                 for e in ("P1", "P2") for k in range(1, 5)], ["P1"] * 4 + ["P2"] * 4)}
    found = {}
    for name, function in made.items():
        path = os.path.join(options.out, name + ".csv")
        if not options.again:
            write(path, function(options.out, options.quick))
        found[name] = read(path)
    tables = matrix_tables.tables(found)
    for name, text in tables.items():
        print(f"\n## {name}\n\n{text}")
    matrix_pictures.conditions(found["matrices"], os.path.join(options.out, "matrices.png"))
    if options.store:
        matrix_tables.store(tables, options.out, HERE)
    wrong = matrix_tables.broken_claims(found)
    for line in wrong:
        print("does not hold: " + line)
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
