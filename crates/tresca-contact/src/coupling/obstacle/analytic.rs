//! Nearest points of planes, spheres and cylinders.

use tresca_fem::vector3::{dot, norm, unit};

use super::shape::RigidShape;
use crate::error::ContactError;

/// Deeper than this share of the radius the nearest point of a round obstacle means nothing.
const DEEPEST: f64 = 0.5;

/// The nearest point of an obstacle, seen from a point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearest {
    /// Unit normal out of the obstacle.
    pub normal: [f64; 3],
    /// Signed distance, positive outside of the obstacle.
    pub distance: f64,
}

/// A checked obstacle with a closed form.
#[derive(Debug, Clone, Copy)]
pub(super) enum Analytic {
    Plane {
        point: [f64; 3],
        normal: [f64; 3],
    },
    /// Distances from a centre, or from an axis through it.
    Round {
        center: [f64; 3],
        axis: Option<[f64; 3]>,
        radius: f64,
        inside: bool,
    },
}

impl Analytic {
    /// Checks an obstacle for a space of the given dimension.
    pub fn new(obstacle: &RigidShape, dimension: usize) -> Result<Self, ContactError> {
        let wrong = |what| Err(ContactError::Obstacle { what });
        // In the plane the third coordinate has no meaning.
        let in_space =
            |a: [f64; 3]| std::array::from_fn(|k| if k < dimension { a[k] } else { 0.0 });
        let finite = |a: &[f64; 3]| a.iter().all(|x| x.is_finite());
        let direction = |a: [f64; 3]| Some(unit(a)).filter(finite);
        match *obstacle {
            RigidShape::Plane { point, normal } => {
                let Some(normal) = direction(in_space(normal)) else {
                    return wrong("the normal of an obstacle's plane must be a direction");
                };
                if !finite(&point) {
                    return wrong("the point of an obstacle's plane must be finite");
                }
                let point = in_space(point);
                Ok(Self::Plane { point, normal })
            }
            RigidShape::Sphere { center, radius, .. }
            | RigidShape::Cylinder {
                point: center,
                radius,
                ..
            } if !(finite(&center) && radius.is_finite() && radius > 0.0) => {
                wrong("the centre of a round obstacle must be finite, its radius positive")
            }
            RigidShape::Sphere {
                center,
                radius,
                inside,
            } => Ok(Self::Round {
                center: in_space(center),
                axis: None,
                radius,
                inside,
            }),
            RigidShape::Cylinder {
                point,
                axis,
                radius,
                inside,
            } => {
                let Some(axis) = direction(axis) else {
                    return wrong("the axis of an obstacle's cylinder must be a direction");
                };
                if dimension == 2 && norm(in_space(axis)) > 1e-9 {
                    return wrong(
                        "in two dimensions the axis of an obstacle's cylinder must be the z axis",
                    );
                }
                Ok(Self::Round {
                    center: in_space(point),
                    axis: Some(axis).filter(|_| dimension == 3),
                    radius,
                    inside,
                })
            }
            RigidShape::Surface(_) => wrong("a surface of faces has no closed form"),
        }
    }

    /// The nearest point. At the very centre of a round obstacle its normal is no number.
    pub fn nearest(&self, x: [f64; 3]) -> Nearest {
        match *self {
            Self::Plane { point, normal } => Nearest {
                normal,
                distance: dot(normal, std::array::from_fn(|k| x[k] - point[k])),
            },
            Self::Round { radius, inside, .. } => {
                let arm = self.arm(x);
                let length = norm(arm);
                let sign = if inside { -1.0 } else { 1.0 };
                Nearest {
                    normal: arm.map(|a| sign * a / length),
                    distance: sign * (length - radius),
                }
            }
        }
    }

    /// From the centre, or from the axis, to a point.
    fn arm(&self, x: [f64; 3]) -> [f64; 3] {
        match *self {
            Self::Plane { .. } => [0.0; 3],
            Self::Round { center, axis, .. } => {
                let offset: [f64; 3] = std::array::from_fn(|k| x[k] - center[k]);
                match axis {
                    None => offset,
                    Some(axis) => {
                        let along = dot(axis, offset);
                        std::array::from_fn(|k| offset[k] - along * axis[k])
                    }
                }
            }
        }
    }

    /// Refuses points from which the nearest point means nothing: deep inside of a round obstacle, or at
    /// the centre of a cavity.
    pub fn check(&self, point: [f64; 3], nearest: &Nearest) -> Result<(), ContactError> {
        let &Self::Round { radius, .. } = self else {
            return Ok(());
        };
        let depth = -nearest.distance;
        if depth > DEEPEST * radius {
            return Err(ContactError::TooDeep {
                point,
                depth,
                radius,
            });
        }
        if norm(self.arm(point)) <= 1e-9 * radius {
            return Err(ContactError::AtCenter { point });
        }
        Ok(())
    }
}
