//! The founding benchmark: two bricks with Tresca friction.
//!
//! Source: the two-brick experiment of *Symmetrized semi-smooth Newton method for solving 3D
//! contact problems* (the Kučera school, Ostrava), restated in `docs/theory.md`. The element type
//! is not in the paper; hex8 with s × s × s nodes per brick gives its numbers of dofs, 6s³.

use tresca::material::Isotropic;
use tresca::mesh::{BrickSpec, brick};
use tresca::model::{Body, Contact, Support, Traction};
use tresca::{FrictionLaw, Model, ModelError};

/// The units in which the benchmark is stated. The answer must not depend on them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// Length unit per metre: 1 for m, 1000 for mm.
    pub length: f64,
    /// Stress unit per megapascal: 1 for MPa (N/mm² or MN/m²), 1e6 for Pa.
    pub stress: f64,
}

impl Units {
    /// m, MN, MPa, as in the paper.
    pub const METRE_MEGAPASCAL: Self = Self {
        length: 1.0,
        stress: 1.0,
    };
    /// mm, N, MPa.
    pub const MILLIMETRE_MEGAPASCAL: Self = Self {
        length: 1e3,
        stress: 1.0,
    };
    /// m, N, Pa.
    pub const SI: Self = Self {
        length: 1.0,
        stress: 1e6,
    };
}

/// Two bricks of s × s × s nodes: 6s³ dofs, s² contact pairs.
///
/// Upper brick (0,2)×(0,1)×(1,2), E = 50 000 MPa, ν = 0.277, clamped on x = 2; lower brick
/// (0,2)×(0,1)×(0,1), E = 50 000 MPa, ν = 0.35, clamped on x = 0. Traction (0, 0, −1) MPa on the top face
/// and the face x = 0 of the upper brick; slip bound 0.09 MPa on z = 1.
///
/// # Errors
/// When s < 2.
pub fn two_bricks(s: usize, units: Units) -> Result<Model, ModelError> {
    two_bricks_with(s, units, FrictionLaw::tresca(0.09 * units.stress))
}

/// The same bricks with another law of friction.
///
/// # Errors
/// When s < 2, or the law has impossible figures.
pub fn two_bricks_with(s: usize, units: Units, friction: FrictionLaw) -> Result<Model, ModelError> {
    let mut model = Model::new(format!(
        "Two bricks with {} friction, s = {s}",
        friction.name()
    ));
    for (name, low, poisson) in [("upper", 1.0, 0.277), ("lower", 0.0, 0.35)] {
        let in_body = |source| ModelError::Body {
            body: name.to_owned(),
            source,
        };
        let spec = BrickSpec {
            min: [0.0, 0.0, low * units.length],
            max: [2.0 * units.length, units.length, (low + 1.0) * units.length],
            nodes: [s; 3],
        };
        let mesh = brick(&spec).map_err(in_body)?;
        let material = Isotropic::new(5.0e4 * units.stress, poisson).map_err(in_body)?;
        model.add_body(Body::new(name, mesh, material))?;
    }
    model.add_support(Support::clamp("upper.x+"))?;
    model.add_support(Support::clamp("lower.x-"))?;
    let pressed = Traction::new([0.0, 0.0, -units.stress]);
    model.add_load(pressed.on(["upper.z+", "upper.x-"]))?;
    model.add_contact(Contact::new("upper.z-", "lower.z+", friction))?;
    Ok(model)
}
