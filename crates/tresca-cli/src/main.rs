//! The command-line program `tresca`.

mod args;
mod commands;
mod door;
mod interrupt;
mod terminal;

use std::process::ExitCode;

use clap::Parser;

use args::{Arguments, Command};

/// The run converged, or the command did what it was asked for.
const SUCCESS: u8 = 0;
/// The method ended without reaching its tolerance; results are written and say so.
const NOT_CONVERGED: u8 = 1;
/// The input is wrong; nothing was written.
const WRONG_INPUT: u8 = 2;
/// Interrupted before there was a result (128 + SIGINT, as shells have it).
const INTERRUPTED: u8 = 130;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let result = match &arguments.command {
        Command::Solve(solve) => commands::solve::run(solve),
        Command::Check(check) => commands::check::run(check),
        Command::Export(export) => commands::export::run(export),
        Command::Bench(bench) => commands::bench::run(bench),
        Command::Options(options) => commands::options::run(options),
    };
    match result {
        Ok(code) => ExitCode::from(code),
        Err(report) => {
            eprintln!("{report:?}");
            ExitCode::from(WRONG_INPUT)
        }
    }
}
