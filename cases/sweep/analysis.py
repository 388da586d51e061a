"""What the variants say of a result: response surface with its cross-validated error, sensitivity by Sobol indices of that surface and by
elementary effects of the variants themselves.

Points x are n rows of d parameters between 0 and 1 (their ranges, of first:last:number:log their logarithms), y are n results.
Surface: that of polynomials of degree 1, 2, 3 by least squares and thin-plate splines (scipy.interpolate.RBFInterpolator) whose error is
the least where each point is left out in turn (PRESS). share = 1 - PRESS/sum (y - mean)^2: of the variance that it predicts.
Sobol indices of the surface, parameters even between their ends: first order by Saltelli 2010, total by Jansen 1999, on a Sobol sequence
(scipy.stats.qmc). SciPy of Debian 12 has no sobol_indices, and SALib is no package of it.
Elementary effects, Morris 1991: change of the result over that of a parameter, over its range, from neighbors that differ in it alone.
"""
import itertools
from collections import namedtuple

import numpy as np

# kind in words, predict(points) -> values, rms of the errors where each point is left out, share of the variance predicted
Surface = namedtuple("Surface", "kind predict error share")
SPARE = 2            # points beyond the coefficients of a polynomial
MOST_SPLINE = 300    # points up to which splines are tried: each is left out once
LEVERAGE = 1 - 1e-9
ROUNDING = 1e-9      # of the largest result: errors below it are alike, and the simpler surface is taken
TRUSTED = 0.5        # share from which indices of the surface are told
POWER = 13           # 2^13 points of the Sobol sequence


def powers(dimension, degree):
    return [p for p in itertools.product(range(degree + 1), repeat=dimension) if sum(p) <= degree]


def monomials(x, exponents):
    return np.column_stack([np.prod(x ** np.array(p), axis=1) for p in exponents])


def polynomial(x, y, degree):
    """(predict, errors of the points left out), None where the points do not settle the coefficients."""
    exponents = powers(x.shape[1], degree)
    if len(y) < len(exponents) + SPARE:
        return None
    matrix = monomials(x, exponents)
    q, r = np.linalg.qr(matrix)
    if np.abs(np.diag(r)).min() < 1e-9 * np.abs(np.diag(r)).max():
        return None
    leverage = (q ** 2).sum(axis=1)
    if leverage.max() > LEVERAGE:
        return None
    coefficients = np.linalg.solve(r, q.T @ y)
    return lambda z: monomials(z, exponents) @ coefficients, (y - matrix @ coefficients) / (1 - leverage)


def spline(x, y):
    """The same of the thin-plate spline through all points; None where points coincide or are too few."""
    from scipy.interpolate import RBFInterpolator
    if not x.shape[1] + 2 <= len(y) <= MOST_SPLINE:
        return None
    try:
        left = np.array([RBFInterpolator(np.delete(x, i, 0), np.delete(y, i))(x[i:i + 1])[0] for i in range(len(y))])
        return RBFInterpolator(x, y), y - left
    except (np.linalg.LinAlgError, ValueError):
        return None


def surface_of(x, y):
    """The Surface of least error; None with fewer than three points or results that are all the same."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(y) < 3 or not np.ptp(y) > 1e-9 * np.abs(y).max():
        return None
    tried = [(f"polynomial of degree {k}", polynomial(x, y, k)) for k in (1, 2, 3)] + [("thin-plate spline", spline(x, y))]
    known = [(kind, *made) for kind, made in tried if made and np.isfinite(made[1]).all()]
    if not known:
        return None
    least = len(y) * (ROUNDING * np.abs(y).max()) ** 2
    kind, predict, errors = min(known, key=lambda found: max((found[2] ** 2).sum(), least))
    return Surface(kind, predict, np.sqrt(np.mean(errors ** 2)), 1 - (errors ** 2).sum() / ((y - y.mean()) ** 2).sum())


def sobol(predict, dimension, power=POWER, seed=1):
    """(first order, total) Sobol indices of a function of points between 0 and 1."""
    from scipy.stats import qmc
    sample = qmc.Sobol(2 * dimension, seed=seed).random_base2(power)
    a, b = sample[:, :dimension], sample[:, dimension:]
    at_a, at_b = predict(a), predict(b)
    variance = np.var(np.r_[at_a, at_b])
    first, total = np.empty(dimension), np.empty(dimension)
    for k in range(dimension):
        mixed = a.copy()
        mixed[:, k] = b[:, k]
        at_mixed = predict(mixed)
        first[k] = np.mean(at_b * (at_mixed - at_a)) / variance
        total[k] = 0.5 * np.mean((at_a - at_mixed) ** 2) / variance
    return first, total


def elementary_effects(x, y):
    """[(mean of the sizes, standard deviation, number)] of the effects of each parameter; number 0: no two points differ in it alone."""
    found = []
    for k in range(x.shape[1]):
        lines = {}
        for others, at, value in zip(np.round(np.delete(x, k, 1), 9), x[:, k], y):
            lines.setdefault(tuple(others), []).append((at, value))
        steps = [(a, b) for line in lines.values() for a, b in itertools.pairwise(sorted(line)) if b[0] > a[0]]
        effects = np.array([(b[1] - a[1]) / (b[0] - a[0]) for a, b in steps])
        found.append((np.abs(effects).mean(), effects.std(), len(effects)) if len(effects) else (np.nan, np.nan, 0))
    return found


def scaled(parameters, rows):
    """Points between 0 and 1 of the parameters that are numbers and change: (their names, points n x d, low, high); None without any,
    or where one is a word with more than one value."""
    names, columns, ends = [], [], []
    for p in parameters:
        if len({r[p["name"]] for r in rows}) < 2:
            continue
        try:
            column = np.array([float(r[p["name"]]) for r in rows])
        except ValueError:
            return None
        if np.ptp(column) > 0:
            low, high = column.min(), column.max()
            names.append(p["name"])
            ends.append((low, high))
            log = p.get("spacing") == "log"
            columns.append(np.log(column / low) / np.log(high / low) if log else (column - low) / (high - low))
    return (names, np.column_stack(columns), ends) if names else None


def value_at(end, fraction, spacing):
    """A parameter's value from its place between 0 and 1."""
    low, high = end
    return low * (high / low) ** fraction if spacing == "log" else low + (high - low) * fraction
