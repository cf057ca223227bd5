"""The pure dual form."""

from __future__ import annotations

from typing import Any, Unpack

import numpy as np
import numpy.typing as npt

from . import _arrays, _tresca
from ._friction import Friction, pack
from ._options import Options, given
from ._solution import Solution, solution
from ._solve import Callback, Start, start_arrays
from ._tresca import ProblemError


def solve_dual(
    A: Any,
    b: npt.ArrayLike,
    friction: Friction = None,
    *,
    tangents: int = 2,
    diagonal: npt.ArrayLike | None = None,
    start: Start | None = None,
    callback: Callback | None = None,
    **options: Unpack[Options],
) -> Solution:
    """Minimise ½ λᵀAλ − λᵀb over admissible contact forces λ.

    λ holds m normal forces (≥ 0), then the friction forces, those of a pair adjacent (‖λτ,i‖ ≤ g_i). With
    matrices as of :func:`solve`, A = B K⁻¹ Bᵀ and b = B K⁻¹ f − [d; 0], B = [N; T].

    Parameters
    ----------
    A : array_like, sparse matrix, LinearOperator or callable
        Symmetric positive (semi)definite, of order (1 + `tangents`) m. A callable computes ``A @ x``. An array of
        doubles is not copied: do not change it meanwhile.
    b : array_like, shape ((1 + tangents) m,)
        Right-hand side.
    friction : law, list of m laws, or array_like, optional
        As of :func:`solve`; numbers alone are bounds of Tresca's law.
    tangents : int, optional
        Tangents per pair: 2 in space, 1 in the plane, 0 without friction.
    diagonal : array_like, optional
        The diagonal of A, when A is a LinearOperator or a callable: preconditions.
    start, callback, **options
        As of :func:`solve`. There is no factorisation here: `engine` is not looked at.

    Returns
    -------
    Solution
        Without `u`; `gap` and `slip` are those of Aλ − b = [gap; −slip].

    Raises
    ------
    ProblemError
        When A, b, a law or an option is wrong.

    Warns
    -----
    ConvergenceWarning
        When the run ended otherwise than at its tolerance.
    """
    rhs = _arrays.vector("the right-hand side b", b)
    if tangents not in (0, 1, 2):
        raise ProblemError(f"there are {tangents} tangents per pair: expected 0, 1 or 2")
    rest = (rhs, tangents, pack(friction, len(rhs) // (1 + tangents)), start_arrays(start))
    if _arrays.is_sparse(A):
        _check_shape(A.shape, len(rhs))
        matrix = A.tocsr()
        diagonal = matrix.diagonal() if diagonal is None else diagonal
        product = matrix.__matmul__
    elif hasattr(A, "matvec"):
        _check_shape(A.shape, len(rhs))
        product = A.matvec
    elif callable(A):
        product = A
    else:
        dense = np.asarray(A)
        if dense.ndim == 2 and dense.flags.f_contiguous:
            # A is symmetric: its transpose, which needs no copy, does as well.
            dense = dense.T
        dense = _arrays.floats("A", dense)
        if dense.ndim != 2:
            raise ProblemError(f"A has {dense.ndim} dimension(s): a matrix has two")
        return solution(_tresca.solve_dual_dense(dense, rest, given(options), callback), stacklevel=2)

    def apply(x: _arrays.Floats) -> _arrays.Floats:
        return _arrays.vector("the product A x", product(x))

    raw = _tresca.solve_dual_product(
        apply, _arrays.optional("the diagonal of A", diagonal), rest, given(options), callback
    )
    return solution(raw, stacklevel=2)


def _check_shape(shape: tuple[int, ...], order: int) -> None:
    if tuple(shape) != (order, order):
        raise ProblemError(f"A has the shape {tuple(shape)}, expected {(order, order)}: b has length {order}")
