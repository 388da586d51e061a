"""Numbers of a sparse matrix: condition, rows, zeros, inertia, nonsymmetry, entries."""
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as sla

TOLERANCE = 1e-2   # of the singular values
SMALL = 1e-4       # diagonal entry over the largest of its row: below, the largest sets the scale
DENSE = 400        # up to this size: all singular values


def extreme(apply, size):
    """Largest eigenvalue of a symmetric positive operator."""
    operator = sla.LinearOperator((size, size), matvec=apply, dtype=float)
    start = np.random.default_rng(1).standard_normal(size)
    return sla.eigsh(operator, k=1, tol=TOLERANCE, v0=start, return_eigenvectors=False)[0]


def condition(A):
    """Largest over smallest singular value, to 1 %; inf where A is singular."""
    size = A.shape[0]
    if size <= DENSE:
        values = np.linalg.svd(A.toarray(), compute_uv=False)
        return values[0] / values[-1] if values[-1] > 0 else np.inf
    try:
        lu = sla.splu(A.tocsc())
    except RuntimeError:
        return np.inf
    rows = A.tocsr()
    transposed = rows.T.tocsr()
    large = extreme(lambda x: transposed @ (rows @ x), size)
    small = extreme(lambda x: lu.solve(lu.solve(x, trans="T")), size)
    return float(np.sqrt(large * small))


def by_diagonal(A):
    """Rows and columns over the root of the diagonal, as the dense block of the contact is scaled; then those whose diagonal is small over the root of
    their largest entry, until that is 1."""
    d = abs(A.diagonal())
    zero = d <= SMALL * np.asarray(abs(A).max(axis=1).todense()).ravel()
    scale = 1 / np.sqrt(np.where(zero, 1, d))
    A = (sp.diags(scale) @ A @ sp.diags(scale)).tocsr()
    for _ in range(20 if zero.any() else 0):
        largest = np.asarray(abs(A).max(axis=1).todense()).ravel()
        more = sp.diags(np.where(zero & (largest > 0), 1 / np.sqrt(np.where(largest > 0, largest, 1)), 1))
        A = (more @ A @ more).tocsr()
    return A


def negative(A, border):
    """Negative, zero and positive eigenvalues of the symmetric part: pivots without pivoting of all but the last `border` rows, and of their
    Schur complement."""
    S = by_diagonal(((A + A.T) / 2).tocsr())
    size = S.shape[0]
    inner = np.arange(size - border)
    outer = np.arange(size - border, size)
    lu = sla.splu(S[inner][:, inner].tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                  options={"SymmetricMode": True, "Equil": False})
    pivots = lu.U.diagonal()
    count = [int((pivots < 0).sum()), 0, int((pivots > 0).sum())]
    if border:
        side = S[inner][:, outer].toarray()
        complement = S[outer][:, outer].toarray() - side.T @ lu.solve(side)
        values = np.linalg.eigvalsh((complement + complement.T) / 2)
        least = 1e-10 * abs(values).max()
        count = [count[0] + int((values < -least).sum()), int((abs(values) <= least).sum()), count[2] + int((values > least).sum())]
    return count


def measure(A, border=0):
    """border: rows at the end that may have zeros on the diagonal."""
    A = A.tocsr()
    A.eliminate_zeros()
    A.sum_duplicates()
    d, size = abs(A.diagonal()), A.shape[0]
    off = np.asarray(abs(A - sp.diags(A.diagonal())).max(axis=1).todense()).ravel()
    zero = d <= 1e-10 * np.maximum(off, 1e-300)
    ratio = off / np.where(zero, np.nan, d)
    below, none, above = negative(A, border)
    return {"size": size, "entries": int(A.nnz), "megabytes": (12 * A.nnz + 4 * size) / 1e6, "condition": condition(A),
            "condition_scaled": condition(by_diagonal(A)), "row_ratio": float(np.nanmax(ratio)),
            "rows_above_1": float(((ratio > 1) | zero).mean()), "zeros": int(zero.sum()), "negative": below, "null": none,
            "positive": above, "nonsymmetry": float(sla.norm(A - A.T) / sla.norm(A)) / 2}
