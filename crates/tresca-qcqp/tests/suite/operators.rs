//! Every engine is the same operator.

use crate::common::problems::{normals, rng};
use crate::common::{distance, dot, norm, settings};
use faer::sparse::{SparseColMat, SparseRowMat, Triplet};
use faer::{Mat, Side, prelude::Solve};
use std::sync::Arc;
use tresca_la::{BodySolver, Ordering, Parallelism, SparseCholesky, SymmetricMatrix};
use tresca_qcqp::operator::{Condensed, Coupling, Dense, Factored, LocalModel, groups};
use tresca_qcqp::sets::{BlockSet, Disc, Interval};
use tresca_qcqp::{
    DualOperator, DualProblem, InnerSolver, Method, ProductSet, Settings, Unobserved, solve,
};

const PAIRS: usize = 12;

/// A random sparse SPD stiffness, and coupling rows with a few entries each.
struct Body {
    stiffness: Mat<f64>,
    rows: Mat<f64>,
}

impl Body {
    fn random(dofs: usize, contact: std::ops::Range<usize>, seed: u64) -> Self {
        let rng = &mut rng(seed);
        let mut stiffness = Mat::zeros(dofs, dofs);
        for i in 0..dofs {
            for j in [i + 1, i + 2, i + 7].into_iter().filter(|&j| j < dofs) {
                let v = crate::common::problems::normal(rng);
                stiffness[(i, j)] = v;
                stiffness[(j, i)] = v;
            }
        }
        for i in 0..dofs {
            let sum: f64 = (0..dofs).map(|j| stiffness[(i, j)].abs()).sum();
            stiffness[(i, i)] = sum + 0.5;
        }
        // Each pair hangs on three dofs of its own, turned by a random frame; the last one on none
        // (it is clamped on this body).
        let mut rows = Mat::zeros(3 * PAIRS, dofs);
        let free: Vec<usize> = contact.collect();
        for pair in 0..PAIRS - 1 {
            for row in [pair, PAIRS + 2 * pair, PAIRS + 2 * pair + 1] {
                for (k, v) in normals(rng, 3).into_iter().enumerate() {
                    rows[(row, free[(3 * pair + k) % free.len()])] += v;
                }
            }
        }
        Self { stiffness, rows }
    }

    fn symmetric(&self) -> SymmetricMatrix {
        let n = self.stiffness.nrows();
        let entries: Vec<_> = (0..n)
            .flat_map(|j| (j..n).map(move |i| (i, j)))
            .filter(|&(i, j)| self.stiffness[(i, j)] != 0.0)
            .map(|(i, j)| Triplet::new(i, j, self.stiffness[(i, j)]))
            .collect();
        SymmetricMatrix::from_lower(SparseColMat::try_new_from_triplets(n, n, &entries).unwrap())
    }

    fn coupling(&self) -> Coupling {
        let (m, n) = self.rows.shape();
        let entries: Vec<_> = (0..m)
            .flat_map(|i| (0..n).map(move |j| (i, j)))
            .filter(|&(i, j)| self.rows[(i, j)] != 0.0)
            .map(|(i, j)| Triplet::new(i, j, self.rows[(i, j)]))
            .collect();
        Coupling::new(SparseRowMat::try_new_from_triplets(m, n, &entries).unwrap())
    }

    fn dual(&self) -> Mat<f64> {
        let inverse = self
            .stiffness
            .llt(Side::Lower)
            .unwrap()
            .solve(self.rows.transpose());
        &self.rows * inverse
    }
}

fn bodies() -> [Body; 2] {
    [Body::random(70, 20..60, 1), Body::random(55, 0..36, 2)]
}

fn exact() -> Mat<f64> {
    let [upper, lower] = bodies();
    upper.dual() + lower.dual()
}

fn factored(patches: &[Vec<usize>]) -> Factored {
    let bodies = bodies();
    let stiffness: Vec<SymmetricMatrix> = bodies.iter().map(Body::symmetric).collect();
    let parts = bodies.iter().zip(&stiffness).map(|(body, stiffness)| {
        let ordering = Ordering::nested_dissection(stiffness).unwrap();
        let cholesky = SparseCholesky::factor(stiffness, ordering, Parallelism::Sequential);
        let solver: Arc<dyn BodySolver> = Arc::new(cholesky.unwrap());
        (stiffness, solver, body.coupling())
    });
    Factored::new(parts.collect(), patches)
}

fn condensed(patches: Vec<Vec<usize>>) -> Condensed {
    let parts = bodies().map(|body| {
        let (stiffness, coupling) = (body.symmetric(), body.coupling());
        // Any order of the contact dofs will do.
        let mut trailing = coupling.touched();
        trailing.rotate_left(5);
        let ordering = Ordering::nested_dissection_with_trailing(&stiffness, &trailing).unwrap();
        let cholesky =
            SparseCholesky::factor(&stiffness, ordering, Parallelism::Sequential).unwrap();
        (cholesky.trailing().unwrap(), coupling.restricted(&trailing))
    });
    Condensed::new(parts.into(), patches)
}

fn pairs() -> Vec<Vec<usize>> {
    groups::unknowns_of_pairs(&(0..PAIRS).map(|i| vec![i]).collect::<Vec<_>>(), 3)
}

fn patches() -> Vec<Vec<usize>> {
    let points: Vec<[f64; 3]> = (0..PAIRS).map(|i| [i as f64, 0.0, 0.0]).collect();
    groups::unknowns_of_pairs(&groups::neighbours(&points, 4), 3)
}

/// What every dual operator must fulfil.
fn assert_conforms(operator: &mut dyn DualOperator, exact: &Mat<f64>) {
    let n = exact.nrows();
    assert_eq!(DualOperator::dim(operator), n);
    let rng = &mut rng(77);
    let (x, z) = (normals(rng, n), normals(rng, n));
    let multiply = |operator: &mut dyn DualOperator, x: &[f64]| {
        let before = operator.tally().count;
        // The output is overwritten, not read.
        let mut y = vec![f64::NAN; n];
        DualOperator::apply(operator, x, &mut y);
        assert_eq!(operator.tally().count, before + 1);
        y
    };
    let (ax, az) = (multiply(operator, &x), multiply(operator, &z));
    let expected: Vec<f64> = (0..n)
        .map(|i| (0..n).map(|j| exact[(i, j)] * x[j]).sum())
        .collect();
    assert!(distance(&ax, &expected) <= 1e-12 * norm(&expected));
    assert!((dot(&ax, &z) - dot(&az, &x)).abs() <= 1e-12 * norm(&ax) * norm(&z));
    assert!(dot(&ax, &x) > 0.0);
    assert_eq!(
        multiply(operator, &x),
        ax,
        "two products of one vector differ"
    );
    assert_eq!(multiply(operator, &vec![0.0; n]), vec![0.0; n]);
    assert_model_fits(&operator.local_model(), exact);
    if let Some(matrix) = operator.explicit() {
        for j in 0..n {
            for i in j..n {
                assert!((matrix.entry(i, j) - exact[(i, j)]).abs() <= 1e-12 * exact.norm_max());
            }
        }
    }
}

/// Every unknown once, positive semidefinite, and on the diagonal between a part of A and A:
/// holding the other dofs makes a body stiffer, never softer.
fn assert_model_fits(model: &LocalModel, exact: &Mat<f64>) {
    let n = exact.nrows();
    let mut diagonal = vec![f64::NAN; n];
    match model {
        LocalModel::Diagonal(d) => diagonal.copy_from_slice(d),
        LocalModel::Blocks(blocks) => {
            for block in blocks {
                for (row, &i) in block.unknowns.iter().enumerate() {
                    assert!(diagonal[i].is_nan(), "unknown {i} is in two blocks");
                    diagonal[i] = block.matrix[(row, row)];
                }
                let own = Mat::from_fn(block.unknowns.len(), block.unknowns.len(), |i, j| {
                    exact[(block.unknowns[i], block.unknowns[j])]
                });
                let missing = &own - &block.matrix;
                let lowest = missing.self_adjoint_eigenvalues(Side::Lower).unwrap()[0];
                assert!(
                    lowest >= -1e-12 * own.norm_max(),
                    "the model is above A by {lowest:e}"
                );
            }
        }
    }
    for (i, d) in diagonal.into_iter().enumerate() {
        let a = exact[(i, i)];
        assert!(
            d <= a * (1.0 + 1e-12) && d >= 0.3 * a,
            "unknown {i}: {d} for {a}"
        );
    }
}

#[test]
fn factored_conforms() {
    assert_conforms(&mut factored(&pairs()), &exact());
    assert_conforms(&mut factored(&patches()), &exact());
}

#[test]
fn condensed_conforms() {
    assert_conforms(&mut condensed(pairs()), &exact());
    assert_conforms(&mut condensed(patches()), &exact());
}

#[test]
fn explicit_conforms() {
    for parallelism in [Parallelism::Sequential, Parallelism::Threads(2)] {
        let mut dense: Dense = condensed(pairs()).explicit(parallelism);
        assert_conforms(&mut dense, &exact());
    }
}

#[test]
fn touched_dofs_and_restriction_keep_every_entry() {
    let body = &bodies()[0];
    let coupling = body.coupling();
    let touched = coupling.touched();
    assert!(touched.is_sorted() && touched.iter().all(|dof| (20..60).contains(dof)));
    let mut order = touched.clone();
    order.reverse();
    let restricted = coupling.restricted(&order);
    assert_eq!(
        (restricted.rows(), restricted.dofs()),
        (3 * PAIRS, touched.len())
    );
    for i in 0..coupling.rows() {
        let mut back: Vec<_> = restricted.row(i).map(|(j, b)| (order[j], b)).collect();
        back.sort_by_key(|(j, _)| *j);
        assert_eq!(back, coupling.row(i).collect::<Vec<_>>());
    }
}

/// The pair that hangs on nothing has a zero row in A; b decides about it alone.
#[test]
fn engines_lead_to_the_same_solution() {
    let n = 3 * PAIRS;
    let mut rhs = normals(&mut rng(4), n);
    rhs[PAIRS - 1] = -1.0;
    rhs[n - 2..].fill(0.0);
    let set = ProductSet::contact_3d(&[0.2; PAIRS]).unwrap();
    let run = |problem: Result<DualProblem, _>, inner_solver| {
        let settings = Settings {
            inner_solver,
            ..settings(Method::Grssn, 1e-11)
        };
        let solution = solve(&mut problem.unwrap(), &settings, None, &mut Unobserved).unwrap();
        assert!(solution.status.is_converged(), "{}", solution.status);
        (solution.lambda, solution.figures.n_a)
    };
    let iterative = InnerSolver::Iterative;
    let (reference, pairs_n_a) = run(
        DualProblem::new(condensed(pairs()), rhs.clone(), set.clone()),
        iterative,
    );
    let results = [
        run(
            DualProblem::new(condensed(patches()), rhs.clone(), set.clone()),
            iterative,
        ),
        run(
            DualProblem::new(factored(&pairs()), rhs.clone(), set.clone()),
            iterative,
        ),
        run(
            DualProblem::new(
                condensed(pairs()).explicit(Parallelism::Sequential),
                rhs.clone(),
                set.clone(),
            ),
            InnerSolver::Auto,
        ),
    ];
    for (lambda, n_a) in results {
        assert!(distance(&lambda, &reference) <= 1e-9 * norm(&reference));
        assert!(
            n_a <= pairs_n_a + 5,
            "{n_a} products, {pairs_n_a} with the model of single pairs"
        );
    }
}

/// Unknowns of a pair that is held on both sides: zero rows, points as their sets, and any b.
#[test]
fn held_pairs_are_harmless_in_every_engine() {
    let n = 3 * PAIRS;
    let mut rhs = normals(&mut rng(5), n);
    let set = |held: bool| {
        let mut blocks = ProductSet::contact_3d(&[0.2; PAIRS])
            .unwrap()
            .blocks()
            .to_vec();
        let point = BlockSet::Interval(Interval { bound: 0.0 });
        if held {
            blocks[PAIRS - 1].set = point;
            blocks[2 * PAIRS - 1].set = BlockSet::Disc(Disc { bound: 0.0 });
        }
        ProductSet::new(n, blocks).unwrap()
    };
    let run = |operator: Box<dyn DualOperator>, rhs: &[f64], held, method, inner_solver| {
        let settings = Settings {
            inner_solver,
            ..settings(method, 1e-10)
        };
        let mut problem = DualProblem::new(Boxed(operator), rhs.to_vec(), set(held)).unwrap();
        let solution = solve(&mut problem, &settings, None, &mut Unobserved).unwrap();
        assert!(
            solution.status.is_converged(),
            "{method}: {}",
            solution.status
        );
        solution.lambda
    };
    let mut harmless = rhs.clone();
    harmless[PAIRS - 1] = -1.0;
    harmless[n - 2..].fill(0.0);
    let iterative = InnerSolver::Iterative;
    let reference = run(
        Box::new(condensed(pairs())),
        &harmless,
        false,
        Method::Grssn,
        iterative,
    );
    rhs[PAIRS - 1] = 2.0;
    for method in [Method::Grssn, Method::Apgd, Method::Gimssn] {
        for inner_solver in [iterative, InnerSolver::Direct] {
            let engines: [Box<dyn DualOperator>; 4] = [
                Box::new(condensed(pairs())),
                Box::new(condensed(patches())),
                Box::new(factored(&patches())),
                Box::new(condensed(patches()).explicit(Parallelism::Sequential)),
            ];
            for engine in engines {
                let lambda = run(engine, &rhs, true, method, inner_solver);
                assert!(
                    distance(&lambda, &reference) <= 1e-7 * norm(&reference),
                    "{method}"
                );
                assert_eq!((lambda[PAIRS - 1], &lambda[n - 2..]), (0.0, &[0.0; 2][..]));
            }
        }
    }
}

/// An engine behind a pointer.
struct Boxed(Box<dyn DualOperator>);

impl DualOperator for Boxed {
    fn dim(&self) -> usize {
        DualOperator::dim(&*self.0)
    }
    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.0.multiply(x, y);
    }
    fn tally(&mut self) -> &mut tresca_qcqp::Tally {
        self.0.tally()
    }
    fn local_model(&self) -> LocalModel {
        self.0.local_model()
    }
    fn explicit(&self) -> Option<&dyn tresca_la::SymmetricEntries> {
        self.0.explicit()
    }
}

#[test]
#[should_panic(expected = "in no group")]
fn groups_must_cover_every_unknown() {
    condensed(pairs()[1..].to_vec());
}

/// A solver that is off by a known part.
struct Rough(Box<dyn BodySolver>);

impl BodySolver for Rough {
    fn order(&self) -> usize {
        self.0.order()
    }

    fn solve_many(&self, mut columns: faer::MatMut<'_, f64>) {
        self.0.solve_many(columns.as_mut());
        columns *= faer::Scale(1.0 + 1e-6);
    }

    fn work(&self) -> tresca_la::SolverWork {
        self.0.work()
    }

    fn accuracy(&self) -> f64 {
        1e-6
    }
}

#[test]
fn a_sum_of_solves_is_as_accurate_as_the_worst_of_them_states() {
    assert_eq!(factored(&patches()).accuracy(), f64::EPSILON);
    assert_eq!(condensed(patches()).accuracy(), f64::EPSILON);
    let bodies = bodies();
    let stiffness: Vec<SymmetricMatrix> = bodies.iter().map(Body::symmetric).collect();
    let parts = bodies.iter().zip(&stiffness).enumerate();
    let parts = parts.map(|(number, (body, stiffness))| {
        let ordering = Ordering::nested_dissection(stiffness).unwrap();
        let exact = SparseCholesky::factor(stiffness, ordering, Parallelism::Sequential).unwrap();
        let solver: Arc<dyn BodySolver> = if number == 0 {
            Arc::new(Rough(Box::new(exact)))
        } else {
            Arc::new(exact)
        };
        (stiffness, solver, body.coupling())
    });
    let mut operator = Factored::new(parts.collect(), &patches());
    assert_eq!(operator.accuracy(), 1e-6);
    let exact = exact();
    let x = normals(&mut rng(78), exact.nrows());
    let mut y = vec![0.0; x.len()];
    operator.apply(&x, &mut y);
    let off = faer::ColRef::from_slice(&y) - &exact * faer::ColRef::from_slice(&x);
    assert!(off.norm_l2() <= 1e-6 * exact.norm_l2() * faer::ColRef::from_slice(&x).norm_l2());
}
