//! `tresca bench`: experiments whose figures the documentation quotes. They are run by `tresca_bench`;
//! here they are printed.

mod campaign;
mod case;
mod coulomb;
mod table1;

use tresca_bench::trial::Cost;

use crate::args::{BenchArguments, Experiment};
use crate::terminal::format::{bytes, seconds};

pub fn run(arguments: &BenchArguments) -> miette::Result<u8> {
    let all_converged = match &arguments.experiment {
        Experiment::Campaign(arguments) => campaign::run(arguments),
        Experiment::Case(arguments) => case::run(arguments),
        Experiment::Table1(arguments) => table1::run(arguments),
        Experiment::Coulomb(arguments) => coulomb::run(arguments),
    }?;
    Ok(if all_converged {
        crate::SUCCESS
    } else {
        crate::NOT_CONVERGED
    })
}

fn print_cost(cost: &Cost) {
    let (times, work) = (&cost.times, &cost.factorization);
    println!(
        "    whole contact solve {}: assembly {}, factorisation {} ({:.0} GFLOP, {:.1} GFLOP/s), solve {}, recovery {}, the rest files",
        seconds(cost.seconds),
        seconds(times.assembly),
        seconds(times.factorization),
        work.flops / 1e9,
        work.gigaflops_per_second(),
        seconds(times.solve),
        seconds(times.recovery)
    );
    let linear = &cost.linear;
    println!(
        "    one linear solve {} ({:.0} GFLOP, {:.1} GFLOP/s); ratio {:.2}",
        seconds(linear.seconds),
        linear.factorization.flops / 1e9,
        linear.factorization.gigaflops_per_second(),
        cost.seconds / linear.seconds
    );
    if let Some(peak) = cost.peak_memory_bytes {
        println!("    peak memory of the contact solves {}", bytes(peak));
    }
}
