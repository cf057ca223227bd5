//! Glued and bilateral surfaces.

use super::support::{assert_close, solved, variant};
use tresca::{Body, Contact, Outcome, Settings, Silent, Support, Traction};

/// Two glued bricks are one brick: the same displacement, node by node.
#[test]
fn glued_bricks_are_one_brick() {
    let law = ("law = \"tresca\", bound = 0.09", "law = \"tied\"");
    let nodes = ("nodes = [16, 16, 16]", "nodes = [7, 7, 7]");
    let poisson = ("poisson = 0.277", "poisson = 0.35");
    let clamp = ("[\"upper.x+\", \"lower.x-\"]", "[\"lower.z-\"]");
    let glued = solved(&variant("two-bricks.toml", &[law, nodes, poisson, clamp]));

    // One brick of both, in contact with something far away from what happens.
    let mut model = tresca::Model::new("one brick");
    let block = |low: f64, high: f64, nodes: usize| {
        tresca::mesh::brick(&tresca::mesh::BrickSpec {
            min: [0.0, 0.0, low],
            max: [2.0, 1.0, high],
            nodes: [7, 7, nodes],
        })
        .unwrap()
    };
    let material = tresca::material::Isotropic::new(5.0e4, 0.35).unwrap();
    model
        .add_body(Body::new("whole", block(0.0, 2.0, 13), material))
        .unwrap();
    model
        .add_body(Body::new("other", block(-1.0, 0.0, 2), material))
        .unwrap();
    model
        .add_support(Support::clamp(["whole.z-", "other.z-"]))
        .unwrap();
    model
        .add_load(Traction::new([0.0, 0.0, -1.0]).on("whole.z+"))
        .unwrap();
    // The side x = 0 is loaded on its upper half only: by nodal forces through a function.
    let value = tresca::model::VectorField::Function(std::sync::Arc::new(|[_, _, z]| {
        [0.0, 0.0, if z > 1.0 { -1.0 } else { 0.0 }]
    }));
    model.add_load(Traction::new(value).on("whole.x-")).unwrap();
    model
        .add_contact(Contact::new(
            "whole.z-",
            "other.z+",
            tresca::FrictionLaw::Frictionless,
        ))
        .unwrap();
    let whole = tresca::solve_with(&model, &Settings::default(), &mut Silent).unwrap();
    let (upper, lower) = (
        &glued.last().displacements[0],
        &glued.last().displacements[1],
    );
    let one = &whole.last().displacements[0];
    let layer = 3 * 49;
    let largest = one.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
    for (k, expected) in one.iter().enumerate() {
        let found = if k < 6 * layer {
            lower[k]
        } else {
            upper[k - 6 * layer]
        };
        assert!(
            (found - expected).abs() < 1e-6 * largest,
            "dof {k}: {found} instead of {expected}"
        );
    }
}

fn tip_deflection(outcome: &Outcome) -> f64 {
    let u = &outcome.last().displacements[0];
    -u.chunks_exact(3).map(|u| u[2]).fold(0.0, f64::min)
}

/// Bending stiffness of a layered beam is between that of loose layers and that of one piece.
#[test]
fn a_bilateral_joint_transmits_what_its_bound_allows() {
    let solve = |law: &str| {
        let own = "law = \"bilateral\", bound = \"0.2 + 0.01*x\"";
        let outcome = solved(&variant("glued-beam.toml", &[(own, law)]));
        let deflection = tip_deflection(&outcome);
        for pair in &outcome.last().contacts[1] {
            assert!(
                pair.closed && pair.gap.abs() < 1e-7 * deflection,
                "it never opens"
            );
        }
        for pair in &outcome.last().contacts[0] {
            let slips = pair.local_slip.iter().any(|s| s.abs() > 1e-7 * deflection);
            assert!(!slips, "glue does not slip");
        }
        deflection
    };
    let loose = solve("law = \"bilateral\"");
    let partly = solve("law = \"bilateral\", bound = \"0.2 + 0.01*x\"");
    let glued = solve("law = \"tied\"");
    assert!(
        glued < 0.95 * partly && partly < 0.95 * loose,
        "{glued} {partly} {loose}"
    );
    // Layers of 4 and 2 side by side against one of 6: 216/(64 + 8) = 3 in bending stiffness, less
    // what clamp and shear add.
    let ratio = loose / glued;
    assert!((2.5..3.1).contains(&ratio), "{ratio}");
}

/// Negative normal forces occur where the joint pulls.
#[test]
fn joints_that_never_open_pull() {
    let outcome = solved(&variant("glued-beam.toml", &[]));
    let pulls = |contact: usize| {
        let pairs = outcome.last().contacts[contact].iter();
        pairs.filter(|pair| pair.normal_force < 0.0).count()
    };
    assert!(pulls(0) > 0 && pulls(1) > 0);
    assert_close(
        outcome.last().certificate.bodies[0].load[2],
        -2.0 * 8.0 * 2.0,
        1e-12,
    );
}
