"""Goals of a sweep: values of its unknowns, name=first:last, for which results are what is asked. Names are those of results of the script
or of "final" in summary.json; runs are variants of the study, none is repeated.

  target="depth=0.1"                       one unknown: Brent's method (scipy.optimize.brentq)
  target="depth=0.1,turn=-5"               as many unknowns as targets, or more targets: least squares of (result - target)/|target|,
                                           Gauss-Newton in a trust region within the ends (scipy.optimize.least_squares)
  minimize="drive force", maximize=...     COBYLA (scipy.optimize) from the best of some points drawn first; where="depth<0.1,width>0.5"
                                           are its constraints
  measured=curve.csv                       identify.py
  within=1e-3                              allowed distance of a result from its target or its bound, over the size of that
A name that holds a comma: separate by semicolons. A point whose run fails gives way to its neighbors, NUDGES of the range apart; a
point all of whose neighbors fail, too, counts as worse than all others.
"""
import re

import numpy as np
from runner import run
from solve import least_squares
from study import finished
from values import Failed, SweepError, to_number

NUDGES = (0.004, -0.004, 0.02, -0.02)   # over the range of each unknown
MOST_RUNS = 200
TOLERANCE = 1e-4                        # of least squares: runs scatter more
FIRST = 4                               # points drawn first, a number for each unknown


class Runs:
    """Rows of results as a function of the unknowns z, which go from 0 to 1 between their ends."""

    def __init__(self, study):
        self.study, self.names = study, list(study.request.vary)
        self.low = np.array([study.request.vary[n][1] for n in self.names])
        self.high = np.array([study.request.vary[n][2] for n in self.names])

    def values(self, z):
        return self.low + np.clip(z, 0, 1) * (self.high - self.low)

    def texts(self, z):
        return {n: f"{v:.8g}" for n, v in zip(self.names, self.values(z))}

    def raw(self, points):
        """Folder of each point's run, None of one that failed; what is missing runs side by side."""
        named = [self.study.add(self.texts(z)) for z in points]
        if len(self.study.variants) > MOST_RUNS:
            raise Failed(f"no answer in {MOST_RUNS} runs")
        missing = [n for n in dict.fromkeys(named) if n in self.study.missing()]
        self.study.write()
        run(self.study, missing, quiet=True)
        return [self.study.place_of(n) if finished(self.study.place_of(n)) else None for n in named]

    def folders(self, points):
        """The same, of the nearest neighbor where a run failed."""
        found = self.raw(points)
        for nudge in NUDGES:
            gone = [i for i, f in enumerate(found) if f is None]
            if not gone:
                break
            for i, f in zip(gone, self.raw([inward(points[i], nudge) for i in gone])):
                found[i] = f
        return found


def inward(z, nudge):
    moved = np.asarray(z, float) + nudge
    return np.where((moved < 0) | (moved > 1), np.asarray(z) - nudge, moved)


class Results:
    """Values of some results at points, a line on the screen for each; None where no run nearby ends."""

    def __init__(self, runs, names):
        self.runs, self.names, self.seen = runs, names, {}

    def many(self, points):
        new = [z for z in points if self.key(z) not in self.seen]
        for z, folder in zip(new, self.runs.folders(new)):
            self.seen[self.key(z)] = self.read(folder)
            told = ", ".join(f"{n} = {v:.8g}" for n, v in zip(self.names, self.seen[self.key(z)])) if folder else "failed"
            print("  " + ", ".join(f"{n} = {t}" for n, t in self.runs.texts(z).items()) + f": {told}", flush=True)
        return [self.seen[self.key(z)] for z in points]

    def key(self, z):
        return tuple(self.runs.texts(z).values())

    def read(self, folder):
        from gather import read_summary, row_of
        if folder is None:
            return None
        row = row_of(read_summary(folder))
        for name in self.names:
            if name not in row:
                raise SweepError(f"no result \"{name}\"; there are: {', '.join(row)}")
        return np.array([float(row[n]) for n in self.names])

    def one(self, z):
        return self.many([z])[0]


def split(text):
    """Parts with semicolons, or with commas where there are none."""
    return [p.strip() for p in text.split(";" if ";" in text else ",") if p.strip()]


def parse_targets(text):
    found = {}
    for part in split(text):
        name, equals, value = part.rpartition("=")
        if not equals or not name.strip():
            raise SweepError(f"target: \"{part}\" is not name=value, such as depth=0.1")
        found[name.strip()] = to_number(value, f"target: {name.strip()}")
    return found


def parse_constraints(text):
    """[(name, sign, bound)]: sign*(value - bound) >= 0"""
    found = []
    for part in split(text):
        match = re.fullmatch(r"(.+?)\s*([<>])=?\s*(\S+)", part)
        if not match:
            raise SweepError(f"where: \"{part}\" is not name<value or name>value")
        found.append((match[1].strip(), 1 if match[2] == ">" else -1, to_number(match[3], f"where: {match[1]}")))
    return found


def answer_of(runs, z, told):
    return {"values": runs.texts(z), "told": told}


def one_target(runs, name, target, within):
    """Brent's method; an end whose runs all fail moves inward."""
    from scipy.optimize import brentq
    results = Results(runs, [name])
    ends = [0.0, 1.0]
    results.many([[0.0], [1.0]])
    for k, way in ((0, 0.1), (1, -0.1)):
        while results.one([ends[k]]) is None:
            ends[k] += way
            if not ends[0] < ends[1] - 0.05:
                raise Failed("all runs failed")
    low, high = (results.one([e])[0] for e in ends)
    near = within * (abs(target) or max(abs(low), abs(high)))
    if (low - target) * (high - target) > 0:
        a, b = (runs.values(np.array([e]))[0] for e in ends)
        raise Failed(f"{name} = {target:g} is not between {low:g} at {runs.names[0]} = {a:g} and {high:g} at {b:g}; expected another range")

    def distance(x):  # zero as soon as it is near enough: the method stops there
        got = results.one([x])
        if got is None:
            raise Failed(f"runs about {runs.names[0]} = {runs.values(np.array([x]))[0]:.6g} failed")
        return 0.0 if abs(got[0] - target) <= near else got[0] - target

    z = [brentq(distance, *ends, xtol=1e-9, maxiter=60)]
    reached = results.one(z)[0]
    if abs(reached - target) > near:
        raise Failed(f"{name} jumps over {target:g} near {runs.names[0]} = {runs.values(np.array(z))[0]:.8g}")
    return answer_of(runs, z, [f"{name} = {reached:.8g}, target {target:g}"])


def several_targets(runs, targets, within):
    results = Results(runs, list(targets))
    wanted = np.array(list(targets.values()))
    first = results.one(np.full(len(runs.names), 0.5))
    size = np.where(wanted != 0, np.abs(wanted), np.abs(first) if first is not None else 1.0)
    many = lambda points: [None if r is None else (r - wanted) / np.where(size > 0, size, 1.0) for r in results.many(points)]  # noqa: E731
    found = least_squares(many, len(runs.names), TOLERANCE, within)
    reached = results.one(found)
    if reached is None:
        raise Failed("runs about the last point failed; expected other ranges")
    told = [f"{n} = {r:.8g}, target {t:g}" for n, r, t in zip(targets, reached, wanted)]
    far = np.abs(many([found])[0])
    if far.max() > within and len(targets) == len(runs.names):
        at = ", ".join(f"{n} = {t}" for n, t in runs.texts(found).items())
        raise Failed(f"nearest at {at}: {'; '.join(told)}; expected other ranges or targets")
    return answer_of(runs, found, told)


def least(runs, name, sign, constraints, within):
    """Least value of sign times a result."""
    from scipy import optimize
    from scipy.stats import qmc
    results = Results(runs, [name, *(c[0] for c in constraints)])
    signs, bounds = (np.array([c[k] for c in constraints]) for k in (1, 2))
    size = np.where(bounds != 0, np.abs(bounds), 1.0)
    dimension = len(runs.names)
    points = [np.full(dimension, 0.5), *qmc.LatinHypercube(dimension, seed=1).random(FIRST * dimension)]
    rows = [(r, z) for r, z in zip(results.many(points), points) if r is not None]
    if not rows:
        raise Failed("all runs failed")
    goals = [sign * r[0] for r, _ in rows]
    span = max(np.ptp(goals), 1e-12)

    def room(row):   # of each constraint, below zero where it does not hold
        return signs * (row[1:] - bounds) / size

    def goal(z):
        row = results.one(z)
        return max(goals) / span + 1 if row is None else sign * row[0] / span

    def inside(z):
        row = results.one(z)
        walls = np.r_[z, 1 - np.asarray(z)]
        return np.r_[walls, room(row) if row is not None else np.full(len(constraints), -1.0)]

    best = min(rows, key=lambda pair: (np.minimum(room(pair[0]), 0).sum() < -within, sign * pair[0][0]))[1]
    optimize.minimize(goal, best, method="COBYLA", constraints={"type": "ineq", "fun": inside}, tol=within, options={"rhobeg": 0.15, "maxiter": 80})
    allowed = [(sign * r[0], key) for key, r in results.seen.items() if r is not None and (room(r) >= -within).all()]
    if not allowed:
        raise Failed("no run holds where=; expected other ranges or bounds")
    _, key = min(allowed)
    row = results.seen[key]
    return {"values": dict(zip(runs.names, key)), "told": [f"{n} = {v:.8g}" for n, v in zip(results.names, row)]}


def chosen_goal(study):
    """The function that runs variants until the goal of the request is reached; a SweepError says what is wrong with it before any runs."""
    try:
        import scipy  # noqa: F401
    except ImportError as error:
        raise SweepError(f"{error}; the Debian package python3-scipy is needed") from None
    goals, within, runs = study.request.goals, study.request.within, Runs(study)
    if not 0 < within < 1:
        raise SweepError(f"within is {within:g}, expected 0 < within < 1")
    asked = [g for g in ("target", "minimize", "maximize", "measured") if g in goals]
    if len(asked) != 1:
        raise SweepError(f"goals {', '.join(goals)}: expected one of target=, minimize=, maximize=, measured=")
    if "where" in goals and asked[0] not in ("minimize", "maximize"):
        raise SweepError("where= goes with minimize= or maximize=")
    if asked[0] == "measured":
        from identify import identify, read_measured
        measured = read_measured(goals["measured"], len(runs.names))
        return lambda: identify(runs, measured, within)
    if asked[0] == "target":
        targets = parse_targets(goals["target"])
        if len(targets) == 1 and len(runs.names) == 1:
            return lambda: one_target(runs, *next(iter(targets.items())), within)
        if len(targets) < len(runs.names):
            raise SweepError(f"target: {len(targets)} results for {len(runs.names)} unknowns, expected at least as many")
        return lambda: several_targets(runs, targets, within)
    constraints = parse_constraints(goals.get("where", ""))
    return lambda: least(runs, goals[asked[0]].strip(), 1 if asked[0] == "minimize" else -1, constraints, within)


def reach(study, goal):
    """Reaches the goal and prints it. @returns {"values": {unknown: text}, "told": [lines], ...} for the page"""
    answer = goal()
    print(", ".join(f"{n} = {t}" + answer.get("interval", {}).get(n, "") for n, t in answer["values"].items())
          + f": {'; '.join(answer['told'])}, {len(study.variants)} runs")
    return answer
