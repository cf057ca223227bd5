//! The one thing that Krylov methods need to know about a matrix.

/// A square linear map y = A x on slices.
///
/// `apply` must overwrite `y` completely, must not read it, and must be
/// deterministic: the same `x` gives the same `y`, bit for bit.
pub trait LinearOperator {
    /// Order n of the operator; `x` and `y` have this length.
    fn dim(&self) -> usize;
    /// y ← A x.
    fn apply(&mut self, x: &[f64], y: &mut [f64]);
}

/// A symmetric matrix whose entries can be asked for.
pub trait SymmetricEntries: Sync {
    /// The entry (i, j), i ≥ j.
    fn entry(&self, i: usize, j: usize) -> f64;
}
