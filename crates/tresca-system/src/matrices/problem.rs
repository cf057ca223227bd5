//! A contact problem as matrices.

use super::error::AlgebraicError;
use super::friction::{Friction, PairLaw};
use super::matrix::Matrix;
use super::solution::Forces;

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

/// A contact problem as matrices. Whether they fit is checked by [`prepare`](super::prepare).
#[derive(Debug, Clone, PartialEq)]
pub struct MatrixProblem {
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

impl MatrixProblem {
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
                friction: PairLaw::Frictionless.into(),
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

    /// Sets the friction: one [`PairLaw`] for all pairs or a list.
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
