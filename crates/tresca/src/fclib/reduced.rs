//! A problem reduced to its contacts.

use faer::sparse::{SparseColMat, Triplet};
use faer::{MatRef, Side};
use serde::Serialize;
use tresca_io::fclib::{FclibMatrix, FclibProblem};
use tresca_la::{BodySolver, Ordering, Parallelism, SparseCholesky, SymmetricMatrix};

use crate::fclib::error::FclibProblemError;

/// Asymmetry up to which a matrix is taken for a symmetric one with rounding errors. Files of
/// Siconos printed with six digits, and of solvers that build W by blocks, reach 1e-5.
const ASYMMETRY: f64 = 1e-3;
/// Largest order of W: 20 000 unknowns take 3.2 GB.
const LARGEST: usize = 20_000;
/// Largest order whose eigenvalues are computed, which takes some seconds there.
const LARGEST_SPECTRUM: usize = 2000;
/// Eigenvalues below this times the order times the largest one count as zero.
const ZERO: f64 = 1e-12;

/// W and q of a problem of either form, in the solver's order (all normals before all tangents), and M factored.
pub(super) struct Reduced {
    /// ½(W + Wᵀ), full, row by row.
    pub w: Vec<f64>,
    /// q.
    pub q: Vec<f64>,
    pub facts: MatrixFacts,
    mass: Option<Box<dyn BodySolver>>,
}

/// What W is like.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct MatrixFacts {
    /// Its order.
    pub unknowns: usize,
    /// Entries that are not zero (of a dense W all of them).
    pub entries: usize,
    /// max |W − Wᵀ| / (2 max |W|). The solver has ½(W + Wᵀ).
    pub asymmetry: f64,
    /// Rank of ½(W + Wᵀ); `None` above the order up to which eigenvalues are computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rank: Option<usize>,
    /// Smallest eigenvalue; below zero W is no longer semidefinite.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smallest_eigenvalue: Option<f64>,
    /// Largest eigenvalue.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub largest_eigenvalue: Option<f64>,
}

impl MatrixFacts {
    /// Whether the rank is known to be below the order: then forces need not be unique.
    pub fn is_singular(&self) -> bool {
        self.rank.is_some_and(|rank| rank < self.unknowns)
    }
}

/// Where unknown `i` of λ = \[normals; tangents\] stands in the vectors of the file.
pub(super) fn place(dimension: usize, contacts: usize, i: usize) -> usize {
    let tangents = dimension - 1;
    match i.checked_sub(contacts) {
        None => dimension * i,
        Some(t) => dimension * (t / tangents) + 1 + t % tangents,
    }
}

/// Where the unknowns of the file stand in λ = \[normals; tangents\].
fn inverse_places(problem: &FclibProblem) -> Vec<usize> {
    let mut own = vec![0; problem.unknowns()];
    for i in 0..own.len() {
        own[place(problem.dimension(), problem.contacts(), i)] = i;
    }
    own
}

impl Reduced {
    pub fn new(problem: &FclibProblem) -> Result<Self, FclibProblemError> {
        let check = problem.check();
        check.map_err(|(part, defect)| FclibProblemError::Part { part, defect })?;
        let unknowns = problem.unknowns();
        if unknowns > LARGEST {
            return Err(FclibProblemError::TooLarge {
                unknowns,
                allowed: LARGEST,
            });
        }
        let own = inverse_places(problem);
        let mut w = vec![0.0; unknowns * unknowns];
        let mut q = vec![0.0; unknowns];
        let mut mass = None;
        match problem {
            FclibProblem::Local(local) => {
                for &(row, column, value) in local.w.entries() {
                    w[unknowns * own[row] + own[column]] = value;
                }
                own.iter().zip(&local.q).for_each(|(&i, &own)| q[i] = own);
            }
            FclibProblem::Global(global) => {
                let factor = factor(&global.m)?;
                for (column, image) in columns(&global.h).into_iter().enumerate() {
                    let mut image = image;
                    factor.solve_in_place(&mut image);
                    for (row, value) in global.h.transposed_times(&image).into_iter().enumerate() {
                        w[unknowns * own[row] + own[column]] = value;
                    }
                }
                let mut without = global.f.clone();
                factor.solve_in_place(&mut without);
                let velocity = global.h.transposed_times(&without);
                for (&i, (u, shift)) in own.iter().zip(velocity.iter().zip(&global.w)) {
                    q[i] = u + shift;
                }
                mass = Some(factor);
            }
        }
        let asymmetry = symmetrise(&mut w, unknowns);
        if asymmetry > ASYMMETRY {
            return Err(FclibProblemError::Asymmetric {
                name: "W",
                asymmetry,
                allowed: ASYMMETRY,
            });
        }
        let facts = facts(problem, &w, asymmetry);
        Ok(Self { w, q, facts, mass })
    }

    /// u and v from r, by the matrices of the file.
    pub fn velocities(
        &self,
        problem: &FclibProblem,
        forces: &[f64],
    ) -> (Vec<f64>, Option<Vec<f64>>) {
        let sum =
            |a: Vec<f64>, b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a + b).collect() };
        match (problem, &self.mass) {
            (FclibProblem::Global(global), Some(mass)) => {
                let mut v = sum(global.h.times(forces), &global.f);
                mass.solve_in_place(&mut v);
                let u = sum(global.h.transposed_times(&v), &global.w);
                (u, Some(v))
            }
            (FclibProblem::Local(local), _) => (sum(local.w.times(forces), &local.q), None),
            (FclibProblem::Global(_), None) => {
                unreachable!("M of a global problem has been factored")
            }
        }
    }
}

fn facts(problem: &FclibProblem, w: &[f64], asymmetry: f64) -> MatrixFacts {
    let unknowns = problem.unknowns();
    let eigenvalues = (0 < unknowns && unknowns <= LARGEST_SPECTRUM)
        .then(|| {
            let w = MatRef::from_row_major_slice(w, unknowns, unknowns);
            w.self_adjoint_eigenvalues(Side::Lower).ok()
        })
        .flatten();
    let largest = eigenvalues
        .as_ref()
        .and_then(|values| values.last().copied());
    let zero = largest.map(|largest| ZERO * unknowns as f64 * largest);
    let rank = eigenvalues.as_ref().zip(zero);
    MatrixFacts {
        unknowns,
        entries: match problem {
            FclibProblem::Local(local) => local.w.entries().len(),
            FclibProblem::Global(_) => unknowns * unknowns,
        },
        asymmetry,
        rank: rank.map(|(values, zero)| values.iter().filter(|&&value| value > zero).count()),
        smallest_eigenvalue: eigenvalues
            .as_ref()
            .and_then(|values| values.first().copied()),
        largest_eigenvalue: largest,
    }
}

fn columns(matrix: &FclibMatrix) -> Vec<Vec<f64>> {
    let mut columns = vec![vec![0.0; matrix.rows()]; matrix.columns()];
    for &(row, column, value) in matrix.entries() {
        columns[column][row] = value;
    }
    columns
}

/// A ← ½(A + Aᵀ), row by row; returns max |A − Aᵀ| / (2 max |A|), 0 for A = 0.
fn symmetrise(a: &mut [f64], order: usize) -> f64 {
    let (mut largest, mut difference) = (0.0_f64, 0.0_f64);
    for j in 0..order {
        largest = largest.max(a[order * j + j].abs());
        for i in j + 1..order {
            let (below, above) = (a[order * i + j], a[order * j + i]);
            largest = largest.max(below.abs()).max(above.abs());
            difference = difference.max((below - above).abs());
            let mean = 0.5 * (below + above);
            a[order * i + j] = mean;
            a[order * j + i] = mean;
        }
    }
    if largest > 0.0 {
        difference / (2.0 * largest)
    } else {
        0.0
    }
}

/// The factor of ½(M + Mᵀ).
fn factor(m: &FclibMatrix) -> Result<Box<dyn BodySolver>, FclibProblemError> {
    let largest = m.entries().iter().fold(0.0_f64, |a, e| a.max(e.2.abs()));
    // Every entry goes in half, and half into its mirror image: what is on the diagonal twice.
    let halves = m
        .entries()
        .iter()
        .flat_map(|&(row, column, value)| [(row, column, 0.5 * value), (column, row, 0.5 * value)]);
    let mut symmetric = std::collections::BTreeMap::<(usize, usize), [f64; 2]>::new();
    for (index, (row, column, value)) in halves.enumerate() {
        symmetric.entry((column, row)).or_default()[index % 2] += value;
    }
    let differs = |halves: &[f64; 2]| (halves[0] - halves[1]).abs();
    let asymmetry =
        symmetric.values().map(differs).fold(0.0, f64::max) / largest.max(f64::MIN_POSITIVE);
    if asymmetry > ASYMMETRY {
        return Err(FclibProblemError::Asymmetric {
            name: "M",
            asymmetry,
            allowed: ASYMMETRY,
        });
    }
    let lower: Vec<_> = symmetric
        .into_iter()
        .filter(|((column, row), _)| row >= column)
        .map(|((column, row), halves)| Triplet::new(row, column, halves[0] + halves[1]))
        .collect();
    let Ok(lower) = SparseColMat::try_new_from_triplets(m.rows(), m.rows(), &lower) else {
        unreachable!("the entries of a checked matrix lie inside")
    };
    let symmetric = SymmetricMatrix::from_lower(lower);
    let ordering = Ordering::nested_dissection(&symmetric)?;
    let all = Parallelism::Threads(rayon::current_num_threads());
    let factor = SparseCholesky::factor(&symmetric, ordering, all)?;
    Ok(Box::new(factor))
}
