"""What a solve gives back."""

from __future__ import annotations

import json
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from ._arrays import Bools, Floats


class ConvergenceWarning(UserWarning):
    """A solve ended without reaching its tolerance."""


class Certificate(dict[str, float]):
    """How far a result is from solving the problem: figures that are zero for an exact solution.

    Computed from displacements and forces alone, by a way that knows nothing of the solver's residuals:

    ``equilibrium``
        ``‖K u + Bᵀλ − f‖`` over the forces that act, ``‖f‖`` or ``‖Bᵀλ‖``: the worst body.
    ``penetration``
        Largest ``max(N u − d, 0)`` over the largest displacement or gap.
    ``normal_force_sign``
        Largest ``max(−λν, 0)`` over the largest normal force.
    ``complementarity``
        ``Σ |λν (N u − d)|`` over the elastic energy.
    ``cone_violation``
        Largest excess of a friction force over its bound, over the largest bound.
    ``slip_law``
        How far slipping pairs are from the direction and the bound that their law asks for, as an energy.
    ``negative_dissipation``
        Work that friction puts in instead of taking out, over the elastic energy.
    ``duality_gap``
        Primal less dual energy, over the elastic energy.
    ``force_balance``, ``moment_balance``
        Of cases only: loads, contact forces and reactions of a body must cancel; the worst body.
    """

    @property
    def worst(self) -> float:
        """The worst figure; NaN when one could not be computed."""
        return float(np.max(np.abs(list(self.values()))))

    def __str__(self) -> str:
        return "\n".join(f"{name.replace('_', ' '):<20}{value:9.1e}" for name, value in self.items())


@dataclass(frozen=True, repr=False, eq=False)
class Solution:
    """The outcome of a solve, all arrays in the caller's order.

    Look at `status` first: forces are always admissible, but only when `converged` are they a solution.

    Attributes
    ----------
    status : str
        ``"converged"``, ``"iteration_limit"``, ``"stagnated"``, ``"interrupted"``, ``"diverged"``,
        ``"no_equilibrium"``, ``"infeasible"``, ``"inaccurate"``, ``"coulomb_cycles"`` or ``"coulomb_diverges"``.
    u : ndarray, shape (n,)
        Displacements; empty for the pure dual form.
    normal_force : ndarray, shape (m,)
        λν, positive in compression: it acts on the bodies by −Nᵀλν.
    tangential_force : ndarray, shape (m, tangents)
        λτ: it acts on the bodies by −Tᵀλτ, against the slip.
    closed, stick : ndarray of bool, shape (m,)
        Which pairs carry a normal force; which have a friction force below their bound.
    gap : ndarray, shape (m,)
        The gap left, d − N u.
    slip : ndarray, shape (m, tangents)
        T u.
    slip_bounds : ndarray, shape (m, 2)
        The slip bounds (forces) that hold at the solution; infinite for tied pairs.
    history : structured ndarray
        One record per iteration.
    certificate : Certificate
        Independent check of the result.
    iterations, n_a : int
        Iterations; multiplications by the dual matrix A, `n_a_setup` of them for an eigenvalue estimate.
    outer_iterations : int
        Updates of Coulomb bounds or of motions of floating parts.
    relative_reduced_gradient : float
        What `tolerance` is on.
    dual_objective : float
        ½ λᵀAλ − λᵀb.
    notes : tuple of str
        What you should know about the input: kernels that were found, dependent rows, asymmetry.
    settings : dict
        All options as they were in force.
    times : dict
        Wall-clock seconds: ``check``, ``factorization``, ``solve`` (``multiplications`` by A are a part of it),
        ``recovery`` and their ``total``.
    summary : dict
        The figures of the result, as the command line writes them into ``summary.json``.
    kernel_amounts : ndarray
        How much of each kernel vector of K there is in u, for a start.
    unresisted_motion : ndarray, shape (n,), or None
        With ``"no_equilibrium"``: a motion that nothing resists.
    contradiction : dict or None
        With ``"infeasible"``: ``by``, the length by which constraints miss each other, and ``pairs``, those that
        take part, each with the force (``normal``, ``tangential``) of the proof. These forces cancel, N and T
        weighted by them add up to zero, and yet they do work on the gaps: no displacement satisfies all of them.
    """

    status: str
    u: Floats
    normal_force: Floats
    tangential_force: Floats
    closed: Bools
    stick: Bools
    gap: Floats
    slip: Floats
    slip_bounds: Floats
    history: npt.NDArray[np.void]
    certificate: Certificate
    iterations: int
    n_a: int
    n_a_setup: int
    outer_iterations: int
    relative_reduced_gradient: float
    dual_objective: float
    notes: tuple[str, ...]
    settings: dict[str, Any]
    times: dict[str, float]
    summary: dict[str, Any]
    kernel_amounts: Floats = field(default_factory=lambda: np.zeros(0))
    unresisted_motion: Floats | None = None

    @property
    def contradiction(self) -> dict[str, Any] | None:
        """Pairs that contradict each other, and by how much; of ``"infeasible"`` solves."""
        found: dict[str, Any] | None = self.summary["steps"][-1].get("contradiction")
        return found

    @property
    def converged(self) -> bool:
        """Whether the tolerance was reached."""
        return self.status == "converged"

    def __repr__(self) -> str:
        pairs = len(self.normal_force)
        contact = self.summary["steps"][-1]["contact"]
        lines = [
            f"<tresca.Solution: {self.status} after {self.iterations} iterations, {self.n_a} multiplications by A",
            f"  relative reduced gradient {self.relative_reduced_gradient:.1e}, "
            f"worst figure of the certificate {self.certificate.worst:.1e}",
            f"  {pairs} pairs: {contact['closed']} closed ({contact['stick']} stick, {contact['slip']} slip), "
            f"{contact['open']} open",

            f"  sum of normal forces {self.normal_force.sum():.6g}, dual objective {self.dual_objective:.6g}",
        ]
        lines += [f"  note: {note}" for note in self.notes]
        return "\n".join(lines) + ">"


def table(columns: Mapping[str, npt.NDArray[Any]]) -> npt.NDArray[np.void]:
    """Columns as one structured array."""
    rows = len(next(iter(columns.values())))
    array = np.empty(rows, dtype=[(name, column.dtype) for name, column in columns.items()])
    for name, column in columns.items():
        array[name] = column
    return array


def certificate(figures: Mapping[str, Any]) -> Certificate:
    """A certificate from the figures of a summary; what is no finite number arrives as None."""
    result = Certificate({name: number(value) for name, value in figures.items() if name != "bodies"})
    for balance in ("force", "moment") if figures["bodies"] else ():
        result[f"{balance}_balance"] = float(np.max([number(body[balance]) for body in figures["bodies"]]))
    return result


def number(value: float | None) -> float:
    """A figure of a summary."""
    return np.nan if value is None else value


def solution(raw: Mapping[str, Any], stacklevel: int) -> Solution:
    """The result of the compiled half; warns when it is none."""
    summary = json.loads(raw["summary"])
    (step,) = summary["steps"]
    result = Solution(
        status=step["status"],
        history=table(raw["history"]),
        certificate=certificate(step["certificate"]),
        iterations=step["iterations"],
        n_a=step["n_a"],
        n_a_setup=step["n_a_setup"],
        outer_iterations=step["outer_iterations"],
        relative_reduced_gradient=number(step["relative_reduced_gradient"]),
        dual_objective=number(step["dual_objective"]),
        notes=tuple(summary["notes"]),
        settings=summary["settings"],
        # Matrices are not assembled but checked.
        times={"check" if name == "assembly" else name: seconds for name, seconds in summary["times"].items()},
        summary=summary,
        **{name: value for name, value in raw.items() if name not in ("summary", "history")},
    )
    warn(result.status, result.relative_reduced_gradient, stacklevel + 1)
    return result


def warn(status: str, reached: float, stacklevel: int) -> None:
    """Warns unless a run has converged."""
    if status != "converged":
        warnings.warn(
            f"not converged: {status} at the relative reduced gradient {reached:.1e}; this is no solution",
            ConvergenceWarning,
            stacklevel=stacklevel + 1,
        )
