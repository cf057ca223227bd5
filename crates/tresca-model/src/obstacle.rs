//! Rigid obstacles.

use crate::amount::Amount;

/// A rigid partner of bodies.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Obstacle {
    /// Name, unique among bodies and obstacles.
    pub name: String,
    /// Where its surface is.
    pub shape: tresca_contact::RigidShape,
    /// Its displacement (a length), `None` where it stays; load steps scale or replace it. Small, as all displacements
    /// are: the surface is looked at where it was.
    pub motion: Option<[f64; 3]>,
}

impl Obstacle {
    /// An obstacle that stays.
    pub fn new(name: impl Into<String>, shape: tresca_contact::RigidShape) -> Self {
        Self {
            name: name.into(),
            shape,
            motion: None,
        }
    }

    /// With a displacement (a length).
    #[must_use]
    pub fn motion(mut self, motion: [f64; 3]) -> Self {
        self.motion = Some(motion);
        self
    }

    /// Its displacement in a step.
    pub fn motion_by(&self, amount: Amount) -> [f64; 3] {
        amount.of_vector(self.motion.unwrap_or_default())
    }
}
