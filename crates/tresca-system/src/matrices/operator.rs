//! A of the pure dual form: a matrix where it lies, or a function.

use tresca_la::{SquareMatrix, SymmetricEntries};
use tresca_qcqp::operator::LocalModel;
use tresca_qcqp::{DualOperator, Tally};

use super::check;
use super::error::AlgebraicError;
use crate::layout::Layout;

/// Relative asymmetry up to which the lower triangle of A stands for both.
const ALLOWED_ASYMMETRY: f64 = 1e-8;

/// A, order dm: what contact forces do to relative displacements.
pub enum Operator<'a> {
    /// A dense matrix, made by [`Operator::dense`].
    Dense {
        /// A where it lies; its lower triangle counts.
        matrix: SquareMatrix<'a>,
        /// max |A_ij − A_ji| / max |A_ij| of what was given.
        asymmetry: f64,
    },
    /// A function that computes y ← A x.
    Product {
        /// Order of A.
        order: usize,
        /// Overwrites y and does not read it. A product that cannot be had is best filled with NaN: the
        /// solve then ends with an error or with `diverged`.
        apply: Product<'a>,
        /// diag(A), if known: preconditions.
        diagonal: Option<Vec<f64>>,
    },
}

/// y ← A x.
pub type Product<'a> = Box<dyn FnMut(&[f64], &mut [f64]) + Send + 'a>;

impl<'a> Operator<'a> {
    /// From a dense matrix, row by row, which is not copied. It must be symmetric; where it is not to the last
    /// bit, the lower triangle stands for both.
    ///
    /// # Errors
    /// When there are not order² values, one is not finite, or A is not symmetric.
    pub fn dense(order: usize, values: &'a [f64]) -> Result<Self, AlgebraicError> {
        let expected = "order × order";
        if values.len() != order * order {
            check::vector("A", values, order * order, expected)?;
        }
        let matrix = SquareMatrix::new(order, values);
        let seen = matrix.report();
        if !seen.largest.is_finite() {
            check::vector("A", values, order * order, expected)?;
        }
        let asymmetry = if seen.largest > 0.0 {
            seen.asymmetry / seen.largest
        } else {
            0.0
        };
        if asymmetry > ALLOWED_ASYMMETRY {
            let (row, column) = most_asymmetric(order, values);
            return Err(AlgebraicError::DualNotSymmetric {
                row,
                column,
                asymmetry,
            });
        }
        Ok(Operator::Dense { matrix, asymmetry })
    }

    /// From a function that computes y ← A x for vectors of length `order`.
    pub fn product(order: usize, apply: impl FnMut(&[f64], &mut [f64]) + Send + 'a) -> Self {
        Operator::Product {
            order,
            apply: Box::new(apply),
            diagonal: None,
        }
    }

    /// Order of A.
    pub fn order(&self) -> usize {
        match self {
            Operator::Dense { matrix, .. } => matrix.order(),
            Operator::Product { order, .. } => *order,
        }
    }
}

/// Where |A_ij − A_ji| is largest, i > j; the first of several.
fn most_asymmetric(order: usize, values: &[f64]) -> (usize, usize) {
    let mut worst = (0.0, (0, 0));
    for i in 0..order {
        for j in 0..i {
            let difference = (values[order * i + j] - values[order * j + i]).abs();
            if difference > worst.0 {
                worst = (difference, (i, j));
            }
        }
    }
    worst.1
}

/// diag(w): what turns ellipses into discs.
pub(super) struct Scaling {
    weights: Vec<f64>,
    /// All weights are 1.
    trivial: bool,
    scratch: Vec<f64>,
}

impl Scaling {
    pub(super) fn new(layout: &Layout) -> Self {
        let weights = layout.weights().to_vec();
        Self {
            trivial: weights.iter().all(|&w| w == 1.0),
            scratch: vec![0.0; weights.len()],
            weights,
        }
    }

    /// y ← diag(w) A diag(w) x, A the given function.
    fn product(&mut self, x: &[f64], y: &mut [f64], apply: impl FnOnce(&[f64], &mut [f64])) {
        if self.trivial {
            return apply(x, y);
        }
        for ((s, x), w) in self.scratch.iter_mut().zip(x).zip(&self.weights) {
            *s = x * w;
        }
        apply(&self.scratch, y);
        y.iter_mut().zip(&self.weights).for_each(|(y, w)| *y *= w);
    }

    /// The diagonal of diag(w) A diag(w).
    fn model(&self, diagonal: impl Fn(usize) -> f64) -> LocalModel {
        let scaled = self.weights.iter().enumerate();
        LocalModel::Diagonal(scaled.map(|(i, w)| w * w * diagonal(i)).collect())
    }
}

/// diag(w) A diag(w), A a matrix.
pub(super) struct MatrixOperator<'a> {
    matrix: SquareMatrix<'a>,
    scaling: Scaling,
    tally: Tally,
}

impl<'a> MatrixOperator<'a> {
    pub(super) fn new(matrix: SquareMatrix<'a>, scaling: Scaling) -> Self {
        let tally = Tally::default();
        Self {
            matrix,
            scaling,
            tally,
        }
    }
}

impl SymmetricEntries for MatrixOperator<'_> {
    fn entry(&self, i: usize, j: usize) -> f64 {
        let weights = &self.scaling.weights;
        weights[i] * weights[j] * self.matrix.entry(i, j)
    }
}

impl DualOperator for MatrixOperator<'_> {
    fn dim(&self) -> usize {
        self.matrix.order()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        let matrix = self.matrix;
        self.scaling
            .product(x, y, |x, y| matrix.symmetric_mul(x, y));
    }

    fn tally(&mut self) -> &mut Tally {
        &mut self.tally
    }

    fn local_model(&self) -> LocalModel {
        self.scaling.model(|i| self.matrix.entry(i, i))
    }

    fn explicit(&self) -> Option<&dyn SymmetricEntries> {
        Some(self)
    }
}

/// diag(w) A diag(w), A a function.
pub(super) struct FunctionOperator<'a> {
    apply: Product<'a>,
    /// diag(A), or 1 where it is not known.
    diagonal: Vec<f64>,
    scaling: Scaling,
    tally: Tally,
}

impl<'a> FunctionOperator<'a> {
    pub(super) fn new(apply: Product<'a>, diagonal: Vec<f64>, scaling: Scaling) -> Self {
        Self {
            apply,
            diagonal,
            scaling,
            tally: Tally::default(),
        }
    }
}

impl DualOperator for FunctionOperator<'_> {
    fn dim(&self) -> usize {
        self.diagonal.len()
    }

    fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        self.scaling.product(x, y, &mut self.apply);
    }

    fn tally(&mut self) -> &mut Tally {
        &mut self.tally
    }

    fn local_model(&self) -> LocalModel {
        self.scaling.model(|i| self.diagonal[i])
    }
}
