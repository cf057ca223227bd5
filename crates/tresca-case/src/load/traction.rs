//! Forces per area.

use serde::Deserialize;
use tresca_model::{Load, PlaceNames, Traction};
use tresca_io::located::Span;

use super::table::LoadTable;
use crate::error::CaseError;
use crate::field::FieldKeys;
use crate::place::SurfaceList;
use crate::reader::Reader;
use crate::text::at::At;

/// `[[traction]]`: a force per area on surfaces.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[traction]]")]
pub(crate) struct TractionKeys {
    /// How load steps call it.
    pub name: Option<At<String>>,
    /// The surfaces.
    pub on: SurfaceList,
    /// The traction vector (force per area), in the directions of the axes.
    pub value: At<Vec<At<FieldKeys>>>,
}

impl LoadTable for TractionKeys {
    fn load(&self, _: &Span, reader: &Reader<'_>) -> Result<Load<PlaceNames>, CaseError> {
        let value = reader.vector_field("the traction", &self.value)?;
        Ok(Traction::new(value).on(reader.loaded(&self.on)?))
    }

    fn name(&self) -> Option<At<String>> {
        self.name.clone()
    }
}
