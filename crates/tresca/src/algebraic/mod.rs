//! The solver for matrices that were assembled elsewhere: K, f, the contact rows N and T, gaps and friction
//! in; displacements, contact forces, the state of every pair and a certificate out.
//!
//! ```text
//! K u + Nᵀλν + Tᵀλτ = f                                   equilibrium
//! N u ≤ d,  λν ≥ 0,  λνᵀ(N u − d) = 0                     no penetration, no adhesion
//! ‖λτ,i‖ ≤ g_i,  slip only at the bound, against λτ       friction on T u
//! ```
//!
//! | | shape | meaning |
//! |---|---|---|
//! | K | n × n, or a list of diagonal blocks | stiffness, symmetric, positive (semi)definite, both triangles |
//! | f | n | load: what pushes along +u |
//! | N | m × n | N u is the approach of the two sides along the normal; positive closes the gap |
//! | T | (d−1)m × n | T u is the slip, rows of a pair adjacent; d = 2 or 3; without it there is no friction |
//! | d | m | gap at u = 0; negative where the sides overlap |
//! | λν | m | normal forces, positive in compression: they act on the bodies by −Nᵀλν |
//! | λτ | (d−1)m | friction forces: they act on the bodies by −Tᵀλτ, against the slip |
//!
//! Units are the caller's: f, λ and slip bounds in one unit of force, u and d in one of length. All
//! bounds are forces of the pair, not stresses. docs/bring-your-own-matrices.md has the same with files.
//!
//! ```
//! use tresca::algebraic::{Law, Matrix, Problem, solve};
//! use tresca::{Settings, Silent};
//!
//! // A mass on two springs (1 N/m along the normal, 2 N/m along the tangent), 0.5 m above a rough wall.
//! let k = Matrix::from_dense((2, 2), &[1.0, 0.0, 0.0, 2.0])?;
//! let n = Matrix::from_dense((1, 2), &[1.0, 0.0])?;
//! let t = Matrix::from_dense((1, 2), &[0.0, 1.0])?;
//! let problem = Problem::new(k, n, vec![2.0, 1.0])
//!     .with_tangential(t)
//!     .with_gap(vec![0.5])
//!     .with_friction(Law::coulomb(0.2));
//!
//! let solution = solve(&problem, &Settings::default(), &mut Silent)?;
//! assert!(solution.status.is_converged());
//! // The wall takes 2 − 0.5, friction a fifth of it, and the mass slips.
//! assert!((solution.normal_force[0] - 1.5).abs() < 1e-8);
//! assert!((solution.tangential_force[0] - 0.3).abs() < 1e-8);
//! assert!((solution.slip[0] - 0.35).abs() < 1e-8);
//! assert!(solution.closed[0] && !solution.stick[0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`solve`] does it in one go. [`prepare`] factors once, and [`Prepared::solve`] then takes other loads, gaps
//! and bounds: load steps. [`Dual`] is the same for those who have A, b and the bounds alone.

/// The examples of the page are compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../../../docs/bring-your-own-matrices.md")]
struct Page;

mod bodies;
mod check;
mod dual;
mod error;
mod files;
mod friction;
mod grounding;
mod kernel;
mod matrix;
mod model;
mod note;
mod operator;
mod parts;
mod patches;
mod prepared;
mod rank;
mod solution;

pub use dual::{Dual, solve_dual};
pub use error::{AlgebraicError, MatrixError};
pub use files::{ExportError, FileError};
pub use friction::{Friction, Law};
pub use matrix::{Index, Matrix};
pub use model::Assembly;
pub use note::{Note, Row};
pub use operator::{Operator, Product};
pub use prepared::{Prepared, prepare};
pub use solution::{Forces, Solution};

use tresca_qcqp::Settings;

use crate::Progress;

/// The kernel of a K that is singular: the motions that the supports leave to the bodies.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Kernel {
    /// It is looked for.
    #[default]
    Find,
    /// Vectors over all dofs that span it. A vector may move several unconnected parts of K at once: its
    /// share in each part counts on its own.
    Given(Vec<Vec<f64>>),
}

/// A contact problem as matrices. Whether they fit is checked by [`prepare`].
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// K: its diagonal blocks, in the order of the dofs.
    pub stiffness: Vec<Matrix>,
    /// The kernel of K.
    pub kernel: Kernel,
    /// N, m × n.
    pub normal: Matrix,
    /// T, m × n in the plane, 2m × n in space (rows 2i, 2i + 1 belong to pair i); `None` without friction.
    pub tangential: Option<Matrix>,
    /// Where the pairs are, if known; improves the preconditioner, changes no result.
    pub points: Option<Vec<[f64; 3]>>,
    /// More than one solve will follow: forming A may then pay.
    pub many_solves: bool,
    /// What may change from one solve to the next.
    pub conditions: Conditions,
}

/// The part of a problem that may change from one solve to the next.
#[derive(Debug, Clone, PartialEq)]
pub struct Conditions {
    /// f, length n.
    pub load: Vec<f64>,
    /// d, length m; 0 without it.
    pub gap: Option<Vec<f64>>,
    /// The friction laws.
    pub friction: Friction,
    /// The slip T u of the step before, length (d−1)m: friction acts on what is added to it. For tied pairs
    /// the slip at which they were glued. 0 without it.
    pub previous_slip: Option<Vec<f64>>,
    /// Where to start from.
    pub start: Option<Forces>,
}

impl Problem {
    /// A problem without friction and with gap 0: K (one matrix or a list of blocks), N, f.
    pub fn new(stiffness: impl Into<Blocks>, normal: Matrix, load: Vec<f64>) -> Self {
        Self {
            stiffness: stiffness.into().0,
            kernel: Kernel::Find,
            normal,
            tangential: None,
            points: None,
            many_solves: false,
            conditions: Conditions {
                load,
                gap: None,
                friction: Law::Frictionless.into(),
                previous_slip: None,
                start: None,
            },
        }
    }

    /// The same with both parts of B = \[N; T\] in one matrix, `pairs` rows of N first.
    ///
    /// # Errors
    /// [`AlgebraicError::Shape`] when there are not `pairs`, 2·`pairs` or 3·`pairs` rows.
    pub fn stacked(
        stiffness: impl Into<Blocks>,
        b: &Matrix,
        pairs: usize,
        load: Vec<f64>,
    ) -> Result<Self, AlgebraicError> {
        let rows = b.rows();
        if ![pairs, 2 * pairs, 3 * pairs].contains(&rows) {
            return Err(AlgebraicError::Shape {
                what: "B",
                rows,
                columns: b.columns(),
                expected: format!(
                    "{pairs}, {} or {} rows for {pairs} pairs: without, with one and with two tangents",
                    2 * pairs,
                    3 * pairs
                ),
            });
        }
        let problem = Self::new(stiffness, b.rows_between(0, pairs), load);
        Ok(if rows == pairs {
            problem
        } else {
            problem.with_tangential(b.rows_between(pairs, rows))
        })
    }

    /// Adds T.
    #[must_use]
    pub fn with_tangential(mut self, tangential: Matrix) -> Self {
        self.tangential = Some(tangential);
        self
    }

    /// Sets d.
    #[must_use]
    pub fn with_gap(mut self, gap: Vec<f64>) -> Self {
        self.conditions.gap = Some(gap);
        self
    }

    /// Sets the friction: one [`Law`] for all pairs or a list.
    #[must_use]
    pub fn with_friction(mut self, friction: impl Into<Friction>) -> Self {
        self.conditions.friction = friction.into();
        self
    }

    /// Gives vectors over all dofs that span the kernel of K.
    #[must_use]
    pub fn with_kernel(mut self, vectors: Vec<Vec<f64>>) -> Self {
        self.kernel = Kernel::Given(vectors);
        self
    }

    /// Sets the slip of the step before.
    #[must_use]
    pub fn with_previous_slip(mut self, slip: Vec<f64>) -> Self {
        self.conditions.previous_slip = Some(slip);
        self
    }

    /// Sets the forces to start from.
    #[must_use]
    pub fn with_start(mut self, start: Forces) -> Self {
        self.conditions.start = Some(start);
        self
    }

    /// n.
    pub fn dofs(&self) -> usize {
        self.stiffness.iter().map(Matrix::rows).sum()
    }

    /// m.
    pub fn pairs(&self) -> usize {
        self.normal.rows()
    }

    /// Tangents per pair: 0, 1 or 2.
    pub fn tangents(&self) -> usize {
        let rows = self.tangential.as_ref().map_or(0, Matrix::rows);
        rows.checked_div(self.pairs()).unwrap_or(0)
    }
}

/// K as one matrix or as its diagonal blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct Blocks(pub Vec<Matrix>);

impl From<Matrix> for Blocks {
    fn from(matrix: Matrix) -> Self {
        Blocks(vec![matrix])
    }
}

impl From<Vec<Matrix>> for Blocks {
    fn from(blocks: Vec<Matrix>) -> Self {
        Blocks(blocks)
    }
}

/// Prepares and solves.
///
/// `progress` hears the stages and every iteration; a `Break` of it ends the run with
/// [`Status::Interrupted`](crate::Status::Interrupted) and what there is by then. Before the first iteration
/// that is λ = 0.
///
/// # Errors
/// When the matrices, vectors or settings are wrong. How the solve ended stands in the solution.
pub fn solve(
    problem: &Problem,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<Solution, AlgebraicError> {
    settings.validate()?;
    let mut prepared = prepare(problem, settings, progress)?;
    prepared.solve(&problem.conditions, settings, progress)
}
