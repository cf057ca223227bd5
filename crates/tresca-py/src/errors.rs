//! Exceptions. Their text is that of the Rust errors.

use std::fmt::Display;

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use pyo3::PyErr;
use pyo3::create_exception;
use pyo3::exceptions::{PyOSError, PyValueError};

create_exception!(
    tresca,
    ProblemError,
    PyValueError,
    "A matrix, a vector, a friction law or an option is wrong.\n\nHow a solve *ended* is never an exception: \
     see `Solution.status`."
);
create_exception!(
    tresca,
    CaseError,
    ProblemError,
    "A case file is wrong: the message shows the place, what was expected and the likely cause."
);
create_exception!(
    tresca,
    OutputError,
    PyOSError,
    "Result files could not be written."
);

/// For `map_err`.
pub fn problem(error: impl Display) -> PyErr {
    ProblemError::new_err(error.to_string())
}

/// For `map_err`: the report that the command line prints, without colour.
pub fn case(error: impl Diagnostic) -> PyErr {
    let mut text = String::new();
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor());
    if handler.render_report(&mut text, &error).is_err() {
        text = error.to_string();
    }
    CaseError::new_err(text.trim_end().to_owned())
}
