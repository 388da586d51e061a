"""The chart's ball by CalculiX: a quarter of a rigid ball as a cap of C3D20 with curved faces on the script's tetrahedra (C3D4, C3D10).

The cap stands FIRST of the depth in the block at the start, so that the force alone finds its equilibrium in one increment. Pressures: with
faces against faces nodal forces integrated from the stresses, shared to the corners as ours (METHOD.md 3.20); with nodes against faces,
"-nodes", those that CalculiX reports at the nodes, between them by the shape functions of the faces: each the nearer one to Hertz.
"""
import math
import os

import numpy as np

import answers
from solid import Solid

SLOPE = {"P1": 5, "P2": 20}     # of the penalty in units of E over the distance of surface nodes; of nodes 5 on both
FIRST = 0.1                     # of a^2/R
NEAR = 1.6                      # half-width of the contact surfaces in radii of the contact
BEYOND = 0.15                   # of the cap beyond the planes of symmetry, in radii of the contact
CURVED = 2                      # edges of the block on an edge of the cap


class Deck:
    """Lines of the input; nodes and elements count from 1."""

    def __init__(self):
        self.lines = []

    def write(self, *lines):
        self.lines += lines

    def row(self, numbers):
        """At most 16 numbers in a line."""
        words = [str(v) for v in numbers]
        self.lines += [", ".join(words[k:k + 16]) + ("," if k + 16 < len(words) else "") for k in range(0, len(words), 16)]

    def nodes(self, places, first):
        self.write("*NODE", *(f"{k}, " + ", ".join(f"{v:.12e}" for v in x) for k, x in enumerate(places, first)))

    def elements(self, kind, name, elements, first):
        self.write(f"*ELEMENT, TYPE={kind}, ELSET={name}")
        for k, e in enumerate(elements, first):
            self.row([k, *(n + 1 for n in e)])

    def set(self, name, nodes):
        self.write(f"*NSET, NSET={name}", *(f"{n + 1}," for n in nodes))


def cap(center, s, number, first):
    """Nodes and elements of a square of the ball about its lowest point, `number` elements each way, S1 below; first: number of a node."""
    grid, nodes, h = {}, [], (NEAR + BEYOND) * s["half"] / (2 * number)
    for i, j, k in np.ndindex(2 * number + 1, 2 * number + 1, 3):
        if i % 2 + j % 2 + k % 2 < 2:
            x, y = i * h - BEYOND * s["half"], j * h - BEYOND * s["half"]
            grid[i, j, k] = first + len(nodes)
            nodes.append([x, y, center - math.sqrt(s["radius"]**2 - x**2 - y**2) + k * h])
    corners, sides = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (2, 1), (1, 2), (0, 1)]
    places = [(*p, k) for part in (corners, sides) for k in (0, 2) for p in part] + [(*p, 1) for p in corners]
    return nodes, [[grid[2 * i + p, 2 * j + q, k] for p, q, k in places] for i, j in np.ndindex(number, number)]


def write(path, mesh, s, slope, nodes):
    """The deck; h: distance of vertices at the contact, as the script asks for it."""
    deck, center, h, a = Deck(), s["radius"] - FIRST * s["half"]**2 / s["radius"], s["half"] / s["n"], s["half"]
    places, bricks = cap(center, s, math.ceil((NEAR + BEYOND) * s["n"] / CURVED), len(mesh.xyz))
    tool, first = len(mesh.xyz) + len(places) + 1, len(mesh.elements) + 1
    deck.nodes([*mesh.xyz, *places, [0, 0, center], [0, 0, center]], 1)
    deck.elements("C3D10" if mesh.middles else "C3D4", "BODY", mesh.elements, 1)
    deck.elements("C3D20", "CAP", bricks, first)
    deck.set("RIGID", range(len(mesh.xyz), tool - 1))
    deck.set("TOP", mesh.nodes(3))
    deck.set("PLACE", [tool - 1])
    deck.write("*SURFACE, NAME=SURFACE, TYPE=ELEMENT", *(f"{e + 1}, S{k}" for e, k, corners in mesh.faces[3]
                                                        if np.linalg.norm(mesh.xyz[corners].mean(axis=0)) < NEAR * a))
    deck.write("*SURFACE, NAME=BALL, TYPE=ELEMENT", *(f"{first + k}, S1" for k in range(len(bricks))))
    deck.write(f"*RIGID BODY, NSET=RIGID, REF NODE={tool}, ROT NODE={tool + 1}", "*MATERIAL, NAME=STEEL", "*ELASTIC",
               f"{s['E']:g}, {s['nu']:g}", *(f"*SOLID SECTION, ELSET={name}, MATERIAL=STEEL" for name in ("BODY", "CAP")))
    deck.write("*SURFACE INTERACTION, NAME=CONTACT", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{slope * s['E'] / h:g}",
               f"*CONTACT PAIR, INTERACTION=CONTACT, TYPE={'NODE' if nodes else 'SURFACE'} TO SURFACE", "SURFACE, BALL")
    for name, label in (("OUTER", 1), ("FRONT", 4), ("LEFT", 5)):
        deck.set(name, mesh.nodes(label))
    deck.write("*BOUNDARY", "OUTER, 1, 3", "FRONT, 2, 2", "LEFT, 1, 1", f"{tool}, 1, 2", f"{tool + 1}, 1, 3",
               "*STEP, INC=1000", "*STATIC", "1., 1., 1e-5, 1.", "*CLOAD", f"{tool}, 3, {-s['force']:.12g}",
               "*NODE PRINT, NSET=PLACE", "U", "*EL PRINT, ELSET=BODY", "S", "*CONTACT FILE", "CSTR", "*END STEP")
    with open(path, "w") as f:
        f.write("\n".join(deck.lines) + "\n")


def reported(path, count):
    """Contact pressures at the first nodes, of the last block of a .frd file."""
    p, inside = np.zeros(count), False
    with open(path) as f:
        for line in f:
            inside = line.startswith(" -4  CONTACT") or (inside and not line.startswith(" -3"))
            if inside and line.startswith(" -1") and int(line[3:13]) <= count:
                p[int(line[3:13]) - 1] = float(line[49:61])
    return p


def measures(folder, mesh, s, nodes):
    """{name: value} as tests/chart/ball.idp has them."""
    block, R, a = list(answers.read(os.path.join(folder, "scene.dat")).values())[-1], s["radius"], s["half"]
    force = -mesh.forces(block["stresses", "BODY"][:, 2:].reshape(len(mesh.elements), -1, 6))[:, 2]
    top = [n for n in mesh.nodes(3) if np.linalg.norm(mesh.xyz[n]) < 2 * NEAR * a]
    N = np.zeros(len(mesh.xyz))
    N[top] = force[top]
    p = reported(os.path.join(folder, "scene.frd"), len(N)) if nodes else mesh.shared(3, N)
    x, area, p = mesh.on_faces(3, p, not nodes)
    r = np.hypot(x[:, 0], x[:, 1])
    hertz = 2 * s["E"] / (1 - s["nu"]**2) * a / (math.pi * R) * np.sqrt(np.maximum(0, 1 - (r / a)**2))
    inner = area * (r < 0.8 * a)
    return {"depth": FIRST * a**2 / R - block["displacements", "PLACE"][0, 3],
            "force": N.sum() / s["force"] - 1,
            "radius": math.sqrt(2.5 * (N * (mesh.xyz[:, :2]**2).sum(axis=1)).sum() / N.sum()) / a - 1,
            "peak": inner @ (p * hertz) / (inner @ hertz**2) - 1,
            "pressure": math.sqrt(area @ (p - hertz)**2 / (area @ hertz**2)),
            "pressure_inner": math.sqrt(inner @ (p - hertz)**2 / (inner @ hertz**2))}


def prepare(options, folder, s):
    """Deck in the folder; the mesh."""
    mesh = Solid(os.path.join(folder, "scene.msh.mesh"), options.element == "P2")
    s["n"] = options.n
    write(os.path.join(folder, "scene.inp"), mesh, s, options.slope or (5 if options.nodes else SLOPE[options.element]), options.nodes)
    return mesh
