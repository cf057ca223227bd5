//! Hertz: two bodies of revolution, a sphere and a rigid plane, a cylinder and a flat.
//!
//! For the load P the radius of contact is a = (3PR/4E*)^(1/3), the peak pressure p0 = 3P/2πa², the approach
//! δ = a²/R; for a cylinder (load per length) a = √(4PR/πE*), p0 = 2P/πa (Johnson, *Contact Mechanics*,
//! chapter 4). 1/R and 1/E* are sums over the two bodies.
//!
//! The closed form takes bodies for half-spaces: it is off by some (a/R)². So errors are taken at the load that
//! was computed, with a/R of a few hundredths where they shall fall with h.

use std::f64::consts::PI;

use tresca::material::Isotropic;
use tresca::mesh::{CellKind, Mesh, RectangleSpec, Space, rectangle};
use tresca::model;
use tresca::{Body, Contact, FrictionLaw, Model, Outcome, RigidShape, Settings, Silent, Support};

use super::support::{assert_close, digits, report};

const YOUNG: f64 = 20_000.0;
const POISSON: f64 = 0.3;
const RADIUS: f64 = 50.0;

/// The meridian section of a ball (in the plane: of a cylinder) without its rim: pole at the origin, arc up to
/// 60°, flat face at the height of the centre. Standing (`up`) the arc is `y-` and the flat face `y+`; hanging it
/// is the mirror image, the arc `y+`.
///
/// `cells` along each side, graded towards the pole: `focus` is the size of the smallest, 1 for no grading.
fn ball(space: Space, kind: CellKind, cells: usize, focus: f64, up: bool) -> Mesh {
    let spec = RectangleSpec {
        space,
        min: [0.0, 0.0],
        max: [1.0, 1.0],
        nodes: [cells + 1, cells + 1],
        cells: CellKind::Quad4,
    };
    let mesh = rectangle(&spec).unwrap().with_cells(kind).unwrap();
    let graded = |s: f64| focus * s + (1.0 - focus) * s.powi(4);
    mesh.mapped(|[s, t, _]| {
        let angle = PI / 3.0 * graded(s);
        let depth = graded(if up { t } else { 1.0 - t });
        let low = RADIUS * (1.0 - angle.cos());
        let y = (1.0 - depth) * low + depth * RADIUS;
        [RADIUS * angle.sin(), if up { y } else { -y }, 0.0]
    })
    .unwrap()
}

struct Measured {
    load: f64,
    peak: f64,
    radius: f64,
}

/// Load, peak pressure and radius of contact. The radius is that of Hertz's paraboloid with the measured second
/// moment of the pressure: contact ends between two nodes, the moment does not.
fn measured(outcome: &Outcome) -> Measured {
    let pairs: Vec<_> = outcome.last().pairs().collect();
    let load = pairs.iter().map(|pair| pair.normal_force).sum();
    let peak = pairs.iter().map(|pair| pair.pressure()).fold(0.0, f64::max);
    let moment: f64 = pairs
        .iter()
        .map(|pair| pair.normal_force * pair.pair.point[0].powi(2))
        .sum();
    Measured {
        load,
        peak,
        radius: (moment / load).sqrt(),
    }
}

fn solved(model: &Model) -> Outcome {
    let outcome = tresca::solve_with(model, &Settings::default(), &mut Silent).unwrap();
    assert!(outcome.converged(), "{}", outcome.status());
    outcome
}

/// A hemisphere pushed by `approach` on a rigid plane.
fn on_plane(space: Space, kind: CellKind, cells: usize, focus: f64, approach: f64) -> Outcome {
    let mut model = Model::new("Hertz");
    let material = Isotropic::new(YOUNG, POISSON).unwrap();
    let mesh = ball(space, kind, cells, focus, true);
    model.add_body(Body::new("ball", mesh, material)).unwrap();
    let axis = [Some(0.0), None, None];
    model.add_support(Support::new("ball.x-", axis)).unwrap();
    let pushed = [None, Some(-approach), None];
    model.add_support(Support::new("ball.y+", pushed)).unwrap();
    let plane = RigidShape::Plane {
        point: [0.0; 3],
        normal: [0.0, 1.0, 0.0],
    };
    model
        .add_obstacle(model::Obstacle::new("plane", plane))
        .unwrap();
    let contact = Contact::new("ball.y-", "plane", FrictionLaw::Frictionless).search(RADIUS);
    model.add_contact(contact).unwrap();
    solved(&model)
}

#[test]
fn a_sphere_on_a_rigid_plane() {
    let stiffness = YOUNG / (1.0 - POISSON * POISSON);
    for kind in [CellKind::Quad4, CellKind::Quad8] {
        let errors: Vec<[f64; 2]> = [12, 24, 48]
            .into_iter()
            .map(|cells| {
                let outcome = on_plane(Space::Axisymmetric, kind, cells, 0.1, 0.05);
                let found = measured(&outcome);
                let a = (0.75 * found.load * RADIUS / stiffness).cbrt();
                let p0 = 1.5 * found.load / (PI * a * a);
                // ∫ p r² dA / P = 2a²/5.
                let radius = (2.5f64).sqrt() * found.radius;
                [(radius / a - 1.0).abs(), (found.peak / p0 - 1.0).abs()]
            })
            .collect();
        let of = |k: usize| errors.iter().map(|e| e[k]).collect::<Vec<_>>();
        report(&format!(
            "Hertz, sphere on a rigid plane, {kind}: radius {}, peak pressure {} for halved elements",
            digits(&of(0)),
            digits(&of(1))
        ));
        assert!(errors[2][0] < 1e-2 && errors[2][1] < 2e-2, "{errors:?}");
        assert!(
            errors[2][0] < errors[0][0] && errors[2][1] < errors[0][1],
            "{errors:?}"
        );
    }
}

#[test]
fn a_cylinder_on_a_rigid_flat() {
    let stiffness = YOUNG / (1.0 - POISSON * POISSON);
    let errors: Vec<[f64; 2]> = [12, 24, 48]
        .into_iter()
        .map(|cells| {
            let outcome = on_plane(Space::Plane, CellKind::Quad8, cells, 0.1, 0.05);
            let found = measured(&outcome);
            // Half of the section was meshed.
            let load = 2.0 * found.load;
            let a = (4.0 * load * RADIUS / (PI * stiffness)).sqrt();
            let p0 = 2.0 * load / (PI * a);
            // ∫ p x² dx / P = a²/4.
            [
                (2.0 * found.radius / a - 1.0).abs(),
                (found.peak / p0 - 1.0).abs(),
            ]
        })
        .collect();
    let of = |k: usize| errors.iter().map(|e| e[k]).collect::<Vec<_>>();
    report(&format!(
        "Hertz, cylinder on a rigid flat: half-width {}, peak pressure {} for halved elements",
        digits(&of(0)),
        digits(&of(1))
    ));
    assert!(errors[2][0] < 1e-2 && errors[2][1] < 2e-2, "{errors:?}");
    assert!(
        errors[2][0] < errors[0][0] && errors[2][1] < errors[0][1],
        "{errors:?}"
    );
}

/// Errors of two equal balls moved together by `approach`: load, peak pressure and radius against Hertz at that
/// approach; radius and peak pressure against Hertz at the load that was computed.
fn two_balls(cells: usize, focus: f64, approach: f64) -> [f64; 5] {
    let (reduced, radius) = (0.5 * YOUNG / (1.0 - POISSON * POISSON), 0.5 * RADIUS);
    let mut model = Model::new("two balls");
    let material = Isotropic::new(YOUNG, POISSON).unwrap();
    let upper = ball(Space::Axisymmetric, CellKind::Quad8, cells, focus, true);
    // Other cells, and more of them: the two meshes do not match.
    let more = cells + cells / 3;
    let lower = ball(Space::Axisymmetric, CellKind::Tri6, more, focus, false);
    model.add_body(Body::new("upper", upper, material)).unwrap();
    model.add_body(Body::new("lower", lower, material)).unwrap();
    for (body, flat, share) in [("upper", "y+", -0.5), ("lower", "y-", 0.5)] {
        let axis = [Some(0.0), None, None];
        model.add_support(Support::new((body, "x-"), axis)).unwrap();
        let moved = [None, Some(share * approach), None];
        model
            .add_support(Support::new((body, flat), moved))
            .unwrap();
    }
    let (slave, master) = ("upper.y-", "lower.y+");
    model
        .add_contact(Contact::new(slave, master, FrictionLaw::Frictionless).search(RADIUS))
        .unwrap();
    let found = measured(&solved(&model));
    let found_radius = (2.5f64).sqrt() * found.radius;
    let a = (radius * approach).sqrt();
    let at_load = (0.75 * found.load * radius / reduced).cbrt();
    [
        found.load / (4.0 / 3.0 * reduced * radius.sqrt() * approach.powf(1.5)),
        found.peak / (2.0 * reduced * a / (PI * radius)),
        found_radius / a,
        found_radius / at_load,
        found.peak / (1.5 * found.load / (PI * at_load * at_load)),
    ]
    .map(|quotient| quotient - 1.0)
}

/// The example that many programs print: R = 50, E = 20 000, ν = 0.3, approach 4; Hertz has p0 = 2798.3 and
/// a = 10, that is 0.4 of the effective radius: far from a half-space.
#[test]
fn two_hemispheres() {
    let reduced = 0.5 * YOUNG / (1.0 - POISSON * POISSON);
    assert_close(2.0 * reduced * 10.0 / (PI * 0.5 * RADIUS), 2798.3, 1e-4);
    let found = [16, 32].map(|cells| two_balls(cells, 0.3, 4.0));
    for [load, peak, radius, ..] in found {
        report(&format!(
            "two hemispheres, approach 4: load {load:+.1e}, peak pressure {peak:+.1e}, radius {radius:+.1e}"
        ));
    }
    let [load, peak, radius, ..] = found[1];
    assert!(
        load.abs() < 0.12 && peak.abs() < 0.08 && radius.abs() < 0.03,
        "{found:?}"
    );
}

#[test]
fn two_balls_that_hardly_touch() {
    let errors = [12, 24, 48].map(|cells| {
        let [.., radius, peak] = two_balls(cells, 0.1, 0.1);
        [radius.abs(), peak.abs()]
    });
    let of = |k: usize| errors.map(|e| e[k]);
    report(&format!(
        "Hertz, two balls, quad8 on tri6: radius {}, peak pressure {} for halved elements",
        digits(&of(0)),
        digits(&of(1))
    ));
    assert!(errors[2][0] < 1e-2 && errors[2][1] < 1e-2, "{errors:?}");
    assert!(
        errors[2][0] < errors[0][0] && errors[2][1] < errors[0][1],
        "{errors:?}"
    );
}
