"""What a run's numbers are measured in; names, units and factors of the columns of its history."""
from collections import namedtuple

import numpy as np

from plotting.inputs import InputError

# Factors from the numbers of the files to those of the pictures, and the units there; the force and the moment of a
# plane scene are per unit of thickness, those of an axisymmetric one are of the whole ring
Units = namedtuple("Units", "length stress force moment length_unit stress_unit force_unit moment_unit")
METERS, PASCALS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}, {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9}


def named(length, stress, whole=False):
    """Units of the pictures for numbers in the units that rcUnits takes: mm, MPa, and forces in N/mm, where the script says m in kN/m.
    whole: forces are those of the whole ring or body, not per unit of thickness."""
    if length not in METERS or stress not in PASCALS:
        raise InputError(f"units {length!r}, {stress!r}: expected one of {', '.join(METERS)} and one of {', '.join(PASCALS)}")
    meter, pascal = METERS[length], PASCALS[stress]
    force = pascal * meter * (meter if whole else 1)     # N or N/m
    shown, unit = (1e-6, r"$\mu$m") if length == "um" else (1e-3, "mm")
    if length == "m":
        per = "" if whole else "/m"
        return Units(meter / shown, pascal / 1e6, force / 1e3, force * meter, unit, "MPa", "kN" + per, r"N$\cdot$m" + per)
    per, scale = ("", 1.0) if whole else ("/mm", 1e-3)
    return Units(meter / shown, pascal / 1e6, force * scale, force * meter * 1e3 * scale, unit, "MPa", "N" + per, r"N$\cdot$mm" + per)


# What a column is; the kinds of the default history
LENGTH, ANGLE, FORCE, MOMENT, NODES, STRESS, STRAIN, TIME, OTHER = (
    "length", "angle", "force", "moment", "nodes", "stress", "strain", "time", "other")
ANGLES = ("angle", "theta", "phi", "psi", "alpha", "beta", "turn", "spinx", "spiny", "spinz")
LENGTHS = ("x", "y", "r")  # of "cartesian" and "polar"


def power_of_ten(largest, low=0.1, high=1e4):
    """Exponent, a multiple of three, that brings numbers up to the largest between 1 and 1000; 0 from low to high."""
    if not np.isfinite(largest) or largest <= 0 or low <= largest < high:
        return 0
    return 3 * int(np.floor(np.log10(largest) / 3 + 1e-12))


def in_powers(exponent, unit):
    """Unit with a power of ten before it."""
    power = rf"$10^{{{exponent}}}$" if exponent else ""
    return f"{power} {unit}".strip() if unit != "-" or not power else power


def neutral(size, stress, axisymmetric=None):
    """Units of a scene that does not say them: names of the dimensions, with the powers of ten that a size of the
    workpiece and a largest stress ask for. axisymmetric: None if it is not known."""
    lengths, stresses = power_of_ten(size), power_of_ten(stress)
    per = "/length" if axisymmetric is False else ""
    return Units(10.0**-lengths, 10.0**-stresses, 1.0, 1.0, in_powers(lengths, "length"),
                 in_powers(stresses, "stress"), "force" + per, "moment" + per)


def plain(text):
    """A name as matplotlib shows it letter by letter: no formula, and no underscore first, which hides it in a key."""
    return ("\u200a" if text.startswith("_") else "") + text.replace("$", r"\$")


def with_unit(label, unit):
    return f"{label} [{unit}]" if unit else label


def amount(number, unit):
    """Number with its unit in a sentence; of a neutral unit the power of ten alone."""
    power, digits = unit.partition(" ")[0] if unit.startswith("$10^") else "", f"{number:.0f}" if 1000 <= abs(number) < 1e6 else f"{number:.3g}"
    if power:
        return rf"{digits}$\cdot${power}"
    return digits if unit in ("-", "stress", "length") else f"{digits} {unit}"


class Column(namedtuple("Column", "name kind label unit factor")):
    """A column of the history: label and unit for an axis, factor from the file's number to that unit."""

    def axis(self):
        return with_unit(self.label, self.unit)


def split_name(name):
    """Tool and bare name of a column: "Q_roller.x" -> ("roller", "Q_x"); tool "" where there is only one."""
    force = "Q_" if name.startswith("Q_") else ""
    tool, _, bare = name[len(force):].rpartition(".")
    return tool, force + bare


def touch_columns(history):
    """Columns that are above zero where a tool touches: one for each tool, else those of the only one."""
    return [n for n in history if n.endswith(".contact")] or ["sticking", "sliding"]


def kind_of(bare, coordinates, lengths=None):
    """bare: name without the tool; coordinates: bare names that are coordinates (their Q_ stands in the file too);
    lengths: those that are no angles and certainly lengths, None: all."""
    known = {"t": TIME, "contact": NODES, "sticking": NODES, "sliding": NODES, "stress_eq_max": STRESS,
             "plastic_strain_eq_max": STRAIN}
    if bare in known:
        return known[bare]
    coordinate = bare[2:] if bare.startswith("Q_") else bare
    if coordinate not in coordinates:
        return OTHER
    angle = coordinate.rstrip("0123456789") in ANGLES
    if not angle and lengths is not None and coordinate not in lengths:
        return OTHER
    if bare.startswith("Q_"):
        return MOMENT if angle else FORCE
    return ANGLE if angle else LENGTH


def label_of(bare):
    label = {"t": "load parameter t", "contact": "in contact", "stress_eq_max": "largest von Mises stress",
             "plastic_strain_eq_max": "largest plastic strain"}
    if bare in label:
        return label[bare]
    if not bare.startswith("Q_"):
        return plain(bare)
    letters = bare[2:].replace("_", r"\_")
    return f"$Q_{{{letters}}}$" if letters.replace(r"\_", "").isalnum() else plain(bare)


UNITS = {**{unit: unit for unit in ("m", "cm", "mm", "Pa", "kPa", "MPa", "GPa", "N", "kN", "deg", "s")}, "um": r"$\mu$m"}  # that names end with


def named_unit(bare):
    """Label and unit of a column of the script, which may end with its unit: "depth_mm"; no unit where it does not."""
    stem, _, unit = bare.rpartition("_")
    return (plain(stem), UNITS[unit]) if stem and unit in UNITS else (label_of(bare), "")


def describe(names, units, given=None, lengths=None):
    """{name: Column} of a history with these columns. given: {name or bare name: (label, unit, factor)} of the case,
    for its own columns and where the defaults are wrong: coordinates called angle, theta, phi, psi, alpha, beta,
    turn, spinx, spiny or spinz are angles, shown in degrees; all others are taken as lengths, or only those in lengths.
    None in place of the three: left out of the pictures."""
    given = given or {}
    coordinates = {split_name(n)[1][2:] for n in names if n.startswith("Q_")}
    factor = {LENGTH: units.length, ANGLE: 180 / np.pi, FORCE: units.force, MOMENT: units.moment, STRESS: units.stress}
    unit = {LENGTH: units.length_unit, ANGLE: "deg", FORCE: units.force_unit, MOMENT: units.moment_unit,
            STRESS: units.stress_unit}
    columns = {}
    for name in names:
        tool, bare = split_name(name)
        kind = kind_of(bare, coordinates, lengths)
        nothing = "" if lengths is not None and kind == TIME else "-"  # the unit may be any
        default = (*named_unit(bare), 1.0) if kind == OTHER else (label_of(bare), unit.get(kind, nothing), factor.get(kind, 1.0))
        chosen = given.get(name, given.get(bare, default))
        if chosen is None:
            continue
        label = f"{plain(tool)}: {chosen[0]}" if tool else chosen[0]
        columns[name] = Column(name, kind, label, *chosen[1:])
    return columns
