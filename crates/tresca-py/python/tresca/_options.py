"""The options of the solver. They are declared once, in the library; here is how Python sees them."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple, TypedDict

from . import _tresca


class Option(NamedTuple):
    """What there is to know of one option.

    Attributes
    ----------
    name : str
        The keyword.
    doc : str
        What it does.
    default : str
        Its default, as it is written in a case file.
    allowed : str
        Allowed values, in words.
    """

    name: str
    doc: str
    default: str
    allowed: str


class Options(TypedDict, total=False):
    """Keywords that every solve takes; :func:`options` says what they mean."""

    method: Literal["ssn", "mssn", "imssn", "gimssn", "grssn", "apgd"] | None
    tolerance: float | None
    max_iterations: int | None
    rho: float | None
    r_tol: float | None
    c_fact: float | None
    inner_tolerance: float | None
    max_inner_iterations: int | None
    inner_solver: Literal["auto", "iterative", "direct"] | None
    forcing: float | None
    recycled_directions: int | None
    coulomb: Literal["auto", "fixed_point", "in_loop"] | None
    coulomb_tolerance: float | None
    max_outer_iterations: int | None
    engine: Literal["auto", "factored", "condensed", "explicit"] | None


def options() -> list[Option]:
    """Every option of the solver.

    Returns
    -------
    list of Option
        In the order of the documentation.

    Examples
    --------
    >>> {option.name: option.default for option in tresca.options()}["method"]
    '"grssn"'
    """
    return [Option(*option) for option in _tresca.options()]


def given(options: Options) -> dict[str, Any]:
    """The options that were given, as the compiled half takes them."""
    return {name: value for name, value in options.items() if value is not None}
