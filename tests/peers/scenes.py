"""The chart's scenes as decks of CalculiX: same mesh, material, load program; what its input needs beside is said here.

s: numbers that the scene's script prints for -mesh, of its own units. A force alone finds no equilibrium before the tool touches:
all scenes begin with a press by a given depth, less than a hundredth of that at the end.
"""
import math

# penalty slope in units of E over the distance of surface nodes
SLOPE = {"hertz": 5, "indentation": 5, "rolling": 1}
POINTS = "*TIME POINTS, NAME=QUARTERS\n"


def asked(plastic):
    return [*(f"*NODE PRINT, NSET={name}, TIME POINTS=QUARTERS\nU, RF" for name in ("PLACE", "TURN", "FRONT")),
            f"*EL PRINT, ELSET=BODY, TIME POINTS=QUARTERS\nS{', PEEQ' if plastic else ''}"]


def begin(deck, s, name, slope, near, plastic):
    """Materials, contact and output of all scenes; the tool is there."""
    h, E = deck.mesh.spacing(3), s["E"]
    deck.surface(3, near)
    deck.material("STEEL", "BODY", E, s["nu"], [(s["yield"], 0), (s["yield"] + 5 * s["hardening"], 5)] if plastic else ())
    deck.material("TOOL", "BAND", E, s["nu"])
    deck.contact((slope or SLOPE[name]) * E / h, s.get("friction", 0))
    deck.set("PLACE", [deck.place - 1])
    deck.set("TURN", [deck.turn - 1])
    deck.set("FRONT", range(deck.body))
    deck.write("*BOUNDARY", f"{deck.place}, 1, 1", f"{deck.place}, 3, 3", f"{deck.turn}, 1, 2")


def pressing(deck, depth, large, turn=()):
    held = [f"{node}, 3, 3" for node in turn]
    deck.step(1, 1, 1, ["*BOUNDARY", f"{deck.place}, 2, 2, {-depth:.10g}", *held], large)


def free(deck, supports, turning):
    """Boundary conditions without those of the press."""
    return ["*BOUNDARY, OP=NEW", "PLANE, 3, 3", f"{deck.place}, 1, 1", f"{deck.place}, 3, 3", f"{deck.turn}, 1, {2 if turning else 3}", *supports]


def hertz(deck, s, steps, slope):
    """Frictionless, elastic, small strains: one increment, cut by CalculiX itself if it must be."""
    h, R, mesh = deck.mesh.spacing(3), s["radius"], deck.mesh
    deck.tie(set(mesh.nodes(1)))
    deck.set("BOTTOM", deck.behind(mesh.nodes(1)))
    deck.tool((0, R), R, -math.pi / 2 - 3 * s["half"] / R, -math.pi / 2 + 3 * s["half"] / R, h)
    begin(deck, s, "hertz", slope, lambda x, y: True, False)
    supports = ["BOTTOM, 1, 3"]
    deck.write(*supports, f"{deck.turn}, 3, 3", POINTS + "1.")
    pressing(deck, s["half"] ** 2 / R / 100, False)
    deck.step(1, 1, 1, [*free(deck, supports, False), "*CLOAD", f"{deck.place}, 2, {-s['force'] * deck.thickness:.10g}",
                                        *asked(False)], False)


def indentation(deck, s, steps, slope):
    """Half of it; the tool is not lifted off in the end but keeps a thousandth of its force."""
    h, R, mesh = deck.mesh.spacing(3), s["radius"], deck.mesh
    fixed, line = mesh.nodes(1), mesh.nodes(4)
    deck.tie(set(fixed) | set(line))
    deck.set("BOTTOM", deck.behind(fixed))
    deck.set("LINE", [n for n in deck.behind(line) if n % deck.body not in set(fixed)])
    deck.tool((0, R), R, -math.pi / 2 - 0.1 * s["zone"] / R, -math.pi / 2 + 1.2 * s["zone"] / R, h)
    begin(deck, s, "indentation", slope, lambda x, y: x < 1.1 * s["zone"], True)
    supports = ["BOTTOM, 1, 3", "LINE, 1, 1", "LINE, 3, 3"]
    deck.write(*supports, f"{deck.turn}, 3, 3", POINTS + "0.5, 0.9, 1.")
    pressing(deck, 2e-7, True)
    for force, length in ((s["force"], 1), (s["force"] * s["rest"], 0.9)):
        deck.step(length, 0.2 / steps, 1 / steps, [*free(deck, supports, False), "*CLOAD", f"{deck.place}, 2, {-force * deck.thickness:.10g}",
                                                   *asked(True)], True)


def rolling(deck, s, steps, slope):
    """The clamped arc turns under the roller, which keeps its direction: forces along a turning radius are no load of CalculiX."""
    h, R, Ro, mesh, turn = deck.mesh.spacing(3), s["radius"], s["outer"], deck.mesh, math.radians(s["turn"])
    gap = h ** 2 / 8 * (1 / R + 1 / Ro)             # between two nodes at the start, at most
    inner = mesh.nodes(1)
    deck.tie(set(inner))
    deck.set("ARC", deck.behind(inner))
    deck.arc = deck.rigid("ARC", (0, 0))
    back = turn * Ro / R                            # angle of the roller that has been rolled off, about
    deck.tool((0, Ro + R), R, -math.pi / 2 - 0.25, -math.pi / 2 + 0.25 + back, h)
    begin(deck, s, "rolling", slope, lambda x, y: True, True)
    supports = [f"{deck.arc[0]}, 1, 3", f"{deck.arc[1]}, 1, 2"]
    deck.write(*supports, POINTS + "0.25, 0.5, 0.75, 1.")
    pressing(deck, 2e-7 + gap, True, (deck.turn, deck.arc[1]))
    most = min(1 / steps, s["roll"] * h / (Ro * turn))
    deck.step(1, most, most, [*free(deck, supports, True), f"{deck.arc[1]}, 3, 3, {turn:.12g}", "*CLOAD",
                              f"{deck.place}, 2, {-s['force'] * deck.thickness:.10g}", f"{deck.turn}, 3, {s['moment'] * deck.thickness:.10g}",
                              *asked(True)], True)


def turned(x, y, s):
    """Rolling: places in the deck, where the roller stands at +y."""
    a = math.pi / 2 - math.radians(s["start"])
    return x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)


WRITE = {"hertz": hertz, "indentation": indentation, "rolling": rolling}
