//! Forces per volume.

use serde::Deserialize;
use tresca_model::{BodyForce, Load, PlaceNames};
use tresca_io::located::Span;

use super::table::LoadTable;
use crate::error::CaseError;
use crate::reader::Reader;
use crate::text::at::At;

/// `[[body_force]]`: a force per volume.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table of keys under [[body_force]]"
)]
pub(crate) struct BodyForceKeys {
    /// How load steps call it.
    pub name: Option<At<String>>,
    /// Names of the bodies. Default: all.
    pub bodies: Option<At<Vec<At<String>>>>,
    /// The force per volume, in the directions of the axes.
    pub value: At<Vec<At<f64>>>,
}

impl LoadTable for BodyForceKeys {
    fn load(&self, _: &Span, reader: &Reader<'_>) -> Result<Load<PlaceNames>, CaseError> {
        let on = reader.body_list(self.bodies.as_ref())?;
        Ok(BodyForce::new(reader.vector("the body force", &self.value)?).on(on))
    }

    fn name(&self) -> Option<At<String>> {
        self.name.clone()
    }
}
