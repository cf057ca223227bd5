//! Orthotropic friction obeys the associated law: slip is normal to the ellipse.

use super::support::{assert_close, report, resultant, solved, variant};

/// A rigid-like block pulled along s slides along s; then λ = (g1² s1, g2² s2)/√(g1² s1² + g2² s2²).
#[test]
fn a_stiff_block_slides_by_the_associated_law() {
    let error = |young: &str| {
        let outcome = solved(&variant(
            "orthotropic-block.toml",
            &[("young = 2.1e6", young)],
        ));
        assert!(outcome.last().pairs().all(|pair| !pair.stick));
        let (_, friction) = resultant(&outcome, 0, 0);
        let area = 40.0 * 20.0;
        // The pull is along (1, 1).
        let length = (1.0_f64 + 9.0).sqrt();
        let expected = [area / length, 9.0 * area / length];
        (0..2).fold(0.0, |worst: f64, k| {
            worst.max((friction[k] - expected[k]).abs() / area)
        })
    };
    let (soft, stiff) = (error("young = 2.1e6"), error("young = 2.1e8"));
    report(&format!(
        "orthotropic block: friction force off the associated law by {soft:.1e}, 100 times as stiff {stiff:.1e}"
    ));
    assert!(soft < 0.03 && stiff < 3e-4, "{soft:e}, {stiff:e}");
}

/// Every pair, whatever the elasticity: on its ellipse, and slip along the outward normal there.
#[test]
fn slip_is_normal_to_the_ellipse_at_every_pair() {
    let outcome = solved(&variant(
        "orthotropic-block.toml",
        &[("young = 2.1e6", "young = 1e4")],
    ));
    let mut slipping = 0;
    for pair in outcome.last().pairs().filter(|pair| !pair.stick) {
        slipping += 1;
        let area = pair.pair.area;
        let g = [area, 3.0 * area];
        let [a, b] = pair.local_friction;
        assert_close((a / g[0]).hypot(b / g[1]), 1.0, 1e-9);
        let normal = [a / g[0].powi(2), b / g[1].powi(2)];
        let s = pair.local_slip;
        let (cross, along) = (
            normal[0] * s[1] - normal[1] * s[0],
            normal[0] * s[0] + normal[1] * s[1],
        );
        assert!(along >= 0.0 && cross.abs() <= 1e-5 * normal[0].hypot(normal[1]) * 0.03);
    }
    assert!(slipping > 20);
}

/// Equal bounds along turned axes are isotropic friction; a bound of 0 leaves its direction free.
#[test]
fn limits_of_the_ellipse() {
    let law = r#"{ law = "orthotropic", bounds = [1.0, 3.0], axis = [1.0, 0.0, 0.0] }"#;
    let solve = |text: &str| solved(&variant("orthotropic-block.toml", &[(law, text)]));
    let circle = solve(r#"{ law = "orthotropic", bounds = [2.0, 2.0], axis = [0.6, 0.8, 0.3] }"#);
    let tresca = solve(r#"{ law = "tresca", bound = 2.0 }"#);
    for (a, b) in circle.last().pairs().zip(tresca.last().pairs()) {
        for k in 0..3 {
            assert!((a.friction_force[k] - b.friction_force[k]).abs() < 1e-6 * a.pair.area);
        }
    }
    let grooves = solve(r#"{ law = "orthotropic", bounds = [0.0, 3.0], axis = [1.0, 0.0, 0.0] }"#);
    let (_, friction) = resultant(&grooves, 0, 0);
    assert!(friction[0].abs() < 1e-9);
    assert_close(friction[1], 3.0 * 800.0, 1e-6);
}

/// Coulomb friction with two coefficients: on the ellipse F1 λν, F2 λν at every slipping pair.
#[test]
fn orthotropic_coulomb_friction() {
    let law = r#"{ law = "orthotropic", bounds = [1.0, 3.0], axis = [1.0, 0.0, 0.0] }"#;
    let coulomb = r#"{ law = "coulomb", coefficients = [0.1, 0.3], axis = [1.0, 0.0, 0.0] }"#;
    let outcome = solved(&variant("orthotropic-block.toml", &[(law, coulomb)]));
    let mut slipping = 0;
    for pair in outcome.last().pairs() {
        let [a, b] = pair.local_friction;
        let radius = (a / 0.1).hypot(b / 0.3);
        assert!(radius <= pair.normal_force * (1.0 + 1e-4) + 1e-9);
        if pair.closed && !pair.stick {
            slipping += 1;
            assert_close(radius, pair.normal_force, 1e-4);
        }
    }
    assert!(slipping > 20);
}
