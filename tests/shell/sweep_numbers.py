"""What cases/sweep computes of its variants, against known functions: response surface, its error, Sobol indices, intervals."""
import contextlib
import hashlib
import io
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cases/sweep"))
from analysis import elementary_effects, scaled, sobol, surface_of  # noqa: E402
from identify import identify, intervals  # noqa: E402
from parquet import write_parquet  # noqa: E402
from solve import least_squares  # noqa: E402
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
if scaled([{"name": "w"}, {"name": "R"}], [{"w": "P1", "R": "1"}, {"w": "P1", "R": "3"}])[0] != ["R"]:
    wrong.append("a word that all variants share hides the numbers")

# elementary effects: of a plane exactly; of x_0 x_1 on trajectories of four levels those of the levels 0, 1/3, 2/3, 1; on a grid
walks = combinations(parse_vary(["a=2:4:morris", "b=0:1:morris"]), 400, 1)
walked = scaled([{"name": "a"}, {"name": "b"}], walks)[1]
if len(walks) != 1200:
    wrong.append(f"{len(walks)} points of 400 trajectories, expected 1200")
(mean, deviation, number), (second, *_) = elementary_effects(walked, walked @ [1.0, -2.0])
near("effect in a plane", mean, 1, 1e-4)
near("size of the other", second, 2, 1e-4)
near("scatter in a plane", deviation, 0, 1e-4)
mean, deviation, _ = elementary_effects(walked, walked[:, 0] * walked[:, 1])[0]
near("effect in a product", mean, 0.5, 0.05)
near("scatter in a product", deviation, np.sqrt(14 / 36 - 0.25), 0.05)
grid = np.array([[i / 2, j] for i in range(3) for j in range(2)])
if [e[2] for e in elementary_effects(grid, grid[:, 0])] != [4, 3] or elementary_effects(points, quadratic)[0][2] != 0:
    wrong.append("pairs of a grid, or of points at random")


def targets(true, scatter):
    """Residuals of two results about those at true, with what a mesh would scatter."""
    def at(z, s):
        return np.array([(1400 + 700 * z[0] + 250 * z[1] + 150 * z[0] * z[1] - 120 * z[0] ** 2) * (1 + s * np.sin(9e3 * z[0] + 4e3 * z[1])),
                         (560 + 480 * z[0] + 60 * z[1] + 80 * z[0] * z[1]) * (1 + s * np.sin(3e3 * z[0] - 7e3 * z[1] + 1))])
    wanted = at(true, 0)
    return lambda z: (at(np.asarray(z), scatter) - wanted) / wanted


# two targets within 1e-3 of results that scatter by 1e-3: differences of neighbors alone reach half of these
reached = 0
for true in generator.uniform(0.1, 0.9, (20, 2)):
    residual = targets(true, 1e-3)
    found = least_squares(lambda asked: [residual(z) for z in asked], 2, 1e-4, 1e-3)
    reached += np.abs(residual(found)).max() <= 1e-3
if reached < 18:
    wrong.append(f"targets of results that scatter: {reached} of 20 reached, expected 18 or more")

# a straight line by ten points: the intervals of a textbook
x = np.arange(10.0)
jacobian, residual = np.column_stack([np.ones(10), x]), np.tile([0.1, -0.1], 5)
half, _ = intervals(jacobian, residual, np.ones(2))
near("interval of a slope", half[1], 2.306004 * np.sqrt(0.1 / 8 / 82.5), 1e-6)



class Curves:
    """Runs of a curve of two unknowns, one of them with what meshes and steps scatter: 1 % of each part."""
    names, low, high = ["Y", "H"], np.array([100.0, 200.0]), np.array([400.0, 2000.0])

    def __init__(self, folder):
        self.folder = Path(folder)

    def texts(self, z):
        return dict(zip(self.names, (f"{v:.8g}" for v in self.low + np.clip(z, 0, 1) * (self.high - self.low))))

    def curve(self, t, Y, H, scatter):
        return Y * np.tanh(12 * t) * (1 + t) * (1 + scatter * np.sin(9 * Y + 0.7 * H + 40 * t)) + H * t ** 1.5 * (1 + scatter * np.sin(5 * Y - 0.9 * H + 30 * t))

    def folders(self, points):
        found = [self.folder / "-".join(self.texts(z).values()) for z in points]
        for place in found:
            if not place.exists():
                place.mkdir()
                t = np.linspace(0, 1, 101)
                table = np.column_stack([t, self.curve(t, *map(float, place.name.split("-")), 0.01)])
                np.savetxt(place / "history.csv", table, delimiter=",", header="t,force", comments="")
        return found


# the intervals of identifications from curves with noise of 2 % hold the true values: 95 % of the draws, less what runs scatter
held, draws = np.zeros(2), 30
with tempfile.TemporaryDirectory() as folder:
    curves, t = Curves(folder), np.linspace(0.04, 1, 25)
    exact = curves.curve(t, 230, 900, 0)
    for _ in range(draws):
        with contextlib.redirect_stdout(io.StringIO()):
            answer = identify(curves, {"t": t, "force": exact + generator.normal(0, 0.02 * exact.max(), 25)}, 1e-3)
        found = [float(answer["values"][n]) for n in curves.names]
        half = [float(answer["interval"][n].split()[1]) for n in curves.names]
        held += np.abs(np.array(found) - [230, 900]) <= half
if held.min() < 23:
    wrong.append(f"intervals: {held} of {draws} hold the true values, expected 23 or more")

drawn = combinations(parse_vary(["R=5:15:latin", "mu=0.1,0.2", "E=1:100:3:log"]), 3, 1)
if len(drawn) != 18 or sorted({int(3 * (float(v["R"]) - 5) / 10) for v in drawn}) != [0, 1, 2] or {v["E"] for v in drawn} != {"1", "10", "100"}:
    wrong.append(f"values of a hypercube: {drawn}")

# These bytes were read by DuckDB, by Arrow and by hyparquet: 19 rows, numbers in R and depth, texts, 9 and 18 nulls.
table = [{"R": "14", "law": "j2", "depth": 0.25}, {"R": "16.5", "law": "\u00e9", "depth": ""}] * 9 + [{"R": "20", "reason": "exit code 3"}]
with tempfile.TemporaryDirectory() as place:
    write_parquet(f"{place}/table", ["R", "law", "depth", "reason"], table)
    digest = hashlib.sha256(Path(f"{place}/table").read_bytes()).hexdigest()
if digest != "57089a81ee7d03ee83b623005fb07c62f999de517153002d10c0350bbf7f1e7d":
    wrong.append(f"Parquet file: {digest}")

print(*wrong, f"{len(wrong)} wrong", sep="\n")
sys.exit(bool(wrong))
