"""Unknowns from a measured curve: burnish sweep press.edp measured=curve.csv sigY=100:300 H=200:2000

The file has columns named as in history.csv; the first one is what the others are read against, t or a column that grows during a run.
Least squares by Gauss-Newton (scipy.optimize.least_squares), at the end by wide differences; each column counts over its largest measured value. Confidence: the
covariance s^2 (J^T J)^-1 with s^2 the sum of squares over the degrees of freedom, and the 95 % interval of Student's t: of what the
measured points scatter, not of what the model lacks.
"""
import csv
import os

import numpy as np
from goal import answer_of
from solve import least_squares, polished
from values import Failed, SweepError

CONFIDENCE = 0.95


def read_table(path):
    """{column: array} of a file with a line of names."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            rows = [[cell.strip() for cell in row] for row in csv.reader(file) if row and not row[0].startswith("#")]
        table = np.array(rows[1:], float)
        return dict(zip(rows[0], table.T.reshape(len(rows[0]), -1)))
    except (OSError, ValueError, IndexError) as error:
        raise SweepError(f"{path}: {error}; expected numbers with commas below a line of names") from None


def read_measured(path, unknowns):
    table = read_table(path)
    count = len(next(iter(table.values()))) * (len(table) - 1)
    if len(table) < 2 or count <= unknowns:
        raise SweepError(f"{path}: {count} measured values for {unknowns} unknowns, expected more, in columns after the first")
    if not all(np.isfinite(v).all() for v in table.values()):
        raise SweepError(f"{path}: a value is not finite")
    return table


def simulated(folder, measured):
    """Residuals of a run at the measured places, columns one after the other, over the largest measured value of each."""
    history = read_table(os.path.join(folder, "history.csv"))
    against, *columns = measured
    for name in measured:
        if name not in history:
            raise SweepError(f"measured: no column \"{name}\" in history.csv; there are: {', '.join(history)}")
    x = history[against]
    if not (np.diff(x) >= 0).all() or not x[-1] > x[0]:
        raise SweepError(f"measured: {against} does not grow all the way in {folder}/history.csv, expected another first column")
    if measured[against].max() > x[-1] + 1e-9 * abs(x[-1]) and against == "t":
        raise SweepError(f"measured: t to {measured[against].max():g}, the run goes to {x[-1]:g}")
    return np.concatenate([(np.interp(measured[against], x, history[c]) - measured[c]) / (np.abs(measured[c]).max() or 1.0) for c in columns])


def intervals(jacobian, residual, width):
    """(half widths of the intervals, correlations) of the unknowns; width: of their ranges."""
    from scipy.stats import t
    freedom = len(residual) - jacobian.shape[1]
    if np.linalg.matrix_rank(jacobian) < jacobian.shape[1]:
        raise Failed("the measured curve does not tell the unknowns apart; expected fewer of them")
    inverse = np.linalg.inv(jacobian.T @ jacobian)
    deviation = np.sqrt(np.diag(inverse))
    scatter = np.sqrt(residual @ residual / freedom)
    return t.ppf(0.5 + 0.5 * CONFIDENCE, freedom) * scatter * deviation * width, inverse / np.outer(deviation, deviation)


def identify(runs, measured, within):
    """measured: as read_measured gives it. @returns the answer with "interval" and "measured" besides"""
    seen = {}

    def many(points):
        new = [z for z in points if tuple(z) not in seen]
        for z, folder in zip(new, runs.folders(new)):
            seen[tuple(z)] = None if folder is None else simulated(folder, measured)
            told = "failed" if folder is None else f"rms {np.sqrt(np.mean(seen[tuple(z)] ** 2)):.3g} of the largest value"
            print("  " + ", ".join(f"{n} = {t}" for n, t in runs.texts(z).items()) + f": {told}", flush=True)
        return [seen[tuple(z)] for z in points]

    found, residual, jacobian = polished(many, least_squares(many, len(runs.names), 0.1 * within))
    half, correlation = intervals(jacobian, residual, runs.high - runs.low)
    rms = np.sqrt(np.mean(residual ** 2))
    told = [f"rms of {rms:.3g} of the largest measured value"]
    told += [f"correlation of {a} and {b} {correlation[i, j]:.2f}" for i, a in enumerate(runs.names) for j, b in enumerate(runs.names) if i < j]
    edge = [n for n, z in zip(runs.names, found) if min(z, 1 - z) < 1e-3]
    if edge:
        raise Failed(f"{' and '.join(edge)} at an end of the range, expected a wider one")
    answer = answer_of(runs, found, told)
    answer["interval"] = {n: f" +- {h:.2g}" for n, h in zip(runs.names, half)}
    answer["measured"] = {n: [float(f"{x:.6g}") for x in v] for n, v in measured.items()}
    return answer
