//! Cattaneo and Mindlin for two equal balls: pressed together, then shifted by less than it takes to slide.
//!
//! With Tresca's law and g = μp, p the pressure of frictionless contact, the tangential traction is the
//! difference of two of Hertz's: μp0 √(1 − r²/a²) and, where it sticks (r < c), less μp0 (c/a) √(1 − r²/c²). So
//! Q = μP (1 − (c/a)³), and its second moment is ∫ q r² dA = ⅖ μP a² (1 − (c/a)⁵) (Johnson, *Contact Mechanics*,
//! section 7.2, which neglects slip across the pull).

use std::f64::consts::PI;

use tresca::material::Isotropic;
use tresca::mesh::{BrickSpec, Mesh, brick};
use tresca::{Body, Contact, FrictionLaw, Model, Outcome, ScalarField, Settings, Silent, Support};

use super::support::report;

const RADIUS: f64 = 50.0;
const YOUNG: f64 = 1000.0;
const POISSON: f64 = 0.3;
const FRICTION: f64 = 0.2;
/// Half the width and the depth of each block that a ball is cut out of, some five radii of contact.
const SIZE: f64 = 6.0;

/// The half y ≥ 0 of a ball about its pole, above (`up`) or below the plane z = 0.
fn cap(cells: usize, up: bool) -> Mesh {
    let mesh = brick(&BrickSpec {
        min: [-1.0, 0.0, 0.0],
        max: [1.0, 1.0, 1.0],
        nodes: [2 * cells + 1, cells + 1, cells / 2 + 2],
    })
    .unwrap();
    let graded = |s: f64| SIZE * (0.25 * s + 0.75 * s * s.abs().powi(2));
    mesh.mapped(|[x, y, z]| {
        let (x, y) = (graded(x), graded(y));
        let low = (x * x + y * y) / (2.0 * RADIUS);
        let depth = graded(if up { z } else { 1.0 - z }) / SIZE;
        let height = low + depth * (SIZE - low);
        [x, y, if up { height } else { -height }]
    })
    .unwrap()
}

/// Both balls moved towards each other by `approach` in all, and the upper one by `shift` along x.
fn solved(cells: usize, approach: f64, shift: f64, friction: FrictionLaw) -> Outcome {
    let material = Isotropic::new(YOUNG, POISSON).unwrap();
    let mut model = Model::new("two balls, pressed and shifted");
    for (body, up, far, sign) in [("upper", true, "z+", 1.0), ("lower", false, "z-", -1.0)] {
        model
            .add_body(Body::new(body, cap(cells, up), material))
            .unwrap();
        let moved = [
            Some(0.5 * sign * shift),
            Some(0.0),
            Some(-0.5 * sign * approach),
        ];
        model.add_support(Support::new((body, far), moved)).unwrap();
        let symmetry = [None, Some(0.0), None];
        model
            .add_support(Support::new((body, "y-"), symmetry))
            .unwrap();
    }
    let contact = Contact::new("upper.z-", "lower.z+", friction).search(2.0);
    model.add_contact(contact).unwrap();
    let outcome = tresca::solve_with(&model, &Settings::default(), &mut Silent).unwrap();
    assert!(outcome.converged(), "{}", outcome.status());
    outcome
}

/// Sums over the pairs: of a force, and of the force times r².
fn moments(outcome: &Outcome, force: impl Fn(&tresca::PairState) -> f64) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for pair in outcome.last().pairs() {
        let [x, y, _] = pair.pair.point;
        sums[0] += force(pair);
        sums[1] += force(pair) * (x * x + y * y);
    }
    sums
}

#[test]
fn two_balls_slip_in_a_ring() {
    let (approach, shift) = (0.06, 0.008);
    let mut errors = Vec::new();
    for cells in [8, 12] {
        let pressed = solved(cells, approach, 0.0, FrictionLaw::Frictionless);
        let mut bounds = vec![0.0; (2 * cells + 1) * (cells + 1)];
        // The slave surface is the first layer of nodes: its nodes have the first numbers.
        for pair in pressed.last().pairs() {
            bounds[pair.pair.slave_node] = FRICTION * pair.pressure();
        }
        let law = FrictionLaw::tresca(ScalarField::Values(bounds));
        let shifted = solved(cells, approach, shift, law);
        let [load, of_pressure] = moments(&shifted, |pair| pair.normal_force);
        let [pull, of_traction] = moments(&shifted, |pair| pair.friction_force[0]);
        // Half of each ball was meshed.
        let stiffness = 0.5 * YOUNG / (1.0 - POISSON * POISSON);
        let a = (0.75 * 2.0 * load * (0.5 * RADIUS) / stiffness).cbrt();
        let ratio = (1.0 - pull / (FRICTION * load)).cbrt();
        assert!((0.3..0.9).contains(&ratio), "nothing to see: c/a = {ratio}");
        let sticks = shifted
            .last()
            .pairs()
            .filter(|pair| pair.stick && pair.closed);
        let stick_area: f64 = sticks.map(|pair| pair.pair.area).sum();
        let stick_radius = (2.0 * stick_area / PI).sqrt();
        let expected = 0.4 * FRICTION * load * a * a * (1.0 - ratio.powi(5));
        let error = [
            (of_pressure / (0.4 * load * a * a) - 1.0).abs(),
            (of_traction / expected - 1.0).abs(),
            (stick_radius / (ratio * a) - 1.0).abs(),
        ];
        report(&format!(
            "Cattaneo and Mindlin, two balls, {cells} cells: c/a = {ratio:.3}; second moments of pressure {:.1e} and \
             traction {:.1e}, stick radius {:.1e}",
            error[0], error[1], error[2]
        ));
        errors.push(error);
    }
    let [pressure, traction, radius] = errors[1];
    assert!(
        pressure < 0.05 && traction < 0.08 && radius < 0.1,
        "{errors:?}"
    );
}
