"""Least squares with runs in the place of a function: Gauss-Newton by differences of neighbors (scipy.optimize.least_squares), and where
what meshes and steps scatter hides these, by a plane through the runs about the best one.
"""
import numpy as np
from values import Failed

STEP = 0.01       # of a difference, over the range
WIDE = 0.05       # of one to both sides, which outweighs what runs scatter
POLISHES = 4
ROUNDS = 12       # planes
APART = 1e-3      # points nearer to each other tell one plane nothing more
NEAR = 0.07       # distance from which the curvature of results counts more than what they scatter
LONGEST = 0.15    # way from the best point
BESIDE = 0.02     # way of a point that is taken where the plane leads to one that is known


class Enough(Exception):
    """Residuals within what is allowed; z: where."""


def differences(many, z, here):
    """Jacobian by one-sided differences, all runs side by side; many(points): rows of numbers, None where a run failed."""
    steps = [STEP if x + STEP <= 1 else -STEP for x in z]
    points = [np.array(z) + s * np.eye(len(z))[k] for k, s in enumerate(steps)]
    rows = many(points)
    if here is None or any(r is None for r in rows):
        raise Failed("runs beside the last point failed; expected other ranges")
    return np.column_stack([(r - here) / s for r, s in zip(rows, steps)])


def wide_differences(many, z):
    """The same by differences to both sides."""
    z = np.asarray(z, float)
    ends = [np.clip(z + side * WIDE * unit, 0, 1) for unit in np.eye(len(z)) for side in (-1, 1)]
    rows = many(ends)
    if any(r is None for r in rows):
        raise Failed("runs beside the last point failed; expected other ranges")
    return np.column_stack([(rows[2 * k + 1] - rows[2 * k]) / (ends[2 * k + 1][k] - ends[2 * k][k]) for k in range(len(z))])


def polished(many, z):
    """Gauss-Newton by wide differences as long as the residual falls. @returns z, residual, Jacobian"""
    residual = many([z])[0]
    for _ in range(POLISHES):
        jacobian = wide_differences(many, z)
        further = np.clip(z - np.linalg.lstsq(jacobian, residual, rcond=None)[0], 0, 1)
        row = many([further])[0]
        if row is None or not np.linalg.norm(row) < np.linalg.norm(residual):
            break
        z, residual = further, row
    return z, residual, jacobian


def least_squares(many, dimension, tolerance, enough=0.0):
    """Gauss-Newton from the best of some points; many: rows of residuals, None where a run failed; enough: residuals that end it.
    @returns z of the least residual"""
    from scipy import optimize
    from scipy.stats import qmc
    points = [np.full(dimension, 0.5), *qmc.LatinHypercube(dimension, seed=1).random(2 * dimension)]
    known = []

    def look(asked):
        rows = many(asked)
        known.extend((r, np.array(z)) for r, z in zip(rows, asked) if r is not None)
        for r, z in known[-len(asked):] if enough else ():
            if (np.abs(r) <= enough).all():
                raise Enough(z)
        return rows

    def residual(z):
        row = look([z])[0]
        return np.full_like(known[0][0], bad) if row is None else row

    try:
        look(points)
        if not known:
            raise Failed("all runs failed")
        bad = 10 * max(np.linalg.norm(r) for r, _ in known) + 1
        optimize.least_squares(residual, np.clip(best_of(known)[1], 0.02, 0.98), jac=lambda z: differences(look, z, look([z])[0]), bounds=(0, 1),
                               ftol=tolerance, xtol=tolerance, gtol=1e-10, max_nfev=25)
        if enough:
            by_planes(look, known, dimension)
        return best_of(known)[1]
    except Enough as found:
        return found.args[0]


def best_of(known):
    return min(known, key=lambda pair: np.linalg.norm(pair[0]))


def by_planes(look, known, dimension):
    """Goes on from the best of the known (residuals, z) until look raises Enough, or for ROUNDS points."""
    for turn in range(ROUNDS):
        row, z = best_of(known)
        rows, places = [row], [z]
        for r, p in sorted(known, key=lambda pair: np.linalg.norm(pair[1] - z)):
            if all(np.linalg.norm(p - q) > APART for q in places):
                rows.append(r)
                places.append(p)
        ways = np.array(places) - z
        weight = 1 / (1 + (np.linalg.norm(ways, axis=1) / NEAR) ** 4)
        plane = np.linalg.lstsq(weight[:, None] * np.column_stack([np.ones(len(ways)), ways]), weight[:, None] * np.array(rows), rcond=None)[0]
        step = -np.linalg.lstsq(plane[1:].T, plane[0], rcond=None)[0]
        step *= min(1, LONGEST / max(np.linalg.norm(step), 1e-12))
        target = np.clip(z + step, 0, 1)
        if min(np.linalg.norm(target - p) for p in places) < APART:
            target = np.clip(z + BESIDE * np.cos(2.4 * turn + np.pi / 2 * np.arange(dimension)), 0, 1)
        look([target])
