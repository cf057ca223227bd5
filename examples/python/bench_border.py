"""What the border between Python and the solver costs, beside the multiplications by A.

A dense dual problem with 41² contact pairs (5043 unknowns), once with A as an array, once with A as a Python
function. For the function the time spent in it is measured. For the array the price of a multiplication is
taken from the projected gradient method, which does nothing else but a few vector operations; so it is
an upper bound for the price, by about one part in a hundred.

    python examples/python/bench_border.py
"""

from __future__ import annotations

import argparse
import time

import numpy as np
import tresca

LIMIT = 0.10


def problem(side: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A, b and slip bounds as of an elastic half-space: a force at one pair moves the others as 1/distance."""
    ticks = np.linspace(0.0, 1.0, side)
    points = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 2)
    m = len(points)
    distance = np.linalg.norm(points[:, np.newaxis] - points, axis=2)
    decay = ticks[1] / (distance + ticks[1])
    A = np.zeros((3 * m, 3 * m))
    A[:m, :m] = decay
    A[m::2, m::2] = A[m + 1 :: 2, m + 1 :: 2] = 1.2 * decay
    x, y = points.T
    approach = 10 * np.cos(2 * np.pi * x) + 4 * y
    slip = 10 * np.stack([np.sin(3 * x + y), 0.5 * np.cos(4 * y)], axis=1)
    b = np.concatenate([approach, slip.ravel()])
    return A, b, np.full(m, 0.5)


def timed(call) -> tuple[tresca.Solution, float]:
    """A result and the seconds that it took."""
    begin = time.perf_counter()
    solution = call()
    return solution, time.perf_counter() - begin


def report(what: str, total: float, inside: float, solution: tresca.Solution) -> float:
    """One line; returns the share of the time outside of the multiplications."""
    share = 1.0 - inside / total
    print(
        f"{what:<18}{solution.n_a:6d} n_A{total:9.3f} s total{inside:9.3f} s in multiplications{share:8.1%} outside"
    )
    return share


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--side", type=int, default=41, help="pairs along an edge of the contact face")
    parser.add_argument("--runs", type=int, default=3, help="the best of so many runs counts")
    arguments = parser.parse_args()
    A, b, bound = problem(arguments.side)
    print(f"{len(bound)} pairs, {len(b)} unknowns")

    def of_array() -> tuple[float, str, tuple]:
        gradient = tresca.solve_dual(A, b, bound, method="apgd", tolerance=1e-3)
        price = gradient.times["solve"] / gradient.n_a
        solution, total = timed(lambda: tresca.solve_dual(A, b, bound))
        # One more for the certificate.
        inside = (solution.n_a + 1) * price
        return 1 - inside / total, "A as an array", (total, inside, solution)

    def of_function() -> tuple[float, str, tuple]:
        spent = [0.0]

        def product(x: np.ndarray) -> np.ndarray:
            begin = time.perf_counter()
            y = A @ x
            spent[0] += time.perf_counter() - begin
            return y

        solution, total = timed(lambda: tresca.solve_dual(product, b, bound, diagonal=np.diag(A)))
        return 1 - spent[0] / total, "A as a function", (total, spent[0], solution)

    for measure in (of_array, of_function):
        runs = [measure() for _ in range(arguments.runs)]
        _, what, figures = min(runs, key=lambda run: run[2][0])
        share = report(what, *figures)
        times = ", ".join(f"{name} {seconds:.3f}" for name, seconds in figures[2].times.items())
        before = figures[0] - figures[2].times["total"]
        print(f"{'':<18}taking A in and results out {before:.3f} s; then {times}")
        if share > LIMIT:
            print(f"{'':<18}more than {LIMIT:.0%}")


if __name__ == "__main__":
    main()
