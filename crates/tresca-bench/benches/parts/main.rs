//! Times of the parts of a solve: `cargo bench -p tresca-bench [-- PART]`, see the README of this crate.
//!
//! As a test (`cargo test -p tresca-bench`) each runs once, on the smallest problem.

mod assembly;
mod brick;
mod factor;
mod mortar;

use std::error::Error;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, SamplingMode};

fn main() -> Result<(), Box<dyn Error>> {
    let mut criterion = Criterion::default().configure_from_args();
    assembly::run(&mut criterion)?;
    factor::run(&mut criterion)?;
    mortar::run(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}

/// How fine the problems are: what `TRESCA_BENCH_SIZE` says, else `usual` under `cargo bench` and `smallest` in a test.
fn size(usual: usize, smallest: usize) -> Result<usize, Box<dyn Error>> {
    match std::env::var("TRESCA_BENCH_SIZE") {
        Ok(given) => Ok(given.parse()?),
        Err(_) if std::env::args().any(|argument| argument == "--bench") => Ok(usual),
        Err(_) => Ok(smallest),
    }
}

/// For what takes from milliseconds to seconds: few samples, all of the same length.
fn group<'a>(criterion: &'a mut Criterion, name: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group
        .sample_size(10)
        .sampling_mode(SamplingMode::Flat)
        .warm_up_time(Duration::from_secs(1));
    group
}
