"""The two bricks of the benchmark (docs/theory.md), assembled by scikit-fem.

Two elastic bricks, clamped at opposite ends, pressed and dragged over each other. Units: m, MN, MPa.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
import skfem
from skfem.models.elasticity import lame_parameters, linear_elasticity

YOUNG = 5.0e4
SLIP_BOUND = 0.09


@dataclass
class Bricks:
    """Matrices over the free dofs of both bodies, and what is needed to draw the result."""

    K: list[sp.csr_matrix]
    f: np.ndarray
    N: sp.csr_matrix
    T: sp.csr_matrix
    areas: np.ndarray
    points: np.ndarray


def brick(nodes: int, low: float, poisson: float, clamped: float, loads: list):
    """K, f, the free dofs, and the contact dofs of the brick (0, 2) × (0, 1) × (low, low + 1)."""
    ticks = [np.linspace(*ends, nodes) for ends in ((0, 2), (0, 1), (low, low + 1))]
    mesh = skfem.MeshHex.init_tensor(*ticks)
    element = skfem.ElementVector(skfem.ElementHex1())
    basis = skfem.Basis(mesh, element, intorder=3)
    K = linear_elasticity(*lame_parameters(YOUNG, poisson)).assemble(basis)
    f = np.zeros(basis.N)
    for where in loads:
        pressed = skfem.FacetBasis(mesh, element, facets=mesh.facets_satisfying(where))
        f += skfem.LinearForm(lambda v, w: -1.0 * v[2]).assemble(pressed)
    held = np.isclose(mesh.p[0], clamped)
    free = np.setdiff1d(np.arange(basis.N), basis.nodal_dofs[:, held])

    face = mesh.facets_satisfying(lambda x: np.isclose(x[2], 1.0))
    scalar = skfem.FacetBasis(mesh, skfem.ElementHex1(), facets=face)
    areas = skfem.LinearForm(lambda v, w: v).assemble(scalar)
    contact = np.flatnonzero(np.isclose(mesh.p[2], 1.0))
    # Both bricks list their pairs in the same order.
    contact = contact[np.lexsort((mesh.p[1, contact], mesh.p[0, contact]))]
    return K, f, free, basis.nodal_dofs[:, contact], areas[contact], mesh.p[:, contact].T


def two_bricks(nodes: int) -> Bricks:
    """The problem with nodes³ nodes in each brick."""
    top = lambda x: np.isclose(x[2], 2.0)  # noqa: E731
    end = lambda x: np.isclose(x[0], 0.0)  # noqa: E731
    upper = brick(nodes, 1.0, 0.277, clamped=2.0, loads=[top, end])
    lower = brick(nodes, 0.0, 0.35, clamped=0.0, loads=[])
    # The upper brick is the slave: its outward normal on the contact face is −z, and the approach of
    # the two sides is −(u_upper − u_lower)·z. Slip along x and y, rows of a pair adjacent.
    m = nodes**2
    normal, tangential = [], []
    for (K, _, free, dofs, _, _), sign in ((upper, 1.0), (lower, -1.0)):
        ones = np.full(m, sign)
        rows = sp.csr_matrix((-ones, (np.arange(m), dofs[2])), shape=(m, K.shape[0]))
        slips = np.concatenate([ones, ones])
        at = (np.concatenate([2 * np.arange(m), 2 * np.arange(m) + 1]), np.concatenate([dofs[0], dofs[1]]))
        normal.append(rows[:, free])
        tangential.append(sp.csr_matrix((slips, at), shape=(2 * m, K.shape[0]))[:, free])
    return Bricks(
        K=[K[free][:, free] for K, _, free, *_ in (upper, lower)],
        f=np.concatenate([f[free] for _, f, free, *_ in (upper, lower)]),
        N=sp.hstack(normal, format="csr"),
        T=sp.hstack(tangential, format="csr"),
        areas=upper[4],
        points=upper[5],
    )
