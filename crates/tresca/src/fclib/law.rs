//! The law that a problem is solved with.

/// The law of friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FclibLaw {
    /// As the file poses it: ‖r_T‖ ≤ μ r_N.
    Coulomb,
    /// ‖r_T‖ ≤ bound at every contact.
    Tresca {
        /// The slip bound, a force ≥ 0.
        bound: f64,
    },
}
