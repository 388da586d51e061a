"""The values of VARY. For each option one of
  name=a,b,c              numbers or words
  name=first:last:number  equally spaced;  first:last:number:log: equal ratios
  name=first:last:random  SAMPLES points drawn at random;  first:last:latin: a Latin hypercube of SAMPLES points
Listed and spaced options are combined, each with each. Those that are drawn form one set of SAMPLES points, which every
combination of the others gets; SEED makes another set.
"""
import itertools
import math
import os
import re

WORD = re.compile(r"[A-Za-z0-9_.+-]+")
DRAWN = ("random", "latin")


class SweepError(Exception):
    """What is wrong with the request."""


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
        raise SweepError(f"{where}: \"{text}\" values, expected a whole number from {least} to {most}")
    return int(number)


def spaced(parts, where):
    """first:last:number[:log] -> the values as texts."""
    if len(parts) not in (3, 4) or len(parts) == 4 and parts[3] != "log":
        raise SweepError(f"{where}: \"{':'.join(parts)}\" has {len(parts)} parts, expected first:last:number, "
                         "first:last:number:log, first:last:random or first:last:latin")
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


def parse_one(values, where):
    """List of values, or (kind, first, last) of an option that is drawn."""
    parts = values.split(":")
    if len(parts) == 3 and parts[2] in DRAWN:
        first, last = to_number(parts[0], where), to_number(parts[1], where)
        if not last > first:
            raise SweepError(f"{where}: {parts[0]} to {parts[1]}, expected an ascending range")
        return parts[2], first, last
    listed = spaced(parts, where) if ":" in values else [plain(v) for v in values.split(",")]
    for value in listed:
        if not WORD.fullmatch(value):
            raise SweepError(f"{where}: \"{value}\" is not a value, expected numbers or words with commas")
    if len(set(listed)) != len(listed):
        raise SweepError(f"{where} has a value twice: {', '.join(listed)}")
    return listed


def parse_vary(text, forbidden=()):
    """ "R=1:2:3 mu=0.1:0.4:latin" -> {"R": ["1", "1.5", "2"], "mu": ("latin", 0.1, 0.4)} """
    vary = {}
    for part in text.split():
        name, equals, values = part.partition("=")
        if not equals or not name or not values:
            raise SweepError(f"VARY: \"{part}\" is not name=values, such as R=10e-3:20e-3:5 or mu=0.1,0.2")
        where = f"VARY: {name}"
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9]*", name):
            raise SweepError(f"VARY: \"{name}\" is not the name of an option (without its dash)")
        if name in vary:
            raise SweepError(f"{where} is given twice")
        if name in forbidden:
            raise SweepError(f"{where} cannot be varied")
        vary[name] = parse_one(values, where)
    if not vary:
        raise SweepError('VARY is empty, expected for example VARY="R=10e-3:20e-3:5 mu=0.1,0.2"')
    return vary


def drawn_points(drawn, samples, seed):
    """[{name: text}], SAMPLES points of the options that are drawn; one empty point if there are none."""
    if not drawn:
        return [{}]
    try:
        import numpy as np
        from scipy.stats import qmc
    except ImportError as error:
        raise SweepError(f"{error}; random and latin need the Debian package python3-scipy") from None
    generator = np.random.default_rng(seed)
    latin = [n for n, (kind, *_) in drawn.items() if kind == "latin"]
    hypercube = iter(qmc.LatinHypercube(len(latin), seed=generator).random(samples).T) if latin else None
    column = {n: next(hypercube) if n in latin else generator.random(samples) for n in drawn}
    return [{n: f"{first + (last - first) * column[n][i]:.6g}" for n, (_, first, last) in drawn.items()}
            for i in range(samples)]


def combinations(vary):
    """[{name: text}] in the order of the options, the first one slowest."""
    lists = {n: v for n, v in vary.items() if isinstance(v, list)}
    drawn = {n: v for n, v in vary.items() if n not in lists}
    samples = whole(os.environ.get("SAMPLES") or "20", "SAMPLES", 2, 10000) if drawn else 0
    seed = whole(os.environ.get("SEED") or "1", "SEED", 0, 2 ** 31)
    points = drawn_points(drawn, samples, seed)
    made = [{**dict(zip(lists, values)), **point} for values in itertools.product(*lists.values()) for point in points]
    return [{n: one[n] for n in vary} for one in made]
