//! `tresca export`: the problem of a case file for other programs. The name of the file says in which form.

mod fclib;
mod matrices;

use crate::args::ExportArguments;
use crate::commands::fclib::is_problem;

pub fn run(arguments: &ExportArguments) -> miette::Result<u8> {
    if is_problem(&arguments.to) {
        fclib::run(arguments)
    } else {
        matrices::run(arguments)
    }
}
