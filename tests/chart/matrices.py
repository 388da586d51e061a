"""Matrices of the methods on small meshes: condition number, symmetry, inertia, zeros on the diagonal.

The matrix is the last one that the method solved, as handed to the solver, without the rows and columns that say nothing: given
displacements and coordinates, and multipliers of nodes out of contact (rows with nothing but a diagonal, or a diagonal above
GIVEN). Condition number: largest over smallest singular value, dense (numpy.linalg.svd), of the matrix as it is and after
scaling rows and columns to a largest entry of 1 (Ruiz's iteration). Negative: number of negative eigenvalues of the symmetric
part. Mesh: the same problem in a block of BLOCK half-widths.
"""
import os
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
GIVEN = 1e25
BLOCK = "1"
MESHES = {"P1": [2, 3, 4, 6, 8], "P2": [2, 3]}
FACTORS = [1, 10, 100, 1000, 1e4, 1e5]


def read(path):
    with open(path) as f:
        size = int(f.readline())
        entries = np.loadtxt(f, ndmin=2)
    A = np.zeros((size, size))
    np.add.at(A, (entries[:, 0].astype(int), entries[:, 1].astype(int)), entries[:, 2])
    return A


def essential(A):
    """A without rows and columns of what is given."""
    off = np.abs(A - np.diag(np.diag(A)))
    keep = ((off.max(axis=1) > 0) | (off.max(axis=0) > 0)) & (np.abs(np.diag(A)) < GIVEN)
    return A[np.ix_(keep, keep)]


def scaled(A):
    for _ in range(30):
        rows, columns = np.sqrt(np.abs(A).max(axis=1)), np.sqrt(np.abs(A).max(axis=0))
        A = A / rows[:, None] / columns[None, :]
    return A


def condition(A):
    values = np.linalg.svd(A, compute_uv=False)
    return values[0] / values[-1]


def measure(A):
    A = essential(A)
    largest = np.abs(A).max()
    symmetric = (A + A.T) / 2
    return {"size": len(A), "condition": condition(A), "condition_scaled": condition(scaled(A)),
            "asymmetry": np.abs(A - A.T).max() / largest,
            "zero_diagonal": int((np.abs(np.diag(A)) < 1e-14 * largest).sum()),
            "negative": int((np.linalg.eigvalsh(scaled(symmetric)) < 0).sum())}


def look(scene, methods, quick, folder):
    """Rows of all methods over mesh and penalty factor; own: with the factor that the chart uses."""
    file, rows = os.path.abspath(os.path.join(folder, "matrix.txt")), []

    def one(method, element, n, options, factor, own):
        command = [os.environ["BURNISH"], os.path.join(HERE, scene["name"] + ".edp"), *method["options"], *options,
                   "-element", element, "-n", str(n), "-block", BLOCK, "-matrix", file]
        done = subprocess.run(command, capture_output=True, text=True, errors="replace")
        if done.returncode != 0:
            sys.exit(f"chart: exit status {done.returncode} of {' '.join(command)}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        rows.append({"method": method["name"], "element": element, "n": n, "factor": factor, "own": own, **measure(read(file))})

    for method in methods:
        takes_factor = "-factor" in method["options"]
        own = method["options"][method["options"].index("-factor") + 1] if takes_factor else ""
        for element in ["P1"] if quick else ["P1", "P2"]:
            for n in MESHES[element][:3] if quick else MESHES[element]:
                one(method, element, n, [], own, True)
        for factor in FACTORS[::2 if quick else 1] if takes_factor else []:
            if f"{factor:g}" != own:
                one(method, "P1", MESHES["P1"][1], ["-factor", str(factor)], f"{factor:g}", False)
    if os.path.exists(file):
        os.remove(file)
    return rows
