//! A case file read, changed and solved by several methods; results written as the command line writes them.
//!
//! `cargo run --release -p tresca --example case_file -- cases/two-bricks.toml`
#![allow(clippy::print_stdout, reason = "an example shows what it finds")]

use tresca::case::Case;
use tresca::output::Destination;
use tresca::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let own = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../cases/two-rectangles.toml"
    );
    let path = std::env::args().nth(1).unwrap_or_else(|| own.to_owned());
    let case = Case::load(&path)?;
    println!(
        "{}: {} bodies",
        case.model.title(),
        case.model.bodies().len()
    );

    // Assembled and factored once.
    let mut prepared = tresca::prepare(&case.model, case.settings(), &mut Silent)?;
    let mut last = None;
    for method in [Method::Grssn, Method::Gimssn, Method::Apgd] {
        let settings = Settings {
            method,
            ..case.settings().clone()
        };
        let outcome = prepared.solve(&settings, &mut Silent)?;
        let figures = &outcome.last().solution.figures;
        println!(
            "{method:>8}: {}, {} iterations, {} multiplications",
            outcome.status(),
            figures.iterations,
            figures.n_a
        );
        assert!(outcome.converged());
        last = Some(outcome);
    }

    let folder = tempfile::tempdir()?;
    if let Some(outcome) = last {
        Destination::new(folder.path())?.write("run", &case.model, &outcome)?;
    }
    let written = std::fs::read_dir(folder.path())?.count();
    println!("{written} result files");
    assert!(written > 3);
    Ok(())
}
