"""Matrices in, a solution out."""

import signal
import threading
import time

import numpy as np
import pytest
import scipy.sparse as sp
import tresca
from problems import random_problem

# A mass on two springs (1 along the normal, 2 along the tangent), half a metre above a rough wall.
K = np.diag([1.0, 2.0])
F = [2.0, 1.0]
N, T = [[1.0, 0.0]], [[0.0, 1.0]]
GAP = [0.5]


@pytest.mark.parametrize(
    ("friction", "normal", "tangential", "slip"),
    [
        (tresca.Frictionless(), 1.5, 0.0, 0.5),
        (None, 1.5, 0.0, 0.5),
        (tresca.Tresca(0.4), 1.5, 0.4, 0.3),
        (0.4, 1.5, 0.4, 0.3),
        (tresca.Tresca(3.0), 1.5, 1.0, 0.0),
        (tresca.Coulomb(0.2), 1.5, 0.3, 0.35),
        (tresca.Coulomb(0.2, limit=0.1), 1.5, 0.1, 0.45),
        (tresca.Orthotropic(0.4, 7.0), 1.5, 0.4, 0.3),
        (tresca.Bilateral(0.4), 1.5, 0.4, 0.3),
        (tresca.Bilateral(), 1.5, 0.0, 0.5),
        (tresca.Tied(), 1.5, 1.0, 0.0),
        ([tresca.Coulomb(0.2)], 1.5, 0.3, 0.35),
    ],
)
def test_every_law_has_its_closed_form(friction, normal, tangential, slip):
    solution = tresca.solve(K, F, N, T, GAP, friction, tolerance=1e-12)
    assert solution.converged and solution.status == "converged"
    np.testing.assert_allclose(solution.normal_force, [normal], rtol=1e-9)
    np.testing.assert_allclose(solution.tangential_force, [[tangential]], atol=1e-9)
    np.testing.assert_allclose(solution.slip, [[slip]], atol=1e-9)
    np.testing.assert_allclose(solution.u, [0.5, slip], atol=1e-9)
    np.testing.assert_allclose(solution.gap, [0.0], atol=1e-9)
    assert solution.certificate.worst < 1e-8


def test_a_pair_that_never_opens_may_pull():
    solution = tresca.solve(K, [-2.0, 1.0], N, T, GAP, tresca.Bilateral(), tolerance=1e-12)
    np.testing.assert_allclose(solution.normal_force, [-2.5], rtol=1e-9)
    opens = tresca.solve(K, [-2.0, 1.0], N, T, GAP, tresca.Coulomb(0.2), tolerance=1e-12)
    assert opens.normal_force == [0.0] and not opens.closed[0]
    np.testing.assert_allclose(opens.gap, [2.5], rtol=1e-12)


def test_formats_and_types_do_not_matter():
    problem = random_problem(1)
    bound = tresca.Tresca(problem.bound)
    reference = tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, bound)
    for form in ("csr", "csc", "coo", "bsr", "lil", "dok", "dia"):
        k, n, t = (matrix.asformat(form) for matrix in (problem.K, problem.N, problem.T))
        solution = tresca.solve(k, problem.f, n, t, problem.gap, bound)
        np.testing.assert_array_equal(solution.u, reference.u, err_msg=form)
    wide = sp.csr_array(problem.K)
    wide.indices, wide.indptr = wide.indices.astype(np.int64), wide.indptr.astype(np.int64)
    dense = [matrix.toarray() for matrix in (problem.N, problem.T)]
    dense[1] = np.asfortranarray(dense[1])
    solution = tresca.solve(wide, list(problem.f), *dense, problem.gap[::-1][::-1], bound)
    np.testing.assert_array_equal(solution.u, reference.u)
    half = problem.K.shape[0]
    blocks = [problem.K, sp.eye(3, format="csr")]
    pad = sp.csr_matrix((problem.N.shape[0], 3))
    pad_t = sp.csr_matrix((problem.T.shape[0], 3))
    solution = tresca.solve(
        blocks,
        np.concatenate([problem.f, [1, 2, 3]]),
        sp.hstack([problem.N, pad]),
        sp.hstack([problem.T, pad_t]),
        problem.gap,
        bound,
        tolerance=1e-12,
    )
    np.testing.assert_allclose(solution.u[:half], reference.u, atol=1e-6)
    np.testing.assert_allclose(solution.u[half:], [1, 2, 3])


@pytest.mark.parametrize("method", ["ssn", "mssn", "imssn", "gimssn", "grssn", "apgd"])
@pytest.mark.parametrize("engine", ["factored", "condensed", "explicit"])
def test_every_method_and_engine(method, engine):
    problem = random_problem(2, pairs=20)
    solution = tresca.solve(
        problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound, method=method, engine=engine
    )
    assert solution.settings["method"] == method
    assert solution.summary["engine"]["engine"] == engine
    # Optimality, by NumPy.
    A, b = problem.dual()
    force = np.concatenate([solution.normal_force, solution.tangential_force.ravel()])
    r = A @ force - b
    m = len(problem.gap)
    np.testing.assert_allclose(r[:m], solution.gap, atol=1e-10)
    np.testing.assert_allclose(-r[m:], solution.slip.ravel(), atol=1e-10)
    assert (solution.normal_force >= 0).all() and (r[:m] > -1e-6).all()
    assert np.abs(solution.normal_force * r[:m]).max() < 1e-6
    sizes = np.linalg.norm(solution.tangential_force, axis=1)
    assert (sizes < problem.bound * (1 + 1e-12)).all()
    work = (solution.tangential_force * solution.slip).sum(axis=1)
    np.testing.assert_allclose(work, problem.bound * np.linalg.norm(solution.slip, axis=1), atol=1e-6)
    assert 0 < solution.closed.sum() < m and 0 < solution.stick.sum() < m


def test_laws_pair_by_pair():
    problem = random_problem(3)
    m = len(problem.gap)
    laws = [tresca.Tresca(g) for g in problem.bound]
    one = tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, laws)
    other = tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, tresca.Tresca(problem.bound))
    np.testing.assert_array_equal(one.u, other.u)
    laws[:3] = [tresca.Tied(), tresca.Frictionless(), tresca.Coulomb(0.3)]
    mixed = tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, laws, tolerance=1e-10)
    np.testing.assert_allclose(mixed.slip[0], 0, atol=1e-8)
    np.testing.assert_allclose(mixed.gap[0], 0, atol=1e-8)
    assert (mixed.tangential_force[1] == 0).all()
    assert np.linalg.norm(mixed.tangential_force[2]) <= 0.3 * mixed.normal_force[2] * (1 + 1e-6)
    assert np.isinf(mixed.slip_bounds[0]).all() and mixed.slip_bounds.shape == (m, 2)


def test_a_floating_block_is_held_by_contact():
    # Two masses on a spring, nothing else, pushed against a wall by 3.
    k = np.array([[5.0, -5.0], [-5.0, 5.0]])
    for kernel in (None, [1.0, 1.0], [[1.0], [1.0]]):
        solution = tresca.solve(k, [1.0, 2.0], [[1.0, 0.0]], gap=[0.25], kernel=kernel, tolerance=1e-12)
        np.testing.assert_allclose(solution.normal_force, [3.0], rtol=1e-10)
        np.testing.assert_allclose(solution.u, [0.25, 0.65], rtol=1e-10)
        assert solution.tangential_force.shape == (1, 0)
        assert any("kernel" in note for note in solution.notes) == (kernel is None)
    with pytest.warns(tresca.ConvergenceWarning, match="no_equilibrium"):
        solution = tresca.solve(k, [-1.0, -2.0], [[1.0, 0.0]])
    np.testing.assert_allclose(np.abs(solution.unresisted_motion), [1.0, 1.0])


def test_load_steps_remember_the_slip():
    problem = random_problem(4)
    prepared = tresca.prepare(problem.K, problem.N, problem.T, tresca.Tresca(problem.bound), tolerance=1e-10)
    assert prepared.description["pairs"] == 8 and "8 pairs" in repr(prepared)
    first = prepared.solve(problem.f, problem.gap)
    assert first.settings["tolerance"] == 1e-10
    back = prepared.solve(0 * problem.f, problem.gap, previous_slip=first.slip, start=first)
    alone = tresca.solve(
        problem.K,
        0 * problem.f,
        problem.N,
        problem.T,
        problem.gap,
        problem.bound,
        previous_slip=first.slip,
        tolerance=1e-10,
    )
    np.testing.assert_allclose(back.u, alone.u, atol=1e-8)
    assert np.abs(back.u).max() > 1e-3, "friction holds something back"
    again = prepared.solve(problem.f, problem.gap, start=(first.normal_force, first.tangential_force))
    assert again.iterations <= 1 and first.iterations > 1
    weaker = prepared.solve(problem.f, problem.gap, tresca.Tresca(problem.bound / 2))
    assert np.linalg.norm(weaker.tangential_force) < np.linalg.norm(first.tangential_force)
    with pytest.raises(tresca.ProblemError, match="another kind"):
        prepared.solve(problem.f, friction=tresca.Tied())


def test_history_and_repr():
    problem = random_problem(5)
    seen = []
    solution = tresca.solve(
        problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound, callback=seen.append
    )
    history = solution.history
    assert len(history) == len(seen) == solution.iterations + 1
    for name in history.dtype.names:
        np.testing.assert_array_equal(history[name], [getattr(record, name) for record in seen])
    assert history["relative_reduced_gradient"][-1] <= 1e-8
    assert (np.diff(history["objective"]) <= 1e-15).all()
    assert history["n_a"][-1] <= solution.n_a
    text = repr(solution)
    for part in ("converged", f"{solution.closed.sum()} closed", "worst figure of the certificate"):
        assert part in text
    assert "equilibrium" in str(solution.certificate) and "Iteration(" in repr(seen[0])


def test_an_unconverged_result_warns():
    problem = random_problem(6)
    with pytest.warns(tresca.ConvergenceWarning, match="iteration_limit") as record:
        solution = tresca.solve(
            problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound, max_iterations=1
        )
    assert record[0].filename == __file__
    assert solution.status == "iteration_limit" and not solution.converged


def test_a_callback_stops_and_raises():
    problem = random_problem(7)
    arguments = (problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound)
    with pytest.warns(tresca.ConvergenceWarning, match="interrupted"):
        solution = tresca.solve(*arguments, callback=lambda record: record.iteration == 1)
    assert solution.iterations == 1

    def fails(record):
        raise LookupError("from the callback")

    with pytest.raises(LookupError, match="from the callback"):
        tresca.solve(*arguments, callback=fails)


def slow(seconds):
    """A dual problem whose products take their time; interruptible as plain Python is."""

    def product(x):
        time.sleep(seconds)
        return x * (1 + np.arange(len(x)))

    return product


@pytest.fixture
def ctrl_c():
    """A timer that interrupts the main thread once.

    Programs started in the background ignore interrupts: Python's own handler is set for the test.
    """
    main = threading.main_thread().ident
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield lambda seconds: threading.Timer(seconds, lambda: signal.pthread_kill(main, signal.SIGINT))
    signal.signal(signal.SIGINT, before)


def test_ctrl_c_ends_a_solve(ctrl_c):
    problem = random_problem(8, pairs=40)
    timer = ctrl_c(0.2)

    def wait(record):
        # Signals arrive between bytecodes: as a loop of plain Python would see them.
        timer.start() if not timer.is_alive() and record.iteration == 0 else None
        time.sleep(0.3)

    with pytest.raises(KeyboardInterrupt):
        tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound, callback=wait)
    timer.join()
    timer = ctrl_c(0.2)
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        tresca.solve_dual(slow(0.01), np.ones(400), tangents=0, tolerance=1e-14)
    timer.join()


def test_ctrl_c_without_any_python_code(ctrl_c):
    problem = random_problem(9, pairs=400)
    timer = ctrl_c(0.3)
    timer.start()
    end = time.monotonic() + 30
    with pytest.raises(KeyboardInterrupt):
        while time.monotonic() < end:
            tresca.solve(problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound)
    timer.join()


def test_other_threads_run_meanwhile():
    problem = random_problem(10, pairs=400)
    done, longest = threading.Event(), [0.0]

    def beat():
        last = time.perf_counter()
        while not done.is_set():
            time.sleep(0.001)
            now = time.perf_counter()
            longest[0] = max(longest[0], now - last)
            last = now

    thread = threading.Thread(target=beat)
    thread.start()
    begin = time.perf_counter()
    for _ in range(3):
        tresca.solve(
            problem.K, problem.f, problem.N, problem.T, problem.gap, problem.bound, method="apgd", tolerance=1e-12
        )
    took = time.perf_counter() - begin
    done.set()
    thread.join()
    assert longest[0] < 0.5 * took, (longest, took)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"K": np.diag([1.0, np.nan])}, "K: entry 3 is NaN"),
        ({"K": np.array([[1.0, 0.5], [0.0, 2.0]])}, "not symmetric"),
        ({"K": np.diag([1.0, -2.0])}, "positive"),
        ({"K": np.ones(4)}, "K has 1 dimension"),
        ({"K": np.diag([1.0, 2.0j])}, "complex128"),
        ({"f": [1.0]}, "the load f has length 1, expected 2"),
        ({"f": [1.0, np.inf]}, "the load f holds inf at index 1"),
        ({"N": [[1.0, 0.0, 0.0]]}, "N is 1 × 3"),
        ({"T": [[1.0, 0.0]] * 3}, "T is 3 × 2"),
        ({"T": None}, "needs the tangential matrix T"),
        ({"gap": [0.1, 0.2]}, "the gap d has length 2, expected 1"),
        ({"friction": tresca.Tresca(-1.0)}, "the slip bound of pair 0 is -1"),
        ({"friction": tresca.Tresca([1.0, 2.0])}, "for 2 pairs, expected 1"),
        ({"friction": tresca.Tresca(np.nan)}, "must be a number"),
        ({"friction": [tresca.Tied()] * 2}, "the list of friction laws has length 2"),
        ({"friction": "tresca"}, "expected real numbers"),
        ({"tolerance": 0.0}, "setting `tolerance` is 0.0"),
        ({"tolerance": np.nan}, "setting `tolerance` is NaN"),
        ({"method": "newton"}, "newton"),
        ({"max_iterations": 1.5}, "max_iterations|integer|usize"),
        ({"kernel": [[1.0], [0.0]]}, "kernel"),
        ({"points": [[0.0]]}, "points has the shape"),
        ({"previous_slip": [1.0, 2.0]}, "the previous slip has length 2"),
        ({"start": ([1.0], [])}, "the start of the tangential forces"),
    ],
)
def test_wrong_input_is_named(change, message):
    arguments = {"K": K, "f": F, "N": N, "T": T, "gap": GAP, "friction": tresca.Tresca(0.4)} | change
    with pytest.raises(tresca.ProblemError, match=message) as caught:
        tresca.solve(**arguments)
    assert isinstance(caught.value, ValueError)


def test_unknown_options_are_refused():
    with pytest.raises(TypeError, match="no option `tolerence`: expected one of method, tolerance"):
        tresca.solve(K, F, N, tolerence=1e-8)
    with pytest.raises(TypeError, match="a number or a word"):
        tresca.solve(K, F, N, tolerance=[1e-8])


def test_corrupt_sparse_matrices_are_refused():
    broken = sp.csr_matrix(K)
    broken.indices[1] = 7
    with pytest.raises(tresca.ProblemError, match="column that is not in 0..2"):
        tresca.solve(broken, F, N)
