"""The values of what a sweep varies. For each option one of
  name=a,b,c              numbers or words
  name=first:last:number  equally spaced;  first:last:number:log: equal ratios
  name=first:last:random  -samples points drawn at random;  first:last:latin: a Latin hypercube of -samples points
  name=first:last:morris  -samples trajectories: from a point at random one option after the other moves by 2/3 of its range
  name=first:last         an unknown between these ends, which a goal finds (goal.py)
Listed and spaced options are combined, each with each. Those that are drawn form one set of points, which every combination of the
others gets; -seed makes another set.
"""
import itertools
import math
import re

WORD = re.compile(r"[A-Za-z0-9_.+-]+")
DRAWN = ("random", "latin", "morris")


class SweepError(Exception):
    """What is wrong with the request."""


class Failed(Exception):
    """A goal that is not reached, or a run that it cannot do without."""


def to_number(text, where):
    try:
        value = float(text)
    except ValueError:
        raise SweepError(f"{where}: \"{text}\" is not a number") from None
    if not math.isfinite(value):
        raise SweepError(f"{where}: \"{text}\" is not finite")
    return value


def whole(text, where, least, most):
    number = to_number(text, where)
    if number != int(number) or not least <= number <= most:
        raise SweepError(f"{where}: \"{text}\", expected a whole number from {least} to {most}")
    return int(number)


def spaced(parts, where):
    """first:last:number[:log] -> the values as texts."""
    if len(parts) not in (3, 4) or len(parts) == 4 and parts[3] != "log":
        raise SweepError(f"{where}: \"{':'.join(parts)}\" has {len(parts)} parts, expected first:last:number, "
                         "first:last:number:log, first:last:random, first:last:latin or first:last:morris")
    first, last = to_number(parts[0], where), to_number(parts[1], where)
    count = whole(parts[2], where, 2, 10000)
    if len(parts) == 3:
        return [f"{first + (last - first) * i / (count - 1):.10g}" for i in range(count)]
    if not first * last > 0:
        raise SweepError(f"{where}: {parts[0]} and {parts[1]} with log, expected two numbers of one sign, not zero")
    return [f"{first * (last / first) ** (i / (count - 1)):.6g}" for i in range(count)]


def plain(text):
    """Numbers in one way of writing, so that 14e-3 and 0.014 are the same variant; words as they are."""
    try:
        value = float(text)
    except ValueError:
        return text
    return f"{value:.10g}" if math.isfinite(value) else text


def ascending(parts, where):
    first, last = to_number(parts[0], where), to_number(parts[1], where)
    if not last > first:
        raise SweepError(f"{where}: {parts[0]} to {parts[1]}, expected an ascending range")
    return first, last


def parse_one(values, where):
    """List of values, or (kind, first, last) of an option that is drawn, kind "unknown" of one that a goal finds."""
    parts = values.split(":")
    if len(parts) == 2:
        return ("unknown", *ascending(parts, where))
    if len(parts) == 3 and parts[2] in DRAWN:
        return (parts[2], *ascending(parts, where))
    listed = spaced(parts, where) if ":" in values else [plain(v) for v in values.split(",")]
    for value in listed:
        if not WORD.fullmatch(value):
            raise SweepError(f"{where}: \"{value}\" is not a value, expected numbers or words with commas")
    if len(set(listed)) != len(listed):
        raise SweepError(f"{where} has a value twice: {', '.join(listed)}")
    return listed


def parse_vary(words, forbidden=()):
    """["R=1:2:3", "mu=0.1:0.4:latin"] -> {"R": ["1", "1.5", "2"], "mu": ("latin", 0.1, 0.4)}"""
    vary = {}
    for word in words:
        name, equals, values = word.partition("=")
        if not equals or not name or not values:
            raise SweepError(f"\"{word}\" is not name=values, such as R=10:20:5 or mu=0.1,0.2")
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9]*", name):
            raise SweepError(f"\"{name}\" is not the name of an option (without its dash)")
        if name in vary:
            raise SweepError(f"{name} is given twice")
        if name in forbidden:
            raise SweepError(f"{name} cannot be varied")
        vary[name] = parse_one(values, name)
    ways = {v[0]: n for n, v in vary.items() if v[0] in DRAWN}
    if "morris" in ways and len(ways) > 1:
        other = next(n for kind, n in ways.items() if kind != "morris")
        raise SweepError(f"{ways['morris']} is drawn by morris and {other} is not, expected one way for all that are drawn")
    return vary


def trajectories(dimension, count, generator):
    """Points between 0 and 1, dimension + 1 for each trajectory: Morris 1991, four levels."""
    import numpy as np
    points = []
    for _ in range(count):
        up = generator.integers(0, 2, dimension) == 1
        at = generator.integers(0, 2, dimension) / 3 + np.where(up, 0, 2 / 3)
        points.append(at.copy())
        for k in generator.permutation(dimension):
            at[k] += 2 / 3 if up[k] else -2 / 3
            points.append(at.copy())
    return np.array(points)


def drawn_points(drawn, samples, seed):
    """[{name: text}], points of the options that are drawn; one empty point if there are none."""
    if not drawn:
        return [{}]
    morris = [n for n, (kind, *_) in drawn.items() if kind == "morris"]
    try:
        import numpy as np
        from scipy.stats import qmc
    except ImportError as error:
        raise SweepError(f"{error}; random, latin and morris need the Debian package python3-scipy") from None
    generator = np.random.default_rng(seed)
    latin = [n for n, (kind, *_) in drawn.items() if kind == "latin"]
    hypercube = iter(qmc.LatinHypercube(len(latin), seed=generator).random(samples).T) if latin else None
    path = iter(trajectories(len(morris), samples, generator).T) if morris else None
    column = {n: next(path) if morris else next(hypercube) if n in latin else generator.random(samples) for n in drawn}
    return [{n: f"{first + (last - first) * column[n][i]:.6g}" for n, (_, first, last) in drawn.items()}
            for i in range(len(next(iter(column.values()))))]


def combinations(vary, samples, seed):
    """[{name: text}] in the order of the options, the first one slowest."""
    lists = {n: v for n, v in vary.items() if isinstance(v, list)}
    drawn = {n: v for n, v in vary.items() if n not in lists}
    points = drawn_points(drawn, samples, seed)
    made = [{**dict(zip(lists, values)), **point} for values in itertools.product(*lists.values()) for point in points]
    return [{n: one[n] for n in vary} for one in made]
