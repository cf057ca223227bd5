//! Bodies held by contact alone: statics decides, and where it cannot, the motion is named.

use super::support::{assert_close, report, resultant, run, solved, variant};
use tresca::{Outcome, Status, StepOutcome};

const G: f64 = 9810.0;

#[test]
fn a_brick_rests_by_its_weight() {
    let outcome = solved(&variant("resting-brick.toml", &[]));
    assert_eq!(outcome.description.rigid_motions, 6);
    let weight = 60.0 * 40.0 * 30.0 * 7.85e-9 * G;
    let (normal, friction) = resultant(&outcome, 0, 0);
    assert_close(normal, weight, 1e-7);
    assert!(
        friction.iter().all(|f| f.abs() < 1e-7 * weight),
        "{friction:?}"
    );
    // The table carries both weights.
    let table = 60.0 * 40.0 * 40.0 * 7.85e-9 * G;
    assert_close(
        outcome.last().certificate.bodies[1].reaction[2],
        weight + table,
        1e-7,
    );
}

#[test]
fn two_guides_hold_a_frictionless_brick() {
    let outcome = solved(&variant("frictionless-guide.toml", &[]));
    // Left by the guides x = 0 and y = 0: up and down, and nothing else.
    let motions = outcome.description.rigid_motions;
    assert!((1..=3).contains(&motions), "{motions}");
    let weight = 60.0 * 40.0 * 30.0 * 7.85e-9 * G;
    assert_close(resultant(&outcome, 0, 0).0, weight, 1e-7);
    let block = &outcome.last().certificate.bodies[0];
    assert!(
        block.reaction.iter().all(|r| r.abs() < 1e-6 * weight),
        "{:?}",
        block.reaction
    );
}

#[test]
fn each_contact_of_a_stack_carries_what_stands_on_it() {
    let outcome = solved(&variant("stack.toml", &[]));
    assert_eq!(outcome.description.rigid_motions, 12);
    let volume = 30.0 * 20.0 * 20.0;
    let (top, middle) = (volume * 2.7e-9 * G, volume * 7.85e-9 * G);
    let forces = [0, 1].map(|contact| resultant(&outcome, 0, contact).0);
    report(&format!(
        "stack: contact forces / weights = 1 + {:.1e}, 1 + {:.1e}",
        forces[0] / top - 1.0,
        forces[1] / (top + middle) - 1.0
    ));
    assert_close(forces[0], top, 1e-7);
    assert_close(forces[1], top + middle, 1e-7);
}

#[test]
fn a_block_between_two_jaws_is_held_by_friction() {
    let outcome = solved(&variant("clamping-jaws.toml", &[]));
    let (left, left_friction) = resultant(&outcome, 0, 0);
    let (right, right_friction) = resultant(&outcome, 0, 1);
    assert_close(left, right, 1e-6);
    let weight = 20.0 * 20.0 * 20.0 * 2.7e-9 * G;
    let pull = 2.0 * 20.0 * 20.0;
    // What the block, the slave, hands on is what acts on it.
    assert_close(left_friction[1] + right_friction[1], pull, 1e-6);
    assert!((left_friction[2] + right_friction[2] + weight).abs() < 1e-6 * pull);
}

/// A brick without any load that just touches: no force, and it stays where it is.
#[test]
fn bodies_that_touch_with_zero_force() {
    let gravity = ("[[gravity]]\nvalue = [0.0, 0.0, -9810.0]\n", "");
    for law in [
        "{ law = \"coulomb\", coefficient = 0.2 }",
        "{ law = \"frictionless\" }",
    ] {
        let law = ("{ law = \"coulomb\", coefficient = 0.2 }", law);
        let outcome = solved(&variant("resting-brick.toml", &[gravity, law]));
        assert!(outcome.last().pairs().all(|pair| pair.normal_force == 0.0));
        for u in &outcome.last().displacements {
            assert!(u.iter().all(|x| x.abs() < 1e-12));
        }
    }
    // Placed with an overlap of 0.001 mm, it is pushed out of it, and no force is left.
    let overlap = (
        "pair = [\"block.z-\", \"table.z+\"]",
        "pair = [\"block.z-\", \"table.z+\"]\ngap = -0.001",
    );
    let outcome = solved(&variant("resting-brick.toml", &[gravity, overlap]));
    for pair in outcome.last().pairs() {
        assert!(pair.gap > -1e-9, "{}", pair.gap);
        assert!(pair.normal_force < 1e-6, "{}", pair.normal_force);
    }
}

fn reported(outcome: &Outcome) -> (&StepOutcome, String) {
    assert_eq!(outcome.status(), Status::NoEquilibrium);
    let step = outcome.last();
    let motion = step.unresisted.as_ref().expect("the motion is named");
    (step, format!("{:?} {:?}", motion.bodies, motion.contacts))
}

#[test]
fn a_brick_pulled_away_is_reported() {
    let case = variant("pulled-away.toml", &[]);
    let outcome = run(&case, case.settings());
    let (step, motion) = reported(&outcome);
    assert!(
        motion.contains("block") && motion.contains("opens"),
        "{motion}"
    );
    let u = &step.unresisted.as_ref().unwrap().displacements[0];
    // All of the block goes up.
    assert!(u.iter().skip(2).step_by(3).all(|&w| w > 0.9), "{motion}");
}

#[test]
fn a_frictionless_brick_pushed_sideways_is_reported() {
    let law = (
        "{ law = \"coulomb\", coefficient = 0.2 }",
        "{ law = \"frictionless\" }",
    );
    let push = (
        "[[gravity]]\nvalue = [0.0, 0.0, -9810.0]",
        "[[gravity]]\nvalue = [1.0, 0.0, -9810.0]",
    );
    let case = variant("resting-brick.toml", &[law, push]);
    let outcome = run(&case, case.settings());
    let (_, motion) = reported(&outcome);
    assert!(
        motion.contains("translation along (1, 0, 0)") && motion.contains("slides"),
        "{motion}"
    );
}

/// A block on a table of slope F: it stays as long as the pull is below F times its weight.
#[test]
fn the_friction_cone_is_sharp() {
    for (pull, holds) in [(0.1998, true), (0.2002, false)] {
        let tilted = format!(
            "[[gravity]]\nbodies = [\"block\"]\nvalue = [{}, 0.0, -9810.0]",
            pull * G
        );
        let push = ("[[gravity]]\nvalue = [0.0, 0.0, -9810.0]", tilted.as_str());
        let case = variant("resting-brick.toml", &[push]);
        let outcome = run(&case, case.settings());
        if holds {
            assert_eq!(outcome.status(), Status::Converged, "pull {pull}");
            let weight = 60.0 * 40.0 * 30.0 * 7.85e-9 * G;
            assert_close(resultant(&outcome, 0, 0).1[0], pull * weight, 1e-5);
        } else {
            let (_, motion) = reported(&outcome);
            assert!(
                motion.contains("block") && motion.contains("slides"),
                "{motion}"
            );
        }
    }
}

/// The same with Tresca's law: bound × area is all that friction can carry.
#[test]
fn a_slip_bound_too_small_for_the_load_is_reported() {
    for (bound, holds) in [("0.2005", true), ("0.1995", false)] {
        let law = format!("{{ law = \"tresca\", bound = {bound} }}");
        let push = "[[traction]]\non = [\"block.z+\"]\nvalue = [0.2, 0.0, 0.0]\n[[gravity]]";
        let case = variant(
            "resting-brick.toml",
            &[
                ("{ law = \"coulomb\", coefficient = 0.2 }", law.as_str()),
                ("[[gravity]]", push),
                // Heavy enough not to tip over.
                ("-9810.0", "-9810.0e3"),
            ],
        );
        let outcome = run(&case, case.settings());
        if holds {
            assert_eq!(outcome.status(), Status::Converged, "bound {bound}");
        } else {
            let (_, motion) = reported(&outcome);
            assert!(motion.contains("translation along (1, 0, 0)"), "{motion}");
        }
    }
}
