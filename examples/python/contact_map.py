"""A picture of contact pressure, friction and stick/slip on the contact face of the two bricks.

    python examples/python/contact_map.py --out contact.png
"""

from __future__ import annotations

import argparse

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import tresca
from bricks import SLIP_BOUND, two_bricks


def main() -> None:
    """Solves and draws."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nodes", type=int, default=13, help="nodes along every edge of a brick")
    parser.add_argument("--out", default="contact.png", help="the picture")
    arguments = parser.parse_args()

    bricks = two_bricks(arguments.nodes)
    bound = SLIP_BOUND * bricks.areas
    solution = tresca.solve(bricks.K, bricks.f, bricks.N, bricks.T, friction=tresca.Tresca(bound))
    assert solution.converged and solution.certificate.worst < 1e-6, solution

    x, y = bricks.points[:, 0], bricks.points[:, 1]
    pressure = solution.normal_force / bricks.areas
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 3.2), layout="constrained", sharey=True)
    filled = left.tricontourf(x, y, pressure, levels=20, cmap="viridis")
    figure.colorbar(filled, ax=left, label="MPa")
    left.set_title("contact pressure")
    states = {
        "open, sticks": (~solution.closed & solution.stick, "none", "tab:blue"),
        "open, slips": (~solution.closed & ~solution.stick, "none", "tab:red"),
        "closed, sticks": (solution.closed & solution.stick, "tab:blue", "tab:blue"),
        "closed, slips": (solution.closed & ~solution.stick, "tab:red", "tab:red"),
    }
    for label, (which, face, edge) in states.items():
        if which.any():
            right.scatter(x[which], y[which], s=18, facecolors=face, edgecolors=edge, label=label)
    friction = solution.tangential_force / bricks.areas[:, np.newaxis]
    right.quiver(x, y, *friction.T, width=0.002, alpha=0.6)
    right.set_title("state and friction of the pairs")
    right.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize="small")
    for axes in (left, right):
        axes.set(xlabel="x [m]", aspect="equal")
    left.set_ylabel("y [m]")
    figure.savefig(arguments.out, dpi=130)
    print(f"{arguments.out}: largest pressure {pressure.max():.3f} MPa, {solution.stick.sum()} pairs stick")


if __name__ == "__main__":
    main()
