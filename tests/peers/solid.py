"""Tetrahedra that FreeFEM has saved, with straight quadratic edges on request; forces at their nodes from stresses, pressures on their faces."""
import math

import numpy as np

EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))          # of C3D10, in its order
FACES = {1: (0, 1, 2), 2: (0, 1, 3), 3: (1, 2, 3), 4: (0, 2, 3)}   # of CalculiX
# points of a triangle and their weights, exact to degree 5: those of the chart's scripts
NEAR, FAR = (6 - math.sqrt(15)) / 21, (6 + math.sqrt(15)) / 21
POINTS = np.array([[1 / 3] * 3, *([1 - 2 * c if i == k else c for i in range(3)] for c in (NEAR, FAR) for k in range(3))])
WEIGHTS = np.array([9 / 40, *[(155 - math.sqrt(15)) / 1200] * 3, *[(155 + math.sqrt(15)) / 1200] * 3])
INNER = (5 + 3 * math.sqrt(5)) / 20     # of the four points of C3D10, its largest coordinate


class Solid:
    """xyz: nodes, corners first; elements: 4 or 10 nodes; faces: by label (element, number of its face, its corners); middles: of edges."""

    def __init__(self, path, quadratic):
        with open(path) as f:
            words = f.read().split()

        def block(name, width, kind):
            first = words.index(name) + 2
            return np.array(words[first:first + width * int(words[first - 1])], kind).reshape(-1, width)
        self.xyz = block("Vertices", 4, float)[:, :3]
        self.elements = block("Tetrahedra", 5, int)[:, :4] - 1
        labels = {frozenset(t[:3] - 1): t[3] for t in block("Triangles", 4, int)}
        self.faces, self.middles = {}, {}
        for e, t in enumerate(self.elements):
            for k, local in FACES.items():
                corners = [t[i] for i in local]
                if frozenset(corners) in labels:
                    self.faces.setdefault(labels[frozenset(corners)], []).append((e, k, corners))
        if quadratic:
            pairs = np.sort(self.elements[:, np.array(EDGES)].reshape(-1, 2), axis=1)
            edges, number = np.unique(pairs, axis=0, return_inverse=True)
            self.middles = {tuple(pair): len(self.xyz) + k for k, pair in enumerate(edges)}
            self.elements = np.hstack([self.elements, len(self.xyz) + number.reshape(-1, 6)])
            self.xyz = np.vstack([self.xyz, self.xyz[edges].mean(axis=1)])

    def middles_of(self, corners):
        """(middle, its ends) of the edges 12, 23, 31 of a face; none on linear elements."""
        return [(self.middles[tuple(sorted(ends))], ends) for ends in zip(corners, [*corners[1:], corners[0]]) if self.middles]

    def nodes(self, label):
        return sorted({n for _, _, corners in self.faces[label] for n in [*corners, *(m for m, _ in self.middles_of(corners))]})

    def area(self, corners):
        a, b, c = self.xyz[corners]
        return np.linalg.norm(np.cross(b - a, c - a)) / 2

    def forces(self, stress):
        """Forces at the nodes from stresses (xx, yy, zz, xy, xz, yz) in one or four points of every element: sum of sigma times the
        derivatives of the shape functions."""
        linear = np.vstack([-np.ones(3), np.eye(3)])
        J = np.einsum("eai,aj->eij", self.xyz[self.elements[:, :4]], linear)
        volume, g, F = abs(np.linalg.det(J)) / 6, np.einsum("aj,eji->eai", linear, np.linalg.inv(J)), np.zeros_like(self.xyz)
        for k, s in enumerate(np.moveaxis(stress, 1, 0)):
            sigma = s[:, [0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(-1, 3, 3)
            if self.middles:
                L = [INNER if i == k else (1 - INNER) / 3 for i in range(4)]
                slopes = np.stack([*((4 * L[i] - 1) * g[:, i] for i in range(4)), *(4 * (L[i] * g[:, j] + L[j] * g[:, i]) for i, j in EDGES)], 1)
            else:
                slopes = g
            np.add.at(F, self.elements, np.einsum("e,eij,eaj->eai", volume / stress.shape[1], sigma, slopes))
        return F

    def shared(self, label, N):
        """Pressures at the corners of a label of normal forces, half of those of a middle at each end (METHOD.md 3.20)."""
        share, area = np.zeros(len(self.xyz)), np.zeros(len(self.xyz))
        corners = [c for _, _, c in self.faces[label]]
        for c in corners:
            area[c] += self.area(c) / 3
        share[area > 0] = N[area > 0]
        for m, ends in {m: ends for c in corners for m, ends in self.middles_of(c)}.items():
            share[list(ends)] += N[m] / 2
        return np.divide(share, area, out=np.zeros(len(area)), where=area > 0)

    def on_faces(self, label, p, linear):
        """Places, areas and values in the points of all faces of a label; linear: between the corners even where there are middles."""
        L = POINTS
        N = np.column_stack([L * (2 * L - 1), *(4 * L[:, i] * L[:, j] for i, j in ((0, 1), (1, 2), (2, 0)))])
        found = [[], [], []]
        for _, _, c in self.faces[label]:
            middles = [m for m, _ in self.middles_of(c)]
            values = L @ p[c] if linear or not middles else N @ p[[*c, *middles]]
            for some, one in zip(found, (L @ self.xyz[c], WEIGHTS * self.area(c), values)):
                some.append(one)
        return [np.concatenate(some) for some in found]
