//! The compiled half of the Python package `tresca`: arrays in, arrays out.
//!
//! What a user sees (signatures, documentation, conversions from SciPy) is in `python/tresca/`; here is only
//! what has to be compiled. Everything is checked by the library `tresca`, whose errors become exceptions with
//! the same text. While something is solved the interpreter is free for other threads.
//!
//! | module | what it does |
//! |---|---|
//! | `arrays` | matrices and vectors from NumPy |
//! | `laws` | friction laws from codes and figures |
//! | `options` | keyword arguments to settings |
//! | `observer` | callbacks and Ctrl-C |
//! | `algebraic` | matrices: prepare, solve |
//! | `dual` | the pure dual form |
//! | `case` | case files |
//! | `solution` | results as dictionaries of arrays |
//! | `errors` | exceptions |

mod algebraic;
mod arrays;
mod case;
mod dual;
mod errors;
mod laws;
mod observer;
mod options;
mod solution;

use pyo3::prelude::*;

#[pymodule]
mod _tresca {
    #[pymodule_export]
    use super::algebraic::Prepared;
    #[pymodule_export]
    use super::case::{Case, CaseOutcome};
    #[pymodule_export]
    use super::dual::{solve_dual_dense, solve_dual_product};
    #[pymodule_export]
    use super::errors::{CaseError, OutputError, ProblemError};
    #[pymodule_export]
    use super::observer::Iteration;
    #[pymodule_export]
    use super::options::options;

    use super::laws::LAWS;
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        super::observer::Iteration::describe(module.py())?;
        module.add("__version__", tresca::VERSION)?;
        module.add("LAWS", LAWS)
    }
}
