//! Keys of rigid obstacles.

use serde::Deserialize;
use toml::Spanned;

use super::super::entries::Triple;
use super::mesh::RotateKeys;

/// `[[obstacle]]`: a rigid body. One of the shapes is given, which is checked afterwards, so that
/// the report can say so.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[obstacle]]")]
pub(crate) struct ObstacleKeys {
    /// How contacts and load steps call it.
    pub name: Spanned<String>,
    /// A half-space; in the plane a half-plane.
    pub plane: Option<Spanned<PlaneKeys>>,
    /// A ball, or the outside of one.
    pub sphere: Option<Spanned<SphereKeys>>,
    /// An endless cylinder, or the outside of one.
    pub cylinder: Option<Spanned<CylinderKeys>>,
    /// In the plane: a disc, or the outside of one.
    pub circle: Option<Spanned<CircleKeys>>,
    /// The surface in a mesh file; in the plane a curve.
    pub surface: Option<Spanned<SurfaceKeys>>,
    /// Its displacement (length). Default: it stays.
    pub motion: Option<Spanned<Vec<Spanned<f64>>>>,
}

/// `plane`: everything behind a plane.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ point = …, normal = … }`")]
pub(crate) struct PlaneKeys {
    /// A point of the plane (length).
    pub point: Spanned<Vec<Spanned<f64>>>,
    /// Its normal, out of the solid side.
    pub normal: Spanned<Vec<Spanned<f64>>>,
}

/// `sphere`: a ball.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ center = …, radius = … }`"
)]
pub(crate) struct SphereKeys {
    /// Its centre (length).
    pub center: Spanned<Triple<f64>>,
    /// Its radius (length), positive.
    pub radius: Spanned<f64>,
    /// The body is inside: the obstacle is what is outside of the sphere. Default: false.
    #[serde(default)]
    pub inside: bool,
}

/// `cylinder`: a circular cylinder without ends.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ point = …, axis = …, radius = … }`"
)]
pub(crate) struct CylinderKeys {
    /// A point of the axis (length).
    pub point: Spanned<Triple<f64>>,
    /// Direction of the axis.
    pub axis: Spanned<Triple<f64>>,
    /// Its radius (length), positive.
    pub radius: Spanned<f64>,
    /// As for a sphere.
    #[serde(default)]
    pub inside: bool,
}

/// `circle`: a disc in the plane.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ center = …, radius = … }`"
)]
pub(crate) struct CircleKeys {
    /// Its centre (length).
    pub center: Spanned<Vec<Spanned<f64>>>,
    /// Its radius (length), positive.
    pub radius: Spanned<f64>,
    /// As for a sphere.
    #[serde(default)]
    pub inside: bool,
}

/// `surface`: a surface out of a mesh file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ file = \"….msh\" }`")]
pub(crate) struct SurfaceKeys {
    /// Path of the file, relative to the case file.
    pub file: Spanned<String>,
    /// The surface group (in the plane: curve group). Default: all surface elements.
    pub group: Option<Spanned<String>>,
    /// As for the mesh of a body.
    pub scale: Option<Spanned<f64>>,
    /// As for the mesh of a body.
    pub rotate: Option<Spanned<RotateKeys>>,
    /// As for the mesh of a body.
    pub translate: Option<Spanned<Vec<Spanned<f64>>>>,
    /// Exchanges the solid side and the other. Default: false.
    #[serde(default)]
    pub flip: bool,
}
