"""What a case's numbers are measured in; names, units and factors of the columns of its history."""
from collections import namedtuple

import numpy as np

# Factors to the units of the pictures: mm, MPa, and force (kN/m = N/mm) and moment per unit of thickness
Units = namedtuple("Units", "mm MPa force moment force_unit moment_unit")
SYSTEMS = {"m": Units(1e3, 1e-6, 1e-3, 1.0, "kN/m", r"N$\cdot$m/m"),
           "mm": Units(1.0, 1.0, 1.0, 1.0, "N/mm", r"N$\cdot$mm/mm")}

# What a column is; the kinds of the default history
LENGTH, ANGLE, FORCE, MOMENT, NODES, STRESS, STRAIN, TIME, OTHER = (
    "length", "angle", "force", "moment", "nodes", "stress", "strain", "time", "other")
ANGLES = ("angle", "theta", "phi", "psi", "alpha", "beta", "turn")


class Column(namedtuple("Column", "name kind label unit factor")):
    """A column of the history: label and unit for an axis, factor from the file's number to that unit."""

    def axis(self):
        return f"{self.label} [{self.unit}]"


def split_name(name):
    """Tool and bare name of a column: "Q_roller.x" -> ("roller", "Q_x"); tool "" where there is only one."""
    force = "Q_" if name.startswith("Q_") else ""
    tool, _, bare = name[len(force):].rpartition(".")
    return tool, force + bare


def kind_of(bare, coordinates):
    """bare: name without the tool; coordinates: bare names that are coordinates (their Q_ stands in the file too)."""
    known = {"t": TIME, "contact": NODES, "sticking": NODES, "sliding": NODES, "stress_eq_max": STRESS,
             "plastic_strain_eq_max": STRAIN}
    if bare in known:
        return known[bare]
    coordinate = bare[2:] if bare.startswith("Q_") else bare
    if coordinate not in coordinates:
        return OTHER
    angle = coordinate.rstrip("0123456789") in ANGLES
    if bare.startswith("Q_"):
        return MOMENT if angle else FORCE
    return ANGLE if angle else LENGTH


def describe(names, units, given=None):
    """{name: Column} of a history with these columns. given: {name or bare name: (label, unit, factor)} of the case,
    for its own columns and where the defaults are wrong: coordinates called angle, theta, phi, psi, alpha, beta or
    turn are angles, shown in degrees; all others are taken as lengths. None in place of the three: left out of the
    pictures."""
    given = given or {}
    coordinates = {split_name(n)[1][2:] for n in names if n.startswith("Q_")}
    factor = {LENGTH: units.mm, ANGLE: 180 / np.pi, FORCE: units.force, MOMENT: units.moment, STRESS: units.MPa}
    unit = {LENGTH: "mm", ANGLE: "deg", FORCE: units.force_unit, MOMENT: units.moment_unit, STRESS: "MPa"}
    label = {"t": "load parameter t", "contact": "in contact", "stress_eq_max": "largest von Mises stress",
             "plastic_strain_eq_max": "largest plastic strain"}
    columns = {}
    for name in names:
        tool, bare = split_name(name)
        kind = kind_of(bare, coordinates)
        text = label.get(bare, f"$Q_{{{bare[2:]}}}$" if bare.startswith("Q_") else bare)
        default = (text, unit.get(kind, "-"), factor.get(kind, 1.0))
        chosen = given.get(name, given.get(bare, default))
        if chosen is None:
            continue
        columns[name] = Column(name, kind, f"{tool}: {chosen[0]}" if tool else chosen[0], *chosen[1:])
    return columns
