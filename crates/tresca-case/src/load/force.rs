//! Total forces.

use serde::Deserialize;
use tresca_model::{Force, Load, PlaceNames};
use tresca_io::located::Span;

use super::table::LoadTable;
use crate::error::CaseError;
use crate::place::SurfaceList;
use crate::reader::Reader;
use crate::text::at::At;

/// `[[force]]`: a total force, spread evenly over surfaces.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[force]]")]
pub(crate) struct ForceKeys {
    /// How load steps call it.
    pub name: Option<At<String>>,
    /// The surfaces.
    pub on: SurfaceList,
    /// The force on all of them together, in the directions of the axes.
    pub value: At<Vec<At<f64>>>,
}

impl LoadTable for ForceKeys {
    fn load(&self, _: &Span, reader: &Reader<'_>) -> Result<Load<PlaceNames>, CaseError> {
        let value = reader.vector("the force", &self.value)?;
        Ok(Force::new(value).on(reader.loaded(&self.on)?))
    }

    fn name(&self) -> Option<At<String>> {
        self.name.clone()
    }
}
