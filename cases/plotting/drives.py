"""What the program prescribes for the tools, from `drive` of the summary: motion, straight, along the way or turning, and forces, as arrows
with their values; in the plane and in space. arrows.py draws them."""
from collections import namedtuple

import numpy as np

from plotting import maps
from plotting.inputs import InputError
from plotting.units import amount, split_name, touch_columns

# Of one tool: "motion", "force" or "free turn", that of a tool which nothing turns but the workpiece; points of the arrow about its middle,
# whose size is chosen later; text: its value
Arrow = namedtuple("Arrow", "tool what shape both text")
STRAIGHT, TURN, WAY, AROUND = "straight", "turn", "way", "around"

Shape = namedtuple("Shape", "kind points")     # points: of a straight one its direction, of a turn its axis, of a way, AROUND something too, its places

FAR, TURNED, ROLLED = 0.01, 0.05, 0.2    # motion over the view, turn, free turn [rad], below which there is no arrow,
NEAR = 1e-3                     # of a run with such arrows; of one without any
SMALL = 0.2                     # of the largest motion of the run, below which another is none to see: a tool that goes off
NOISE = 1e-3                    # of the largest force on a tool, below which another is what is out of balance
BACK = 0.3                      # of the motion, back from its end: an arrow with two heads
BACK_WORDS = ", and back"
CURVED, BENT = 0.02, 0.1        # sagitta over length, above which the arrow goes along the way, above which it is drawn where it is


def given(run):
    """{coordinate: its drive}, {} where the files do not say it."""
    try:
        return run.summary.get("drive", {})
    except InputError:
        return {}


def arrows(run, size):
    """All arrows of a run. size: of the view, in the unit of the pictures"""
    names, found = run.tool_names, []
    driven = [(split_name(name)[0] or next(iter(names), ""), name, drive) for name, drive in given(run).items()]
    driven = [(tool, name, drive, moved_by(run, tool, name, drive)) for tool, name, drive in driven if tool in names]
    largest = max((abs(most) * rates(drive)[0] for _, _, drive, (most, _) in driven), default=0) * run.units.length
    length = size / run.units.length
    heaviest = max((load_of({**drive, "force": np.nanmax(np.abs(run.history["Q_" + name]))}, length) for _, name, drive, _ in driven), default=0)
    for least in (FAR * size, NEAR * size):      # where nothing goes far, as in a test of a material, what goes
        for tool, _, drive, (most, both) in driven if not found else ():
            motion = motion_of(run, (tool, drive, most, both), max(least, SMALL * largest))
            force = force_of(run, tool, drive) if load_of(drive, length) > NOISE * heaviest else []
            found += force or motion if drive["kind"].startswith("force") else motion or force     # what comes first is what the process is
    return found


def load_of(drive, length):
    """A force, or a moment as a pair of forces at this distance."""
    fast, turn = rates(drive)
    return abs(drive["force"]) / fast if fast else abs(drive["force"]) / (turn * length) if turn else 0.0


def parts(drive):
    """Velocity and angular velocity for a unit rate, the latter one number in the plane."""
    return np.split(np.array(drive["twist"]), [2 if len(drive["twist"]) == 3 else 3])


def rates(drive):
    return [np.linalg.norm(part) for part in parts(drive)]


def moved_by(run, tool, name, drive):
    """How far a coordinate goes that is moved, follows or turns, 0 for others; whether it comes back."""
    if name not in run.history or not rates(drive)[0] == 0 and not any(word in drive["kind"] for word in ("motion", "follows")):
        return 0.0, False
    moved = (run.history[name] - run.history[name][0])[:while_touching(run.history, tool)]
    last = int(np.nanargmax(np.abs(moved)))
    most, there = moved[last], np.sign(moved[last]) * moved
    return most, bool(np.nanmax(there[last] - there[last:]) > BACK * abs(most) or np.nanmin(there) < -BACK * abs(most))


def while_touching(history, tool):
    """Lines of the history up to the last in which the tool touches: what comes then takes it off. All if it never does."""
    own = [n for n in touch_columns(history) if n == f"{tool}.contact"] or touch_columns(history)
    touching = np.flatnonzero(sum(history[n] > 0 for n in own))
    return 1 + int(touching[-1]) if len(touching) else None


def motion_of(run, given, least):
    """The arrow of a coordinate that goes far enough, in a list. given: tool, drive, and what moved_by says; least: length"""
    tool, drive, most, both = given
    (velocity, turn), (fast, spin), units = parts(drive), rates(drive), run.units
    if fast * abs(most) * units.length > least:
        far = distance(run, tool) if len(velocity) == 2 and alone(run, tool) else fast * abs(most) * units.length
        text = rounded(far, units.length_unit) + BACK_WORDS * both
        return [Arrow(tool, "motion", way_or_line(run, tool, np.sign(most) * velocity / fast), both, text)]
    what, least = ("free turn", ROLLED) if drive["kind"] == "force" else ("motion", TURNED)
    if fast == 0 and spin * abs(most) > least:
        return [Arrow(tool, what, Shape(TURN, np.sign(most) * turn / spin), both, f"{np.degrees(spin * abs(most)):.3g}°" + BACK_WORDS * both)]
    return []


def alone(run, tool):
    """Whether only one coordinate moves a tool: it may be one of a mechanism, whose rate changes on the way."""
    moving = [name for name in given(run) if (split_name(name)[0] or tool) == tool and name in run.history and np.ptp(run.history[name]) > 0]
    return len(moving) == 1


def distance(run, tool):
    """How far a tool goes that does not turn, from where it begins."""
    way = way_of(run, tool)
    return np.hypot(*(way - way[0]).T).max()


def way_or_line(run, tool, direction):
    """The way of the tool in the plane where that is curved, else the direction in which it begins."""
    if len(direction) == 3:
        return Shape(STRAIGHT, direction)
    way = way_of(run, tool)
    chord = way[-1] - way[0]
    length = maps.length(way)
    if length > 0 and len(way) > 4 and np.hypot(*chord) > 0:
        off = np.abs((way - way[0]) @ np.array([-chord[1], chord[0]])).max() / np.hypot(*chord)
        if off > CURVED * length and (way[len(way) // 4] - way[0]) @ direction > 0.8 * np.hypot(*(way[len(way) // 4] - way[0])):
            return Shape(AROUND if off > BENT * length else WAY, way)
    return Shape(STRAIGHT, direction)


def way_of(run, tool):
    """Middles of the box about a tool at the instants of tools.csv while tools touch, those where it rests once."""
    last = run.history["t"][:while_touching(run.history, tool)][-1]
    own = sorted((o for o in run.tools if o.name == tool and o.t <= last * (1 + 1e-9)), key=lambda o: o.t)
    way = np.array([0.5 * (o.points.min(axis=0) + o.points.max(axis=0)) for o in own])
    goes = np.hypot(*np.diff(way, axis=0).T) > 1e-3 * maps.length(way)
    return way[np.r_[True, goes]]


def force_of(run, tool, drive):
    """The arrow of a coordinate under a force, in a list; none without one."""
    force, (velocity, turn), (fast, spin), units = drive["force"], parts(drive), rates(drive), run.units
    if fast:
        text = rounded(abs(force) / fast * units.force, units.force_unit)
        return [Arrow(tool, "force", Shape(STRAIGHT, np.sign(force) * velocity / fast), False, text)]
    return [Arrow(tool, "force", Shape(TURN, np.sign(force) * turn / spin), False, rounded(abs(force / spin) * units.moment, units.moment_unit))]


def rounded(number, unit):
    """Three digits: what was prescribed, without what is out of balance."""
    return amount(float(f"{number:.3g}"), unit)
