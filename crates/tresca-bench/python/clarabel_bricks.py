"""The two bricks beside Clarabel: the same matrices, the same tolerance, the same run.

Clarabel solves the primal cone form, min ½uᵀKu − fᵀu + Σ g_i t_i with N u ≤ d and ‖(T u)_i‖ ≤ t_i. Lengths are
scaled so that displacements are near 1: without that its stopping criterion, which compares with 1, is met
too early. A result is measured with the same problem solved to 1e-13.

    python crates/tresca-bench/python/clarabel_bricks.py --sizes 9 13 16
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import clarabel
import numpy as np
import scipy.sparse as sp
import tresca

sys.path.insert(0, str(Path(__file__).parents[3] / "examples" / "python"))

from bricks import SLIP_BOUND, Bricks, two_bricks

SCALE = 1e4


def by_clarabel(bricks: Bricks, bound: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray, str]:
    """u, normal forces and the solver's status."""
    K = sp.block_diag(bricks.K, format="csc")
    n, m = K.shape[0], len(bound)
    # With u = ũ/SCALE and energies times SCALE: K/SCALE, f, N, T, g.
    P = sp.block_diag([sp.triu(K) / SCALE, sp.csc_matrix((m, m))], format="csc")
    q = np.concatenate([-bricks.f, bound])
    # Rows (t_i, (Tu)_i) pair by pair.
    radii = sp.csr_matrix((-np.ones(m), (3 * np.arange(m), np.arange(m))), shape=(3 * m, m))
    places = (3 * np.arange(m)[:, np.newaxis] + [1, 2]).ravel()
    spread = sp.csr_matrix((np.ones(2 * m), (places, np.arange(2 * m))), shape=(3 * m, 2 * m))
    rows = sp.vstack(
        [sp.hstack([bricks.N, sp.csr_matrix((m, m))]), sp.hstack([spread @ bricks.T, radii])], format="csc"
    )
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = tolerance
    cones = [clarabel.NonnegativeConeT(m)] + [clarabel.SecondOrderConeT(3)] * m
    solution = clarabel.DefaultSolver(P, q, rows, np.zeros(4 * m), cones, settings).solve()
    return np.array(solution.x)[:n] / SCALE, np.array(solution.z)[:m], str(solution.status)


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sizes", type=int, nargs="+", default=[9, 13, 16], help="nodes along an edge")
    parser.add_argument("--tolerance", type=float, default=1e-8)
    arguments = parser.parse_args()

    print("| s | dofs | pairs | solver | seconds | energy | displacements | normal forces | pairs in a wrong state |")
    print("|---|---|---|---|---|---|---|---|---|")
    for s in arguments.sizes:
        bricks = two_bricks(s)
        bound = SLIP_BOUND * bricks.areas
        K = sp.block_diag(bricks.K, format="csr")

        def ours(tolerance: float) -> tresca.Solution:
            law = tresca.Tresca(bound)
            return tresca.solve(
                bricks.K, bricks.f, bricks.N, bricks.T, friction=law, points=bricks.points, tolerance=tolerance
            )

        def energy(u: np.ndarray) -> float:
            slip = np.linalg.norm((bricks.T @ u).reshape(-1, 2), axis=1)
            return 0.5 * u @ (K @ u) - bricks.f @ u + bound @ slip

        exact = ours(1e-13)

        def row(name: str, seconds: float, u: np.ndarray, force: np.ndarray) -> None:
            closed = force > 1e-6 * force.max()
            slip = np.linalg.norm((bricks.T @ u).reshape(-1, 2), axis=1)
            slides = slip > 1e-6 * slip.max()
            wrong = (closed != exact.closed) | (slides == exact.stick)
            errors = [
                abs(energy(u) / energy(exact.u) - 1),
                np.linalg.norm(u - exact.u) / np.linalg.norm(exact.u),
                np.linalg.norm(force - exact.normal_force) / np.linalg.norm(exact.normal_force),
            ]
            figures = " | ".join(f"{error:.0e}" for error in errors)
            print(f"| {s} | {K.shape[0]} | {len(bound)} | {name} | {seconds:.2f} | {figures} | {wrong.sum()} |", flush=True)

        begin = time.perf_counter()
        solution = ours(arguments.tolerance)
        row("tresca", time.perf_counter() - begin, solution.u, solution.normal_force)
        begin = time.perf_counter()
        u, force, status = by_clarabel(bricks, bound, arguments.tolerance)
        row(f"Clarabel ({status})", time.perf_counter() - begin, u, force)


if __name__ == "__main__":
    main()
