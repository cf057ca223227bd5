"""Coulomb friction and a load cycle: a spring-held block that is pulled to and fro remembers where it slipped.

The smallest problem with a closed form: a mass on a spring of stiffness k along the wall, pressed on it
with the force P. It slips when the spring force differs from the pull by more than F P, so over a cycle of
amplitude A the friction dissipates 4 F P (A − F P)/k once the loop has closed.

    python examples/python/load_cycle.py
"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
import tresca

PRESSED, COEFFICIENT, STIFFNESS, AMPLITUDE = 10.0, 0.3, 4.0, 8.0


def main() -> None:
    """Two cycles; the second is compared with the closed form."""
    # dofs: normal (stiffness 1, pushed against the wall) and tangential.
    K = sp.diags([1.0, STIFFNESS], format="csr")
    N = sp.csr_matrix([[1.0, 0.0]])
    T = sp.csr_matrix([[0.0, 1.0]])
    problem = tresca.prepare(K, N, T, tresca.Coulomb(COEFFICIENT))

    cycle = np.concatenate([np.linspace(0, 1, 11), np.linspace(1, -1, 21)[1:], np.linspace(-1, 0, 11)[1:]])
    pulls = AMPLITUDE * np.concatenate([cycle, cycle[1:]])
    slip, last = None, None
    positions, dissipated = [], []
    for pull in pulls:
        before = 0.0 if slip is None else slip[0, 0]
        last = problem.solve([PRESSED, pull], previous_slip=slip, start=last, tolerance=1e-12)
        slip = last.slip
        positions.append(slip[0, 0])
        dissipated.append(last.tangential_force[0, 0] * (slip[0, 0] - before))

    bound = COEFFICIENT * PRESSED
    loop = np.sum(dissipated[len(cycle) :])
    exact = 4 * bound * (AMPLITUDE - bound) / STIFFNESS
    print(f"work of friction in the second cycle {loop:.12f}, closed form {exact:.12f}")
    print(f"largest displacement {max(positions):.12f}, closed form {(AMPLITUDE - bound) / STIFFNESS:.12f}")
    assert abs(loop / exact - 1) < 1e-9
    assert abs(max(positions) * STIFFNESS / (AMPLITUDE - bound) - 1) < 1e-9
    # Forward and back the block stands at different places under the same pull.
    there, back = (len(cycle) - 1 + np.array([5, 15])).tolist()
    assert pulls[there] == pulls[back] and positions[back] - positions[there] > 0.1


if __name__ == "__main__":
    main()
