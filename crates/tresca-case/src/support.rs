//! Supports and clamps.

use serde::Deserialize;
use tresca_model::{PlaceName, PlaceNames, Support};

use crate::error::{CaseError, FaultKind};
use crate::expression::names::VARIABLES;
use crate::place::{SurfaceList, Wanted};
use crate::reader::Reader;
use crate::text::at::At;

/// `[[clamp]]`: surfaces whose displacement is zero.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[clamp]]")]
pub(crate) struct ClampKeys {
    /// The surfaces.
    pub on: SurfaceList,
}

/// `[[support]]`: prescribed components of the displacement.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[support]]")]
pub(crate) struct SupportKeys {
    /// How load steps call it.
    pub name: Option<At<String>>,
    /// The surfaces.
    pub on: SurfaceList,
    /// Displacement along x (length).
    pub x: Option<At<f64>>,
    /// Displacement along y (length).
    pub y: Option<At<f64>>,
    /// Displacement along z (length).
    pub z: Option<At<f64>>,
}

/// A place and the components that are prescribed there.
type Held = (At<PlaceName>, [Option<f64>; 3]);

impl Reader<'_> {
    pub(crate) fn supports(
        &mut self,
        clamps: Vec<ClampKeys>,
        supports: Vec<At<SupportKeys>>,
    ) -> Result<(), CaseError> {
        let mut held: Vec<Held> = Vec::new();
        for clamp in clamps {
            for place in self.surfaces(&clamp.on, Wanted::Nodes)? {
                let span = place.span();
                let added = self.model.add_support(Support::clamp(place.value.clone()));
                let id = added.map_err(|error| self.refused(&span, error))?;
                self.origins.note(&span, None, vec![id.into()]);
                // A surface in two clamps is as fixed as in one.
                held.push((place, [Some(0.0); 3]));
            }
        }
        supports
            .into_iter()
            .try_for_each(|keys| self.support(keys, &mut held))
    }

    fn support(&mut self, keys: At<SupportKeys>, held: &mut Vec<Held>) -> Result<(), CaseError> {
        let span = keys.span();
        let keys = keys.value;
        let on = self.surfaces(&keys.on, Wanted::Nodes)?;
        let components = self.displacement([keys.x, keys.y, keys.z])?;
        if components == [None; 3] {
            return Err(self
                .fault(
                    FaultKind::MissingKey,
                    span,
                    "the support holds nothing",
                    "expected at least one of the keys `x`, `y` and `z`",
                )
                .with_help("`x = 0` holds the component along x; a [[clamp]] holds all of them"));
        }
        let name = self.checked_name(keys.name)?;
        self.held_once(&on, components, held)?;
        let places: PlaceNames = on.iter().map(|place| place.value.clone()).collect();
        let mut support = Support::new(places, components);
        support.name = name.as_ref().map(|name| name.value.clone());
        let added = self.model.add_support(support);
        let id = added.map_err(|error| self.refused(&span, error))?;
        self.origins.note(&span, name, vec![id.into()]);
        held.extend(on.into_iter().map(|place| (place, components)));
        Ok(())
    }

    /// Refuses places of which a component is prescribed twice. Places that share nodes without
    /// being the same are compared when the model is assembled.
    fn held_once(
        &self,
        on: &[At<PlaceName>],
        components: [Option<f64>; 3],
        held: &[Held],
    ) -> Result<(), CaseError> {
        for place in on {
            for (other, others) in held.iter().filter(|(other, _)| other == place) {
                let axis = (0..3).find(|&k| components[k].is_some() && others[k].is_some());
                let Some(axis) = axis else { continue };
                let name = self.source.slice(place.span());
                let letter = VARIABLES[axis];
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        place.span(),
                        format!("the displacement of {name} along {letter} is prescribed twice"),
                        "the second time",
                    )
                    .and_at(other.span(), "the first time")
                    .with_help(
                        "a surface may stand in several [[support]] tables with different \
                         components; a [[clamp]] holds all of them",
                    ));
            }
        }
        Ok(())
    }

    /// Components of a displacement, with no component that the case does not have.
    pub(crate) fn displacement(
        &self,
        keys: [Option<At<f64>>; 3],
    ) -> Result<[Option<f64>; 3], CaseError> {
        let mut displacement = [None; 3];
        for (axis, value) in keys.into_iter().enumerate() {
            let Some(value) = value else { continue };
            if axis >= self.analysis.dimension() {
                return Err(self
                    .fault(
                        FaultKind::UnknownKey,
                        value.span(),
                        format!(
                            "there is no z with `analysis = \"{}\"`",
                            self.analysis.word()
                        ),
                        "expected `x` and `y` only",
                    )
                    .with_help("remove the key `z`"));
            }
            displacement[axis] = Some(self.finite("the prescribed displacement", &value)?);
        }
        Ok(displacement)
    }
}
