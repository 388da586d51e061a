"""Matrices of the usual methods of contact at a state that states.idp has written: same tangent, same contact nodes, same forces.

Circles only. Node and coordinates (x, q) of a contact node have the rows
    G = [n, -n.V]  gap,  S = [t, -t.V]  slip,  P = [t, -t.c]/rho  turn of the normal,
V velocity of the tool at the node by its coordinates, c that of its center; n out of the tool, t = (-n_y, n_x), F = N n + T t the force on the
node. With the residuals R - F of nodes and V.F - Q of coordinates their derivative at given N, T is
    geometry = (T G' - N S') P + F.V'      (cxx/ALGORITHMS.md (18.1): the gap's second derivative is S'P without turns)
"""
import numpy as np
import scipy.sparse as sp

STICKS = (1, 3)   # touched, sticking
SLIDES = 2


def read_matrix(path):
    with open(path) as f:
        size = int(f.readline())
        entries = np.loadtxt(f, ndmin=2)
    return sp.csr_matrix((entries[:, 2], (entries[:, 0].astype(int), entries[:, 1].astype(int))), shape=(size, size))


def mirrored(lower):
    """Both triangles of a symmetric matrix."""
    return (lower + sp.tril(lower, -1).T).tocsr() if abs(sp.triu(lower, 1)).nnz == 0 else lower


class State:
    """What states.idp has written. coordinates: names of the tool's; free: those under force."""

    def __init__(self, base, coordinates, free, radius, pivot=(0, 0)):
        self.base, self.radius, self.pivot = base, radius, np.array(pivot, float)
        self.coordinates, self.free, self.free_names = coordinates, [coordinates.index(k) for k in free], free
        table = np.loadtxt(base + "nodes", ndmin=2)
        self.node, self.place = table[:, 0].astype(int), table[:, 1:3]
        self.state, self.N, self.T, self.length = table[:, 3].astype(int), table[:, 4], table[:, 5], table[:, 6]
        self.held = np.loadtxt(base + "held") > 0
        self.q = dict(zip(coordinates, np.loadtxt(base + "q", ndmin=1)))
        self.K = mirrored(read_matrix(base + "K"))
        self.active = np.flatnonzero(np.isin(self.state, (*STICKS, SLIDES)))
        self.kept = np.flatnonzero(~self.held)
        self.normal = self.place - self.center()
        self.normal /= np.linalg.norm(self.normal, axis=1)[:, None]
        self.tangent = np.column_stack([-self.normal[:, 1], self.normal[:, 0]])

    def condensed(self, name):
        return read_matrix(self.base + name)

    def center(self):
        if "r" in self.q:
            return self.pivot + self.q["r"] * np.array([np.cos(self.q["phi"]), np.sin(self.q["phi"])])
        return np.array([self.q["x"], self.q["y"]])

    def velocity(self, i, name):
        """Of the tool at contact node i, and of its center, per unit of a coordinate."""
        if name in ("angle", "theta"):
            arm = self.place[i] - self.center()
            return np.array([-arm[1], arm[0]]), np.zeros(2)
        if name in ("x", "y"):
            c = np.array([1.0, 0.0] if name == "x" else [0.0, 1.0])
        else:
            e = np.array([np.cos(self.q["phi"]), np.sin(self.q["phi"])])
            c = e if name == "r" else self.q["r"] * np.array([-e[1], e[0]])
        return c, c

    def rows(self):
        """G, S, P of the active nodes over all displacements and the free coordinates."""
        size = self.K.shape[0]
        G, S, P = (sp.lil_matrix((len(self.active), size + len(self.free))) for _ in range(3))
        for a, i in enumerate(self.active):
            dofs = [2 * self.node[i], 2 * self.node[i] + 1]
            n, t = self.normal[i], self.tangent[i]
            G[a, dofs], S[a, dofs], P[a, dofs] = n, t, t / self.radius
            for k, name in enumerate(self.free_names):
                V, c = self.velocity(i, name)
                G[a, size + k], S[a, size + k], P[a, size + k] = -n @ V, -t @ V, -t @ c / self.radius
        return G.tocsr(), S.tocsr(), P.tocsr()

    def geometry(self, G, S, P):
        """Derivative of the contact forces at given N, T."""
        N, T = self.N[self.active], self.T[self.active]
        Z = (G.T @ sp.diags(T) - S.T @ sp.diags(N)) @ P
        size = self.K.shape[0]
        extra = sp.lil_matrix(Z.shape)
        turn = next((k for k, name in enumerate(self.free_names) if name in ("angle", "theta")), None)
        for i in self.active:
            if turn is None:
                break
            F = self.N[i] * self.normal[i] + self.T[i] * self.tangent[i]
            along = np.array([F[1], -F[0]])            # F.(e_z x dx) = along.dx
            for c in range(2):
                extra[size + turn, 2 * self.node[i] + c] += along[c]
            for k, name in enumerate(self.free_names):
                extra[size + turn, size + k] -= along @ self.velocity(i, name)[1]
        return Z + extra.tocsr()


def unit(state):
    """Unit of penalty factors, cxx/ALGORITHMS.md 18: diagonal of K over the tributary length, mean over the surface."""
    d = state.K.diagonal()
    return (d[2 * state.node] + d[2 * state.node + 1]).sum() / (2 * state.length.sum())


def reduced(state, A, extra=0):
    """Without what is given; coordinates and `extra` unknowns behind the displacements stay."""
    keep = np.concatenate([state.kept, np.arange(state.K.shape[0], state.K.shape[0] + len(state.free) + extra)])
    return A.tocsr()[keep][:, keep]


def bordered(state):
    """K with the geometry of the contact, over displacements and free coordinates; G, S, which nodes stick, and signs of slip times friction."""
    G, S, P = state.rows()
    size = state.K.shape[0] + len(state.free)
    K = sp.block_diag([state.K, sp.csr_matrix((len(state.free),) * 2)]).tocsr() + state.geometry(G, S, P)
    sticks = np.isin(state.state[state.active], STICKS)
    return K.tocsr(), G, S, sticks, size


def slide(state, sticks, mu):
    """Tangential over normal force of nodes that slide, 0 of those that stick."""
    return np.where(sticks, 0.0, mu * np.sign(state.T[state.active]))


def penalty(state, factor, mu):
    K, G, S, sticks, _ = bordered(state)
    stiff = factor * unit(state) * state.length[state.active]
    A = K + G.T @ sp.diags(stiff) @ G + S.T @ sp.diags(slide(state, sticks, mu) * stiff) @ G
    if mu > 0:
        A = A + S.T @ sp.diags(np.where(sticks, stiff, 0)) @ S
    return reduced(state, A)


def multiplier(state, mu, factor=0):
    """Multipliers of the normal forces, and of the tangential ones of nodes that stick; factor > 0: augmented, mixed form. Their unit is the mean
    diagonal of K at the contact, so that rows and columns compare with those of nodes."""
    K, G, S, sticks, _ = bordered(state)
    column = (G.T + S.T @ sp.diags(slide(state, sticks, mu))).tocsr()
    row = G
    if factor > 0:
        stiff = factor * unit(state) * state.length[state.active]
        K = K + column @ sp.diags(stiff) @ G
        if mu > 0:
            K = K + S.T @ sp.diags(np.where(sticks, stiff, 0)) @ S
    if mu > 0 and sticks.any():
        column, row = sp.hstack([column, S.T.tocsr()[:, sticks]]), sp.vstack([row, S[sticks]])
    weight = unit(state) * state.length.mean()
    A = sp.bmat([[K, -weight * column], [-weight * row, None]]).tocsr()
    return reduced(state, A, row.shape[0])


def free_body(state):
    """K itself: no contact, supports taken off."""
    return state.K[state.kept][:, state.kept]


def condensed(state, name="complete", scale_coordinates=False):
    """The condensed matrix without given unknowns. scale_coordinates: in units in which their diagonal entries are the mean of K's at the contact, the
    article's scaling."""
    A = state.condensed(name)
    body = state.K.shape[0]
    off = abs(A - sp.diags(A.diagonal()))
    keep = (np.asarray(off.max(axis=1).todense()).ravel() > 0) | (np.asarray(off.max(axis=0).todense()).ravel() > 0)
    scale = np.ones(A.shape[0])
    if scale_coordinates:
        scale[body:] = np.sqrt(unit(state) * state.length.mean() / abs(A.diagonal()[body:]))
    A = sp.diags(scale) @ A @ sp.diags(scale)
    return A.tocsr()[keep][:, keep]
