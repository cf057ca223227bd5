//! Rigid obstacles.

use std::sync::Arc;

use toml::Spanned;

use super::body::Body;
use super::check::{Check, fault_of_name};
use super::error::{CaseError, FaultKind};
use super::keys::{CircleKeys, CylinderKeys, ObstacleKeys, PlaneKeys, SphereKeys, SurfaceKeys};
use super::source::Span;
use tresca_io::mesh::{MeshFileError, RigidSurface};
use tresca_io::names::listed;

/// A rigid body that the others may touch.
#[derive(Clone, Debug)]
pub struct Obstacle {
    /// How contacts and load steps call it; different from the names of the bodies.
    pub name: Spanned<String>,
    /// What it is.
    pub shape: ObstacleShape,
    /// Its displacement (length), where the file gives one.
    pub motion: Option<[f64; 3]>,
    /// The whole table.
    pub span: Span,
}

/// The shape of an obstacle. In the plane the third coordinates are 0.
#[derive(Clone, Debug)]
pub enum ObstacleShape {
    /// Everything behind a plane; in the plane, behind a line.
    Plane {
        /// A point of the plane (length).
        point: [f64; 3],
        /// Out of the solid side; not zero, of any length.
        normal: [f64; 3],
    },
    /// A ball, in space only.
    Sphere {
        /// Its centre (length).
        center: [f64; 3],
        /// Its radius (length), positive.
        radius: f64,
        /// The obstacle is what is outside of it.
        inside: bool,
    },
    /// An endless circular cylinder; in the plane, a disc: the axis is then that of z.
    Cylinder {
        /// A point of the axis (length).
        point: [f64; 3],
        /// Direction of the axis; not zero, of any length.
        axis: [f64; 3],
        /// Its radius (length), positive.
        radius: f64,
        /// The obstacle is what is outside of it.
        inside: bool,
    },
    /// A surface out of a mesh file; in the plane, a curve.
    Surface(Arc<RigidSurface>),
}

/// The keys of the shapes.
const SHAPES: [&str; 5] = ["plane", "sphere", "cylinder", "circle", "surface"];

impl Check<'_> {
    pub(super) fn obstacles(
        &self,
        list: Vec<Spanned<ObstacleKeys>>,
        bodies: &[Body],
    ) -> Result<Vec<Obstacle>, CaseError> {
        let mut obstacles: Vec<Obstacle> = Vec::with_capacity(list.len());
        for keys in list {
            let span = keys.span();
            let keys = keys.into_inner();
            self.obstacle_name(&keys.name, bodies, &obstacles)?;
            let shape = self.shape(&keys, &span)?;
            let motion = keys.motion.as_ref();
            let motion = motion.map(|motion| self.vector("the motion", motion));
            obstacles.push(Obstacle {
                name: keys.name,
                shape,
                motion: motion.transpose()?,
                span,
            });
        }
        Ok(obstacles)
    }

    fn obstacle_name(
        &self,
        name: &Spanned<String>,
        bodies: &[Body],
        obstacles: &[Obstacle],
    ) -> Result<(), CaseError> {
        if let Some(label) = fault_of_name(name.get_ref()) {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    name.span(),
                    "this cannot be the name of an obstacle",
                    label,
                )
                .with_help("names are written as in `table` or `ball-2`")
                .into());
        }
        let bodies = bodies.iter().map(|body| &body.name);
        let mut taken = bodies.chain(obstacles.iter().map(|obstacle| &obstacle.name));
        let lower = name.get_ref().to_lowercase();
        match taken.find(|other| other.get_ref().to_lowercase() == lower) {
            None => Ok(()),
            Some(other) => Err(self
                .fault(
                    FaultKind::Duplicate,
                    name.span(),
                    format!("the name `{}` is given twice", name.get_ref()),
                    "the second time",
                )
                .and_at(other.span(), "the first time")
                .with_help("bodies and obstacles have different names; upper and lower case count as equal")
                .into()),
        }
    }

    fn shape(&self, keys: &ObstacleKeys, span: &Span) -> Result<ObstacleShape, CaseError> {
        let given = [
            keys.plane.as_ref().map(Spanned::span),
            keys.sphere.as_ref().map(Spanned::span),
            keys.cylinder.as_ref().map(Spanned::span),
            keys.circle.as_ref().map(Spanned::span),
            keys.surface.as_ref().map(Spanned::span),
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
                .with_help("each obstacle has its own [[obstacle]]")
                .into());
        }
        if let Some(plane) = &keys.plane {
            self.plane(plane.get_ref())
        } else if let Some(sphere) = &keys.sphere {
            self.only_in(3, sphere.span(), "sphere", "circle")?;
            self.sphere(sphere.get_ref())
        } else if let Some(cylinder) = &keys.cylinder {
            self.only_in(3, cylinder.span(), "cylinder", "circle")?;
            self.cylinder(cylinder.get_ref())
        } else if let Some(circle) = &keys.circle {
            self.only_in(2, circle.span(), "circle", "cylinder")?;
            self.circle(circle.get_ref())
        } else if let Some(surface) = &keys.surface {
            self.rigid_surface(surface.get_ref())
        } else {
            Err(self
                .fault(
                    FaultKind::MissingKey,
                    span.clone(),
                    format!("the obstacle `{}` has no shape", keys.name.get_ref()),
                    "expected a shape in this table",
                )
                .with_help(format!("the shapes are {}", listed(&SHAPES)))
                .into())
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
            .with_help("in space there are `sphere` and `cylinder`, in the plane `circle`")
            .into())
    }

    fn plane(&self, keys: &PlaneKeys) -> Result<ObstacleShape, CaseError> {
        let normal = self.vector("the normal", &keys.normal)?;
        Ok(ObstacleShape::Plane {
            point: self.vector("the point", &keys.point)?,
            normal: self.direction("the normal", keys.normal.span(), normal)?,
        })
    }

    fn sphere(&self, keys: &SphereKeys) -> Result<ObstacleShape, CaseError> {
        self.finite_components("the center", &keys.center)?;
        Ok(ObstacleShape::Sphere {
            center: keys.center.get_ref().values(),
            radius: self.radius(&keys.radius)?,
            inside: keys.inside,
        })
    }

    fn cylinder(&self, keys: &CylinderKeys) -> Result<ObstacleShape, CaseError> {
        self.finite_components("the point", &keys.point)?;
        self.finite_components("the axis", &keys.axis)?;
        let axis = keys.axis.get_ref().values();
        Ok(ObstacleShape::Cylinder {
            point: keys.point.get_ref().values(),
            axis: self.direction("the axis", keys.axis.span(), axis)?,
            radius: self.radius(&keys.radius)?,
            inside: keys.inside,
        })
    }

    fn circle(&self, keys: &CircleKeys) -> Result<ObstacleShape, CaseError> {
        Ok(ObstacleShape::Cylinder {
            point: self.vector("the center", &keys.center)?,
            axis: [0.0, 0.0, 1.0],
            radius: self.radius(&keys.radius)?,
            inside: keys.inside,
        })
    }

    fn radius(&self, radius: &Spanned<f64>) -> Result<f64, CaseError> {
        let help = "`inside = true` puts the body into the sphere or cylinder";
        self.positive("the radius", radius, help)
    }

    fn rigid_surface(&self, keys: &SurfaceKeys) -> Result<ObstacleShape, CaseError> {
        let placement = self.placement(
            keys.scale.as_ref(),
            keys.rotate.as_ref(),
            keys.translate.as_ref(),
        )?;
        let file = self.mesh_file(&keys.file)?;
        let group = keys.group.as_ref().map(|group| group.get_ref().as_str());
        let dimension = self.analysis.dimension();
        let surface = file.surface(dimension, group, &placement, keys.flip);
        let surface = surface.map_err(|error| {
            let span = match (&error, &keys.group) {
                (
                    MeshFileError::UnknownGroup { .. } | MeshFileError::GroupDimension { .. },
                    Some(group),
                ) => group.span(),
                _ => keys.file.span(),
            };
            self.bad_mesh(span, &error)
        })?;
        Ok(ObstacleShape::Surface(Arc::new(surface)))
    }
}
