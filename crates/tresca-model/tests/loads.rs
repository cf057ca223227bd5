//! Every kind of load against its resultant in closed form, in the amounts of load steps.

use tresca_contact::ScalarField;
use tresca_fem::loads::resultant;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, RectangleSpec, Space, brick, rectangle};
use tresca_model::{
    Amount, Body, BodyForce, Force, Gravity, Load, Model, ModelError, PlaceNames, Pressure, Step,
    Traction,
};

const DENSITY: f64 = 7.0;

/// Two boxes: 2 × 1 × 3 and, above, 2 × 1 × 0.5, the latter without density.
fn boxes() -> Model {
    let steel = Isotropic::new(1.0, 0.3).unwrap();
    let block = |low: f64, high: f64| {
        let spec = BrickSpec {
            min: [0.0, 0.0, low],
            max: [2.0, 1.0, high],
            nodes: [4, 3, 3],
        };
        brick(&spec).unwrap()
    };
    let mut model = Model::new("boxes");
    let heavy = Body::new("heavy", block(0.0, 3.0), steel).density(DENSITY);
    model.add_body(heavy).unwrap();
    let light = block(3.0, 3.5).with_cells(CellKind::Tet10).unwrap();
    model.add_body(Body::new("light", light, steel)).unwrap();
    model
}

/// The force on each body.
fn forces(model: &mut Model, load: Load<PlaceNames>, amount: Amount) -> Vec<[f64; 3]> {
    let id = model.add_load(load).unwrap();
    let bodies = model.bodies().iter().enumerate();
    bodies
        .map(|(index, body)| {
            let mut forces = vec![0.0; body.mesh.dof_count()];
            model.add_forces(id, index, amount, &mut forces);
            resultant(&body.mesh, &forces, [0.0; 3]).force
        })
        .collect()
}

fn assert_close(found: &[[f64; 3]], expected: &[[f64; 3]]) {
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!(
            (found - expected).abs() < 1e-12,
            "{found} instead of {expected}"
        );
    }
}

/// Its own value, half of it, and another one: `expected` is the force of the first on the two boxes, `other` that of
/// the last.
fn check(load: &Load<PlaceNames>, expected: [[f64; 3]; 2], new: Amount, other: [[f64; 3]; 2]) {
    let model = &mut boxes();
    let mut acting = |amount| forces(model, load.clone(), amount);
    assert_close(&acting(Amount::WHOLE), &expected);
    assert_close(&acting(Amount::NOTHING), &[[0.0; 3]; 2]);
    let half = expected.map(|force| force.map(|f| 0.5 * f));
    assert_close(&acting(Amount::Factor(0.5)), &half);
    assert_close(&acting(new), &other);
}

const NONE: [f64; 3] = [0.0; 3];

#[test]
fn tractions_are_forces_per_area() {
    let load = Traction::new([1.0, 2.0, -3.0]).on(["light.z+", "heavy.x-"]);
    let other = Amount::Vector([0.0, 0.0, 1.0]);
    check(
        &load,
        [[3.0, 6.0, -9.0], [2.0, 4.0, -6.0]],
        other,
        [[0.0, 0.0, 3.0], [0.0, 0.0, 2.0]],
    );
}

#[test]
fn pressures_push_inwards() {
    let load = Pressure::new(4.0).on("heavy.x-");
    let other = [[15.0, 0.0, 0.0], NONE];
    check(&load, [[12.0, 0.0, 0.0], NONE], Amount::Scalar(5.0), other);
}

#[test]
fn body_forces_act_on_volumes() {
    let load = BodyForce::new([1.0, 0.0, 2.0]).on(PlaceNames::default());
    let expected = [[6.0, 0.0, 12.0], [1.0, 0.0, 2.0]];
    let other = [[0.0, 6.0, 0.0], [0.0, 1.0, 0.0]];
    check(&load, expected, Amount::Vector([0.0, 1.0, 0.0]), other);
}

#[test]
fn gravity_acts_on_masses() {
    let load = Gravity::new([0.0, 0.0, -10.0]).on("heavy");
    let expected = [[0.0, 0.0, -60.0 * DENSITY], NONE];
    let other = [[6.0 * DENSITY, 0.0, 0.0], NONE];
    check(&load, expected, Amount::Vector([1.0, 0.0, 0.0]), other);
    let all = Gravity::new([0.0, 0.0, -10.0]).on(PlaceNames::default());
    let refused = boxes().add_load(all);
    assert!(matches!(refused, Err(ModelError::NoDensity { body }) if body == "light"));
}

/// Whatever the meshes.
#[test]
fn a_total_force_is_shared_by_area() {
    let load = Force::new([6.0, 0.0, -12.0]).on(["heavy.x-", "light.x+", "light.y-", "heavy.z-"]);
    let areas = [3.0 + 2.0, 0.5 + 1.0];
    let share = |force: [f64; 3]| areas.map(|area| force.map(|f| f * area / 6.5));
    let (own, new) = ([6.0, 0.0, -12.0], [0.0, 1.0, 0.0]);
    check(&load, share(own), Amount::Vector(new), share(new));
}

/// A force along the axis is that of the whole circumference.
#[test]
fn a_total_force_of_a_body_of_revolution() {
    let steel = Isotropic::new(1.0, 0.3).unwrap();
    let spec = RectangleSpec {
        space: Space::Axisymmetric,
        min: [1.0, 0.0],
        max: [3.0, 1.0],
        nodes: [5, 3],
        cells: CellKind::Quad4,
    };
    let mut model = Model::new("ring");
    let ring = Body::new("ring", rectangle(&spec).unwrap(), steel);
    model.add_body(ring).unwrap();
    let load = Force::new([0.0, -5.0, 0.0]).on(["ring.y+", "ring.x-"]);
    let found = forces(&mut model, load, Amount::WHOLE);
    assert_close(&found, &[[0.0, -5.0, 0.0]]);
}

#[test]
fn impossible_loads_are_refused() {
    let mut model = boxes();
    let mut refused = |load: Load<PlaceNames>| model.add_load(load).unwrap_err().to_string();
    let nan = Force::new([f64::NAN, 0.0, 0.0]).on("heavy.x-");
    assert!(refused(nan).contains("must be finite"));
    let nowhere = Force::new([1.0, 0.0, 0.0]).on("heavy.left");
    assert!(refused(nowhere).contains("no surface `left`"));
    let values = Pressure::new(ScalarField::Values(vec![1.0])).on("heavy.x-");
    assert!(refused(values).contains("a constant or a function"));
}

/// What a step changes exists, has the right shape, and is finite.
#[test]
fn steps_are_checked() {
    let mut model = boxes();
    let push = model.add_load(Traction::new([1.0; 3]).on("heavy.x-"));
    let push = push.unwrap();
    let water = model.add_load(Pressure::new(1.0).on("heavy.y-")).unwrap();
    let mut refused = |step: Step| model.add_step(step).unwrap_err().to_string();
    let step = || Step::new(1.0);
    assert!(refused(step().with(push, Amount::Scalar(2.0))).contains("does not take"));
    assert!(refused(step().with(water, Amount::Vector([1.0; 3]))).contains("does not take"));
    assert!(refused(step().with(push, Amount::Factor(f64::NAN))).contains("finite"));
    let other = tresca_model::LoadId(2);
    assert!(refused(step().with(other, Amount::WHOLE)).contains("has no"));
    assert!(refused(Step::new(f64::INFINITY)).contains("not later"));
    model
        .add_step(step().with(push, Amount::Factor(0.5)))
        .unwrap();
    assert!(model.add_step(step()).is_err());
    assert_eq!(model.steps()[0].amount(water), Amount::WHOLE);
}
