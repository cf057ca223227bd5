"""What the border between Python and the solver costs, beside the multiplications by A.

A dense dual problem with 41² contact pairs (5043 unknowns), once with A as an array, once with A as a Python
function. The solver clocks its multiplications itself (``times["multiplications"]``); for the function the time
spent in it is measured here. All else counts as outside: looking at every entry of A, the methods' own work,
and the way through Python. The certificate multiplies once more, at the price of the others.

    python crates/tresca-bench/python/border.py
"""

from __future__ import annotations

import argparse
import statistics
import time

import numpy as np
import tresca

SIDE = 41
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


def measure(name: str, solve, inside) -> float:
    """Solves and prints one line; returns the share of the time outside of the multiplications."""
    begin = time.perf_counter()
    solution = solve()
    total = time.perf_counter() - begin
    spent = inside(solution)
    share = 1.0 - spent / total
    before = total - solution.times["total"]
    print(
        f"{name:<16}{solution.n_a:5d} n_A{total:9.3f} s total{spent:9.3f} s in multiplications{share:8.1%} outside,"
        f" {before:.3f} s of it to take A in and results out"
    )
    return share


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--side", type=int, default=SIDE, help="pairs along an edge of the contact face")
    parser.add_argument("--runs", type=int, default=5, help="the median of so many runs counts")
    arguments = parser.parse_args()
    A, b, bound = problem(arguments.side)
    print(f"{len(bound)} pairs, {len(b)} unknowns, A has {A.nbytes / 1e6:.0f} MB")
    clock = [0.0]

    def product(x: np.ndarray) -> np.ndarray:
        begin = time.perf_counter()
        y = A @ x
        clock[0] += time.perf_counter() - begin
        return y

    def by_function() -> tresca.Solution:
        clock[0] = 0.0
        return tresca.solve_dual(product, b, bound, diagonal=np.diag(A))

    ways = {
        "A as an array": (lambda: tresca.solve_dual(A, b, bound), lambda s: s.times["multiplications"] * (s.n_a + 1) / s.n_a),
        "A as a function": (by_function, lambda s: clock[0]),
    }
    for name, (solve, inside) in ways.items():
        shares = [measure(name, solve, inside) for _ in range(arguments.runs)]
        share = statistics.median(shares)
        verdict = "within" if share <= LIMIT else "MORE THAN"
        # Small problems are all border.
        allowed = f", {verdict} the {LIMIT:.0%} that are allowed" if arguments.side >= SIDE else ""
        print(f"{name}: {share:.1%} outside in the median{allowed}\n")


if __name__ == "__main__":
    main()
