//! Loads. A new kind is a file beside this one, whose keys implement [`LoadTable`](table::LoadTable), and a line in the list below.

/// Hands the list of all kinds to a macro: the name of the table, which is that of the file, and its keys.
macro_rules! kinds_of_loads {
    ($to:ident) => {
        $to! {
            /// Surfaces that are loaded by a vector.
            traction::TractionKeys,
            /// Surfaces that are pressed.
            pressure::PressureKeys,
            /// Forces per volume.
            body_force::BodyForceKeys,
            /// Accelerations of the field of gravity.
            gravity::GravityKeys,
            /// Total forces.
            force::ForceKeys,
        }
    };
}
pub(crate) use kinds_of_loads;

macro_rules! modules {
    ($($(#[$doc:meta])* $module:ident::$keys:ident,)*) => {
        $(
            mod $module;
            pub(crate) use $module::$keys;
        )*
    };
}
kinds_of_loads!(modules);

mod table;

use tresca_model::PlaceNames;

use crate::error::CaseError;
use crate::place::{SurfaceList, Wanted};
use crate::reader::Reader;
use crate::text::at::At;
use table::LoadTable;

impl Reader<'_> {
    pub(crate) fn loads<K: LoadTable>(&mut self, list: &[At<K>]) -> Result<(), CaseError> {
        for keys in list {
            let span = keys.span();
            let mut load = keys.load(&span, self)?;
            let name = self.checked_name(keys.name())?;
            load.name = name.as_ref().map(|name| name.value.clone());
            let added = self.model.add_load(load);
            let id = added.map_err(|error| self.refused(&span, error))?;
            self.origins.note(&span, name, vec![id.into()]);
        }
        Ok(())
    }

    /// The surfaces that a load acts on.
    fn loaded(&self, on: &SurfaceList) -> Result<PlaceNames, CaseError> {
        let surfaces = self.surfaces(on, Wanted::Faces)?;
        Ok(surfaces.into_iter().map(|surface| surface.value).collect())
    }
}
