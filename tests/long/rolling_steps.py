"""Error of the length of the steps of example 1 at the quarters of the program:  python3 rolling_steps.py FOLDER
FOLDER has the runs of rolling-steps.sh, NAME, NAME-half, NAME-fine for each mesh, reference.   python3 rolling_steps.py FINE RUN...
prints the same table of any runs with -series 4. Depth, theta, Q_phi, 99th percentile of the plastic strain (by area, of what
is above 1e-4), its field in L2 (same mesh only): percent of the fine run, a number for every quarter."""
import os
import sys

import numpy as np
import meshio
from run import Checks, Run

QUARTERS = (0.25, 0.5, 0.75, 1.0)
FLOWED = 1e-4  # [-]


def percentile(values, weight, part):
    order = np.argsort(values)
    filled = np.cumsum(weight[order])
    return values[order][np.searchsorted(filled, part * filled[-1])]


class Fields:
    """Depth, rotation, torque and plastic strain at the quarters."""

    def __init__(self, folder):
        self.run = Run(folder)
        rows = {round(row["t"], 9): row for row in self.run.history}
        start = self.run.history[0]["r"]
        at = [rows[t] for t in QUARTERS]
        self.globals = np.array([[start - row["r"], row["theta"], row["Q_phi"]] for row in at]).T
        self.strain, self.weight = [], None
        for k in range(1, 5):
            mesh = meshio.read(os.path.join(folder, f"fields-{k}.vtu"))
            self.strain.append(np.asarray(mesh.point_data["plastic_strain_eq"]))
            if self.weight is None:
                self.weight = self.nodal_areas(mesh)
        self.p99 = np.array([percentile(e[e > FLOWED], self.weight[e > FLOWED], 0.99) for e in self.strain])

    @staticmethod
    def nodal_areas(mesh):
        triangles = np.vstack([c.data for c in mesh.cells if c.type == "triangle"])
        p = mesh.points[triangles]
        a, b = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
        area = 0.5 * np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
        weight = np.zeros(len(mesh.points))
        np.add.at(weight, triangles, (area / 3)[:, None])
        return weight

    def errors(self, reference):
        """Rows depth, theta, Q_phi, p99, L2 (NaN on another mesh) in percent; a column a quarter."""
        rows = list(100 * (self.globals / reference.globals - 1)) + [100 * (self.p99 / reference.p99 - 1)]
        same = len(self.weight) == len(reference.weight)
        field = [100 * np.sqrt(np.sum(self.weight * (mine - its) ** 2) / np.sum(self.weight * its ** 2)) if same else np.nan
                 for mine, its in zip(self.strain, reference.strain)]
        return np.array(rows + [field])


def cell(values):
    return " ".join(f"{v:6.2f}" for v in values)


def table(reference, runs):
    print(f"{'run':16s} steps fact iter  CPU s | {'depth':27s} | {'theta':27s} | {'Q_phi':27s} | {'p99':27s} | L2, all in %")
    for name, fields in runs:
        counts = fields.run.summary
        c, cpu = counts["counts"], counts["cpu_seconds"]["total"]
        print(f"{name:16s} {c['steps']:5} {c['factorizations']:4} {c['iterations']:5} {cpu:5.2f} | "
              + " | ".join(cell(row) for row in fields.errors(reference)))


def check(folder):
    checks = Checks()
    for mesh in ("default", "graded"):
        fine, half, run = (Fields(os.path.join(folder, mesh + kind)) for kind in ("-fine", "-half", ""))
        table(fine, [(mesh, run), (mesh + ", half", half)])
        errors, finer = run.errors(fine), half.errors(fine)
        order = np.log2(errors[4] / finer[4])
        print(f"{'':16s} observed order of the field: {cell(order)}")
        worst = np.abs(errors).max(axis=1)
        for name, value, allowed in zip(("depth", "theta", "Q_phi", "p99"), worst, (1, 1, 1, 3)):
            checks.that(f"{mesh}, {name}", value <= allowed, f"largest error at the quarters {value:.2f} %, allowed {allowed} %")
    runs = {name: Fields(os.path.join(folder, name)) for name in ("reference", "default", "graded", "graded-lean", "graded-least")}
    reference = runs.pop("reference")
    print("steps and mesh"), table(reference, runs.items())
    for mesh in ("graded", "graded-lean", "graded-least"):
        worst = np.abs(runs[mesh].errors(reference)).max(axis=1)
        for name, value, allowed in zip(("depth", "theta", "Q_phi", "p99"), worst, (1, 1, 1, 3.2)):
            checks.that(f"{mesh}, {name}", value <= allowed, f"steps and mesh: {value:.2f} % at the quarters, allowed {allowed} %")
    checks.done()


if __name__ == "__main__":
    if len(sys.argv) == 2:
        check(sys.argv[1])
    base = Fields(sys.argv[1])
    table(base, [(os.path.basename(f.rstrip("/")), Fields(f)) for f in sys.argv[2:]])
