//! A block on a block, with Tresca friction: the smallest model, and what comes out of it.
//!
//! `cargo run --release -p tresca --example two_blocks`
#![allow(clippy::print_stdout, reason = "an example shows what it finds")]

use tresca::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Units: mm, N, MPa.
    let steel = Isotropic::new(2.1e5, 0.3)?;
    let block = |low: f64| BrickSpec {
        min: [0.0, 0.0, low],
        max: [20.0, 10.0, low + 10.0],
        nodes: [9, 5, 5],
    };
    let mut model = Model::new("a block on a block");
    model.add_body(Body::new("upper", brick(&block(10.0))?, steel))?;
    model.add_body(Body::new("lower", brick(&block(0.0))?, steel))?;
    model.add_support(Support::clamp(["upper.x+", "lower.x-"]))?;
    model.add_load(Traction::new([0.0, 0.0, -50.0]).on("upper.z+"))?;
    model.add_contact(Contact::new(
        "upper.z-",
        "lower.z+",
        FrictionLaw::tresca(4.0),
    ))?;

    let outcome = tresca::solve(&model)?;
    assert!(outcome.converged());

    let pairs = || outcome.last().pairs();
    let force: f64 = pairs().map(|pair| pair.normal_force).sum();
    let largest = pairs().map(PairState::pressure).fold(0.0, f64::max);
    println!("contact carries {force:.0} N, pressure up to {largest:.1} MPa");
    println!(
        "{} of {} pairs are closed, {} stick",
        pairs().filter(|pair| pair.closed).count(),
        pairs().count(),
        pairs().filter(|pair| pair.stick).count()
    );
    let worst = outcome.last().certificate.worst();
    println!("worst figure of the certificate: {worst:.1e}");
    assert!(worst < 1e-5);
    Ok(())
}
