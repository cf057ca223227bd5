//! What can be wrong with a model.

use tresca_contact::ContactError;

/// Why a model could not be built.
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
        "body `{body}` has no surface `{surface}`; its surfaces are {}",
        list(known)
    )]
    UnknownSurface {
        /// The body.
        body: String,
        /// The surface that was given.
        surface: String,
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
}

fn list(names: &[String]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}
