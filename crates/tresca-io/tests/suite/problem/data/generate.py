"""Writes the archives of this folder: two springs in contact with a wall, by SciPy and NumPy.

    python generate.py
"""

from pathlib import Path

import numpy as np
import scipy.sparse as sp

HERE = Path(__file__).parent

K = sp.csr_matrix(np.array([[2.0, -1.0, 0.0], [-1.0, 3.0, 0.5], [0.0, 0.5, 4.0]]))
N = sp.csc_matrix(np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]))
T = sp.coo_matrix(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -2.0]]))


def parts(name, matrix):
    """What scipy.sparse.save_npz writes, under a prefix."""
    arrays = {"format": np.array(matrix.format.encode("ascii")), "shape": np.array(matrix.shape)}
    if matrix.format == "coo":
        arrays |= {"row": matrix.row, "col": matrix.col}
    else:
        arrays |= {"indices": matrix.indices, "indptr": matrix.indptr}
    return {f"{name}/{key}": value for key, value in (arrays | {"data": matrix.data}).items()}


common = {"f": np.array([1.0, -2.0, 0.25]), "gap": np.array([0.5, np.float64(1) / 3])}

# As SciPy leaves it: int32 indices, formats as bytes, compressed.
np.savez_compressed(
    HERE / "scipy.npz",
    **parts("K", K),
    **parts("N", N),
    **parts("T", T),
    **common,
    law=np.array(["tresca", "coulomb"]),
    bounds=np.array([0.1, 0.0]),
    coefficients=np.array([[0.0, 0.0], [0.3, 0.2]]),
)

# The same with dense arrays of other types and orders, K in two blocks, N and T in one.
np.savez(
    HERE / "dense.npz",
    K0=np.asfortranarray(np.array([[2, -1], [-1, 3]], dtype=np.int16)),
    K1=np.array([[4.0]], dtype=np.float32),
    B=np.asfortranarray(np.vstack([N.toarray(), T.toarray()])),
    pairs=np.array(2),
    **common,
    law="tresca",
    bounds=0.25,
    points=np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0]]),
)
