//! Weight.

use serde::Deserialize;
use tresca_model::{Gravity, Load, PlaceNames};
use tresca_io::located::Span;

use super::table::LoadTable;
use crate::error::{CaseError, FaultKind};
use crate::reader::Reader;
use crate::text::at::At;

/// `[[gravity]]`: an acceleration that acts on masses.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[gravity]]")]
pub(crate) struct GravityKeys {
    /// How load steps call it.
    pub name: Option<At<String>>,
    /// Names of the bodies. Default: all.
    pub bodies: Option<At<Vec<At<String>>>>,
    /// The acceleration, in the directions of the axes.
    pub value: At<Vec<At<f64>>>,
}

impl LoadTable for GravityKeys {
    fn load(&self, span: &Span, reader: &Reader<'_>) -> Result<Load<PlaceNames>, CaseError> {
        let on = reader.body_list(self.bodies.as_ref())?;
        let value = reader.vector("the acceleration", &self.value)?;
        for (body, origin) in reader.model.bodies().iter().zip(&reader.origins.bodies) {
            let name = body.name.as_str();
            if body.density.is_none() && on.0.iter().any(|on| on.owner == name) {
                return Err(reader
                    .fault(
                        FaultKind::MissingKey,
                        origin.material.clone(),
                        format!("gravity acts on `{name}`, which has no density"),
                        "expected `density` in this table",
                    )
                    .and_at(span.clone(), "the gravity")
                    .with_help(format!(
                        "give `{name}` a `density` (0 for no weight), or list the heavy bodies: \
                         `bodies = [\"…\"]` in [[gravity]]"
                    ))
                    );
            }
        }
        Ok(Gravity::new(value).on(on))
    }

    fn name(&self) -> Option<At<String>> {
        self.name.clone()
    }
}
