//! What statics say of a load.

/// What statics alone say of the load on bodies that float, where a run has ended without an answer and without
/// a proof that there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Statics {
    /// Contact forces within their bounds, and not only at them, are in equilibrium with the load: there is a
    /// solution as far as the bodies that float decide it, and the run has not found it.
    Balanced,
    /// The load is the largest one that friction can hold, to a part in a million: a little less friction, and
    /// there is no equilibrium. Where forces are in equilibrium at their bounds only, no rigid motion need
    /// belong to them, and a run need not end.
    AtTheLimit,
    /// Neither forces in equilibrium nor a proof of the contrary have been found; rounding decides.
    Undecided,
}
