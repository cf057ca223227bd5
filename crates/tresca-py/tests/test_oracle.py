"""Against Clarabel, which solves the primal cone form."""

import clarabel
import numpy as np
import pytest
import scipy.sparse as sp
import tresca
from problems import random_problem


def by_clarabel(problem, axes):
    """min ½uᵀKu − fᵀu + Σ t_i,  N u ≤ d,  ‖diag(axes_i) (T u)_i‖ ≤ t_i."""
    n, m = problem.K.shape[0], problem.N.shape[0]
    P = sp.block_diag([problem.K, sp.csc_matrix((m, m))], format="csc")
    q = np.concatenate([-problem.f, np.ones(m)])
    scaled = sp.diags(axes.ravel()) @ problem.T
    rows = [sp.hstack([problem.N, sp.csr_matrix((m, m))])]
    for i in range(m):
        radius = sp.csr_matrix(([-1.0], ([0], [n + i])), shape=(1, n + m))
        rows += [radius, sp.hstack([scaled[2 * i : 2 * i + 2], sp.csr_matrix((2, m))])]
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = 1e-12
    cones = [clarabel.NonnegativeConeT(m)] + [clarabel.SecondOrderConeT(3)] * m
    rhs = np.concatenate([problem.gap, np.zeros(3 * m)])
    solution = clarabel.DefaultSolver(
        sp.triu(P, format="csc"), q, sp.vstack(rows, format="csc"), rhs, cones, settings
    ).solve()
    assert str(solution.status) in ("Solved", "AlmostSolved")
    return np.array(solution.x)[:n], np.array(solution.z)[:m]


@pytest.mark.parametrize("seed", range(30, 34))
@pytest.mark.parametrize("ratio", [1.0, 0.4])
def test_displacements_and_forces_are_those_of_clarabel(seed, ratio):
    problem = random_problem(seed, pairs=20)
    axes = np.column_stack([problem.bound, ratio * problem.bound])
    law = tresca.Tresca(problem.bound) if ratio == 1.0 else tresca.Orthotropic(*axes.T)
    solution = tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, law, tolerance=1e-12)
    u, normal_force = by_clarabel(problem, axes)
    # An interior point near a degenerate pair (no slip, friction at its bound) is as far away as the root of
    # its duality gap, in energy as far as that.
    np.testing.assert_allclose(solution.u, u, atol=1e-6)
    np.testing.assert_allclose(solution.normal_force, normal_force, atol=1e-6)

    def energy(u):
        slip = (problem.T @ u).reshape(-1, 2) * axes
        return 0.5 * u @ (problem.K @ u) - problem.f @ u + np.linalg.norm(slip, axis=1).sum()

    assert abs(energy(solution.u) - energy(u)) < 1e-10 * abs(energy(u))
    assert 0 < solution.closed.sum() < 20 and 0 < solution.stick.sum() < 20
