//! Supports and loads: what holds and what pushes.

use toml::Spanned;

use super::body::Body;
use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::fields::{Field, Kind, VectorField};
use super::keys::{BodyForceKeys, GravityKeys, PressureKeys, SupportKeys, TractionKeys};
use super::source::Span;
use super::surface::{Surface, Wanted};
use crate::expression::VARIABLES;
use tresca_io::names::{listed, nearest};

/// Surfaces with zero displacement.
#[derive(Clone, Debug)]
pub struct Clamp {
    /// The surfaces; at least one, none twice.
    pub on: Vec<Surface>,
}

/// Prescribed components of the displacement.
#[derive(Clone, Debug)]
pub struct Support {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// The surfaces; at least one, none twice.
    pub on: Vec<Surface>,
    /// Displacement along x, y, z (length), finite; `None` where the surfaces may move. At least one
    /// is given; in a plane case the last never is.
    pub displacement: [Option<f64>; 3],
    /// The whole table.
    pub span: Span,
}

/// A force per area.
#[derive(Clone, Debug)]
pub struct Traction {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// The surfaces; at least one, none twice.
    pub on: Vec<Surface>,
    /// The traction vector (force per undeformed area).
    pub value: VectorField,
    /// The whole table.
    pub span: Span,
}

/// A force per area along the normal.
#[derive(Clone, Debug)]
pub struct Pressure {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// The surfaces; at least one, none twice.
    pub on: Vec<Surface>,
    /// The pressure (force per undeformed area), positive when it presses on the body.
    pub value: Spanned<Field>,
    /// The whole table.
    pub span: Span,
}

/// A force per volume.
#[derive(Clone, Debug)]
pub struct BodyForce {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// Indices into [`CaseFile::bodies`](super::CaseFile::bodies), ascending; at least one.
    pub bodies: Vec<usize>,
    /// The force per undeformed volume, finite.
    pub value: [f64; 3],
    /// The whole table.
    pub span: Span,
}

/// An acceleration that acts on masses.
#[derive(Clone, Debug)]
pub struct Gravity {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// Indices into [`CaseFile::bodies`](super::CaseFile::bodies), ascending; at least one. All of them
    /// have a density.
    pub bodies: Vec<usize>,
    /// The acceleration, finite: the force per volume is density × acceleration.
    pub value: [f64; 3],
    /// The whole table.
    pub span: Span,
}

impl Check<'_> {
    pub(super) fn support(
        &self,
        keys: Spanned<SupportKeys>,
        bodies: &[Body],
    ) -> Result<Support, CaseError> {
        let span = keys.span();
        let keys = keys.into_inner();
        let on = self.surfaces(&keys.on, bodies, Wanted::Nodes)?;
        let displacement = self.displacement([keys.x, keys.y, keys.z])?;
        if displacement == [None; 3] {
            return Err(self
                .fault(
                    FaultKind::MissingKey,
                    span,
                    "the support holds nothing",
                    "expected at least one of the keys `x`, `y` and `z`",
                )
                .with_help("`x = 0` holds the component along x; a [[clamp]] holds all of them")
                .into());
        }
        Ok(Support {
            name: self.item_name(keys.name)?,
            on,
            displacement,
            span,
        })
    }

    /// Refuses surfaces of which a component is prescribed twice. Surfaces that share nodes without
    /// being the same are for the caller to compare.
    pub(super) fn held_once(
        &self,
        clamps: &[Clamp],
        supports: &[Support],
    ) -> Result<(), CaseError> {
        let clamped = clamps.iter().flat_map(|clamp| &clamp.on);
        let clamped = clamped.map(|surface| (surface, [Some(0.0); 3]));
        let supported = supports
            .iter()
            .flat_map(|support| support.on.iter().map(|on| (on, support.displacement)));
        // A surface in two clamps is as fixed as in one.
        let mut known: Vec<(&Surface, [Option<f64>; 3])> = clamped.collect();
        for (surface, held) in supported {
            for (other, others) in known.iter().filter(|(other, _)| other.is_same(surface)) {
                let axis = (0..3).find(|&axis| held[axis].is_some() && others[axis].is_some());
                let Some(axis) = axis else { continue };
                let name = self.source.slice(surface.span.clone());
                let letter = VARIABLES[axis];
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        surface.span.clone(),
                        format!("the displacement of {name} along {letter} is prescribed twice"),
                        "the second time",
                    )
                    .and_at(other.span.clone(), "the first time")
                    .with_help(
                        "a surface may stand in several [[support]] tables with different \
                         components; a [[clamp]] holds all of them",
                    )
                    .into());
            }
            known.push((surface, held));
        }
        Ok(())
    }

    /// Components of a displacement, with no component that the case does not have.
    pub(super) fn displacement(
        &self,
        keys: [Option<Spanned<f64>>; 3],
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
                    .with_help("remove the key `z`")
                    .into());
            }
            displacement[axis] = Some(self.finite("the prescribed displacement", &value)?);
        }
        Ok(displacement)
    }

    pub(super) fn traction(
        &self,
        keys: Spanned<TractionKeys>,
        bodies: &[Body],
    ) -> Result<Traction, CaseError> {
        let span = keys.span();
        let keys = keys.into_inner();
        let value = self.vector_field("the traction", &keys.value)?;
        Ok(Traction {
            name: self.item_name(keys.name)?,
            on: self.surfaces(&keys.on, bodies, Wanted::Faces)?,
            value,
            span,
        })
    }

    pub(super) fn pressure(
        &self,
        keys: Spanned<PressureKeys>,
        bodies: &[Body],
    ) -> Result<Pressure, CaseError> {
        let span = keys.span();
        let keys = keys.into_inner();
        Ok(Pressure {
            name: self.item_name(keys.name)?,
            on: self.surfaces(&keys.on, bodies, Wanted::Faces)?,
            value: self.field("the pressure", Kind::Signed, &keys.value, "")?,
            span,
        })
    }

    pub(super) fn body_force(
        &self,
        keys: Spanned<BodyForceKeys>,
        bodies: &[Body],
    ) -> Result<BodyForce, CaseError> {
        let span = keys.span();
        let keys = keys.into_inner();
        Ok(BodyForce {
            name: self.item_name(keys.name)?,
            bodies: self.body_list(keys.bodies.as_ref(), bodies)?,
            value: self.vector("the body force", &keys.value)?,
            span,
        })
    }

    pub(super) fn gravity(
        &self,
        keys: Spanned<GravityKeys>,
        bodies: &[Body],
    ) -> Result<Gravity, CaseError> {
        let span = keys.span();
        let keys = keys.into_inner();
        let gravity = Gravity {
            name: self.item_name(keys.name)?,
            bodies: self.body_list(keys.bodies.as_ref(), bodies)?,
            value: self.vector("the acceleration", &keys.value)?,
            span,
        };
        for body in gravity.bodies.iter().map(|&body| &bodies[body]) {
            if body.material.get_ref().density.is_none() {
                let name = body.name.get_ref();
                return Err(self
                    .fault(
                        FaultKind::MissingKey,
                        body.material.span(),
                        format!("gravity acts on `{name}`, which has no density"),
                        "expected `density` in this table",
                    )
                    .and_at(gravity.span, "the gravity")
                    .with_help(format!(
                        "give `{name}` a `density` (0 for no weight), or list the heavy bodies: \
                         `bodies = [\"…\"]` in [[gravity]]"
                    ))
                    .into());
            }
        }
        Ok(gravity)
    }

    /// Bodies by name; all of them without a list.
    pub(super) fn body_list(
        &self,
        list: Option<&Spanned<Vec<Spanned<String>>>>,
        bodies: &[Body],
    ) -> Result<Vec<usize>, CaseError> {
        let Some(list) = list else {
            return Ok((0..bodies.len()).collect());
        };
        if list.get_ref().is_empty() {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    list.span(),
                    "the list of bodies is empty",
                    "expected at least one name",
                )
                .with_help("without `bodies` all of them are meant")
                .into());
        }
        let names: Vec<&str> = bodies.iter().map(|b| b.name.get_ref().as_str()).collect();
        let mut indices: Vec<usize> = Vec::new();
        for name in list.get_ref() {
            let wanted = name.get_ref().as_str();
            let Some(body) = names.iter().position(|&name| name == wanted) else {
                return Err(self
                    .fault(
                        FaultKind::BadReference,
                        name.span(),
                        format!("there is no body `{wanted}`"),
                        match nearest(wanted, names.iter().copied()) {
                            Some(near) => format!("did you mean `{near}`?"),
                            None => "expected the name of a body of this file".to_owned(),
                        },
                    )
                    .with_help(format!("the bodies of this case are {}", listed(&names)))
                    .into());
            };
            if indices.contains(&body) {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        name.span(),
                        "this body is listed twice",
                        "the second time",
                    )
                    .with_help("remove one of the two, or correct it")
                    .into());
            }
            indices.push(body);
        }
        indices.sort_unstable();
        Ok(indices)
    }
}
