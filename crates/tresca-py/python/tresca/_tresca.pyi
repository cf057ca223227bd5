"""The compiled half of the package. Private: the names in `tresca` are those to use."""

from pathlib import Path
from typing import Any, final

import numpy as np
import numpy.typing as npt

from ._arrays import Floats, Matrix
from ._friction import Packed
from ._solve import Callback

__all__ = [
    "LAWS",
    "Case",
    "CaseError",
    "Iteration",
    "Outcome",
    "OutputError",
    "Prepared",
    "ProblemError",
    "__version__",
    "options",
    "solve_dual_dense",
    "solve_dual_product",
]

__version__: str
LAWS: list[str]

class ProblemError(ValueError):
    """A matrix, a vector, a friction law or an option is wrong.

    How a solve *ended* is never an exception: see `Solution.status`.
    """

class CaseError(ProblemError):
    """A case file is wrong: the message shows the place, what was expected and the likely cause."""

class OutputError(OSError):
    """Result files could not be written."""

@final
class Iteration:
    """One line of the iteration table."""

    @property
    def iteration(self) -> int:
        """Its number; 0 is the start."""
    @property
    def outer(self) -> int:
        """Number of the outer iteration (Coulomb's bounds, motions of floating parts), from 0."""
    @property
    def relative_reduced_gradient(self) -> float:
        """What the tolerance is on."""
    @property
    def objective(self) -> float:
        """q(λ)."""
    @property
    def decrease(self) -> float:
        """By how much q fell."""
    @property
    def open(self) -> int:
        """Pairs without normal force."""
    @property
    def closed(self) -> int:
        """Pairs with."""
    @property
    def stick(self) -> int:
        """Pairs (with separate tangents: directions) below their slip bound."""
    @property
    def slip(self) -> int:
        """The others."""
    @property
    def set_changes(self) -> int:
        """How many changed their state."""
    @property
    def inner_iterations(self) -> int:
        """Iterations of the inner solver."""
    @property
    def n_a(self) -> int:
        """Multiplications by A so far."""
    @property
    def step_length(self) -> float:
        """Length of the Newton step; 0 for a projected gradient step instead."""

_Start = tuple[Floats, Floats, Floats] | None

@final
class Prepared:
    def __new__(
        cls,
        stiffness: list[Matrix],
        normal: Matrix,
        tangential: Matrix | None,
        kernel: list[Floats] | None,
        points: Floats | None,
        many_solves: bool,
        laws: Packed,
        options: dict[str, Any],
        callback: Callback | None,
    ) -> Prepared: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def description(self) -> str: ...
    def solve(
        self,
        load: Floats,
        gap: Floats | None,
        laws: Packed,
        previous_slip: Floats | None,
        start: _Start,
        options: dict[str, Any],
        callback: Callback | None,
    ) -> dict[str, Any]: ...

@final
class Case:
    @staticmethod
    def load(path: Path) -> Case: ...
    @staticmethod
    def parse(name: str, text: str) -> Case: ...
    @property
    def title(self) -> str: ...
    @property
    def settings(self) -> str: ...
    def solve(self, options: dict[str, Any], callback: Callback | None) -> Outcome: ...

@final
class Outcome:
    def summary(self) -> str: ...
    def write(self, directory: Path, name: str) -> None: ...
    def bodies(self) -> list[tuple[str, npt.NDArray[np.float64]]]: ...
    def steps(self) -> list[dict[str, Any]]: ...

def options() -> list[tuple[str, str, str, str]]: ...
def solve_dual_dense(
    a: Floats,
    rest: tuple[Floats, int, Packed, _Start],
    options: dict[str, Any],
    callback: Callback | None,
) -> dict[str, Any]: ...
def solve_dual_product(
    product: Any,
    diagonal: Floats | None,
    rest: tuple[Floats, int, Packed, _Start],
    options: dict[str, Any],
    callback: Callback | None,
) -> dict[str, Any]: ...
