"""Contact with friction for matrices of your own.

Linear elastic bodies that touch and rub, given as matrices: stiffness K, load f, the rows N and T that
say how contact pairs approach and slide, gaps and friction. Out come displacements, contact forces, the
state of every pair and a certificate of the answer::

    K u + Nᵀ λν + Tᵀ λτ = f                              equilibrium
    N u ≤ d,  λν ≥ 0,  λν·(N u − d) = 0                  no penetration, no adhesion
    ‖λτ,i‖ ≤ g_i,  slip only at the bound, along λτ,i    friction

Functions
---------
solve
    From matrices to a :class:`Solution`.
prepare
    Factors once, for many solves: load steps, parameter studies.
solve_dual
    From the dual matrix A, b and the bounds alone.
options
    Every option of the solver with its default.

Classes
-------
Tresca, Coulomb, Orthotropic, Frictionless, Tied, Bilateral
    Friction laws.
Case
    A case file, as the command line solves it.
Solution, CaseResult
    Results. Look at ``status`` or ``converged`` first.
"""

from ._case import Case, CaseResult, Contact, StepResult
from ._dual import solve_dual
from ._friction import Bilateral, Coulomb, Frictionless, Orthotropic, Tied, Tresca
from ._options import Option, Options, options
from ._solution import Certificate, ConvergenceWarning, Solution
from ._solve import Prepared, prepare, solve
from ._tresca import CaseError, Iteration, OutputError, ProblemError, __version__

__all__ = [
    "Bilateral",
    "Case",
    "CaseError",
    "CaseResult",
    "Certificate",
    "Contact",
    "ConvergenceWarning",
    "Coulomb",
    "Frictionless",
    "Iteration",
    "Option",
    "Options",
    "Orthotropic",
    "OutputError",
    "Prepared",
    "ProblemError",
    "Solution",
    "StepResult",
    "Tied",
    "Tresca",
    "__version__",
    "options",
    "prepare",
    "solve",
    "solve_dual",
]
