//! Problems of Siconos, which no one here posed, and problems with known answers, solved and measured
//! by the natural map of De Saxcé, which knows nothing of the solver.

use std::path::PathBuf;

use tresca::fclib::{
    self, Document, FclibLaw, FclibMatrix, FclibOutcome, FclibProblem, FclibProblemError,
    GlobalProblem, LocalProblem,
};
use tresca::material::Isotropic;
use tresca::mesh::{BrickSpec, brick};
use tresca::output::Destination;
use tresca::{Body, Contact, FrictionLaw, Model, Settings, Silent, Support, Traction};
use tresca_testkit::assert_near;

const FILES: [&str; 6] = [
    "FC2D_SliderCrankLagrangian00000.dat",
    "GFC3D_Example00.dat",
    "GFC3D_Example00_badly_scaled.dat",
    "Rover1039.dat",
    "Rover4516.dat",
    "problem-check2.dat",
];

fn document(name: &str) -> Document {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tresca-io/tests/data/fclib");
    fclib::read(&data.join(name)).unwrap()
}

fn tight() -> Settings {
    Settings {
        tolerance: 1e-10,
        coulomb_tolerance: 1e-9,
        ..Settings::default()
    }
}

fn solve(problem: &FclibProblem, law: FclibLaw) -> FclibOutcome {
    fclib::solve(problem, law, &tight(), &mut Silent).unwrap()
}

#[track_caller]
fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_near(found, expected, tolerance, "FCLIB");
}

fn diagonal(values: &[f64]) -> FclibMatrix {
    let entries = values.iter().enumerate().map(|(i, &value)| (i, i, value));
    FclibMatrix::new(values.len(), values.len(), entries.collect()).unwrap()
}

#[test]
fn all_problems_of_siconos_are_solved_with_both_laws() {
    for name in FILES {
        let problem = document(name).problem;
        for law in [
            FclibLaw::Coulomb,
            FclibLaw::Tresca { bound: 0.05 },
            FclibLaw::Tresca { bound: 0.0 },
        ] {
            let outcome = solve(&problem, law);
            let FclibOutcome {
                solution,
                residuals,
                matrix,
                ..
            } = &outcome;
            assert!(
                solution.status.is_converged(),
                "{name}, {law:?}: {}",
                solution.status
            );
            assert!(
                residuals.symmetrised <= 1e-9,
                "{name}, {law:?}: {residuals:?}"
            );
            // The matrices of the files are symmetric to some digits only: so far, and no further.
            let allowed = 1e-9 + 4.0 * matrix.asymmetry;
            assert!(
                residuals.scaled <= allowed,
                "{name}, {law:?}: {residuals:?}, {matrix:?}"
            );
            assert!(
                residuals.siconos <= 1e-9 + 20.0 * matrix.asymmetry,
                "{name}: {residuals:?}"
            );
        }
    }
}

/// At the tolerances that everyone gets who asks for none.
#[test]
fn default_settings_are_enough_for_six_digits() {
    for name in FILES {
        let problem = document(name).problem;
        let outcome = fclib::solve(
            &problem,
            FclibLaw::Coulomb,
            &Settings::default(),
            &mut Silent,
        )
        .unwrap();
        assert!(outcome.solution.status.is_converged(), "{name}");
        assert!(
            outcome.residuals.symmetrised <= 1e-6,
            "{name}: {:?}",
            outcome.residuals
        );
    }
}

#[test]
fn one_contact_by_hand() {
    // M = H = I, f = −(1, 1, 1), μ = 0.1: it slides along (1, 1), for sticking would take √2 > 0.1.
    let outcome = solve(&document("GFC3D_Example00.dat").problem, FclibLaw::Coulomb);
    let friction = 0.1 * 0.5_f64.sqrt();
    near(&outcome.forces, &[1.0, friction, friction], 1e-12);
    near(
        &outcome.velocities,
        &[0.0, friction - 1.0, friction - 1.0],
        1e-12,
    );
    near(
        &outcome.global_velocities.unwrap(),
        &outcome.velocities,
        0.0,
    );

    // M = diag(1e-4, 1, 1e4): r_T = (1/(1 + c), ε/(ε + c)) with ε = 1e-4 and ‖r_T‖ = 0.1.
    let force = |c: f64| [1.0 / (1.0 + c), 1e-4 / (1e-4 + c)];
    let (mut low, mut high) = (1.0_f64, 100.0_f64);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let [a, b] = force(middle);
        if a.hypot(b) > 0.1 {
            low = middle
        } else {
            high = middle
        }
    }
    let [a, b] = force(low);
    let outcome = solve(
        &document("GFC3D_Example00_badly_scaled.dat").problem,
        FclibLaw::Coulomb,
    );
    near(&outcome.forces, &[1.0, a, b], 1e-9);

    // A contact that opens: u = q where q_N > 0.
    let open = FclibProblem::Local(LocalProblem {
        dimension: 2,
        w: diagonal(&[2.0, 3.0]),
        q: vec![0.5, -4.0],
        friction: vec![0.3],
    });
    let outcome = solve(&open, FclibLaw::Coulomb);
    near(&outcome.forces, &[0.0, 0.0], 0.0);
    near(&outcome.velocities, &[0.5, -4.0], 0.0);
    // Tresca's law holds an open contact back all the same: u_T = −4 + 3·1.
    let outcome = solve(&open, FclibLaw::Tresca { bound: 1.0 });
    near(&outcome.forces, &[0.0, 1.0], 1e-12);
    near(&outcome.velocities, &[0.5, -1.0], 1e-12);
}

/// A rigid block of mass 1, half as high as wide, on its four corners, under an impulse of weight 1
/// and a push. 12 contact forces for 6 motions: W is singular, and how the corners share the load is
/// nobody's business.
fn block(push: f64) -> FclibProblem {
    let (half, height) = (0.5, 0.25);
    let mut entries = Vec::new();
    for corner in 0..4 {
        let x = if corner % 2 == 0 { half } else { -half };
        let y = if corner < 2 { half } else { -half };
        // Velocity of the corner (x, y, −height): v + ω × p. Components: normal z, tangents x, y.
        let (first, p) = (3 * corner, [x, y, -height]);
        let mut add = |component: usize, motion: usize, value: f64| {
            entries.push((motion, first + component, value));
        };
        add(0, 2, 1.0);
        add(0, 3, p[1]);
        add(0, 4, -p[0]);
        add(1, 0, 1.0);
        add(1, 4, p[2]);
        add(1, 5, -p[1]);
        add(2, 1, 1.0);
        add(2, 3, -p[2]);
        add(2, 5, p[0]);
    }
    let (width, tall) = (2.0 * half, 2.0 * height);
    let inertia = (width * width + tall * tall) / 12.0;
    let turning = (width * width + width * width) / 12.0;
    FclibProblem::Global(GlobalProblem {
        dimension: 3,
        m: diagonal(&[1.0, 1.0, 1.0, inertia, inertia, turning]),
        h: FclibMatrix::new(6, 12, entries).unwrap(),
        f: vec![push, 0.0, -1.0, 0.0, 0.0, 0.0],
        w: vec![0.0; 12],
        friction: vec![0.5; 4],
    })
}

#[test]
fn a_singular_w_is_survived() {
    let sums = |outcome: &FclibOutcome| -> [f64; 3] {
        let forces = outcome.forces.chunks(3);
        std::array::from_fn(|k| forces.clone().map(|r| r[k]).sum())
    };
    // Pushed with less than μ times the weight it stays.
    let outcome = solve(&block(0.3), FclibLaw::Coulomb);
    assert!(outcome.solution.status.is_converged());
    assert_eq!(
        (outcome.matrix.rank, outcome.matrix.unknowns),
        (Some(6), 12)
    );
    assert!(outcome.matrix.is_singular());
    near(&sums(&outcome), &[1.0, -0.3, 0.0], 1e-8);
    near(&outcome.global_velocities.clone().unwrap(), &[0.0; 6], 1e-8);
    assert!(outcome.residuals.scaled < 1e-8, "{:?}", outcome.residuals);
    // With more it slides, friction being μ times the weight however the corners share it.
    let outcome = solve(&block(0.8), FclibLaw::Coulomb);
    assert!(
        outcome.solution.status.is_converged(),
        "{}",
        outcome.solution.status
    );
    near(&sums(&outcome), &[1.0, -0.5, 0.0], 1e-8);
    near(
        &outcome.global_velocities.clone().unwrap(),
        &[0.3, 0.0, 0.0, 0.0, 0.0, 0.0],
        1e-8,
    );
    assert!(outcome.residuals.scaled < 1e-8, "{:?}", outcome.residuals);

    let plane = solve(
        &document("FC2D_SliderCrankLagrangian00000.dat").problem,
        FclibLaw::Coulomb,
    );
    assert!(plane.matrix.is_singular());
}

#[test]
fn no_contact_is_no_trouble() {
    let nothing = FclibProblem::Local(LocalProblem {
        dimension: 3,
        w: diagonal(&[]),
        q: Vec::new(),
        friction: Vec::new(),
    });
    let outcome = solve(&nothing, FclibLaw::Coulomb);
    assert!(outcome.solution.status.is_converged());
    assert_eq!((outcome.forces.len(), outcome.residuals.scaled), (0, 0.0));
}

#[test]
fn units_do_not_matter() {
    let FclibProblem::Local(rover) = document("Rover1039.dat").problem else {
        panic!("a local problem")
    };
    let before = solve(&FclibProblem::Local(rover.clone()), FclibLaw::Coulomb);
    // Velocities in mm/s: W and q grow by 1000, forces stay.
    let entries = rover
        .w
        .entries()
        .iter()
        .map(|&(i, j, w)| (i, j, 1000.0 * w));
    let millimetres = FclibProblem::Local(LocalProblem {
        w: FclibMatrix::new(12, 12, entries.collect()).unwrap(),
        q: rover.q.iter().map(|q| 1000.0 * q).collect(),
        ..rover
    });
    let after = solve(&millimetres, FclibLaw::Coulomb);
    near(&after.forces, &before.forces, 1e-6);
    assert_eq!(
        after.solution.figures.iterations,
        before.solution.figures.iterations
    );
    assert!((after.residuals.scaled / before.residuals.scaled - 1.0).abs() < 1e-3);
}

#[test]
fn what_is_wrong_is_refused_and_said() {
    let contact = LocalProblem {
        dimension: 2,
        w: diagonal(&[1.0, 1.0]),
        q: vec![-1.0, 0.0],
        friction: vec![0.5],
    };
    let refused = |problem: &FclibProblem, law| {
        let error = fclib::solve(problem, law, &tight(), &mut Silent).unwrap_err();
        error.to_string()
    };
    let local = |change: &dyn Fn(&mut LocalProblem)| {
        let mut own = contact.clone();
        change(&mut own);
        FclibProblem::Local(own)
    };
    let lopsided = local(&|p| {
        p.w = FclibMatrix::new(2, 2, vec![(0, 0, 1.0), (1, 1, 1.0), (0, 1, 0.5)]).unwrap();
    });
    assert_eq!(
        refused(&lopsided, FclibLaw::Coulomb),
        "W is not symmetric: entries differ from their mirror images by up to 2.5e-1 of the largest \
         entry (allowed: 1e-3, which is then averaged away)"
    );
    let negative = local(&|p| p.friction = vec![-1.0]);
    assert!(refused(&negative, FclibLaw::Coulomb).contains("contact 0 is -1"));
    let sound = local(&|_| ());
    for bound in [f64::NAN, -1.0, f64::INFINITY] {
        let text = refused(&sound, FclibLaw::Tresca { bound });
        assert!(
            text.starts_with("the slip bound must be a number ≥ 0"),
            "{text}"
        );
    }
    let FclibProblem::Global(mut global) = block(0.1) else {
        panic!("a global problem")
    };
    global.m = diagonal(&[1.0, 1.0, -1.0, 1.0, 1.0, 1.0]);
    let text = refused(&FclibProblem::Global(global), FclibLaw::Coulomb);
    assert!(
        text.starts_with("M: the matrix is not positive definite"),
        "{text}"
    );
}

/// A block on a block, both held, under Coulomb friction or another law.
fn bricks(friction: FrictionLaw) -> Model {
    let block = |low: f64| BrickSpec {
        min: [0.0, 0.0, low],
        max: [2.0, 1.0, low + 1.0],
        nodes: [5, 4, 4],
    };
    let material = || Isotropic::new(1000.0, 0.3).unwrap();
    let mut model = Model::new("a block on a block");
    model
        .add_body(Body::new("upper", brick(&block(1.0)).unwrap(), material()))
        .unwrap();
    model
        .add_body(Body::new("lower", brick(&block(0.0)).unwrap(), material()))
        .unwrap();
    model.add_support(Support::clamp("upper.x+")).unwrap();
    model.add_support(Support::clamp("lower.x-")).unwrap();
    model
        .add_load(Traction::new([0.0, 0.2, -1.0]).on("upper.z+"))
        .unwrap();
    model
        .add_contact(Contact::new("upper.z-", "lower.z+", friction))
        .unwrap();
    model
}

fn exported(model: &Model) -> Result<Document, FclibProblemError> {
    let mut progress = tresca::Silent;
    let mut prepared = tresca::prepare(model, &tight(), &mut progress).unwrap();
    let outcome = prepared.solve(&tight(), &mut progress).unwrap();
    assert!(outcome.converged());
    fclib::document(&mut prepared, &outcome)
}

#[test]
fn our_problems_go_out_and_come_back() {
    let document = exported(&bricks(FrictionLaw::coulomb(0.3))).unwrap();
    let expected = document.solution.clone().unwrap();
    assert!(expected.r.iter().any(|&r| r > 0.0) && expected.u.iter().any(|&u| u > 1e-6));
    let mut text = Vec::new();
    document.write_dat(&mut text).unwrap();
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("bricks.dat");
    std::fs::write(&path, text).unwrap();

    let outcome = solve(&fclib::read(&path).unwrap().problem, FclibLaw::Coulomb);
    assert!(outcome.solution.status.is_converged());
    assert!(outcome.residuals.scaled <= 1e-8, "{:?}", outcome.residuals);
    let size = expected.r.iter().fold(0.0_f64, |a, r| a.max(r.abs()));
    near(&outcome.forces, &expected.r, 1e-6 * size);
    let size = expected.u.iter().fold(0.0_f64, |a, u| a.max(u.abs()));
    near(&outcome.velocities, &expected.u, 1e-6 * size);

    let error = exported(&bricks(FrictionLaw::tresca(0.1)))
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("FCLIB cannot express laws other than"),
        "{error}"
    );
    let frictionless = exported(&bricks(FrictionLaw::Frictionless)).unwrap();
    assert!(frictionless.problem.friction().iter().all(|&mu| mu == 0.0));
}

#[test]
fn the_written_files_hold_the_solution() {
    let document = document("FC2D_SliderCrankLagrangian00000.dat");
    let settings = tight();
    let outcome =
        fclib::solve(&document.problem, FclibLaw::Coulomb, &settings, &mut Silent).unwrap();
    let directory = tempfile::tempdir().unwrap();
    let write = |document: &Document, outcome: &FclibOutcome| {
        Destination::new(directory.path())
            .and_then(|to| to.write_fclib("crank", document, outcome, &settings))
            .unwrap()
    };
    write(&document, &outcome);
    let read = |name: &str| std::fs::read_to_string(directory.path().join(name)).unwrap();

    let rows: Vec<Vec<f64>> = read("solution.csv")
        .lines()
        .skip(1)
        .map(|line| {
            line.split(',')
                .map(|value| value.parse().unwrap())
                .collect()
        })
        .collect();
    for (contact, row) in rows.iter().enumerate() {
        let (r, u) = (
            &outcome.forces[2 * contact..][..2],
            &outcome.velocities[2 * contact..][..2],
        );
        assert_eq!(
            row[..],
            [contact as f64, r[0], r[1], u[0], u[1], 0.01 * r[0]]
        );
    }
    assert_eq!(
        read("history.csv").lines().count(),
        outcome.solution.records.len() + 1
    );
    let summary: serde_json::Value = serde_json::from_str(&read("summary.json")).unwrap();
    assert_eq!(summary["status"], "converged");
    let step = &summary["steps"][0];
    assert_eq!(step["matrix"]["rank"], 3);
    assert!(
        summary["notes"][0]
            .as_str()
            .unwrap()
            .contains("W is singular (rank 3 of 4)")
    );
    assert!(step.get("reference").is_none());

    #[cfg(feature = "fclib")]
    {
        let written = fclib::read(&directory.path().join("crank.hdf5")).unwrap();
        let state = written.solution.clone().unwrap();
        assert_eq!((&state.r, &state.u), (&outcome.forces, &outcome.velocities));
        // Solved again, the file's own solution is the reference.
        let report = write(&written, &outcome);
        assert_eq!(report.last().reference.unwrap().forces, 0.0);

        // What did not converge is not called a solution.
        let hasty = Settings {
            max_iterations: 0,
            ..settings.clone()
        };
        let unfinished =
            fclib::solve(&document.problem, FclibLaw::Coulomb, &hasty, &mut Silent).unwrap();
        assert!(!write(&document, &unfinished).converged());
        let written = fclib::read(&directory.path().join("crank.hdf5")).unwrap();
        assert!(written.solution.is_none());
    }
}
