//! How many threads a single operation may use.

use faer::Par;

/// Threads for one operation; the caller that runs several side by side shares
/// them out. Results differ by rounding at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Parallelism {
    /// The calling thread alone.
    #[default]
    Sequential,
    /// Up to this many threads of the current rayon pool; 0 means all of them.
    Threads(usize),
}

impl Parallelism {
    pub(crate) fn to_faer(self) -> Par {
        match self {
            Parallelism::Sequential | Parallelism::Threads(1) => Par::Seq,
            Parallelism::Threads(count) => Par::rayon(count),
        }
    }
}
