//! Every key of a case file, as it stands in the text. `docs/case-file.md` says the same for readers
//! of the documentation; a test compares the two.
//!
//! Values that a check may want to point at are [`Spanned`]. Whole numbers are accepted where
//! numbers are expected. No unit is fixed: any consistent system will do (mm, N, MPa; m, N, Pa).

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::de::DeserializeOwned;
use toml::Spanned;
use tresca_fem::assembly::Formulation;

use super::entries::{FieldKeys, Triple, ValueKeys};

mod mesh;
mod obstacle;

pub use mesh::{Brick, BrickCells, PlaneCells, Rectangle};
pub(super) use mesh::{MeshKeys, RotateKeys};
pub(super) use obstacle::{
    CircleKeys, CylinderKeys, ObstacleKeys, PlaneKeys, SphereKeys, SurfaceKeys,
};

/// The whole file.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    bound = "S: DeserializeOwned + Default",
    expecting = "a case file"
)]
pub(super) struct CaseKeys<S> {
    /// Headline of reports. Default: the name of the file.
    pub title: Option<String>,
    /// What the coordinates mean. Default: `solid`.
    pub analysis: Option<Spanned<Analysis>>,
    /// The elastic bodies; at least one.
    pub body: Option<Spanned<Vec<BodyKeys>>>,
    /// Surfaces that are held.
    #[serde(default)]
    pub clamp: Vec<ClampKeys>,
    /// Surfaces of which some displacement components are prescribed.
    #[serde(default)]
    pub support: Vec<Spanned<SupportKeys>>,
    /// Surfaces that are loaded by a vector.
    #[serde(default)]
    pub traction: Vec<Spanned<TractionKeys>>,
    /// Surfaces that are pressed.
    #[serde(default)]
    pub pressure: Vec<Spanned<PressureKeys>>,
    /// Forces per volume.
    #[serde(default)]
    pub body_force: Vec<Spanned<BodyForceKeys>>,
    /// Accelerations of the field of gravity.
    #[serde(default)]
    pub gravity: Vec<Spanned<GravityKeys>>,
    /// Rigid bodies that the others may touch.
    #[serde(default)]
    pub obstacle: Vec<Spanned<ObstacleKeys>>,
    /// Pairs of surfaces that may touch.
    #[serde(default)]
    pub contact: Vec<Spanned<ContactKeys>>,
    /// The history of loading.
    #[serde(default)]
    pub step: Vec<Spanned<StepKeys>>,
    /// Settings of the solver; the keys are those of the caller's type.
    #[serde(default)]
    pub solver: S,
}

/// `analysis`: what the coordinates of a case mean, and how many there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case", expecting = "the name of an analysis")]
pub enum Analysis {
    /// Bodies in space.
    #[default]
    Solid,
    /// Slices of long bodies, of unit thickness; no strain across the plane.
    PlaneStrain,
    /// Thin sheets, of unit thickness; no stress across the plane.
    PlaneStress,
    /// Bodies of revolution: x is the radius, y the axis; forces are those of the whole circumference.
    Axisymmetric,
}

impl Analysis {
    /// Number of coordinates: 3 in space, otherwise 2.
    pub fn dimension(self) -> usize {
        match self {
            Analysis::Solid => 3,
            Analysis::PlaneStrain | Analysis::PlaneStress | Analysis::Axisymmetric => 2,
        }
    }

    /// The word that stands for it in a case file.
    pub fn word(self) -> &'static str {
        match self {
            Analysis::Solid => "solid",
            Analysis::PlaneStrain => "plane_strain",
            Analysis::PlaneStress => "plane_stress",
            Analysis::Axisymmetric => "axisymmetric",
        }
    }
}

/// `[[body]]`: an elastic body.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[body]]")]
pub(super) struct BodyKeys {
    /// How other keys and the written files call the body: letters, digits, `_` and `-`.
    pub name: Spanned<String>,
    /// Where the mesh comes from.
    pub mesh: Spanned<MeshKeys>,
    /// Where the points of that mesh go.
    pub map: Option<Spanned<Vec<Spanned<FieldKeys>>>>,
    /// What the body is made of.
    pub material: Spanned<Material>,
    /// How its stiffness is integrated. Default: `full`.
    pub formulation: Option<Spanned<FormulationWord>>,
}

/// `formulation`: how strains are made of displacements.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case", expecting = "the name of a formulation")]
pub(super) enum FormulationWord {
    /// The strain as it is.
    Full,
    /// The volumetric strain as its mean over the cell.
    BBar,
}

impl From<FormulationWord> for Formulation {
    fn from(word: FormulationWord) -> Self {
        match word {
            FormulationWord::Full => Formulation::Full,
            FormulationWord::BBar => Formulation::BBar,
        }
    }
}

/// `material`: isotropic linear elasticity.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ young = …, poisson = … }`"
)]
pub struct Material {
    /// Young's modulus (force per area), positive.
    pub young: Spanned<f64>,
    /// Poisson's ratio, above -1 and below 0.5.
    pub poisson: Spanned<f64>,
    /// Mass per volume, 0 or more; needed where gravity acts.
    pub density: Option<Spanned<f64>>,
}

/// `on`: surfaces, each `body.face`.
pub(super) type SurfaceList = Spanned<Vec<Spanned<String>>>;

/// `[[clamp]]`: surfaces whose displacement is zero.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[clamp]]")]
pub(super) struct ClampKeys {
    /// The surfaces.
    pub on: SurfaceList,
}

/// `[[support]]`: prescribed components of the displacement.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[support]]")]
pub(super) struct SupportKeys {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// The surfaces.
    pub on: SurfaceList,
    /// Displacement along x (length).
    pub x: Option<Spanned<f64>>,
    /// Displacement along y (length).
    pub y: Option<Spanned<f64>>,
    /// Displacement along z (length).
    pub z: Option<Spanned<f64>>,
}

/// `[[traction]]`: a force per area on surfaces.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[traction]]")]
pub(super) struct TractionKeys {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// The surfaces.
    pub on: SurfaceList,
    /// The traction vector (force per area), in the directions of the axes.
    pub value: Spanned<Vec<Spanned<FieldKeys>>>,
}

/// `[[pressure]]`: a force per area along the inward normal.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[pressure]]")]
pub(super) struct PressureKeys {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// The surfaces.
    pub on: SurfaceList,
    /// The pressure (force per area), positive when it presses on the body.
    pub value: Spanned<FieldKeys>,
}

/// `[[body_force]]`: a force per volume.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table of keys under [[body_force]]"
)]
pub(super) struct BodyForceKeys {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// Names of the bodies. Default: all.
    pub bodies: Option<Spanned<Vec<Spanned<String>>>>,
    /// The force per volume, in the directions of the axes.
    pub value: Spanned<Vec<Spanned<f64>>>,
}

/// `[[gravity]]`: an acceleration that acts on masses.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[gravity]]")]
pub(super) struct GravityKeys {
    /// How load steps call it.
    pub name: Option<Spanned<String>>,
    /// Names of the bodies. Default: all.
    pub bodies: Option<Spanned<Vec<Spanned<String>>>>,
    /// The acceleration, in the directions of the axes.
    pub value: Spanned<Vec<Spanned<f64>>>,
}

/// `[[contact]]`: two surfaces that may touch.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[contact]]")]
pub(super) struct ContactKeys {
    /// How load steps and reports call it.
    pub name: Option<Spanned<String>>,
    /// Slave and master surface, each `body.face`; the second may be the name of an obstacle.
    pub pair: Option<Spanned<Vec<Spanned<String>>>>,
    /// In the place of `pair`: the distance (length) at which outer surfaces become pairs.
    pub within: Option<Spanned<f64>>,
    /// Names of the bodies that `within` looks at. Default: all.
    pub bodies: Option<Spanned<Vec<Spanned<String>>>>,
    /// How the two surfaces are coupled. Default: `auto`.
    #[serde(default)]
    pub coupling: Coupling,
    /// Largest distance at which points of the surfaces are coupled (length). Default: by the size of
    /// the faces.
    pub search: Option<Spanned<f64>>,
    /// What resists sliding.
    pub friction: Spanned<FrictionKeys>,
    /// Length that is added to the distance of the surfaces. Default: 0.
    pub gap: Option<Spanned<FieldKeys>>,
}

/// `coupling`: how two surfaces are coupled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case", expecting = "the name of a coupling")]
pub enum Coupling {
    /// Node by node where the nodes of two surfaces of linear faces lie on one another, otherwise mortar.
    #[default]
    Auto,
    /// Each node with the one opposite.
    NodeByNode,
    /// By integrals over the common surface.
    Mortar,
}

/// `friction`: the law and its figures. All figures of all laws stand here; which of them a law
/// takes is checked afterwards, so that the report can name the law.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ law = \"tresca\", bound = … }`"
)]
pub(super) struct FrictionKeys {
    /// The law, one of [`super::friction::LAWS`].
    pub law: Spanned<String>,
    /// Slip bound (force per area), 0 or more: the tangential traction at which the pair slides.
    pub bound: Option<Spanned<FieldKeys>>,
    /// Slip bounds along the two axes (force per area).
    pub bounds: Option<Spanned<Vec<Spanned<FieldKeys>>>>,
    /// Coefficient of friction, 0 or more.
    pub coefficient: Option<Spanned<f64>>,
    /// Coefficients of friction along the two axes.
    pub coefficients: Option<Spanned<Vec<Spanned<f64>>>>,
    /// The first axis of friction, in the directions of the axes of space.
    pub axis: Option<Spanned<Triple<f64>>>,
    /// Largest slip bound (force per area), whatever the normal force.
    pub limit: Option<Spanned<FieldKeys>>,
}

/// `[[step]]`: a step of the history of loading.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[step]]")]
pub(super) struct StepKeys {
    /// What reports call it.
    pub name: Option<Spanned<String>>,
    /// The instant of its end. Default: one more than that of the step before.
    pub time: Option<Spanned<f64>>,
    /// Number of parts that the change is cut into. Default: 1.
    pub increments: Option<Spanned<usize>>,
    /// By name of a support, load, obstacle or contact: what its own value is multiplied by.
    #[serde(default)]
    pub factors: BTreeMap<Spanned<String>, Spanned<f64>>,
    /// By name of a support, load, obstacle or contact: what takes the place of its own value.
    #[serde(default)]
    pub values: BTreeMap<Spanned<String>, Spanned<ValueKeys>>,
}
