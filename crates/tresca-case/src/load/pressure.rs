//! Forces per area along the inward normal.

use serde::Deserialize;
use tresca_model::{Load, PlaceNames, Pressure};
use tresca_io::located::Span;

use super::table::LoadTable;
use crate::error::CaseError;
use crate::field::{FieldKeys, Kind};
use crate::place::SurfaceList;
use crate::reader::Reader;
use crate::text::at::At;

/// `[[pressure]]`: a force per area along the inward normal.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[pressure]]")]
pub(crate) struct PressureKeys {
    /// How load steps call it.
    pub name: Option<At<String>>,
    /// The surfaces.
    pub on: SurfaceList,
    /// The pressure (force per area), positive when it presses on the body.
    pub value: At<FieldKeys>,
}

impl LoadTable for PressureKeys {
    fn load(&self, _: &Span, reader: &Reader<'_>) -> Result<Load<PlaceNames>, CaseError> {
        let on = reader.loaded(&self.on)?;
        let value = reader.field("the pressure", Kind::Signed, &self.value, "")?;
        Ok(Pressure::new(value).on(on))
    }

    fn name(&self) -> Option<At<String>> {
        self.name.clone()
    }
}
