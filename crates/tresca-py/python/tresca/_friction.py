"""Friction laws. All bounds are forces of a contact pair (a stress times the area that belongs to it)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ._arrays import Floats, vector
from ._tresca import LAWS, ProblemError


@dataclass(frozen=True, eq=False)
class Frictionless:
    """Nothing resists sliding."""

    def _figures(self) -> tuple[str, list[npt.ArrayLike]]:
        return "frictionless", []


@dataclass(frozen=True, eq=False)
class Tresca:
    """A slip bound that does not depend on the normal force: ``‖λτ‖ ≤ bound``.

    Parameters
    ----------
    bound : float or array_like, shape (m,)
        The slip bound, a force ≥ 0, of all pairs or of each.
    """

    bound: npt.ArrayLike

    def _figures(self) -> tuple[str, list[npt.ArrayLike]]:
        return "tresca", [self.bound]


@dataclass(frozen=True, eq=False)
class Orthotropic:
    """Slip bounds along two axes: ``(λ1/g1)² + (λ2/g2)² ≤ 1``. Slip is normal to the ellipse.

    Parameters
    ----------
    g1, g2 : float or array_like, shape (m,)
        Bounds (forces ≥ 0) along the two rows of T of a pair; 0 leaves its direction without friction.
    """

    g1: npt.ArrayLike
    g2: npt.ArrayLike

    def _figures(self) -> tuple[str, list[npt.ArrayLike]]:
        return "orthotropic", [self.g1, self.g2]


@dataclass(frozen=True, eq=False)
class Coulomb:
    """A slip bound in proportion to the normal force: ``‖λτ‖ ≤ min(F λν, limit)``.

    Parameters
    ----------
    F : float or array_like, shape (m,)
        Friction coefficient ≥ 0.
    limit : float or array_like, shape (m,), optional
        Upper limit of the bound, a force.
    F2 : float or array_like, shape (m,), optional
        Coefficient along the second row of T of a pair, when it is another one.
    """

    F: npt.ArrayLike
    limit: npt.ArrayLike | None = None
    F2: npt.ArrayLike | None = None

    def _figures(self) -> tuple[str, list[npt.ArrayLike]]:
        second = self.F if self.F2 is None else self.F2
        return "coulomb", [self.F, second, np.inf if self.limit is None else self.limit]


@dataclass(frozen=True, eq=False)
class Tied:
    """Neither opening nor slip."""

    def _figures(self) -> tuple[str, list[npt.ArrayLike]]:
        return "tied", []


@dataclass(frozen=True, eq=False)
class Bilateral:
    """No opening; slip resisted below a bound as by Tresca's law, or free.

    Parameters
    ----------
    bound : float or array_like, shape (m,), optional
        The slip bound, a force ≥ 0. Free slip without it.
    """

    bound: npt.ArrayLike | None = None

    def _figures(self) -> tuple[str, list[npt.ArrayLike]]:
        return "bilateral", [0.0 if self.bound is None else self.bound]


Law = Frictionless | Tresca | Orthotropic | Coulomb | Tied | Bilateral
Friction = Law | Sequence[Law] | npt.ArrayLike | None

Packed = tuple[npt.NDArray[np.uint8], Floats, bool]


def pack(friction: Any, pairs: int) -> Packed:
    """Codes and figures for the compiled half, one row for all pairs or one for each."""
    if friction is None:
        friction = Frictionless()
    elif not isinstance(friction, Law) and not _is_list_of_laws(friction):
        friction = Tresca(friction)
    if isinstance(friction, Law):
        name, given = friction._figures()
        figures = [vector(f"a figure of {type(friction).__name__}", figure) for figure in given]
        lengths = {len(figure) for figure in figures} - {1}
        if not lengths <= {pairs}:
            raise ProblemError(
                f"{type(friction).__name__} has figures for {max(lengths - {pairs})} pairs, expected {pairs}"
            )
        count = pairs if lengths else 1
        table = np.zeros((count, 3))
        for column, figure in enumerate(figures):
            table[:, column] = figure
        return np.full(count, LAWS.index(name), np.uint8), table, bool(lengths)
    codes = np.zeros(len(friction), np.uint8)
    table = np.zeros((len(friction), 3))
    for pair, law in enumerate(friction):
        name, given = law._figures()
        codes[pair] = LAWS.index(name)
        for column, figure in enumerate(given):
            number = vector(f"the law of pair {pair}", figure)
            if len(number) != 1:
                raise ProblemError(f"the law of pair {pair} has a figure for {len(number)} pairs, expected one number")
            table[pair, column] = number[0]
    return codes, table, True


def _is_list_of_laws(friction: Any) -> bool:
    if not isinstance(friction, Sequence) or isinstance(friction, str):
        return False
    return any(isinstance(law, Law) for law in friction) and all(isinstance(law, Law) for law in friction)
