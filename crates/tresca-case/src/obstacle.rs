//! Rigid obstacles.

use serde::Deserialize;
use tresca_contact::{RigidShape as Shape, RigidSurface};
use tresca_io::located::Span;
use tresca_io::names::listed;
use tresca_model::Obstacle;

use crate::error::{CaseError, FaultKind};
use crate::numbers::Triple;
use crate::placement::RotateKeys;
use crate::reader::{Reader, fault_of_name};
use crate::text::at::At;

/// `[[obstacle]]`: a rigid body. One of the shapes is given, which is checked afterwards, so that
/// the report can say so.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[obstacle]]")]
pub(crate) struct ObstacleKeys {
    /// How contacts and load steps call it.
    pub name: At<String>,
    /// A half-space; in the plane a half-plane.
    pub plane: Option<At<PlaneKeys>>,
    /// A ball, or the outside of one.
    pub sphere: Option<At<SphereKeys>>,
    /// An endless cylinder, or the outside of one.
    pub cylinder: Option<At<CylinderKeys>>,
    /// In the plane: a disc, or the outside of one.
    pub circle: Option<At<CircleKeys>>,
    /// The surface in a mesh file; in the plane a curve.
    pub surface: Option<At<SurfaceKeys>>,
    /// Its displacement (length). Default: it stays.
    pub motion: Option<At<Vec<At<f64>>>>,
}

/// `plane`: everything behind a plane.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ point = …, normal = … }`")]
pub(crate) struct PlaneKeys {
    /// A point of the plane (length).
    pub point: At<Vec<At<f64>>>,
    /// Its normal, out of the solid side.
    pub normal: At<Vec<At<f64>>>,
}

/// `sphere`: a ball.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ center = …, radius = … }`"
)]
pub(crate) struct SphereKeys {
    /// Its centre (length).
    pub center: At<Triple<f64>>,
    /// Its radius (length), positive.
    pub radius: At<f64>,
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
    pub point: At<Triple<f64>>,
    /// Direction of the axis.
    pub axis: At<Triple<f64>>,
    /// Its radius (length), positive.
    pub radius: At<f64>,
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
    pub center: At<Vec<At<f64>>>,
    /// Its radius (length), positive.
    pub radius: At<f64>,
    /// As for a sphere.
    #[serde(default)]
    pub inside: bool,
}

/// `surface`: a surface out of a mesh file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ file = \"….msh\" }`")]
pub(crate) struct SurfaceKeys {
    /// Path of the file, relative to the case file.
    pub file: At<String>,
    /// The surface group (in the plane: curve group). Default: all surface elements.
    pub group: Option<At<String>>,
    /// As for the mesh of a body.
    pub scale: Option<At<f64>>,
    /// As for the mesh of a body.
    pub rotate: Option<At<RotateKeys>>,
    /// As for the mesh of a body.
    pub translate: Option<At<Vec<At<f64>>>>,
    /// Exchanges the solid side and the other. Default: false.
    #[serde(default)]
    pub flip: bool,
}
/// The keys of the shapes.
const SHAPES: [&str; 5] = ["plane", "sphere", "cylinder", "circle", "surface"];

impl Reader<'_> {
    pub(crate) fn obstacles(&mut self, list: Vec<At<ObstacleKeys>>) -> Result<(), CaseError> {
        for keys in list {
            let span = keys.span();
            let keys = keys.value;
            self.obstacle_name(&keys.name)?;
            let mut obstacle = Obstacle::new(keys.name.as_str(), self.shape(&keys, &span)?);
            if let Some(motion) = &keys.motion {
                obstacle = obstacle.motion(self.vector("the motion", motion)?);
            }
            let added = self.model.add_obstacle(obstacle);
            let id = added.map_err(|error| self.refused(&span, error))?;
            self.origins.obstacles.push(keys.name.clone());
            self.origins.note(&span, Some(keys.name), vec![id.into()]);
        }
        Ok(())
    }

    fn obstacle_name(&self, name: &At<String>) -> Result<(), CaseError> {
        if let Some(label) = fault_of_name(name) {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    name.span(),
                    "this cannot be the name of an obstacle",
                    label,
                )
                .with_help("names are written as in `table` or `ball-2`"));
        }
        let bodies = self.origins.bodies.iter().map(|body| &body.name);
        let mut taken = bodies.chain(&self.origins.obstacles);
        let lower = name.to_lowercase();
        match taken.find(|other| other.to_lowercase() == lower) {
            None => Ok(()),
            Some(other) => Err(self
                .fault(
                    FaultKind::Duplicate,
                    name.span(),
                    format!("the name `{}` is given twice", name.value),
                    "the second time",
                )
                .and_at(other.span(), "the first time")
                .with_help("bodies and obstacles have different names; upper and lower case count as equal")),
        }
    }

    fn shape(&mut self, keys: &ObstacleKeys, span: &Span) -> Result<Shape, CaseError> {
        let given = [
            keys.plane.as_ref().map(At::span),
            keys.sphere.as_ref().map(At::span),
            keys.cylinder.as_ref().map(At::span),
            keys.circle.as_ref().map(At::span),
            keys.surface.as_ref().map(At::span),
        ];
        let mut given = given.into_iter().zip(SHAPES);
        let mut given = given.by_ref().filter_map(|(span, key)| Some((span?, key)));
        let first = given.next();
        if let (Some((first, one)), Some((second, other))) = (&first, given.next()) {
            return Err(self
                .fault(
                    FaultKind::Duplicate,
                    second,
                    format!("`{one}` and `{other}` exclude each other"),
                    "the second shape",
                )
                .and_at(first.clone(), "the first shape")
                .with_help("each obstacle has its own [[obstacle]]"));
        }
        if let Some(plane) = &keys.plane {
            self.plane(plane)
        } else if let Some(sphere) = &keys.sphere {
            self.only_in(3, sphere.span(), "sphere", "circle")?;
            self.sphere(sphere)
        } else if let Some(cylinder) = &keys.cylinder {
            self.only_in(3, cylinder.span(), "cylinder", "circle")?;
            self.cylinder(cylinder)
        } else if let Some(circle) = &keys.circle {
            self.only_in(2, circle.span(), "circle", "cylinder")?;
            self.circle(circle)
        } else if let Some(surface) = &keys.surface {
            self.rigid_surface(surface)
        } else {
            Err(self
                .fault(
                    FaultKind::MissingKey,
                    span.clone(),
                    format!("the obstacle `{}` has no shape", keys.name.value),
                    "expected a shape in this table",
                )
                .with_help(format!("the shapes are {}", listed(&SHAPES))))
        }
    }

    /// Refuses a shape of another dimension.
    fn only_in(
        &self,
        dimension: usize,
        span: Span,
        word: &str,
        other: &str,
    ) -> Result<(), CaseError> {
        if self.analysis.dimension() == dimension {
            return Ok(());
        }
        let analysis = self.analysis.word();
        Err(self
            .fault(
                FaultKind::BadValue,
                span,
                format!("a {word} does not belong in a case with `analysis = \"{analysis}\"`"),
                format!("expected `{other}`, or another shape"),
            )
            .with_help("in space there are `sphere` and `cylinder`, in the plane `circle`"))
    }

    fn plane(&self, keys: &PlaneKeys) -> Result<Shape, CaseError> {
        let normal = self.vector("the normal", &keys.normal)?;
        Ok(Shape::Plane {
            point: self.vector("the point", &keys.point)?,
            normal: self.direction("the normal", keys.normal.span(), normal)?,
        })
    }

    fn sphere(&self, keys: &SphereKeys) -> Result<Shape, CaseError> {
        self.finite_components("the center", &keys.center)?;
        Ok(Shape::Sphere {
            center: keys.center.values(),
            radius: self.radius(&keys.radius)?,
            inside: keys.inside,
        })
    }

    fn cylinder(&self, keys: &CylinderKeys) -> Result<Shape, CaseError> {
        self.finite_components("the point", &keys.point)?;
        self.finite_components("the axis", &keys.axis)?;
        let axis = keys.axis.values();
        Ok(Shape::Cylinder {
            point: keys.point.values(),
            axis: self.direction("the axis", keys.axis.span(), axis)?,
            radius: self.radius(&keys.radius)?,
            inside: keys.inside,
        })
    }

    fn circle(&self, keys: &CircleKeys) -> Result<Shape, CaseError> {
        Ok(Shape::Cylinder {
            point: self.vector("the center", &keys.center)?,
            axis: [0.0, 0.0, 1.0],
            radius: self.radius(&keys.radius)?,
            inside: keys.inside,
        })
    }

    fn radius(&self, radius: &At<f64>) -> Result<f64, CaseError> {
        let help = "`inside = true` puts the body into the sphere or cylinder";
        self.positive("the radius", radius, help)
    }

    fn rigid_surface(&mut self, keys: &SurfaceKeys) -> Result<Shape, CaseError> {
        let placement = self.placement(
            keys.scale.as_ref(),
            keys.rotate.as_ref(),
            keys.translate.as_ref(),
        )?;
        let file = self.mesh_file(&keys.file)?;
        let group = keys.group.as_ref();
        let name = group.map(|group| group.as_str());
        let dimension = self.analysis.dimension();
        let surface = file.surface(dimension, name, &placement, keys.flip);
        let surface = surface.map_err(|error| self.bad_part(&keys.file, group, &error))?;
        Ok(Shape::Surface(RigidSurface {
            points: surface.points,
            faces: surface.faces,
        }))
    }
}
