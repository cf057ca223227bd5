//! Random problems against Clarabel, posed in the displacements: min ½uᵀKu − fᵀu + Σ h(Tu − s) over N u ≤ d.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SupportedConeT::*};
use tresca::algebraic::{Friction, Matrix, MatrixProblem, PairLaw, Solution};

use super::common::*;

/// u by Clarabel, for bounds that do not follow the normal forces.
fn oracle(problem: &MatrixProblem) -> Vec<f64> {
    let k = whole(&problem.stiffness);
    let (n, m, tangents) = (problem.dofs(), problem.pairs(), problem.tangents());
    let conditions = &problem.conditions;
    let laws = conditions.friction.laws(m).unwrap();
    let gap = conditions.gap.clone().unwrap_or_else(|| vec![0.0; m]);
    let shift = conditions
        .previous_slip
        .clone()
        .unwrap_or_else(|| vec![0.0; tangents * m]);
    // Unknowns: u, and for each pair the work t that friction does.
    let mut rows: Vec<(Vec<(usize, f64)>, f64)> = Vec::new();
    let mut cones = Vec::new();
    let mut linear: Vec<f64> = conditions.load.iter().map(|f| -f).collect();
    linear.extend(vec![1.0; m]);
    for (pair, law) in laws.iter().enumerate() {
        let normal: Vec<_> = problem.normal.row(pair).collect();
        rows.push((normal, gap[pair]));
        cones.push(match law {
            PairLaw::Tied | PairLaw::Bilateral { .. } => ZeroConeT(1),
            _ => NonnegativeConeT(1),
        });
        let tangential = |t: usize| {
            let row = tangents * pair + t;
            (
                problem
                    .tangential
                    .as_ref()
                    .unwrap()
                    .row(row)
                    .collect::<Vec<_>>(),
                shift[row],
            )
        };
        let bounds = match *law {
            PairLaw::Tied => {
                for t in 0..tangents {
                    rows.push(tangential(t));
                    cones.push(ZeroConeT(1));
                }
                [0.0; 2]
            }
            PairLaw::Tresca { bound } | PairLaw::Bilateral { bound } => [bound; 2],
            PairLaw::Orthotropic { bounds } => bounds,
            _ => [0.0; 2],
        };
        // (t, g1 (T1u − s1), g2 (T2u − s2)) in the cone.
        rows.push((vec![(n + pair, -1.0)], 0.0));
        for (t, bound) in bounds.into_iter().enumerate().take(tangents) {
            let (row, shift) = tangential(t);
            let scaled = row
                .into_iter()
                .map(|(j, value)| (j, -bound * value))
                .collect();
            rows.push((scaled, -bound * shift));
        }
        cones.push(SecondOrderConeT(1 + tangents));
    }
    let upper = (0..n).flat_map(|i| {
        k.row(i)
            .filter(move |(j, _)| *j >= i)
            .map(move |(j, v)| (i, j, v))
    });
    let p = csc(upper, n + m, n + m);
    let entries = rows.iter().enumerate();
    let entries =
        entries.flat_map(|(i, (row, _))| row.iter().map(move |&(j, value)| (i, j, value)));
    let a = csc(entries, rows.len(), n + m);
    let rhs: Vec<f64> = rows.iter().map(|(_, rhs)| *rhs).collect();
    let settings = DefaultSettings {
        verbose: false,
        max_iter: 300,
        tol_gap_abs: 1e-13,
        tol_gap_rel: 1e-13,
        tol_feas: 1e-13,
        ..DefaultSettings::default()
    };
    let mut solver = DefaultSolver::new(&p, &linear, &a, &rhs, &cones, settings).unwrap();
    solver.solve();
    solver.solution.x[..n].to_vec()
}

fn csc(
    entries: impl Iterator<Item = (usize, usize, f64)>,
    rows: usize,
    columns: usize,
) -> CscMatrix<f64> {
    let mut entries: Vec<_> = entries.collect();
    entries.sort_by_key(|&(i, j, _)| (j, i));
    let mut starts = vec![0; columns + 1];
    entries.iter().for_each(|&(_, j, _)| starts[j + 1] += 1);
    (0..columns).for_each(|j| starts[j + 1] += starts[j]);
    let (index, value) = entries.iter().map(|&(i, _, v)| (i, v)).unzip();
    CscMatrix::new(rows, columns, starts, index, value)
}

/// The oracle stops at a relative energy error of 1e-13, the root of which is an error in u.
const ORACLE: f64 = 2e-5;

/// Elastic forces agree (and with them, B having full rank, contact forces), the energies, and without a
/// kernel the displacements.
#[track_caller]
fn assert_same(problem: &MatrixProblem, found: &Solution, expected: &[f64], what: &str) {
    let k = whole(&problem.stiffness);
    let forces = product(&k, &found.displacement);
    assert_close(
        &forces,
        &product(&k, expected),
        ORACLE,
        &format!("{what}: K u"),
    );
    if found.description.as_ref().unwrap().rigid_motions == 0 {
        assert_close(&found.displacement, expected, ORACLE, &format!("{what}: u"));
    }
    // Equilibrium with the forces returned, from the matrices as they were given.
    let mut contact = vec![0.0; problem.dofs()];
    problem
        .normal
        .add_transposed_product(&found.normal_force, &mut contact);
    if let Some(t) = &problem.tangential {
        t.add_transposed_product(&found.tangential_force, &mut contact);
    }
    let sum: Vec<f64> = forces.iter().zip(&contact).map(|(k, c)| k + c).collect();
    assert_close(
        &sum,
        &problem.conditions.load,
        1e-9,
        &format!("{what}: equilibrium"),
    );
}

#[test]
fn every_convex_law_in_every_dimension() {
    for tangents in [1, 2] {
        for kernel in [0, 3] {
            for laws in CONVEX {
                for seed in 0..4 {
                    let problem = random(laws, tangents, kernel, seed);
                    let what =
                        format!("{laws:?}, {tangents} tangents, kernel {kernel}, seed {seed}");
                    let solution = solved(&problem, &tight());
                    assert_eq!(solution.kernel_amounts.len(), kernel, "{what}");
                    assert_same(&problem, &solution, &oracle(&problem), &what);
                }
            }
        }
    }
}

#[test]
fn without_tangents() {
    for kernel in [0, 2] {
        let problem = random(Laws::Frictionless, 0, kernel, 7);
        let solution = solved(&problem, &tight());
        assert!(solution.slip.is_empty() && solution.tangential_force.is_empty());
        assert!(solution.stick.iter().all(|stick| !stick));
        assert_same(&problem, &solution, &oracle(&problem), "no T");
    }
}

/// With Coulomb's law the oracle solves for the bounds that were found: they must give the normal forces that
/// they follow from.
#[test]
fn coulomb_bounds_are_consistent() {
    for tangents in [1, 2] {
        for kernel in [0, 3] {
            for seed in 0..3 {
                let problem = random(Laws::Coulomb, tangents, kernel, seed);
                let solution = solved(&problem, &tight());
                let laws = problem.conditions.friction.laws(problem.pairs()).unwrap();
                let bounds = laws
                    .iter()
                    .zip(&solution.normal_force)
                    .map(|(law, normal)| {
                        let PairLaw::Coulomb {
                            coefficients: [f, _],
                            limit,
                        } = law
                        else {
                            panic!("{law:?}");
                        };
                        (f * normal).min(*limit)
                    });
                let frozen: Vec<f64> = bounds.collect();
                let tresca = problem.clone().with_friction(Friction::tresca(&frozen));
                let what = format!("{tangents} tangents, kernel {kernel}, seed {seed}");
                assert_same(&tresca, &solution, &oracle(&tresca), &what);
            }
        }
    }
}

#[test]
fn a_kernel_that_is_given_is_as_good_as_one_that_is_found() {
    let problem = random(Laws::Tresca, 2, 3, 5);
    let found = solved(&problem, &tight());
    // By the eigenvectors of the second block: three vectors that K maps to zero, and a mixture of them.
    let n = problem.stiffness[0].rows();
    let k = &problem.stiffness[1];
    let whole = faer::Mat::from_fn(k.rows(), k.rows(), |i, j| {
        k.row(i)
            .find(|(column, _)| *column == j)
            .map_or(0.0, |(_, value)| value)
    });
    let eigen = whole.self_adjoint_eigen(faer::Side::Lower).unwrap();
    let vector = |column: usize| -> Vec<f64> {
        let own = (0..k.rows()).map(|i| 7.0 * eigen.U()[(i, column)] + 3.0 * eigen.U()[(i, 0)]);
        vec![0.0; n].into_iter().chain(own).collect()
    };
    let given = problem.clone().with_kernel((0..3).map(vector).collect());
    let solution = solved(&given, &tight());
    assert_close(&solution.displacement, &found.displacement, 1e-9, "u");
    assert_close(&solution.normal_force, &found.normal_force, 1e-9, "λν");
    assert_close(
        &solution.tangential_force,
        &found.tangential_force,
        1e-9,
        "λτ",
    );
}

/// Rows of B that depend on each other: the displacements stay the oracle's.
#[test]
fn dependent_rows_are_survived_and_named() {
    let mut problem = random(Laws::Tresca, 2, 0, 3);
    let b = problem.tangential.as_ref().unwrap();
    let mut rows: Vec<Vec<f64>> = (0..b.rows())
        .map(|i| {
            let mut row = vec![0.0; b.columns()];
            b.row(i).for_each(|(j, value)| row[j] = value);
            row
        })
        .collect();
    let sum: Vec<f64> = (0..b.columns())
        .map(|j| rows[2][j] - 2.0 * rows[5][j])
        .collect();
    rows[9] = sum;
    problem.tangential = Some(dense(&rows));
    let solution = solved(&problem, &tight());
    assert_same(
        &problem,
        &solution,
        &oracle(&problem),
        "T[9] = T[2] − 2 T[5]",
    );
    let notes: Vec<String> = solution.notes.iter().map(ToString::to_string).collect();
    assert!(
        notes
            .iter()
            .any(|note| note.contains("T[9]") && note.contains("not")),
        "{notes:?}"
    );
}

/// A part of more than 200 dofs goes through sparse subspace iteration.
#[test]
fn a_large_part_has_its_kernel_found() {
    // A chain of 300 masses on springs, free at both ends; one end may touch a wall.
    let count = 300;
    let mut k = vec![(0, 0, 0.0); 0];
    for i in 0..count - 1 {
        let stiffness = if i % 7 == 0 { 5.0 } else { 1.0 };
        k.extend([
            (i, i, stiffness),
            (i + 1, i + 1, stiffness),
            (i, i + 1, -stiffness),
            (i + 1, i, -stiffness),
        ]);
    }
    let part =
        |pick: fn(&(usize, usize, f64)) -> usize| -> Vec<usize> { k.iter().map(pick).collect() };
    let values: Vec<f64> = k.iter().map(|entry| entry.2).collect();
    let chain =
        Matrix::from_triplets((count, count), &part(|e| e.0), &part(|e| e.1), &values).unwrap();
    let wall = Matrix::from_triplets((1, count), &[0], &[count - 1], &[1.0]).unwrap();
    let mut load = vec![0.0; count];
    load[0] = 2.0;
    let problem = MatrixProblem::new(chain, wall, load).with_gap(vec![3.0]);
    let solution = solved(&problem, &tight());
    assert_eq!(solution.kernel_amounts.len(), 1);
    assert!((solution.normal_force[0] - 2.0).abs() < 1e-9);
    assert!((solution.displacement[count - 1] - 3.0).abs() < 1e-8);
    // Every spring carries 2.
    let stretch = (0..count - 1)
        .map(|i| if i % 7 == 0 { 2.0 / 5.0 } else { 2.0 })
        .sum::<f64>();
    assert!((solution.displacement[0] - 3.0 - stretch).abs() < 1e-7 * stretch);
    let notes: Vec<String> = solution.notes.iter().map(ToString::to_string).collect();
    assert!(
        notes.iter().any(|note| note.contains("1 kernel vector")),
        "{notes:?}"
    );

    // Pulled away, nothing holds it.
    let mut away = problem.clone();
    away.conditions.load[0] = -2.0;
    let solution = tresca::algebraic::solve(&away, &tight(), &mut tresca::Silent).unwrap();
    assert_eq!(solution.status, tresca::Status::NoEquilibrium);
    let motion = solution.unresisted_motion.unwrap();
    assert_close(&motion, &vec![-1.0; count], 1e-8, "the motion");
}
