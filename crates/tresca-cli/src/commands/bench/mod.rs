//! `tresca bench`: experiments whose figures the documentation quotes.

mod case;
mod coulomb;
mod table1;

use crate::args::{BenchArguments, Experiment};

pub fn run(arguments: &BenchArguments) -> miette::Result<u8> {
    match &arguments.experiment {
        Experiment::Case(arguments) => case::run(arguments),
        Experiment::Table1(arguments) => table1::run(arguments),
        Experiment::Coulomb(arguments) => coulomb::run(arguments),
    }
}
