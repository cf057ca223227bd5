//! Fill-reducing orderings for the sparse Cholesky factorisation.
//!
//! Nested dissection by METIS, on the graph of *groups* of dofs that share
//! their neighbours (the components at one node), followed by a postordering of
//! the elimination tree, which changes no fill and gives the factorisation its
//! largest supernodes.

pub(crate) mod error;
mod graph;
mod layers;
mod metis;

use crate::symmetric::SymmetricMatrix;
use error::OrderingError;
use graph::Graph;
use layers::Layers;

/// A symmetric permutation that keeps the Cholesky factor sparse.
#[derive(Clone, Debug)]
pub struct Ordering {
    to_original: Vec<usize>,
    from_original: Vec<usize>,
    trailing: usize,
}

impl Ordering {
    /// Nested dissection of the whole matrix.
    ///
    /// # Errors
    /// [`OrderingError`]; none of them for matrices of ordinary size.
    pub fn nested_dissection(matrix: &SymmetricMatrix) -> Result<Self, OrderingError> {
        Self::nested_dissection_with_trailing(matrix, &[])
    }

    /// Nested dissection of all dofs but `trailing`, which come last, in the
    /// order given. The last diagonal block of the factor is then the factor of
    /// the Schur complement on these dofs.
    ///
    /// # Errors
    /// [`OrderingError`]: a trailing dof out of range or listed twice.
    pub fn nested_dissection_with_trailing(
        matrix: &SymmetricMatrix,
        trailing: &[usize],
    ) -> Result<Self, OrderingError> {
        let order = matrix.order();
        let mut is_trailing = vec![false; order];
        for &dof in trailing {
            let seen = is_trailing
                .get_mut(dof)
                .ok_or(OrderingError::TrailingOutOfRange { dof, order })?;
            if std::mem::replace(seen, true) {
                return Err(OrderingError::TrailingRepeated { dof });
            }
        }
        let graph = Graph::compressed(matrix, &is_trailing);
        let groups = match Layers::of(&graph) {
            Some(Layers { far, near, cut }) => {
                let mut groups = graph.dissect(&far)?;
                groups.extend(graph.dissect(&near)?);
                groups.extend(cut);
                groups
            }
            None => graph.dissect(&(0..graph.len()).collect::<Vec<_>>())?,
        };
        let mut to_original = Vec::with_capacity(order);
        for group in graph.postordered(groups) {
            to_original.extend(graph.dofs_of(group));
        }
        to_original.extend_from_slice(trailing);
        Ok(Self::from_parts(to_original, trailing.len()))
    }

    /// No reordering: for matrices that are ordered well already, and for tests.
    pub fn natural(order: usize) -> Self {
        Self::from_parts((0..order).collect(), 0)
    }

    fn from_parts(to_original: Vec<usize>, trailing: usize) -> Self {
        let mut from_original = vec![usize::MAX; to_original.len()];
        for (new, &old) in to_original.iter().enumerate() {
            from_original[old] = new;
        }
        debug_assert!(!from_original.contains(&usize::MAX));
        Self {
            to_original,
            from_original,
            trailing,
        }
    }

    /// Number of dofs n.
    pub fn order(&self) -> usize {
        self.to_original.len()
    }

    /// Number of trailing dofs; 0 when none were asked for.
    pub fn trailing(&self) -> usize {
        self.trailing
    }

    /// Original number of the dof at each position of the new order.
    pub fn to_original(&self) -> &[usize] {
        &self.to_original
    }

    /// Position in the new order of each original dof.
    pub fn from_original(&self) -> &[usize] {
        &self.from_original
    }
}
