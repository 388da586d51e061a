"""A mesh that FreeFEM has saved, with straight quadratic edges on request."""
import numpy as np


class Mesh:
    """xy: nodes, corners first; elements: 3 or 6 nodes, corners counter-clockwise, then the middle of edge 12, 23, 31;
    edges: by label the boundary edges as (element, number of its edge), from 0."""

    def __init__(self, path, quadratic):
        words = open(path).read().split()
        corners, triangles, borders = (int(w) for w in words[:3])
        numbers = np.array(words[3:], float)
        self.xy, rest = numbers[:3 * corners].reshape(-1, 3)[:, :2], numbers[3 * corners:].astype(int)
        self.elements = rest[:4 * triangles].reshape(-1, 4)[:, :3] - 1
        labels = {tuple(sorted(e[:2] - 1)): e[2] for e in rest[4 * triangles:][:3 * borders].reshape(-1, 3)}
        self.corners, self.edges, middles = corners, {}, {}
        for number, t in enumerate(self.elements):
            for k in range(3):
                edge = tuple(sorted((t[k], t[(k + 1) % 3])))
                middles.setdefault(edge, corners + len(middles))
                if edge in labels:
                    self.edges.setdefault(labels[edge], []).append((number, k))
        if quadratic:
            self.xy = np.vstack([self.xy, [(self.xy[i] + self.xy[j]) / 2 for i, j in middles]])
            self.elements = np.array([[*t, *(middles[tuple(sorted((t[k], t[(k + 1) % 3])))] for k in range(3))] for t in self.elements])

    def edge_nodes(self, label):
        """Nodes of every edge of a label: both ends, and the middle."""
        for e, k in self.edges[label]:
            t = self.elements[e]
            yield [t[k], t[(k + 1) % 3], *([t[3 + k]] if len(t) == 6 else [])]

    def nodes(self, *labels):
        return sorted({n for label in labels for edge in self.edge_nodes(label) for n in edge})

    def spacing(self, label):
        return min(np.hypot(*(self.xy[e[1]] - self.xy[e[0]])) for e in self.edge_nodes(label))
