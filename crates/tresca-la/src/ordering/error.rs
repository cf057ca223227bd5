//! Why a matrix cannot be ordered.

use thiserror::Error;

/// Why no ordering was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum OrderingError {
    /// A trailing dof does not exist.
    #[error("trailing dof {dof} is out of range: the matrix has order {order}")]
    TrailingOutOfRange {
        /// The dof as given.
        dof: usize,
        /// Order of the matrix.
        order: usize,
    },
    /// A trailing dof is listed twice.
    #[error("trailing dof {dof} is listed twice")]
    TrailingRepeated {
        /// The dof as given.
        dof: usize,
    },
    /// METIS counts vertices and edges in 32 bits.
    #[error(
        "the matrix graph is too large for METIS ({entries} adjacency entries, at most {})",
        i32::MAX
    )]
    TooLarge {
        /// Adjacency entries (two per edge) of the compressed graph.
        entries: usize,
    },
    /// METIS found no memory.
    #[error("METIS ran out of memory while ordering {vertices} vertices")]
    OutOfMemory {
        /// Vertices of the compressed graph.
        vertices: usize,
    },
    /// METIS refused; not expected for any input.
    #[error("METIS failed with status {status}")]
    Metis {
        /// Return code of `METIS_NodeND`.
        status: i32,
    },
}
