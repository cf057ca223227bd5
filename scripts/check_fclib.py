#!/usr/bin/env python3
"""FCLIB files and our programs, seen from outside: h5py, NumPy and SciPy alone.

    python scripts/check_fclib.py RUN...         check the results of `tresca solve problem.dat|hdf5`
    python scripts/check_fclib.py --make DIR     write the two files of crates/tresca-io/tests/data/fclib

RUN is a directory with `summary.json`, `solution.csv` and the FCLIB file that `tresca` wrote. The file is read by h5py
after the description of FCLIB; u is computed again from r and the matrices, and so are both residuals of the natural
map, the violations of the cones and the ranks, and compared with the summary. Exit code 1 and a line on stderr when
something does not fit.
"""

import argparse
import csv
import json
import sys
from pathlib import Path

import h5py
import numpy as np
from scipy import sparse


def demand(holds, message):
    if not holds:
        sys.exit(f"check_fclib.py: {message}")


def matrix(group):
    """A matrix of FCLIB: CSparse's structure."""
    rows, columns, nz = (int(group[name][0]) for name in ("m", "n", "nz"))
    p, i, x = (group[name][:] for name in ("p", "i", "x"))
    if nz == -1:
        return sparse.csc_matrix((x[: p[-1]], i[: p[-1]], p), shape=(rows, columns))
    if nz == -2:
        return sparse.csr_matrix((x[: p[-1]], i[: p[-1]], p), shape=(rows, columns))
    demand(nz >= 0, f"storage scheme {nz}")
    return sparse.coo_matrix((x[:nz], (i[:nz], p[:nz])), shape=(rows, columns)).tocsc()


def problem(file):
    """(dimension, W, q, μ, (M, H, f) or None), W dense."""
    if "fclib_local" in file:
        group = file["fclib_local"]
        vectors = group["vectors"]
        w = matrix(group["W"]).toarray()
        return int(group["spacedim"][0]), w, vectors["q"][:], vectors["mu"][:], None
    group = file["fclib_global"]
    vectors = group["vectors"]
    m, h = matrix(group["M"]).toarray(), matrix(group["H"]).toarray()
    f, w = vectors["f"][:], vectors["w"][:]
    inverse = np.linalg.solve(m, np.column_stack([h, f]))
    return int(group["spacedim"][0]), h.T @ inverse[:, :-1], w + h.T @ inverse[:, -1], vectors["mu"][:], (m, h, f)


def project(law, y, bound):
    """The nearest point of the cone {‖y_T‖ ≤ μ y_N} or of the half-line times the disc of radius g."""
    normal, tangent = y[0], y[1:]
    size = np.linalg.norm(tangent)
    if law == "tresca":
        scale = min(1.0, bound / size) if size > 0 else 1.0
        return np.concatenate([[max(normal, 0.0)], scale * tangent])
    if size <= bound * normal:
        return y
    if bound * size <= -normal:
        return np.zeros_like(y)
    onto = (normal + bound * size) / (1 + bound**2)
    return np.concatenate([[onto], bound * onto * tangent / size])


def natural_map(law, r, u, bounds, rho):
    """‖r − P(r − ρ(u + μ‖u_T‖ n))‖, without the shift for Tresca's law."""
    total = 0.0
    for own_r, own_u, bound in zip(r, u, bounds):
        shifted = own_u.copy()
        if law == "coulomb":
            shifted[0] += bound * np.linalg.norm(own_u[1:])
        total += np.sum((own_r - project(law, own_r - rho * shifted, bound)) ** 2)
    return np.sqrt(total)


def close(name, found, expected, relative=1e-9, absolute=1e-12):
    demand(
        abs(found - expected) <= absolute + relative * abs(expected),
        f"{name}: files say {found!r}, summary {expected!r}",
    )
    print(f"{name:<28} {found:.6g}")


def check(directory):
    summary = json.loads((directory / "summary.json").read_text())
    (step,) = summary["steps"]
    law = summary["law"]["name"]
    print(f"{directory}: {summary['problem']}, {law}, {summary['status']}")
    with open(directory / "solution.csv") as table:
        rows = [[float(value) for value in row] for row in list(csv.reader(table))[1:]]
    table = np.array(rows)[:, 1:]
    with h5py.File(directory / f"{summary['name']}.hdf5") as file:
        dimension, w, q, mu, body = problem(file)
        r, u = table[:, :dimension].ravel(), table[:, dimension : 2 * dimension].ravel()
        v = None
        converged = summary["status"] == "converged"
        demand(("solution" in file) == converged, "what did not converge is called a solution, or the other way round")
        if converged:
            demand(np.array_equal(file["solution/r"][:], r), "solution.csv has another r")
            demand(np.array_equal(file["solution/u"][:], u), "solution.csv has another u")
            v = file["solution/v"][:] if body else None
    scale = np.abs(w).max() * max(np.abs(r).max(), 1e-300) + np.abs(q).max()
    demand(np.abs(w @ r + q - u).max() <= 1e-10 * scale, "u is not W r + q")
    if v is not None:
        m, h, f = body
        demand(np.abs(m @ v - h @ r - f).max() <= 1e-9 * np.abs(m).max() * max(np.abs(v).max(), 1.0), "M v ≠ H r + f")

    r, u = r.reshape(-1, dimension), u.reshape(-1, dimension)
    bounds = mu if law == "coulomb" else np.full(mu.size, summary["law"]["bound"])
    residuals, matrix = step["residuals"], step["matrix"]
    size = np.linalg.norm(q)
    close("natural map, ρ = 1", natural_map(law, r, u, bounds, 1.0) / (size or 1.0), residuals["siconos"])
    rho = 1.0 / np.diag(w).max()
    reference = max(np.linalg.norm(r), rho * size) or 1.0
    close("natural map, ρ = 1/max W_ii", natural_map(law, r, u, bounds, rho) / reference, residuals["scaled"])
    close("asymmetry of W", np.abs(w - w.T).max() / (2 * np.abs(w).max()), matrix["asymmetry"])
    values = np.linalg.eigvalsh((w + w.T) / 2)
    rank = int(np.count_nonzero(values > 1e-12 * values[-1] * values.size))
    demand(rank == matrix["rank"], f"rank {rank}, summary {matrix['rank']}")
    if summary["status"] == "converged":
        demand(residuals["scaled"] <= 1e-6 + 10 * matrix["asymmetry"], "the residual is large")


def text(group, name, value):
    """As H5LTmake_dataset_string does: a scalar of fixed length with a zero at the end."""
    kind = h5py.h5t.C_S1.copy()
    kind.set_size(len(value) + 1)
    kind.set_strpad(h5py.h5t.STR_NULLTERM)
    space = h5py.h5s.create(h5py.h5s.SCALAR)
    dataset = h5py.h5d.create(group.id, name.encode(), kind, space)
    dataset.write(h5py.h5s.ALL, h5py.h5s.ALL, np.array(value.encode(), dtype=f"S{len(value) + 1}"))


def put_matrix(group, m, n, nz, p, i, x):
    for name, value in (("nzmax", [len(x)]), ("m", [m]), ("n", [n]), ("nz", [nz]), ("p", p), ("i", i)):
        group.create_dataset(name, data=np.array(value, dtype=np.int32))
    group.create_dataset("x", data=np.array(x, dtype=np.float64))


def make(directory):
    # The oldest format, which FCLIB has from its library's defaults.
    with h5py.File(directory / "local_h5py.hdf5", "w", libver=("earliest", "v108")) as file:
        group = file.create_group("fclib_local")
        group.create_dataset("spacedim", data=np.array([3], dtype=np.int32))
        # Compressed rows, with space for more entries than there are.
        put_matrix(
            group.create_group("W"), 3, 3, -2, [0, 2, 5, 7], [0, 1, 0, 1, 2, 1, 2, 0], [2, 0.5, 0.5, 1, 0.25, 0.25, 1.5, 99]
        )
        group.create_dataset("vectors/q", data=[-1.0, 0.5, 0.25])
        group.create_dataset("vectors/mu", data=[0.3])
        info = group.create_group("info")
        text(info, "title", "one contact")
        text(info, "description", "written by h5py")
        info.attrs["numberOfDegreeOfFreedom"] = np.int32(6)
        file["solution/u"], file["solution/r"] = [0.0, 0.5, 0.25], [1.0, 2.0, 3.0]
        guesses = file.create_group("guesses")
        guesses.create_dataset("number_of_guesses", data=np.array([2], dtype=np.int32))
        for number, r in (("1", [4.0, 5.0, 6.0]), ("2", [7.0, 8.0, 9.0])):
            guesses[f"{number}/u"], guesses[f"{number}/r"] = np.zeros(3), r
    with h5py.File(directory / "global_h5py.hdf5", "w", libver=("earliest", "v108")) as file:
        group = file.create_group("fclib_global")
        group.create_dataset("spacedim", data=np.array([2], dtype=np.int32))
        # Triplets, p columns and i rows; (0, 0) = 1 + 3 is given in two parts.
        put_matrix(group.create_group("M"), 2, 2, 5, [0, 1, 0, 1, 0], [0, 0, 1, 1, 0], [1, 1, 1, 3, 3])
        # Triplets as FCLIB's header describes them: p rows, i columns.
        put_matrix(group.create_group("H"), 2, 4, 4, [0, 0, 1, 1], [0, 3, 1, 2], [1, -2, 5, 0.5])
        for name, values in (("f", [1, -1]), ("w", [0, 1, 2, 3]), ("mu", [0.1, 0.2])):
            group.create_dataset(f"vectors/{name}", data=np.array(values, dtype=np.float64))
    for path in sorted(directory.glob("*_h5py.hdf5")):
        print(f"{path}: {path.stat().st_size} bytes, superblock version {path.read_bytes()[8]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="*", type=Path)
    parser.add_argument("--make", type=Path, metavar="DIR")
    arguments = parser.parse_args()
    if arguments.make:
        make(arguments.make)
    for directory in arguments.runs:
        check(directory)


if __name__ == "__main__":
    main()
