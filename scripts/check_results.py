#!/usr/bin/env python3
"""Check the result files of a run against its summary, with readers that are not ours.

    python scripts/check_results.py DIRECTORY...

Every `.vtu` of a run's `.pvd` is read by `meshio` and by `vtk` (see check_vtu.py: both must agree on
every value); then the figures of `summary.json` are computed again from the fields, load step by load step: pairs,
closed, stick, slip, sum of the normal forces, resultants, dissipation, largest pressure, gap and slip, cone violation,
and the von Mises stress from the stress tensor. Exit code 1 and a line on stderr when something does not fit.
"""

import json
import sys
from pathlib import Path

import meshio
import numpy as np

import check_vtu


def close(name, found, expected, relative=1e-12):
    scale = max(abs(expected), np.finfo(float).tiny)
    check_vtu.demand(
        abs(found - expected) <= relative * scale, f"{name}: files say {found!r}, summary {expected!r}"
    )
    print(f"{name:<28} {found:.12g}")


def check_contact(fields, step):
    """The contact fields of a step against the summary's figures."""
    contact = step["contact"]
    count = lambda mask: int(np.count_nonzero(mask))
    closed, sticking = fields["closed"] == 1, fields["sticking"] == 1
    close("pairs", closed.size, contact["pairs"])
    close("closed", count(closed), contact["closed"])
    close("stick", count(closed & sticking), contact["stick"])
    close("slip", count(closed & ~sticking), contact["slip"])
    rubbed = np.linalg.norm(fields["tangential_force"], axis=1) > 0
    close("open pairs with friction", count(~closed & rubbed), contact["open_with_friction"])
    close("sum of normal forces", fields["normal_force"].sum(), contact["normal_force_sum"])
    close("largest pressure", max(fields["contact_pressure"].max(), 0.0), contact["max_pressure"])
    close("largest gap", max(fields["gap"].max(), 0.0), contact["max_gap"])
    # Where the normals are along an axis, global slip components are local ones.
    if np.allclose(np.abs(fields["normal"]).max(axis=1), 1.0):
        close("largest slip component", np.abs(fields["slip"]).max(), contact["max_slip_component"])
    work = (fields["tangential_force"] * fields["slip_increment"]).sum()
    size = np.abs(fields["tangential_force"] * fields["slip_increment"]).sum()
    check_vtu.demand(abs(work - contact["dissipation"]) <= 1e-9 * size, "dissipation")
    forces = fields["normal_force"][:, None] * fields["normal"] + fields["tangential_force"]
    for number, resultant in enumerate(step["resultants"]):
        found = forces[fields["pair"] == number].sum(axis=0)
        off = np.abs(found - resultant["force"]).max()
        check_vtu.demand(off <= 1e-9 * np.abs(forces).sum(), f"resultant of contact {number}: off by {off}")

    force = np.linalg.norm(fields["tangential_force"], axis=1)
    # Tied (4) and bilateral (5) pairs may pull; tied ones have no slip bound.
    law, bound = fields["friction_law"], fields["slip_bound"]
    check_vtu.demand((fields["normal_force"][law < 4] >= 0).all(), "a normal force is negative")
    slack = 1e-12 * bound + 1e-5 * bound.max()
    check_vtu.demand((force <= bound + slack)[law != 4].all(), "a friction force is above its bound")
    check_vtu.demand((fields["status"] == np.where(closed, np.where(sticking, 1, 2), 0)).all(), "status")


def check_body(path, status):
    """Von Mises stress against the tensor; what moves."""
    points = meshio.read(path).point_data
    xx, yy, zz, xy, yz, xz = points["stress"].reshape(-1, 6).T
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    equivalent = np.sqrt(0.5 * normal + 3 * (xy**2 + yz**2 + xz**2))
    error = np.abs(equivalent - points["von_mises_stress"].ravel()).max()
    check_vtu.demand(error <= 1e-12 * equivalent.max(), f"{path}: von Mises stress is off by {error}")
    moved = np.linalg.norm(points["displacement"], axis=1)
    # Without equilibrium there is no displacement.
    moves, should = bool((moved > 0).any()), status != "no_equilibrium"
    check_vtu.demand(moves == should, f"{path}: {'something' if moves else 'nothing'} moves, but the status is {status}")
    print(f"{path.name:<28} {moved.size} nodes, largest displacement {moved.max():.6g}")


def main(directory):
    summary = json.loads((directory / "summary.json").read_text())
    collection = next(directory.glob("*.pvd"))
    grids = check_vtu.grids_of(collection)
    steps = summary["steps"]
    check_vtu.demand(len(grids) == len(steps) * (summary["bodies"] + 1), f"{len(grids)} files in {collection}")
    for path in grids:
        check_vtu.check_grid(path)
    for step in steps:
        suffix = "" if summary["planned_steps"] == 1 else f"_{step['step']:04}"
        print(f"-- {directory.name}, step {step['step']}")
        contact = meshio.read(directory / f"contact{suffix}.vtu")
        fields = {name: np.squeeze(values) for name, values in contact.point_data.items()}
        check_contact(fields, step)
        for path in grids:
            if path.stem.endswith(suffix) and path.stem != f"contact{suffix}":
                check_body(path, step["status"])
    rows = [row.split(",") for row in (directory / "history.csv").read_text().splitlines()]
    column = rows[0].index("step")
    found = {int(row[column]) for row in rows[1:]}
    check_vtu.demand(found <= {step["step"] for step in steps}, f"history speaks of the steps {found}")
    close("steps", len(steps), summary["planned_steps"])
    print("the files and the summary agree")


if __name__ == "__main__":
    try:
        for argument in sys.argv[1:]:
            main(Path(argument))
    except check_vtu.Disagreement as problem:
        sys.exit(f"check_results: {problem}")
