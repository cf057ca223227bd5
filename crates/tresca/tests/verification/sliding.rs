//! A block that slides as a whole: the pull is what friction allows, whatever the elasticity.

use super::support::{assert_close, report, resultant, solved, variant};

const AREA: f64 = 40.0 * 20.0;
const PRESSURE: f64 = 5.0;

#[test]
fn coulomb_pull_is_coefficient_times_pressing_force() {
    let outcome = solved(&variant("sliding-block.toml", &[]));
    assert_eq!(outcome.steps.len(), 5);
    for step in 0..5 {
        let (normal, _) = resultant(&outcome, step, 0);
        assert_close(normal, PRESSURE * AREA, 1e-7);
    }
    // The contact force of the slave on the master points along the pull.
    let (_, friction) = resultant(&outcome, 4, 0);
    report(&format!(
        "sliding block: pull / (F × pressing force) = 1 + {:.1e}",
        friction[0] / (0.25 * PRESSURE * AREA) - 1.0
    ));
    assert_close(friction[0], 0.25 * PRESSURE * AREA, 1e-5);
    assert!(friction[1].abs() < 1e-5 * friction[0]);
    let last = outcome.last();
    assert!(last.pairs().all(|pair| !pair.stick));
    // The table feels it at its clamp.
    let table = &last.certificate.bodies[1];
    assert_close(-table.reaction[0], 0.25 * PRESSURE * AREA, 1e-5);
    assert_close(table.reaction[2], PRESSURE * AREA, 1e-7);
    // Work is dissipated only while something slips.
    assert!(last.dissipation() > 0.0);
}

#[test]
fn tresca_pull_is_bound_times_area() {
    let law = r#"friction = { law = "coulomb", coefficient = 0.25 }"#;
    let tresca = r#"friction = { law = "tresca", bound = "1.5 - x/40" }"#;
    let outcome = solved(&variant("sliding-block.toml", &[(law, tresca)]));
    let (_, friction) = resultant(&outcome, 4, 0);
    // The mean of the bound over the face is 1.
    assert_close(friction[0], AREA, 1e-6);
}

/// Metal forming: the bound F λν is cut off at the shear strength of the softer material.
#[test]
fn a_limit_cuts_the_coulomb_bound() {
    let law = "coefficient = 0.25 }";
    let outcome = solved(&variant(
        "sliding-block.toml",
        &[(law, "coefficient = 0.25, limit = 0.8 }")],
    ));
    let last = outcome.last();
    let (mut cut, mut total) = (0, 0.0);
    for pair in last.pairs() {
        let expected = (0.25 * pair.normal_force).min(0.8 * pair.pair.area);
        total += expected;
        cut += usize::from(0.25 * pair.normal_force > 0.8 * pair.pair.area);
        let [a, b] = pair.local_friction;
        assert!((a.hypot(b) - expected).abs() < 1e-5 * PRESSURE * pair.pair.area);
    }
    assert!(
        cut > 0 && cut < last.pairs().count(),
        "{cut} pairs at the limit"
    );
    let (_, friction) = resultant(&outcome, 4, 0);
    assert!(friction[0] < 0.25 * PRESSURE * AREA && friction[0] > 0.9 * total);
}
