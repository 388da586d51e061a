"""What a run of CalculiX has printed, by time: place and forces of the tool, stress and plastic strain in the points of the plane.

Nodal forces are integrated from the stresses, so that pressures are forces over lengths as in the chart's scripts; fields go to the
nodes by a linear fit over the points around each, as M.nodal does it.
"""
import re

import numpy as np
from matplotlib.tri import LinearTriInterpolator, Triangulation

HEAD = re.compile(r"^\s*(displacements|forces|stresses|equivalent plastic strain)\b.*for set (\S+) and time\s+(\S+)")
# points of C3D6 and, of one layer, C3D15, as coordinates in the triangle
POINTS = {3: np.array([[1, 1, 1]]) / 3, 6: np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4]]) / 6}
LEAST = 1e-3    # of the largest nodal force: below it there is no contact


def read(path):
    """{time: {(quantity, set): rows}}"""
    blocks, rows = {}, None
    with open(path) as f:
        for line in f:
            head = HEAD.match(line)
            if head:
                rows = blocks.setdefault(float(head[3]), {}).setdefault((head[1].split()[-1], head[2]), [])
            elif "and time" in line:
                rows = None
            elif rows is not None and line.strip():
                rows.append([float(word) for word in line.split()])
    return {t: {key: np.array(rows) for key, rows in block.items()} for t, block in blocks.items()}


def shapes(mesh):
    """Shape functions and their derivatives by the first two coordinates of a triangle, in its points."""
    for L in POINTS[len(mesh.elements[0])]:
        d = np.array([[1, 0], [0, 1], [-1, -1]])                     # of the coordinates in the triangle
        if len(mesh.elements[0]) == 3:
            yield L, d
        else:
            pairs = ((0, 1), (1, 2), (2, 0))
            yield (np.array([*(l * (2 * l - 1) for l in L), *(4 * L[i] * L[j] for i, j in pairs)]),
                   np.array([*((4 * L[i] - 1) * d[i] for i in range(3)), *(4 * (L[i] * d[j] + L[j] * d[i]) for i, j in pairs)]))


class State:
    """One instant."""

    def __init__(self, mesh, block, deformed):
        self.mesh, self.place, self.turn = mesh, block["displacements", "PLACE"][0, 1:], block["displacements", "TURN"][0, 1:]
        self.force = block["forces", "PLACE"][0, 1:]
        number, layers = len(mesh.elements), 2 if len(mesh.elements[0]) == 3 else 3
        kept = len(POINTS[len(mesh.elements[0])])

        def plane(rows):
            return rows[:, 2:].reshape(number, layers * kept, -1)[:, :kept]
        self.stress = plane(block["stresses", "BODY"])
        self.strain = plane(block["strain", "BODY"])[:, :, 0] if ("strain", "BODY") in block else np.zeros((number, kept))
        self.xy = mesh.xy + block["displacements", "FRONT"][:, 1:3] if deformed else mesh.xy
        xx, yy, zz, xy = np.moveaxis(self.stress[:, :, :4], 2, 0)
        self.mises = np.sqrt(((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) / 2 + 3 * xy**2)

    def weights(self, xy):
        """Of the points: part of the area; derivatives of the shape functions by x, y."""
        for N, dN in shapes(self.mesh):
            J = np.einsum("eai,aj->eij", xy[self.mesh.elements], dN)
            yield N, np.linalg.det(J) / 2 / len(POINTS[len(dN)]), np.einsum("aj,eji->eai", dN, np.linalg.inv(J))

    def forces(self):
        """Nodal forces of the body on what holds it, per thickness."""
        F = np.zeros_like(self.xy)
        for k, (_, area, gradient) in enumerate(self.weights(self.xy)):
            s = self.stress[:, k]
            sigma = np.stack([s[:, [0, 3]], s[:, [3, 1]]], axis=1)
            np.add.at(F, self.mesh.elements, np.einsum("e,eij,eaj->eai", area, sigma, gradient))
        return F

    def percentile(self, values, least):
        """Value below which 99 % of the volume lies where it exceeds the least."""
        areas = np.stack([a for _, a, _ in self.weights(self.mesh.xy)], axis=1)
        chosen = values > least
        order = np.argsort(values[chosen])
        below = np.cumsum(areas[chosen][order])
        return values[chosen][order][np.searchsorted(below, 0.99 * below[-1])] if len(below) else 0.0

    def nodal(self, values):
        """Linear fit over the points of the elements at every corner, within their least and largest value."""
        mesh = self.mesh
        points = np.stack([np.einsum("a,eai->ei", N, mesh.xy[mesh.elements]) for N, _, _ in self.weights(mesh.xy)], axis=1)
        around, found = [[] for _ in range(mesh.corners)], np.zeros(mesh.corners)
        for e, corners in enumerate(mesh.elements[:, :3]):
            for c in corners:
                around[c].append(e)
        for c, patch in enumerate(around):
            v, r = values[patch].ravel(), points[patch].reshape(-1, 2) - mesh.xy[c]
            r = np.column_stack([np.ones(len(v)), r / np.abs(r).max()])
            flat = len(v) < 4 or np.linalg.cond(r) > 1e4
            found[c] = v.mean() if flat else np.clip(np.linalg.lstsq(r, v, rcond=None)[0][0], v.min(), v.max())
        return found

    def mean(self, values):
        """Mean over the elements at every corner, weighted by its linear shape function."""
        total, weight = np.zeros(self.mesh.corners), np.zeros(self.mesh.corners)
        for k, (_, area, _) in enumerate(self.weights(self.mesh.xy)):
            for c, share in enumerate(POINTS[len(self.mesh.elements[0])][k]):
                np.add.at(total, self.mesh.elements[:, c], share * area * values[:, k])
                np.add.at(weight, self.mesh.elements[:, c], share * area)
        return total / weight

    def at(self, values, x, y):
        """Values at the corners as a linear function at places of the undeformed mesh."""
        mesh = Triangulation(*self.mesh.xy[:self.mesh.corners].T, self.mesh.elements[:, :3])
        return np.asarray(LinearTriInterpolator(mesh, values)(x, y))


def pressures(N, length, quadratic):
    """Of the nodes of a surface in their order, a vertex first: forces over tributary lengths; quadratic: linear on every edge, of
    forces shared to the vertices in contact (METHOD.md 3.20)."""
    if not quadratic:
        return N / length
    corner, alone = N[::2] > 0, (N[1::2] > 0) & (N[:-1:2] <= 0) & (N[2::2] <= 0)
    corner[:-1] |= alone
    corner[1:] |= alone
    share, area, p = N[::2].copy(), length[::2].copy(), np.zeros(len(N))
    for side in (slice(None, -1), slice(1, None)):
        share[side] += np.where(corner[:-1] & corner[1:], 0.5, 1) * N[1::2]
        area[side] += length[1::2] / 2
    p[::2] = np.where(corner, share / area, 0)
    p[1::2] = (p[:-1:2] + p[2::2]) / 2
    return p


def lengths(mesh, label):
    """Tributary lengths of the nodes of a label, by node."""
    found = {}
    for nodes in mesh.edge_nodes(label):
        length = np.hypot(*(mesh.xy[nodes[1]] - mesh.xy[nodes[0]]))
        for n, part in zip(nodes, (1 / 2, 1 / 2) if len(nodes) == 2 else (1 / 6, 1 / 6, 2 / 3)):
            found[n] = found.get(n, 0) + part * length
    return found
