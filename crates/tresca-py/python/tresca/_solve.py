"""Problems made of matrices."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from typing import Any, TypeAlias, Unpack

import numpy as np
import numpy.typing as npt

from . import _arrays, _tresca
from ._arrays import Floats
from ._friction import Friction, pack
from ._options import Options, given
from ._solution import Solution, solution
from ._tresca import Iteration

Callback = Callable[[Iteration], object]
Start: TypeAlias = Solution | tuple[npt.ArrayLike, npt.ArrayLike]


def start_arrays(start: Start | None) -> tuple[Floats, Floats, Floats] | None:
    """Forces to start from."""
    if start is None:
        return None
    if isinstance(start, Solution):
        forces: tuple[Any, Any] = (start.normal_force, start.tangential_force)
        amounts = start.kernel_amounts
    else:
        forces, amounts = start, np.zeros(0)
    normal = _arrays.vector("the start of the normal forces", forces[0])
    tangential = _arrays.vector("the start of the tangential forces", forces[1])
    return normal, tangential, np.ascontiguousarray(amounts)


class Prepared:
    """A problem that is checked and factored, to be solved as often as need be; made by :func:`prepare`.

    One thread at a time.
    """

    def __init__(self, inner: _tresca.Prepared, dofs: int, pairs: int, friction: Any, options: dict[str, Any]) -> None:
        self._inner = inner
        self._dofs = dofs
        self._pairs = pairs
        self._friction = friction
        self._options = options

    @property
    def notes(self) -> tuple[str, ...]:
        """What you should know about the input."""
        return tuple(self._inner.notes)

    @property
    def description(self) -> dict[str, Any]:
        """Sizes, the engine that multiplies by A and why, what the factorisation cost."""
        description: dict[str, Any] = json.loads(self._inner.description)
        return description

    def solve(
        self,
        f: npt.ArrayLike,
        gap: npt.ArrayLike | None = None,
        friction: Friction = None,
        *,
        previous_slip: npt.ArrayLike | None = None,
        start: Start | None = None,
        callback: Callback | None = None,
        **options: Unpack[Options],
    ) -> Solution:
        """Solve for this load.

        Parameters
        ----------
        f : array_like, shape (n,)
            Load.
        gap, friction, previous_slip, start, callback, **options
            As of :func:`solve`. Without `friction` the one that the problem was prepared with; another
            may have other figures, but must be of the same kind.

        Returns
        -------
        Solution
        """
        return self._solve(f, gap, friction, previous_slip, start, callback, given(options))

    def _solve(
        self,
        f: npt.ArrayLike,
        gap: npt.ArrayLike | None,
        friction: Any,
        previous_slip: npt.ArrayLike | None,
        start: Start | None,
        callback: Callback | None,
        options: dict[str, Any],
    ) -> Solution:
        raw = self._inner.solve(
            _arrays.vector("the load f", f),
            _arrays.optional("the gap d", gap),
            pack(self._friction if friction is None else friction, self._pairs),
            _arrays.optional("the previous slip", previous_slip),
            start_arrays(start),
            self._options | options,
            callback,
        )
        return solution(raw, stacklevel=3)

    def __repr__(self) -> str:
        return f"<tresca.Prepared: {self._dofs} dofs, {self._pairs} pairs>"


def prepare(
    K: Any,
    N: Any,
    T: Any = None,
    friction: Friction = None,
    *,
    kernel: npt.ArrayLike | None = None,
    points: npt.ArrayLike | None = None,
    callback: Callback | None = None,
    **options: Unpack[Options],
) -> Prepared:
    """Check and factor a problem that is going to be solved several times.

    Parameters
    ----------
    K, N, T, friction, kernel, points, callback, **options
        As of :func:`solve`. The options hold for every solve that does not say otherwise.

    Returns
    -------
    Prepared

    Examples
    --------
    A load cycle with friction that remembers, one factorisation:

    >>> problem = tresca.prepare(K, N, T, tresca.Tresca(bound))
    >>> slip, last = None, None
    >>> for f in loads:
    ...     last = problem.solve(f, previous_slip=slip, start=last)
    ...     slip = last.slip
    """
    return _prepare(K, N, T, friction, kernel, points, True, callback, given(options))


def _prepare(
    K: Any,
    N: Any,
    T: Any,
    friction: Any,
    kernel: npt.ArrayLike | None,
    points: npt.ArrayLike | None,
    many_solves: bool,
    callback: Callback | None,
    options: dict[str, Any],
) -> Prepared:
    is_list = isinstance(K, Sequence) and len(K) > 0 and all(_is_matrix(block) for block in K)
    blocks = [_arrays.matrix("K", block) for block in (K if is_list else [K])]
    normal = _arrays.matrix("N", N)
    pairs = _arrays.rows_of(normal)
    inner = _tresca.Prepared(
        blocks,
        normal,
        None if T is None else _arrays.matrix("T", T),
        None if kernel is None else _arrays.columns("the kernel", kernel),
        None if points is None else _arrays.triples("points", points),
        many_solves,
        pack(friction, pairs),
        options,
        callback,
    )
    return Prepared(inner, sum(_arrays.rows_of(block) for block in blocks), pairs, friction, options)


def _is_matrix(block: Any) -> bool:
    return _arrays.is_sparse(block) or (isinstance(block, np.ndarray) and block.ndim == 2)


def solve(
    K: Any,
    f: npt.ArrayLike,
    N: Any,
    T: Any = None,
    gap: npt.ArrayLike | None = None,
    friction: Friction = None,
    *,
    kernel: npt.ArrayLike | None = None,
    points: npt.ArrayLike | None = None,
    previous_slip: npt.ArrayLike | None = None,
    start: Start | None = None,
    callback: Callback | None = None,
    **options: Unpack[Options],
) -> Solution:
    """Solve a contact problem with friction.

    Units are yours: `f`, forces and slip bounds in one unit of force, displacements and gaps in one of
    length.

    Parameters
    ----------
    K : sparse matrix or array_like, shape (n, n), or list of them
        Stiffness, symmetric and positive (semi)definite, both triangles; or its diagonal blocks. Supported
        dofs are best left out. Any format of scipy.sparse.
    f : array_like, shape (n,)
        Load: what pushes along +u.
    N : sparse matrix or array_like, shape (m, n)
        N u is the approach of the two sides of each contact pair along the normal: positive closes the
        gap.
    T : sparse matrix or array_like, shape (m, n) or (2m, n), optional
        T u is the slip: one row per pair in the plane, two adjacent ones in space.
    gap : array_like, shape (m,), optional
        d, the gap at u = 0; negative where the sides overlap. Default 0.
    friction : law, list of m laws, or array_like, optional
        :class:`Tresca`, :class:`Coulomb`, :class:`Orthotropic`, :class:`Frictionless` (the default),
        :class:`Tied` or :class:`Bilateral`; numbers alone are bounds of Tresca's law. Bounds are forces of
        a pair, not stresses.
    kernel : array_like, shape (n, k), optional
        Columns that span the kernel of K, where bodies float. Looked for without it; ``np.zeros((n, 0))``
        says that there is none.
    points : array_like, shape (m, 2) or (m, 3), optional
        Where the pairs are. Improves the preconditioner, changes no result.
    previous_slip : array_like, shape of the slip, optional
        The slip T u of the load step before: friction acts on what is added to it.
    start : Solution or (normal forces, tangential forces), optional
        Where to start from.
    callback : callable, optional
        Called with an :class:`Iteration` after every iteration; stops the run by returning something true.
        What it raises comes through.
    **options
        ``method="grssn"``, ``tolerance=1e-8``, ``engine="auto"`` …: see :func:`options`.

    Returns
    -------
    Solution

    Raises
    ------
    ProblemError
        When an array, a law or an option is wrong.

    Warns
    -----
    ConvergenceWarning
        When the run ended otherwise than at its tolerance.

    Examples
    --------
    A mass on two springs, half a metre above a rough wall:

    >>> import numpy as np, tresca
    >>> K = np.diag([1.0, 2.0])
    >>> solution = tresca.solve(K, [2.0, 1.0], N=[[1.0, 0.0]], T=[[0.0, 1.0]], gap=[0.5],
    ...                         friction=tresca.Coulomb(0.2))
    >>> solution.status
    'converged'
    >>> np.round(solution.normal_force, 6), np.round(solution.slip, 6)
    (array([1.5]), array([[0.35]]))
    """
    known = given(options)
    problem = _prepare(K, N, T, friction, kernel, points, False, callback, known)
    return problem._solve(f, gap, None, previous_slip, start, callback, {})
