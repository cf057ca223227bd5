"""Case files."""

from __future__ import annotations

import json
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Unpack

import numpy as np
import numpy.typing as npt

from . import _tresca
from ._arrays import Bools, Floats
from ._options import Options, given
from ._solution import Certificate, certificate, number, table, warn
from ._solve import Callback


@dataclass(frozen=True, repr=False, eq=False)
class Contact:
    """The contact pairs of two surfaces after a load step; vectors in global components.

    Attributes
    ----------
    slave, master : str
        The surfaces, as ``body.faces``.
    points, normals : ndarray, shape (m, 3)
        Where the pairs are; unit normals, out of the slave.
    areas : ndarray, shape (m,)
        The area that belongs to each pair.
    closed, stick : ndarray of bool, shape (m,)
        Which pairs carry a normal force; which have a friction force below their bound.
    normal_force, pressure : ndarray, shape (m,)
        Positive in compression; the second is the first over the area.
    friction_force : ndarray, shape (m, 3)
        What the slave puts on the master.
    slip_bounds : ndarray, shape (m, 2)
        Slip bounds (forces) along the two tangents; infinite for tied pairs.
    gap : ndarray, shape (m,)
        The gap left.
    slip : ndarray, shape (m, 3)
        Motion of the slave relative to the master, since the start.
    """

    slave: str
    master: str
    points: Floats
    normals: Floats
    areas: Floats
    closed: Bools
    stick: Bools
    normal_force: Floats
    pressure: Floats
    friction_force: Floats
    slip_bounds: Floats
    gap: Floats
    slip: Floats

    def __repr__(self) -> str:
        return (
            f"<tresca.Contact {self.slave} – {self.master}: {len(self.gap)} pairs, "
            f"{int(self.closed.sum())} closed, {int(self.stick.sum())} stick>"
        )


@dataclass(frozen=True, repr=False, eq=False)
class StepResult:
    """The result of one load step.

    Attributes
    ----------
    number : int
        From 1.
    time : float
        Its instant in the time series.
    name : str or None
        What the case calls it.
    status : str
        How the method ended.
    displacements : dict of str to ndarray, shape (nodes, dimension)
        By body.
    contacts : list of Contact
        In the order of the case.
    history : structured ndarray
        One record per iteration.
    certificate : Certificate
        Independent check of the result.
    iterations, n_a : int
        Iterations; multiplications by the dual matrix A.
    dual_objective : float
        ½ λᵀAλ − λᵀb.
    summary : dict
        The step's part of ``summary.json``.
    """

    number: int
    time: float
    name: str | None
    status: str
    displacements: dict[str, Floats]
    contacts: list[Contact]
    history: npt.NDArray[np.void]
    certificate: Certificate
    iterations: int
    n_a: int
    dual_objective: float
    summary: dict[str, Any]

    @property
    def converged(self) -> bool:
        """Whether the tolerance was reached."""
        return self.status == "converged"

    def __repr__(self) -> str:
        name = f" {self.name!r}" if self.name else ""
        return f"<tresca.StepResult {self.number}{name}: {self.status}, {self.iterations} iterations>"


class CaseResult:
    """The result of a case.

    Attributes
    ----------
    title : str
        Of the case.
    status : str
        As of the last step; ``"interrupted"`` when steps are missing.
    steps : list of StepResult
        The steps that were made. A run ends with the first that does not converge.
    bodies : dict of str to ndarray, shape (nodes, 3)
        Node coordinates by body.
    summary : dict
        What ``summary.json`` holds.
    """

    def __init__(self, inner: _tresca.Outcome) -> None:
        self._inner = inner
        self.summary: dict[str, Any] = json.loads(inner.summary())
        self.title: str = self.summary["title"]
        self.status: str = self.summary["status"]
        self.bodies: dict[str, Floats] = dict(inner.bodies())
        self.steps: list[StepResult] = [
            _step(raw, summary) for raw, summary in zip(inner.steps(), self.summary["steps"], strict=True)
        ]

    @property
    def converged(self) -> bool:
        """Whether every step reached its tolerance."""
        return self.status == "converged"

    @property
    def last(self) -> StepResult:
        """The step made last."""
        return self.steps[-1]

    def write(self, directory: str | PathLike[str], name: str = "case") -> None:
        """Write the files that the command line writes: .vtu, .pvd, history.csv, summary.json.

        Parameters
        ----------
        directory : path
            Made if need be. Either all files appear in it or none.
        name : str, optional
            Of the .pvd file.

        Raises
        ------
        OutputError
            When a file cannot be written.
        """
        self._inner.write(Path(directory), name)

    def __repr__(self) -> str:
        return f"<tresca.CaseResult {self.title!r}: {self.status}, {len(self.steps)} step(s)>"


def _step(raw: dict[str, Any], summary: dict[str, Any]) -> StepResult:
    return StepResult(
        number=summary["step"],
        time=summary["time"],
        name=summary.get("name"),
        status=summary["status"],
        displacements=raw["displacements"],
        contacts=[Contact(**contact) for contact in raw["contacts"]],
        history=table(raw["history"]),
        certificate=certificate(summary["certificate"]),
        iterations=summary["iterations"],
        n_a=summary["n_a"],
        dual_objective=number(summary["dual_objective"]),
        summary=summary,
    )


class Case:
    """A case file, read and checked: the same as ``tresca solve`` takes.

    Examples
    --------
    >>> result = tresca.Case.load("cases/two-bricks.toml").solve()
    >>> result.last.contacts[0].pressure.max()
    """

    def __init__(self, inner: _tresca.Case) -> None:
        self._inner = inner

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Case:
        """Read a case file.

        Raises
        ------
        CaseError
            When it is wrong; the message shows the place.
        """
        return cls(_tresca.Case.load(Path(fspath(path))))

    @classmethod
    def parse(cls, text: str, name: str = "case.toml") -> Case:
        """Read a case from its text; `name` is what messages call it."""
        return cls(_tresca.Case.parse(name, text))

    @property
    def title(self) -> str:
        """Title of the case."""
        return self._inner.title

    @property
    def settings(self) -> dict[str, Any]:
        """The solver options of the file."""
        settings: dict[str, Any] = json.loads(self._inner.settings)
        return settings

    def solve(self, *, callback: Callback | None = None, **options: Unpack[Options]) -> CaseResult:
        """Run the case, all load steps.

        Parameters
        ----------
        callback, **options
            As of :func:`tresca.solve`. Options go before those of the file.

        Returns
        -------
        CaseResult

        Raises
        ------
        CaseError
            When the model cannot be built.

        Warns
        -----
        ConvergenceWarning
            When a step ended otherwise than at its tolerance.
        """
        result = CaseResult(self._inner.solve(given(options), callback))
        last = result.last.summary
        warn(result.status, number(last["relative_reduced_gradient"]), stacklevel=2)
        return result

    def __repr__(self) -> str:
        return f"<tresca.Case {self.title!r}>"
