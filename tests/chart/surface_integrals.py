"""The surface integrals of article (1.20) and article (1.21), literally, beside the sums of nodal forces that stand for them (cxx/METHOD.md 3.8).

A circle in the plane, xi its arc: b has the curvature alone, g = 1, a the unit turn. Of nodes m, n that slide
    curvature and change of area:  - int H^m (kappa Xi_n H^n + Xi_t dH^n/dxi) dS     nodal: - kappa N_m where m = n
    turn:  - int Xi_n H^m dS                                 nodal: - N_m
Tractions are linear on every edge, of forces shared to the corners (METHOD.md 3.20).
"""
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as sla

import contact_matrices as cm

GAUSS = np.polynomial.legendre.leggauss(4)


def shapes(x, quadratic):
    """Values and derivatives at x in (0, 1)."""
    if not quadratic:
        return np.array([1 - x, x]), np.array([-1.0, 1.0])
    return (np.array([(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)]),
            np.array([4 * x - 3, 4 - 8 * x, 4 * x - 1]))


def edges(state, quadratic):
    """Candidates of every edge in order, and tractions at its two ends."""
    count = len(state.node)
    if not quadratic:
        L, N, T = state.length, state.N, state.T
        return [(i, i + 1) for i in range(count - 1)], N / L, T / L
    first = 0 if state.length[0::2].sum() < state.length[1::2].sum() else 1   # the first corner: mid nodes are longer
    N, T, L = state.N.copy(), state.T.copy(), state.length.copy()
    list_of = [(i, i + 1, i + 2) for i in range(first, count - 2, 2)]
    for a, m, b in list_of:
        for values in (N, T, L):
            values[a] += values[m] / 2
            values[b] += values[m] / 2
    return list_of, N / L, T / L


def integrals(state, quadratic):
    """Curvature part, part of the change of area, and int Xi_n H, over the candidates."""
    count = len(state.node)
    curved, area, line = np.zeros((count, count)), np.zeros((count, count)), np.zeros(count)
    touching = np.isin(np.arange(count), state.active)
    list_of, pn, pt = edges(state, quadratic)
    for nodes in list_of:
        if not all(touching[list(nodes)]):
            continue
        a, b = nodes[0], nodes[-1]
        way = state.place[b] - state.place[a]
        h, sign = np.linalg.norm(way), np.sign(way @ state.tangent[a])
        for x, w in zip((GAUSS[0] + 1) / 2, GAUSS[1] / 2):
            H, D = shapes(x, quadratic)
            n, t = pn[a] * (1 - x) + pn[b] * x, pt[a] * (1 - x) + pt[b] * x
            curved[np.ix_(nodes, nodes)] += w * h * n / state.radius * np.outer(H, H)
            area[np.ix_(nodes, nodes)] += w * h * t * sign / h * np.outer(H, D)
            line[list(nodes)] += w * h * n * H
    return curved, area, line


def stiffness(A, state):
    """Schur complement on the first free coordinate, the others giving way."""
    last = state.K.shape[0] + state.free[0]
    off = abs(A - sp.diags(A.diagonal()))
    keep = (np.asarray(off.max(axis=1).todense()).ravel() > 0) | (np.asarray(off.max(axis=0).todense()).ravel() > 0)
    keep[last] = False
    inner = np.flatnonzero(keep)
    column, row = A[inner][:, [last]].toarray().ravel(), A[last][:, inner].toarray().ravel()
    return A[last, last] - row @ sla.splu(A[inner][:, inner].tocsc()).solve(column)


def one(state, quadratic):
    curved, area, line = integrals(state, quadratic)
    sliding = np.flatnonzero(state.state == cm.SLIDES)
    dofs, turn = 2 * state.node[sliding], state.K.shape[0] + state.coordinates.index("theta")
    article = state.condensed("article").tocsr()
    nodal = np.diag(state.N[sliding] / state.radius)
    part = curved[np.ix_(sliding, sliding)], area[np.ix_(sliding, sliding)]
    change = sp.lil_matrix(article.shape)
    change[np.ix_(dofs, dofs)] = nodal - part[0] - part[1]
    change[dofs, turn] = state.N[sliding] - line[sliding]
    literal, norm = (article + change.tocsr()).tocsr(), np.linalg.norm
    S = {name: stiffness(A, state) for name, A in (("complete", state.condensed("complete").tocsr()), ("article", article), ("literal", literal))}
    scale = norm(nodal) if len(sliding) else np.nan
    return {"contact": len(state.active), "sliding": len(sliding), "lumping": norm(nodal - part[0]) / scale, "area": norm(part[1]) / scale,
            "turn": norm(state.N[sliding] - line[sliding]) / norm(state.N[sliding]) if len(sliding) else np.nan,
            "of the matrix": sla.norm(change.tocsr()) / sla.norm(article), "stiffness, article": S["article"] / S["complete"] - 1,
            "stiffness, literal": S["literal"] / S["complete"] - 1}


def measure(states, elements):
    return [{"element": element, "t": 0.25 * (k % 4 + 1), **one(state, element == "P2")}
            for k, (state, element) in enumerate(zip(states, elements))]
