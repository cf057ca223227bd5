//! A block pressed on another and rubbed to and fro: Coulomb's law over load steps, and the work that it takes.
//!
//! `cargo run --release -p tresca --example load_cycle`
#![allow(clippy::print_stdout, reason = "an example shows what it finds")]

use tresca::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Units: mm, N, MPa.
    let (friction, pressure, drag) = (0.4, 10.0, 0.01);
    let rubber = Isotropic::new(1.0e3, 0.3)?;
    let block = |low: f64, nodes| BrickSpec {
        min: [0.0, 0.0, low],
        max: [10.0, 10.0, low + 5.0],
        nodes,
    };
    let mut model = Model::new("rubbed to and fro");
    model.add_body(Body::new("pad", brick(&block(5.0, [5, 5, 3]))?, rubber))?;
    model.add_body(Body::new("table", brick(&block(0.0, [5, 5, 3]))?, rubber))?;
    model.add_support(Support::clamp("table.z-"))?;
    model.add_load(Pressure::new(pressure).on("pad.z+"))?;
    let pulled = model.add_support(Support::x("pad.z+", drag).named("drag"))?;
    model.add_support(Support::y("pad.z+", 0.0))?;
    model.add_contact(Contact::new(
        "pad.z-",
        "table.z+",
        FrictionLaw::coulomb(friction),
    ))?;
    let way = [0.0, 0.5, 1.0, 0.5, 0.0, -0.5, -1.0, -0.5, 0.0, 0.5, 1.0];
    for (instant, &part) in (1..).zip(&way) {
        let time = f64::from(instant);
        model.add_step(Step::new(time).with(pulled, Amount::Factor(20.0 * part)))?;
    }

    let outcome = tresca::solve(&model)?;
    assert!(outcome.converged());
    let mut work = 0.0;
    for (step, part) in outcome.steps.iter().zip(way) {
        let force: f64 = step.pairs().map(|pair| pair.friction_force[0]).sum();
        work += step.dissipation();
        println!(
            "at {:+.2} mm: friction {force:+7.1} N, work so far {work:.3} N mm",
            20.0 * part * drag
        );
        // Coulomb's limit is F times the pressing force.
        assert!(force.abs() <= friction * pressure * 100.0 * (1.0 + 1e-6));
    }
    assert!(work > 0.0);
    Ok(())
}
