"""Problems that several tests use."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp


@dataclass
class Problem:
    """A random contact problem in space."""

    K: sp.csr_matrix
    f: np.ndarray
    N: sp.csr_matrix
    T: sp.csr_matrix
    gap: np.ndarray
    bound: np.ndarray

    def dual(self) -> tuple[np.ndarray, np.ndarray]:
        """A and b, computed by NumPy."""
        B = sp.vstack([self.N, self.T]).toarray()
        inverse = np.linalg.inv(self.K.toarray())
        c = np.concatenate([self.gap, np.zeros(self.T.shape[0])])
        return B @ inverse @ B.T, B @ inverse @ self.f - c


def random_problem(seed: int, pairs: int = 8) -> Problem:
    """Springs between random dofs, every pair with dofs of its own; some pairs open, some slip."""
    random = np.random.default_rng(seed)
    n = 4 * pairs
    coupling = sp.random(n, n, density=3 / n, random_state=random)
    K = sp.csr_matrix(coupling @ coupling.T + sp.diags(random.uniform(1.0, 3.0, n)))
    place = random.permutation(n)[: 3 * pairs]
    one = np.ones(pairs)
    N = sp.csr_matrix((one, (np.arange(pairs), place[:pairs])), shape=(pairs, n))
    T = sp.csr_matrix((np.ones(2 * pairs), (np.arange(2 * pairs), place[pairs:])), shape=(2 * pairs, n))
    return Problem(
        K, random.normal(size=n), N, T, gap=random.uniform(-0.1, 0.2, pairs), bound=random.uniform(0.05, 2.0, pairs)
    )
