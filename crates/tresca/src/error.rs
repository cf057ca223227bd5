//! What can be wrong with a model. Outcomes of a solve are never errors: see
//! [`tresca_qcqp::Status`].

use tresca_contact::ContactError;

/// Why a model could not be built or solved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// Two bodies or obstacles with one name.
    #[error("there is already a body or an obstacle called `{name}`")]
    DuplicateBody {
        /// The name.
        name: String,
    },
    /// A body that does not exist.
    #[error("there is no body called `{name}`; the bodies are {}", list(known))]
    UnknownBody {
        /// The name that was given.
        name: String,
        /// The names that exist.
        known: Vec<String>,
    },
    /// An obstacle that does not exist.
    #[error(
        "there is no obstacle called `{name}`; the obstacles are {}",
        list(known)
    )]
    UnknownObstacle {
        /// The name that was given.
        name: String,
        /// The names that exist.
        known: Vec<String>,
    },
    /// Automatic pairing found nothing.
    #[error("no two bodies have surfaces that face one another within a distance of {distance}")]
    NothingWithin {
        /// The distance.
        distance: f64,
    },
    /// A surface that does not exist.
    #[error(
        "body `{body}` has no surface `{faces}`; its surfaces are {}",
        list(known)
    )]
    UnknownSurface {
        /// The body.
        body: String,
        /// The surface that was given.
        faces: String,
        /// The surfaces of that body.
        known: Vec<String>,
    },
    /// Bodies of different spaces in one model.
    #[error(
        "the bodies `{first}` and `{second}` live in different spaces (solid, plane, axisymmetric)"
    )]
    MixedSpaces {
        /// A body of the one.
        first: String,
        /// A body of the other.
        second: String,
    },
    /// A load or a displacement with NaN or infinity.
    #[error("a load or a prescribed displacement must be finite, found {value:?}")]
    NonFiniteValue {
        /// What was given.
        value: [f64; 3],
    },
    /// A load field that gives NaN or infinity.
    #[error("load {load} is not finite on body `{body}`: its expression gives no number somewhere")]
    NonFiniteLoad {
        /// Index of the load, from 0.
        load: usize,
        /// The body.
        body: String,
    },
    /// A pressure given by values at the nodes of a contact surface.
    #[error("a pressure is a constant or a function of the position")]
    PressureByValues,
    /// A z component in two dimensions.
    #[error("a plane model has no z component")]
    OutOfPlane,
    /// Two friction axes in two dimensions.
    #[error("orthotropic friction needs two tangents; a plane contact has one")]
    OrthotropicInThePlane,
    /// A density that is none.
    #[error("the density of body `{body}` must be a number ≥ 0, found {density}")]
    Density {
        /// The body.
        body: String,
        /// What was given.
        density: f64,
    },
    /// Weight of a body without density.
    #[error("gravity acts on body `{body}`, which has no density")]
    NoDensity {
        /// The body.
        body: String,
    },
    /// A load step that does not fit the model.
    #[error("load step {number}: {reason}")]
    Step {
        /// Number of the step, from 1.
        number: usize,
        /// What does not fit.
        reason: String,
    },
    /// Both sides of a contact on one body.
    #[error("both sides of a contact lie on body `{body}`; self-contact is not supported")]
    SelfContact {
        /// The body.
        body: String,
    },
    /// A model without bodies.
    #[error("the model has no bodies")]
    NoBodies,
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
    /// Data of a contact alone.
    #[error(transparent)]
    Contact(#[from] ContactError),
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
}

fn list(names: &[String]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}
