//! What can be wrong with a model once it is assembled. Outcomes of a solve are never errors: see
//! [`tresca_qcqp::Status`].

use tresca_contact::ContactError;
use tresca_model::ModelError;
use tresca_system::progress::Stopped;
use tresca_system::run::Unsolved;

/// Why a model could not be solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SolveError {
    /// The model itself.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A load field that gives NaN or infinity.
    #[error("load {load} is not finite on body `{body}`: its expression gives no number somewhere")]
    NonFiniteLoad {
        /// Index of the load, from 0.
        load: usize,
        /// The body.
        body: String,
    },
    /// A model without contact.
    #[error("the model has no contact: nothing to solve beyond linear elasticity")]
    NoContact,
    /// Contacts without a pair that can move.
    #[error("supports hold both nodes of every contact pair: no contact can act")]
    NoFreePairs,
    /// A body that can move rigidly, and that no contact can hold.
    #[error(
        "body `{body}` is not held: its supports leave {} rigid motion(s) free ({}), and no contact \
         touches it",
        motions.len(), motions.join(", ")
    )]
    Floating {
        /// The body.
        body: String,
        /// The free motions, in words.
        motions: Vec<String>,
    },
    /// The surfaces of a contact cannot be coupled.
    #[error("contact {slave} – {master}: {source}")]
    Coupling {
        /// Index of the contact in the model.
        contact: usize,
        /// The slave surface, as `body.faces`.
        slave: String,
        /// The master surface.
        master: String,
        /// What is wrong.
        source: ContactError,
    },
    /// Mesh, element or material trouble.
    #[error("body `{body}`: {source}")]
    Body {
        /// The body.
        body: String,
        /// What is wrong.
        source: tresca_fem::FemError,
    },
    /// The stiffness matrix of a body is not positive definite.
    #[error("body `{body}`: {source}")]
    Factorization {
        /// The body.
        body: String,
        /// What is wrong.
        source: tresca_la::FactorError,
    },
    /// No fill-reducing ordering could be made.
    #[error("body `{body}`: {source}")]
    Ordering {
        /// The body.
        body: String,
        /// Why.
        source: tresca_la::OrderingError,
    },
    /// The dual problem was refused.
    #[error(transparent)]
    Dual(#[from] tresca_qcqp::QcqpError),
    /// The caller stopped the run before its first iteration: there is no outcome.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

impl From<Unsolved> for SolveError {
    fn from(error: Unsolved) -> Self {
        match error {
            Unsolved::Stopped(stopped) => SolveError::Stopped(stopped),
            Unsolved::Refused(error) => SolveError::Dual(error),
        }
    }
}
