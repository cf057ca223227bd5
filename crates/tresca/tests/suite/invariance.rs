//! What must not matter: units, the names of the two sides, a mirror, the number of threads.

use tresca::material::Isotropic;
use tresca::mesh::{BrickSpec, brick};
use tresca::{
    Body, Contact, CoulombMethod, Engine, FrictionLaw, Method, Model, Outcome, Settings, Silent,
    Support, Traction,
};
use tresca_bench::two_bricks::{Units, two_bricks, two_bricks_with};
use tresca_testkit::assert_close;

const S: usize = 9;

fn run_with(model: &Model, method: Method, tolerance: f64) -> Outcome {
    let settings = Settings {
        tolerance,
        method,
        engine: Engine::Condensed,
        ..Settings::default()
    };
    tresca::solve_with(model, &settings, &mut Silent).unwrap()
}

fn run(model: &Model) -> Outcome {
    run_with(model, Method::Grssn, 1e-10)
}

#[test]
fn counts_do_not_depend_on_units_and_the_answer_converts() {
    // The methods with a linear tail make hundreds of steps for 1e-10, in which rounding adds up to
    // more than one multiplication; the residual of BiCGSTAB jumps, so that each of the Newton steps of
    // SSN may take an inner iteration (two multiplications) more or less.
    for (method, tolerance, slack) in [
        (Method::Grssn, 1e-10, 1),
        (Method::Imssn, 1e-6, 1),
        (Method::Apgd, 1e-6, 1),
        (Method::Ssn, 1e-6, 16),
    ] {
        let units = [
            Units::METRE_MEGAPASCAL,
            Units::MILLIMETRE_MEGAPASCAL,
            Units::SI,
        ];
        let outcomes =
            units.map(|units| run_with(&two_bricks(S, units).unwrap(), method, tolerance));
        let reference = &outcomes[0].last().solution;
        for (units, outcome) in units.iter().zip(&outcomes).skip(1) {
            let solution = &outcome.last().solution;
            assert!(outcome.converged());
            assert!(
                solution
                    .figures
                    .iterations
                    .abs_diff(reference.figures.iterations)
                    <= 1
                    && solution.figures.n_a.abs_diff(reference.figures.n_a) <= slack,
                "{method} in {units:?}: {} / {} instead of {} / {}",
                solution.figures.iterations,
                solution.figures.n_a,
                reference.figures.iterations,
                reference.figures.n_a
            );
            let force = units.stress * units.length.powi(2);
            let converted: Vec<f64> = solution.lambda.iter().map(|x| x / force).collect();
            assert_close(
                &converted,
                &reference.lambda,
                100.0 * tolerance,
                "other units",
            );
        }
    }
}

/// Coulomb's law in both variants: the outer iteration counts the same in every unit.
#[test]
fn coulomb_counts_do_not_depend_on_units() {
    for coulomb in [CoulombMethod::FixedPoint, CoulombMethod::InLoop] {
        let solve_in = |units: Units| {
            let model = two_bricks_with(S, units, FrictionLaw::coulomb(0.3)).unwrap();
            let settings = Settings {
                coulomb,
                engine: Engine::Condensed,
                ..Settings::default()
            };
            tresca::solve_with(&model, &settings, &mut Silent)
                .unwrap()
                .last()
                .solution
                .clone()
        };
        let reference = solve_in(Units::METRE_MEGAPASCAL);
        for units in [Units::MILLIMETRE_MEGAPASCAL, Units::SI] {
            let solution = solve_in(units);
            assert_eq!(
                solution.figures.outer_iterations, reference.figures.outer_iterations,
                "{coulomb}"
            );
            assert!(
                solution
                    .figures
                    .iterations
                    .abs_diff(reference.figures.iterations)
                    <= 1
                    && solution.figures.n_a.abs_diff(reference.figures.n_a) <= 2,
                "{coulomb} in {units:?}: {} / {} instead of {} / {}",
                solution.figures.iterations,
                solution.figures.n_a,
                reference.figures.iterations,
                reference.figures.n_a
            );
        }
    }
}

/// A brick on a brick, pushed, that only contact holds.
fn resting(units: Units) -> Model {
    let mut model = Model::new("resting");
    for (name, low) in [("upper", 1.0), ("lower", 0.0)] {
        let spec = BrickSpec {
            min: [0.0, 0.0, low * units.length],
            max: [2.0 * units.length, units.length, (low + 1.0) * units.length],
            nodes: [S; 3],
        };
        let material = Isotropic::new(5.0e4 * units.stress, 0.3).unwrap();
        let mesh = brick(&spec).unwrap();
        model.add_body(Body::new(name, mesh, material)).unwrap();
    }
    model.add_support(Support::clamp("lower.z-")).unwrap();
    let push = [0.1, 0.05, -1.0].map(|t| t * units.stress);
    model.add_load(Traction::new(push).on("upper.z+")).unwrap();
    let law = FrictionLaw::tresca(0.2 * units.stress);
    model
        .add_contact(Contact::new("upper.z-", "lower.z+", law))
        .unwrap();
    model
}

#[test]
fn floating_bodies_do_not_depend_on_units() {
    let reference = run(&resting(Units::METRE_MEGAPASCAL));
    assert!(reference.converged() && reference.description.rigid_motions == 6);
    let reference = &reference.last().solution;
    for units in [Units::MILLIMETRE_MEGAPASCAL, Units::SI] {
        let outcome = run(&resting(units));
        let solution = &outcome.last().solution;
        assert!(
            solution
                .figures
                .iterations
                .abs_diff(reference.figures.iterations)
                <= 2
                && solution.figures.n_a.abs_diff(reference.figures.n_a) <= 6,
            "{units:?}: {} / {} instead of {} / {}",
            solution.figures.iterations,
            solution.figures.n_a,
            reference.figures.iterations,
            reference.figures.n_a
        );
        let force = units.stress * units.length.powi(2);
        let converted: Vec<f64> = solution.lambda.iter().map(|x| x / force).collect();
        assert_close(&converted, &reference.lambda, 1e-7, "other units");
    }
}

/// The benchmark with its y extent and the roles of the two sides to choose.
fn variant(y: [f64; 2], swapped: bool) -> Model {
    let mut model = Model::new("variant");
    for (name, low, poisson) in [("upper", 1.0, 0.277), ("lower", 0.0, 0.35)] {
        let spec = BrickSpec {
            min: [0.0, y[0], low],
            max: [2.0, y[1], low + 1.0],
            nodes: [S; 3],
        };
        let material = Isotropic::new(5.0e4, poisson).unwrap();
        model
            .add_body(Body::new(name, brick(&spec).unwrap(), material))
            .unwrap();
    }
    model.add_support(Support::clamp("upper.x+")).unwrap();
    model.add_support(Support::clamp("lower.x-")).unwrap();
    // A sideways part, so that the problem itself is not symmetric in y.
    let sideways = if y[0] < 0.0 { -0.3 } else { 0.3 };
    model
        .add_load(Traction::new([0.0, sideways, -1.0]).on("upper.z+"))
        .unwrap();
    let sides = ["upper.z-", "lower.z+"];
    let (slave, master) = if swapped {
        (sides[1], sides[0])
    } else {
        (sides[0], sides[1])
    };
    model
        .add_contact(Contact::new(slave, master, FrictionLaw::tresca(0.09)))
        .unwrap();
    model
}

/// Displacements of all bodies in one list, their y components times `sign`, nodes in the
/// order of a body whose y axis is reversed when `sign` is −1.
fn displacements(outcome: &Outcome, sign: f64) -> Vec<f64> {
    let mut all = Vec::new();
    for u in &outcome.last().displacements {
        for z in 0..S {
            for y in 0..S {
                let y = if sign < 0.0 { S - 1 - y } else { y };
                for x in 0..S {
                    let node = x + S * (y + S * z);
                    all.extend([u[3 * node], sign * u[3 * node + 1], u[3 * node + 2]]);
                }
            }
        }
    }
    all
}

#[test]
fn master_and_slave_are_names_only() {
    let (plain, swapped) = (
        run(&variant([0.0, 1.0], false)),
        run(&variant([0.0, 1.0], true)),
    );
    assert_close(
        &displacements(&swapped, 1.0),
        &displacements(&plain, 1.0),
        1e-9,
        "other units",
    );
    assert_eq!(
        plain.last().solution.active_set.counts(),
        swapped.last().solution.active_set.counts()
    );
}

#[test]
fn a_mirrored_problem_has_the_mirrored_answer() {
    let (plain, mirrored) = (
        run(&variant([0.0, 1.0], false)),
        run(&variant([-1.0, 0.0], false)),
    );
    assert_close(
        &displacements(&mirrored, -1.0),
        &displacements(&plain, 1.0),
        1e-9,
        "other units",
    );
    assert_eq!(
        plain.last().solution.active_set.counts(),
        mirrored.last().solution.active_set.counts()
    );
}

#[test]
fn one_thread_and_two_give_the_same_counts() {
    let with_threads = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| run(&two_bricks(S, Units::METRE_MEGAPASCAL).unwrap()))
    };
    let (one, two) = (with_threads(1), with_threads(2));
    assert_eq!(
        one.last().solution.figures.iterations,
        two.last().solution.figures.iterations
    );
    assert_eq!(
        one.last().solution.figures.n_a,
        two.last().solution.figures.n_a
    );
    assert_close(
        &one.last().solution.lambda,
        &two.last().solution.lambda,
        1e-10,
        "other units",
    );
}

#[test]
fn loads_and_stiffness_of_any_size_give_the_same_iterations_and_the_answer_in_proportion() {
    let solve = |force: f64, stiffness: f64| {
        let block = |low: f64, top: f64| {
            let spec = BrickSpec {
                min: [0.0, 0.0, low],
                max: [2.0, 1.0, top],
                nodes: [4, 4, 3],
            };
            brick(&spec).unwrap()
        };
        let material = |young: f64| Isotropic::new(young * stiffness, 0.3).unwrap();
        let mut model = Model::new("any size");
        model
            .add_body(Body::new("upper", block(1.0, 2.0), material(5e4)))
            .unwrap();
        model
            .add_body(Body::new("lower", block(0.0, 1.0), material(5e4)))
            .unwrap();
        model.add_support(Support::clamp("upper.x+")).unwrap();
        model.add_support(Support::clamp("lower.x-")).unwrap();
        for face in ["upper.z+", "upper.x-"] {
            let load = Traction::new([0.0, 0.0, -force]).on(face);
            model.add_load(load).unwrap();
        }
        let friction = FrictionLaw::tresca(0.09 * force);
        model
            .add_contact(Contact::new("upper.z-", "lower.z+", friction))
            .unwrap();
        run(&model)
    };
    let expected = solve(1.0, 1.0);
    assert!(expected.converged());
    for size in [1e-200, 1e200] {
        for (force, stiffness) in [(size, 1.0), (1.0, size), (size, size)] {
            let found = solve(force, stiffness);
            assert!(
                found.converged(),
                "{force:e}, {stiffness:e}: {}",
                found.status()
            );
            let [own, other] = [&found, &expected].map(|outcome| outcome.last());
            assert_eq!(
                own.solution.figures.iterations,
                other.solution.figures.iterations
            );
            for (u, v) in own
                .displacements
                .concat()
                .iter()
                .zip(other.displacements.concat())
            {
                let u = u / (force / stiffness);
                assert!(
                    (u - v).abs() < 1e-9 * 1e-4,
                    "{force:e}, {stiffness:e}: {u} is not {v}"
                );
            }
            assert!(own.certificate.worst() < 1e-6, "{:?}", own.certificate);
        }
    }
}
