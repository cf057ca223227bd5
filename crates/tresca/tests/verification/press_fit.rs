//! Lamé's press fit: two rings in plane strain with an interference on the radius.
//!
//! With E' = E/(1 − ν²), ν' = ν/(1 − ν), radii a < b < c and interference δ the pressure is
//!
//! p = (δ/b) / [ ((b² + a²)/(b² − a²) − ν'ᵢ)/E'ᵢ + ((c² + b²)/(c² − b²) + ν'ₒ)/E'ₒ ]
//!
//! (Timoshenko and Goodier, Theory of Elasticity, section 28).

use super::support::{assert_close, digits, rate, report, resultant, solved, variant};
use std::f64::consts::PI;

const RADII: [f64; 3] = [10.0, 20.0, 40.0];
const INTERFERENCE: f64 = 0.01;
const HEIGHT: f64 = 4.0;

fn pressure() -> f64 {
    let [a, b, c] = RADII.map(|r| r * r);
    let plane =
        |young: f64, poisson: f64| (young / (1.0 - poisson * poisson), poisson / (1.0 - poisson));
    let ((ei, ni), (eo, no)) = (plane(1.1e5, 0.34), plane(2.1e5, 0.3));
    let compliance = ((b + a) / (b - a) - ni) / ei + ((c + b) / (c - b) + no) / eo;
    INTERFERENCE / RADII[1] / compliance
}

#[test]
fn axisymmetric_pressure_converges_to_lame() {
    let error = |bush: &str, ring: &str| {
        let exchange = [("nodes = [21, 9]", bush), ("nodes = [41, 9]", ring)];
        let outcome = solved(&variant("press-fit.toml", &exchange));
        let (force, _) = resultant(&outcome, 0, 0);
        let expected = pressure() * 2.0 * PI * RADII[1] * HEIGHT;
        // Every pair carries that pressure: nothing varies along the axis.
        for pair in outcome.last().pairs() {
            assert_close(
                pair.pressure(),
                force / (2.0 * PI * RADII[1] * HEIGHT),
                1e-9,
            );
        }
        ((force - expected) / expected).abs()
    };
    let errors = [
        error("nodes = [6, 5]", "nodes = [11, 5]"),
        error("nodes = [11, 5]", "nodes = [21, 5]"),
        error("nodes = [21, 5]", "nodes = [41, 5]"),
    ];
    report(&format!(
        "press fit, axisymmetric: error of the force {} for halved elements",
        digits(&errors)
    ));
    assert!(errors[2] < 1e-3, "{errors:?}");
    for pair in errors.windows(2) {
        assert!((rate(pair[0], pair[1]) - 2.0).abs() < 0.15, "{errors:?}");
    }
}

#[test]
fn a_quarter_in_plane_strain_has_the_same_pressure_and_no_friction() {
    let error = |bush: &str, ring: &str| {
        let exchange = [("nodes = [11, 25]", bush), ("nodes = [15, 25]", ring)];
        let outcome = solved(&variant("press-fit-quarter.toml", &exchange));
        let mut largest: f64 = 0.0;
        for pair in outcome.last().pairs() {
            largest = largest.max((pair.pressure() / pressure() - 1.0).abs());
            let friction = pair.local_friction[0] / pair.pair.area;
            assert!(friction.abs() < 1e-2 * pressure(), "{friction}");
        }
        largest
    };
    let errors = [
        error("nodes = [6, 13]", "nodes = [8, 13]"),
        error("nodes = [11, 25]", "nodes = [15, 25]"),
        error("nodes = [21, 49]", "nodes = [29, 49]"),
    ];
    report(&format!(
        "press fit, plane strain: largest error of the pressure {} for halved elements",
        digits(&errors)
    ));
    assert!(errors[2] < 5e-3, "{errors:?}");
    assert!(
        errors[0] > 1.8 * errors[1] && errors[1] > 1.8 * errors[2],
        "{errors:?}"
    );
}
