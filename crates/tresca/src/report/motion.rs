//! A motion that nothing resists, in words.

use serde::Serialize;

use crate::unresisted::UnresistedMotion;

/// A motion that nothing resists.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct MotionReport {
    /// What moves, and how.
    pub bodies: Vec<BodyMotion>,
    /// Contacts that open or slide in it.
    pub contacts: Vec<ContactMotion>,
}

/// A body in such a motion.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct BodyMotion {
    /// The body.
    pub body: String,
    /// Translation or rotation, in words.
    pub motion: String,
}

/// A contact in such a motion.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct ContactMotion {
    /// Slave and master surface.
    pub contact: String,
    /// `opens` or `slides`.
    pub does: &'static str,
}

impl From<&UnresistedMotion> for MotionReport {
    fn from(motion: &UnresistedMotion) -> Self {
        let bodies = motion.bodies.iter().cloned();
        let contacts = motion.contacts.iter().cloned();
        Self {
            bodies: bodies
                .map(|(body, motion)| BodyMotion { body, motion })
                .collect(),
            contacts: contacts
                .map(|(contact, does)| ContactMotion { contact, does })
                .collect(),
        }
    }
}
