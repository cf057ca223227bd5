"""Two bricks assembled by scikit-fem and solved through Python: the answer is that of the command line.

    python examples/python/two_bricks.py --nodes 9 --program target/release/tresca
"""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import tresca
from bricks import SLIP_BOUND, two_bricks

CASE = Path(__file__).parents[2] / "cases" / "two-bricks.toml"
TOLERANCE = 1e-12
AGREEMENT = 1e-9


def close(what: str, ours: np.ndarray | float, theirs: np.ndarray | float) -> None:
    """Fails unless two results agree."""
    difference = np.max(np.abs(np.asarray(ours) - theirs)) / np.max(np.abs(theirs))
    print(f"{what:<28}{difference:9.1e}")
    assert difference < AGREEMENT, what


def main() -> None:
    """Solves both ways and compares."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nodes", type=int, default=9, help="nodes along every edge of a brick")
    parser.add_argument("--program", default="tresca", help="the command-line program")
    arguments = parser.parse_args()
    s = arguments.nodes

    bricks = two_bricks(s)
    bound = tresca.Tresca(SLIP_BOUND * bricks.areas)
    solution = tresca.solve(
        bricks.K, bricks.f, bricks.N, bricks.T, friction=bound, points=bricks.points, tolerance=TOLERANCE
    )
    print(solution)

    text = CASE.read_text().replace("nodes = [16, 16, 16]", f"nodes = [{s}, {s}, {s}]")
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder) / "bricks.toml"
        case.write_text(text)
        options = ["--quiet", "--tolerance", str(TOLERANCE), "--out", folder]
        subprocess.run([arguments.program, "solve", str(case), *options], check=True)
        step = json.loads((Path(folder) / "summary.json").read_text())["steps"][0]
        # The files hold the displacements, too; the same case read by Python spares a VTU reader.
        result = tresca.Case.load(case).solve(tolerance=TOLERANCE).last

    print("\nrelative differences to the command line")
    close("dual objective", solution.dual_objective, step["dual_objective"])
    close("sum of normal forces", solution.normal_force.sum(), step["contact"]["normal_force_sum"])
    force = np.array([*solution.tangential_force.sum(axis=0), -solution.normal_force.sum()])
    close("resultant on the master", force, step["resultants"][0]["force"])
    assert solution.closed.sum() == step["contact"]["closed"]
    assert (solution.closed & solution.stick).sum() == step["contact"]["stick"]

    contact = result.contacts[0]
    order = np.lexsort((contact.points[:, 1], contact.points[:, 0]))
    close("normal forces", solution.normal_force, contact.normal_force[order])
    close("friction forces", solution.tangential_force, contact.friction_force[order, :2])
    close("slip", solution.slip, contact.slip[order, :2])
    close("largest displacement", np.abs(solution.u).max(), max(np.abs(u).max() for u in result.displacements.values()))
    # All displacements: both number the nodes of a brick on their own, so the energies stand for them.
    norm = np.sqrt(sum((u**2).sum() for u in result.displacements.values()))
    close("norm of displacements", np.linalg.norm(solution.u), norm)


if __name__ == "__main__":
    main()
