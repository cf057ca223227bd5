//! Sparse Cholesky factorisation K = L Lᵀ of a reordered symmetric matrix.
//!
//! Symbolic analysis and numeric kernels are faer's supernodal ones. What is
//! added here: the original numbering outside, the work counts, and the
//! trailing block.

mod permute;

use super::trailing::TrailingBlock;
use super::{BodySolver, SolverWork};
use crate::ordering::Ordering;
use crate::packed::PackedLower;
use crate::parallelism::Parallelism;
use crate::symmetric::SymmetricMatrix;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::sparse::FaerError;
use faer::sparse::linalg::cholesky::{simplicial, supernodal};
use faer::{Conj, Mat, MatMut};
use thiserror::Error;

/// Why there is no factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FactorError {
    /// The matrix is not positive definite, in floating point at least: the
    /// factorisation met a pivot that is not positive. For a stiffness matrix
    /// that means supports missing, or an element turned inside out.
    #[error(
        "the matrix is not positive definite: elimination stopped at dof {dof}, whose pivot is not positive"
    )]
    NotPositiveDefinite {
        /// The dof in original numbering.
        dof: usize,
    },
    /// Ordering and matrix have different orders.
    #[error("the ordering is for {ordering} dofs, the matrix has {matrix}")]
    OrderMismatch {
        /// Dofs of the ordering.
        ordering: usize,
        /// Dofs of the matrix.
        matrix: usize,
    },
    /// The factor does not fit into memory.
    #[error("out of memory: the factor has {nonzeros} nonzeros, {} GiB", nonzeros >> 27)]
    OutOfMemory {
        /// Nonzeros of the factor (0 when even the analysis did not fit).
        nonzeros: u64,
    },
    /// The factor has more entries than an index can count.
    #[error("the factor has {nonzeros} nonzeros, more than can be indexed")]
    IndexOverflow {
        /// Nonzeros of the factor.
        nonzeros: u64,
    },
}

/// The factor of a symmetric positive definite matrix.
#[derive(Debug)]
pub struct SparseCholesky {
    ordering: Ordering,
    symbolic: supernodal::SymbolicSupernodalCholesky<usize>,
    values: Vec<f64>,
    nonzeros: u64,
    flops: f64,
    parallelism: Parallelism,
}

impl SparseCholesky {
    /// Factors the matrix, eliminating in the given order. The threads are used
    /// for the factorisation and for later solves.
    ///
    /// # Errors
    /// [`FactorError`]; for a matrix that is not positive definite the first bad pivot.
    pub fn factor(
        matrix: &SymmetricMatrix,
        ordering: Ordering,
        parallelism: Parallelism,
    ) -> Result<Self, FactorError> {
        let order = matrix.order();
        if ordering.order() != order {
            return Err(FactorError::OrderMismatch {
                ordering: ordering.order(),
                matrix: order,
            });
        }
        let Analysis {
            symbolic,
            nonzeros,
            flops,
        } = analyse(matrix, &ordering)?;
        let out_of_memory = FactorError::OutOfMemory { nonzeros };

        let mut values = Vec::new();
        values
            .try_reserve_exact(symbolic.len_val())
            .map_err(|_| out_of_memory)?;
        values.resize(symbolic.len_val(), 0.0);
        let par = parallelism.to_faer();
        let scratch = supernodal::factorize_supernodal_numeric_llt_scratch::<usize, f64>(
            &symbolic,
            par,
            Default::default(),
        );
        let mut memory = MemBuffer::try_new(scratch).map_err(|_| out_of_memory)?;
        let permuted = permute::lower(matrix, &ordering);
        supernodal::factorize_supernodal_numeric_llt(
            &mut values,
            permuted.as_ref(),
            Default::default(),
            &symbolic,
            par,
            MemStack::new(&mut memory),
            Default::default(),
        )
        .map_err(|LltError::NonPositivePivot { index }| {
            FactorError::NotPositiveDefinite {
                dof: ordering.to_original()[index],
            }
        })?;
        Ok(Self {
            ordering,
            symbolic,
            values,
            nonzeros,
            flops,
            parallelism,
        })
    }

    /// The ordering in which the matrix was eliminated.
    pub fn ordering(&self) -> &Ordering {
        &self.ordering
    }

    /// Bytes of the stored factor, explicit zeros of merged supernodes included.
    pub fn bytes(&self) -> usize {
        std::mem::size_of_val(&self.values[..])
    }
}

impl BodySolver for SparseCholesky {
    fn order(&self) -> usize {
        self.ordering.order()
    }

    /// Allocates as many numbers as there are in the columns.
    fn solve_many(&self, mut columns: MatMut<'_, f64>) {
        assert_eq!(columns.nrows(), self.order());
        let to_original = self.ordering.to_original();
        let mut permuted = Mat::from_fn(columns.nrows(), columns.ncols(), |i, j| {
            columns[(to_original[i], j)]
        });
        let par = self.parallelism.to_faer();
        let scratch = self
            .symbolic
            .solve_in_place_scratch::<f64>(columns.ncols(), par);
        let mut memory = MemBuffer::new(scratch);
        supernodal::SupernodalLltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            permuted.as_mut(),
            par,
            MemStack::new(&mut memory),
        );
        for j in 0..columns.ncols() {
            for (i, &old) in to_original.iter().enumerate() {
                columns[(old, j)] = permuted[(i, j)];
            }
        }
    }

    fn trailing(&self) -> Option<TrailingBlock> {
        Some(trailing_block(
            supernodal::SupernodalLltRef::new(&self.symbolic, &self.values),
            self.ordering.trailing(),
        ))
    }

    /// Σ_j |L_:j|² operations; what the factorisation spends on explicit zeros in merged supernodes is not counted.
    fn work(&self) -> SolverWork {
        SolverWork {
            nonzeros: self.nonzeros,
            flops: self.flops,
        }
    }
}

/// Copies the last `order` rows and columns out of a supernodal factor,
/// over however many supernodes they are spread.
fn trailing_block(
    source: supernodal::SupernodalLltRef<'_, usize, f64>,
    order: usize,
) -> TrailingBlock {
    let symbolic = source.symbolic();
    let first = symbolic.ncols() - order;
    let mut factor = PackedLower::zeros(order);
    for s in (0..symbolic.n_supernodes()).rev() {
        let end = symbolic.supernode_end()[s];
        if end <= first {
            break;
        }
        let begin = symbolic.supernode_begin()[s];
        let node = source.supernode(s);
        let (values, pattern) = (node.val(), node.pattern());
        for column in begin.max(first)..end {
            let values = values.col(column - begin);
            for row in column..end {
                factor.set(row - first, column - first, values[row - begin]);
            }
            // The pattern below lies beyond `end`, so beyond `first` too.
            for (k, &row) in pattern.iter().enumerate() {
                factor.set(row - first, column - first, values[end - begin + k]);
            }
        }
    }
    TrailingBlock::new(factor)
}

/// What is known of a factorisation before it is done.
struct Analysis {
    symbolic: supernodal::SymbolicSupernodalCholesky<usize>,
    nonzeros: u64,
    flops: f64,
}

fn analyse(matrix: &SymmetricMatrix, ordering: &Ordering) -> Result<Analysis, FactorError> {
    let order = matrix.order();
    let pattern = permute::upper_pattern(matrix, ordering);
    let out_of_memory = FactorError::OutOfMemory { nonzeros: 0 };
    let mut tree = vec![0; order];
    let mut column_counts = vec![0; order];
    let scratch = StackReq::any_of(&[
        simplicial::prefactorize_symbolic_cholesky_scratch::<usize>(order, pattern.row_idx().len()),
        supernodal::factorize_supernodal_symbolic_cholesky_scratch::<usize>(order),
    ]);
    let mut memory = MemBuffer::try_new(scratch).map_err(|_| out_of_memory)?;
    let stack = MemStack::new(&mut memory);
    let tree = simplicial::prefactorize_symbolic_cholesky(
        &mut tree,
        &mut column_counts,
        pattern.as_ref(),
        stack,
    );
    let nonzeros = column_counts.iter().map(|&c| c as u64).sum();
    let flops = column_counts.iter().map(|&c| (c as f64) * (c as f64)).sum();
    let symbolic = supernodal::factorize_supernodal_symbolic_cholesky(
        pattern.as_ref(),
        tree,
        &column_counts,
        stack,
        Default::default(),
    )
    .map_err(|error| match error {
        FaerError::IndexOverflow => FactorError::IndexOverflow { nonzeros },
        // Out of memory is the one other error there is.
        _ => FactorError::OutOfMemory { nonzeros },
    })?;
    Ok(Analysis {
        symbolic,
        nonzeros,
        flops,
    })
}
