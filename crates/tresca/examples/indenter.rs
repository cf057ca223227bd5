//! A rigid ball pressed into a block, load step after load step: an obstacle that moves, and a force over an approach.
//!
//! `cargo run --release -p tresca --example indenter`
#![allow(clippy::print_stdout, reason = "an example shows what it finds")]

use tresca::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Units: mm, N, MPa. A quarter of the block, symmetric about the planes x = 0 and y = 0.
    let (radius, deepest) = (50.0, 0.04);
    let aluminium = Isotropic::new(7.0e4, 0.3)?;
    let quarter = brick(&BrickSpec {
        min: [0.0, 0.0, -6.0],
        max: [6.0, 6.0, 0.0],
        nodes: [17; 3],
    })?;
    let mut model = Model::new("a ball into a block");
    model.add_body(Body::new("block", quarter, aluminium))?;
    model.add_support(Support::x("block.x-", 0.0))?;
    model.add_support(Support::y("block.y-", 0.0))?;
    model.add_support(Support::clamp("block.z-"))?;
    let ball = RigidShape::Sphere {
        center: [0.0, 0.0, radius],
        radius,
        inside: false,
    };
    let ball = model.add_obstacle(Obstacle::new("ball", ball).motion([0.0, 0.0, -deepest]))?;
    model.add_contact(Contact::new("block.z+", "ball", FrictionLaw::Frictionless).search(2.0))?;
    for part in [0.25, 0.5, 0.75, 1.0] {
        model.add_step(Step::new(part).with(ball, Amount::Factor(part)))?;
    }

    let outcome = tresca::solve(&model)?;
    assert!(outcome.converged());
    let mut forces = Vec::new();
    for step in &outcome.steps {
        let quarter: f64 = step.pairs().map(|pair| pair.normal_force).sum();
        forces.push(4.0 * quarter);
        println!(
            "approach {:.3} mm: {:8.1} N",
            step.time * deepest,
            4.0 * quarter
        );
    }
    // Hertz: the force grows with the power 3/2 of the approach; a clamped block of this size is somewhat stiffer.
    let power = (forces[3] / forces[1]).log2();
    println!("the force grows with the power {power:.2} of the approach (Hertz: 1.5)");
    assert!((1.4..1.7).contains(&power));
    Ok(())
}
