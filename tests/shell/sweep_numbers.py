"""What cases/sweep computes of its variants, against known functions: response surface, its error, Sobol indices, intervals."""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cases/sweep"))
from analysis import scaled, sobol, surface_of  # noqa: E402
from identify import intervals  # noqa: E402
from values import combinations, parse_vary  # noqa: E402

wrong = []


def near(what, value, expected, tolerance):
    if not abs(value - expected) <= tolerance:
        wrong.append(f"{what}: {value:.6g}, expected {expected:.6g} within {tolerance:g}")


def ishigami(z):
    x = np.pi * (2 * z - 1)
    return np.sin(x[:, 0]) + 7 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


# Ishigami's function, a = 7, b = 0.1: Saltelli et al. 2008
first, total = sobol(ishigami, 3)
for k, (s, t) in enumerate(((0.3139, 0.5576), (0.4424, 0.4424), (0.0, 0.2437))):
    near(f"first order index {k}", first[k], s, 0.01)
    near(f"total index {k}", total[k], t, 0.01)

generator = np.random.default_rng(1)
points = generator.random((30, 2))
quadratic = 1 + 2 * points[:, 0] - 3 * points[:, 1] * points[:, 0] + points[:, 1] ** 2
surface = surface_of(points, quadratic)
near("surface of a quadratic function", surface.error, 0, 1e-12)
near("between its points", surface.predict(np.array([[0.3, 0.7]]))[0], 1 + 0.6 - 0.63 + 0.49, 1e-12)
# y = x_0 + 2 x_1: variances 1/12 and 4/12
first, total = sobol(surface_of(points, points @ [1.0, 2.0]).predict, 2)
near("index of a plane", first[0], 0.2, 0.005)
near("total index of a plane", total[1], 0.8, 0.005)
# a quadratic function with noise of 0.1: the error of a point left out is a little more than the noise
many = generator.random((200, 2))
noisy = surface_of(many, 5 * many[:, 0] ** 2 + many[:, 1] + generator.normal(0, 0.1, 200))
near("error with noise of 0.1", noisy.error, 0.1, 0.015)
near("share of the variance", noisy.share, 1 - 0.01 / np.var(5 * many[:, 0] ** 2 + many[:, 1]), 0.01)
# what no polynomial is: the error that is told against that at other points
wavy = lambda x: np.sin(4 * x[:, 0]) * np.exp(x[:, 1])  # noqa: E731
surface, other = surface_of(points, wavy(points)), generator.random((2000, 2))
real = np.sqrt(np.mean((surface.predict(other) - wavy(other)) ** 2))
if not 0.4 * real < surface.error < 2.5 * real:
    wrong.append(f"error of {surface.kind}: told {surface.error:.3g}, measured {real:.3g}")
if surface_of(points, np.full(30, 2.0)) is not None or surface_of(points[:2], [1, 2]) is not None:
    wrong.append("a surface of a constant, or of two points")
if scaled([{"name": "w", "spacing": ""}], [{"w": "P1"}, {"w": "P2"}]) is not None:
    wrong.append("words taken as numbers")

# a straight line by ten points: the intervals of a textbook
x = np.arange(10.0)
jacobian, residual = np.column_stack([np.ones(10), x]), np.tile([0.1, -0.1], 5)
half, _ = intervals(jacobian, residual, np.ones(2))
near("interval of a slope", half[1], 2.306004 * np.sqrt(0.1 / 8 / 82.5), 1e-6)

drawn = combinations(parse_vary(["R=5:15:latin", "mu=0.1,0.2", "E=1:100:3:log"]), 3, 1)
if len(drawn) != 18 or sorted({int(3 * (float(v["R"]) - 5) / 10) for v in drawn}) != [0, 1, 2] or {v["E"] for v in drawn} != {"1", "10", "100"}:
    wrong.append(f"values of a hypercube: {drawn}")

print(*wrong, f"{len(wrong)} wrong", sep="\n")
sys.exit(bool(wrong))
