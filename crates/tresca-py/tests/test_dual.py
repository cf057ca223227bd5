"""A, b and the bounds alone."""

import numpy as np
import pytest
import scipy.sparse as sp
import tresca
from problems import random_problem
from scipy.sparse.linalg import aslinearoperator


def test_every_kind_of_operator_gives_the_solution_of_the_matrices():
    problem = random_problem(20)
    A, b = problem.dual()
    whole = tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound, tolerance=1e-12)
    kinds = {
        "array": A,
        "fortran": np.asfortranarray(A),
        "rows": A.tolist(),
        "strided": np.repeat(A, 2, axis=1)[:, ::2],
        "sparse": sp.csr_matrix(A),
        "operator": aslinearoperator(A),
        "function": lambda x: A @ x,
    }
    for kind, operator in kinds.items():
        solution = tresca.solve_dual(operator, b, problem.bound, tolerance=1e-12)
        assert solution.converged, kind
        for name in ("normal_force", "tangential_force", "gap", "slip"):
            ours, theirs = getattr(solution, name), getattr(whole, name)
            np.testing.assert_allclose(ours, theirs, atol=1e-9, err_msg=f"{kind} {name}")
        np.testing.assert_array_equal(solution.closed, whole.closed)
        assert len(solution.u) == 0 and solution.certificate.worst < 1e-8
    with_diagonal = tresca.solve_dual(lambda x: A @ x, b, problem.bound, diagonal=np.diag(A), tolerance=1e-12)
    np.testing.assert_allclose(with_diagonal.normal_force, whole.normal_force, atol=1e-9)


def test_multiplications_are_counted_as_they_are_made():
    problem = random_problem(21)
    A, b = problem.dual()
    calls = []
    solution = tresca.solve_dual(lambda x: calls.append(x) or A @ x, b, problem.bound)
    # One more for the certificate, as documented.
    assert len(calls) == solution.n_a + 1


@pytest.mark.parametrize("tangents", [0, 1])
def test_fewer_tangents(tangents):
    b = np.array([1.0, -1.0, 5.0, 0.2])[: 2 * (1 + tangents)]
    solution = tresca.solve_dual(np.diag([2.0, 1.0, 1.0, 1.0])[: len(b), : len(b)], b, 0.5 if tangents else None, tangents=tangents)
    np.testing.assert_allclose(solution.normal_force, [0.5, 0.0], atol=1e-9)
    if tangents:
        np.testing.assert_allclose(solution.tangential_force, [[0.5], [0.2]], atol=1e-9)
        np.testing.assert_allclose(solution.slip, [[4.5], [0.0]], atol=1e-9)


def test_what_the_function_raises_comes_through():
    def fails(x):
        raise LookupError("from the product")

    with pytest.raises(LookupError, match="from the product"):
        tresca.solve_dual(fails, np.ones(3), 0.1)
    with pytest.raises(ValueError, match="has length 2, expected 3"):
        tresca.solve_dual(lambda x: x[:2], np.ones(3), 0.1)
    with pytest.raises(tresca.ProblemError, match="complex"):
        tresca.solve_dual(lambda x: x * 1j, np.ones(3), 0.1)
    with pytest.raises(tresca.ProblemError, match="returned NaN"):
        tresca.solve_dual(lambda x: x * np.nan, np.ones(3), 0.1)


def test_wrong_input_is_named():
    A, b = np.eye(3), np.ones(3)
    with pytest.raises(tresca.ProblemError, match="not symmetric"):
        tresca.solve_dual(A + np.eye(3, k=1), b, 0.1)
    with pytest.raises(tresca.ProblemError, match="it must be square"):
        tresca.solve_dual(np.ones((3, 4)), b, 0.1)
    with pytest.raises(tresca.ProblemError, match="expected 0, 1 or 2"):
        tresca.solve_dual(A, b, 0.1, tangents=3)
    with pytest.raises(tresca.ProblemError, match="right-hand side"):
        tresca.solve_dual(A, np.ones(6), 0.1)
    with pytest.raises(tresca.ProblemError, match="A has the shape"):
        tresca.solve_dual(aslinearoperator(A), np.ones(6), 0.1)
    with pytest.raises(tresca.ProblemError, match="order of 3 per contact pair"):
        tresca.solve_dual(np.eye(4), np.ones(4), 0.1)
