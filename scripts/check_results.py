#!/usr/bin/env python3
"""Check the result files of a run against its summary, with readers that are not ours.

    python scripts/check_results.py DIRECTORY

Every `.vtu` of the run's `.pvd` is read by `meshio` and by `vtk` (see check_vtu.py: both must agree on
every value); then the figures of `summary.json` are computed again from the fields: pairs, closed, stick, slip,
sum of the normal forces, largest pressure, gap and slip, cone violation, and the von Mises stress from the stress
tensor. Exit code 1 and a line on stderr when something does not fit.
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


def check_contact(fields, contact):
    """The contact fields against the summary's figures."""
    count = lambda mask: int(np.count_nonzero(mask))
    closed, sticking = fields["closed"] == 1, fields["sticking"] == 1
    close("pairs", closed.size, contact["pairs"])
    close("closed", count(closed), contact["closed"])
    close("stick", count(sticking), contact["stick"])
    close("slip", count(~sticking), contact["slip"])
    close("sum of normal forces", fields["normal_force"].sum(), contact["normal_force_sum"])
    close("largest pressure", fields["contact_pressure"].max(), contact["max_pressure"])
    close("largest gap", fields["gap"].max(), contact["max_gap"])
    # The normals of the benchmark are along an axis, so global slip components are local ones.
    if np.allclose(np.abs(fields["normal"]).max(axis=1), 1.0):
        close("largest slip component", np.abs(fields["slip"]).max(), contact["max_slip_component"])

    force = np.linalg.norm(fields["tangential_force"], axis=1)
    bound = fields["slip_bound"]
    check_vtu.demand((fields["normal_force"] >= 0).all(), "a normal force is negative")
    check_vtu.demand((force <= bound * (1 + 1e-12)).all(), "a friction force is above its bound")
    check_vtu.demand((fields["status"] == np.where(closed, np.where(sticking, 1, 2), 0)).all(), "status")


def check_body(path):
    """Von Mises stress against the tensor; held nodes exist."""
    points = meshio.read(path).point_data
    xx, yy, zz, xy, yz, xz = points["stress"].reshape(-1, 6).T
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    equivalent = np.sqrt(0.5 * normal + 3 * (xy**2 + yz**2 + xz**2))
    error = np.abs(equivalent - points["von_mises_stress"].ravel()).max()
    check_vtu.demand(error <= 1e-12 * equivalent.max(), f"{path}: von Mises stress is off by {error}")
    moved = np.linalg.norm(points["displacement"], axis=1)
    check_vtu.demand((moved == 0).any() and (moved > 0).any(), f"{path}: displacement")
    print(f"{path.name:<28} {moved.size} nodes, largest displacement {moved.max():.6g}")


def main(directory):
    summary = json.loads((directory / "summary.json").read_text())
    collection = next(directory.glob("*.pvd"))
    for path in check_vtu.grids_of(collection):
        check_vtu.check_grid(path)
    contact = meshio.read(directory / "contact.vtu")
    fields = {name: np.squeeze(values) for name, values in contact.point_data.items()}
    check_contact(fields, summary["contact"])
    bodies = [path for path in sorted(directory.glob("*.vtu")) if path.stem != "contact"]
    check_vtu.demand(len(bodies) == summary["bodies"], f"{len(bodies)} bodies on disk")
    for path in bodies:
        check_body(path)
    rows = (directory / "history.csv").read_text().splitlines()
    close("iterations", len(rows) - 2, summary["iterations"])
    print("the files and the summary agree")


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]))
    except check_vtu.Disagreement as problem:
        sys.exit(f"check_results: {problem}")
