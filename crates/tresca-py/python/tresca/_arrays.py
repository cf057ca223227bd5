"""Arrays as the compiled half takes them: contiguous, double precision. What is so already is not copied."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import numpy.typing as npt

from ._tresca import ProblemError

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]
Sparse = tuple[str, tuple[int, int], npt.NDArray[Any], npt.NDArray[Any], Floats]
Matrix = Sparse | Floats


def floats(what: str, values: npt.ArrayLike) -> Floats:
    """An array of finite or infinite doubles; complex numbers and texts are refused, not cast."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiub":
        raise ProblemError(f"{what} has the type {array.dtype}: expected real numbers")
    return np.ascontiguousarray(array, dtype=np.float64)


def vector(what: str, values: npt.ArrayLike) -> Floats:
    """A vector; rows of a table (one per contact pair) are put one after another."""
    return floats(what, values).reshape(-1)


def optional(what: str, values: npt.ArrayLike | None) -> Floats | None:
    """The same, if there is one."""
    return None if values is None else vector(what, values)


def is_sparse(matrix: object) -> bool:
    """Whether this is a matrix or an array of scipy.sparse. SciPy itself is not needed to know."""
    return hasattr(matrix, "tocoo") and hasattr(matrix, "format")


def matrix(what: str, value: Any) -> Matrix:
    """A matrix: scipy.sparse in any format, or what NumPy takes for a table."""
    if not is_sparse(value):
        dense = floats(what, value)
        if dense.ndim != 2:
            raise ProblemError(f"{what} has {dense.ndim} dimension(s): a matrix has two")
        return dense
    if len(value.shape) != 2:
        raise ProblemError(f"{what} has {len(value.shape)} dimension(s): a matrix has two")
    if value.format not in ("csr", "csc", "coo"):
        value = value.tocsr()
    if value.format == "coo":
        first, second = value.row, value.col
    else:
        first, second = value.indptr, value.indices
    # One type for both, and one that the compiled half knows.
    both = np.result_type(first.dtype, second.dtype, np.int32)
    first, second = (np.ascontiguousarray(part, dtype=both) for part in (first, second))
    rows, columns = value.shape
    return value.format, (int(rows), int(columns)), first, second, vector(what, value.data)


def columns(what: str, vectors: npt.ArrayLike) -> list[Floats]:
    """The columns of a table, each contiguous."""
    table = floats(what, vectors)
    if table.ndim == 1:
        table = table.reshape(-1, 1)
    if table.ndim != 2:
        raise ProblemError(f"{what} has {table.ndim} dimensions: expected one column per vector")
    return [np.ascontiguousarray(column) for column in table.T]


def triples(what: str, points: npt.ArrayLike) -> Floats:
    """Points in space; points in the plane get a third coordinate 0."""
    table = floats(what, points)
    if table.ndim != 2 or table.shape[1] not in (2, 3):
        raise ProblemError(f"{what} has the shape {table.shape}: expected (m, 2) or (m, 3)")
    if table.shape[1] == 2:
        table = np.column_stack([table, np.zeros(len(table))])
    return np.ascontiguousarray(table)


def rows_of(matrix: Matrix) -> int:
    """Number of rows."""
    shape = matrix[1] if isinstance(matrix, tuple) else matrix.shape
    return cast("int", shape[0])
