//! Friction laws, as the user states them, and what they are for a single pair.

use std::fmt;
use std::sync::Arc;

use crate::frame::{dot, unit};
use crate::{ContactError, Frame};

/// A quantity that may vary over the slave surface.
#[derive(Clone)]
pub enum Field {
    /// The same everywhere.
    Constant(f64),
    /// One value per node of the slave surface, by ascending node number.
    Values(Vec<f64>),
    /// A function of the undeformed position.
    Function(Arc<dyn Fn([f64; 3]) -> f64 + Send + Sync>),
}

impl fmt::Debug for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Field::Constant(value) => write!(f, "Constant({value})"),
            Field::Values(values) => write!(f, "Values({} nodes)", values.len()),
            Field::Function(_) => f.write_str("Function"),
        }
    }
}

impl From<f64> for Field {
    fn from(value: f64) -> Self {
        Field::Constant(value)
    }
}

impl Field {
    /// The value at the `index`-th of `count` nodes of the slave surface.
    pub(crate) fn at(
        &self,
        index: usize,
        count: usize,
        point: [f64; 3],
    ) -> Result<f64, ContactError> {
        match self {
            Field::Constant(value) => Ok(*value),
            Field::Values(values) if values.len() == count => Ok(values[index]),
            Field::Values(values) => Err(ContactError::ValueCount {
                expected: count,
                found: values.len(),
            }),
            Field::Function(function) => Ok(function(point)),
        }
    }
}

/// What resists sliding, and opening, between two surfaces.
///
/// Bounds are stresses (force per area) ≥ 0; of a pair they become forces, g_i = g(x_i) ∫ φ_i.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum FrictionLaw {
    /// Nothing resists sliding.
    Frictionless,
    /// Tresca's law: the tangential traction stays below a bound that is given beforehand and
    /// does not know the contact pressure.
    Tresca {
        /// The slip bound.
        bound: Field,
    },
    /// Tresca's law with two bounds: the tangential traction stays in the ellipse
    /// (t1/g1)² + (t2/g2)² ≤ 1. Slip is normal to the ellipse (the associated law). A bound of 0
    /// leaves its direction without friction. In space only.
    Orthotropic {
        /// Slip bounds g1, g2 along the two axes.
        bounds: [Field; 2],
        /// Direction of axis 1; it is projected on the tangent plane.
        axis: [f64; 3],
    },
    /// Coulomb's law: the bound is F times the contact pressure.
    Coulomb {
        /// Friction coefficients F1, F2 ≥ 0 along the axes; equal for isotropic friction.
        coefficients: [f64; 2],
        /// Direction of axis 1, as in `Orthotropic`; without it the frame's own axes, which is right
        /// for equal coefficients.
        axis: Option<[f64; 3]>,
        /// Upper limit of the bound along the axis of the larger coefficient, a stress (the other
        /// axis in proportion): the shear strength of the softer material. `None` for no limit.
        limit: Option<Field>,
    },
    /// Glued: neither opening nor slip.
    Tied,
    /// No opening; slip free, or resisted below a bound as by Tresca's law.
    Bilateral {
        /// The slip bound, `None` for free slip.
        bound: Option<Field>,
    },
}

/// What a contact pair may do along its normal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Opening {
    /// Open, or closed under pressure.
    Unilateral,
    /// Neither open nor closed any further.
    Never,
}

/// What a contact pair may do along its tangents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sliding {
    /// Not slide.
    Never,
    /// Slide when the friction force leaves the ellipse with these semi-axes (forces ≥ 0) along the
    /// tangents τ1, τ2.
    Bounded([f64; 2]),
    /// The same with the semi-axes min(λν, limit/F)·(F1, F2), F the larger of the two coefficients.
    Coulomb {
        /// F1, F2 ≥ 0 along τ1, τ2.
        coefficients: [f64; 2],
        /// Upper limit of the larger semi-axis (a force), ∞ for none.
        limit: f64,
    },
}

impl Sliding {
    /// The law of a pair with `factor` times the area: bounds and limits, which are forces, grow along.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Sliding::Never => Sliding::Never,
            Sliding::Bounded(bounds) => Sliding::Bounded(bounds.map(|bound| factor * bound)),
            Sliding::Coulomb {
                coefficients,
                limit,
            } => Sliding::Coulomb {
                coefficients,
                limit: factor * limit,
            },
        }
    }

    /// The semi-axes of the ellipse under a normal force λν.
    pub fn bounds(&self, normal_force: f64) -> Option<[f64; 2]> {
        match *self {
            Sliding::Never => None,
            Sliding::Bounded(bounds) => Some(bounds),
            Sliding::Coulomb {
                coefficients,
                limit,
            } => {
                let largest = coefficients[0].max(coefficients[1]);
                let bound = (largest * normal_force.max(0.0)).min(limit);
                let share = |f: f64| if largest > 0.0 { f / largest } else { 0.0 };
                Some(coefficients.map(|f| share(f) * bound))
            }
        }
    }
}

impl FrictionLaw {
    /// Tresca's law with a slip bound (force per area).
    pub fn tresca(bound: impl Into<Field>) -> Self {
        FrictionLaw::Tresca {
            bound: bound.into(),
        }
    }

    /// Isotropic Coulomb friction without a limit.
    pub fn coulomb(coefficient: f64) -> Self {
        FrictionLaw::Coulomb {
            coefficients: [coefficient; 2],
            axis: None,
            limit: None,
        }
    }

    /// Checks what can be checked without a surface.
    ///
    /// # Errors
    /// For a bound or a coefficient that is no number ≥ 0, and an axis that is no direction.
    pub fn validate(&self) -> Result<(), ContactError> {
        let field = |bound: &Field| match bound {
            Field::Constant(value) => bound_at(*value, None).map(drop),
            Field::Values(_) | Field::Function(_) => Ok(()),
        };
        let direction = |axis: [f64; 3]| {
            let length = dot(axis, axis).sqrt();
            if length.is_finite() && length > 0.0 {
                Ok(())
            } else {
                Err(ContactError::Axis { axis, point: None })
            }
        };
        match self {
            FrictionLaw::Frictionless | FrictionLaw::Tied => Ok(()),
            FrictionLaw::Tresca { bound } => field(bound),
            FrictionLaw::Orthotropic { bounds, axis } => {
                bounds.iter().try_for_each(field)?;
                direction(*axis)
            }
            FrictionLaw::Coulomb {
                coefficients,
                axis,
                limit,
            } => {
                if let Some(&value) = coefficients.iter().find(|f| !(f.is_finite() && **f >= 0.0)) {
                    return Err(ContactError::Coefficient { value });
                }
                axis.map_or(Ok(()), direction)?;
                limit.as_ref().map_or(Ok(()), field)
            }
            FrictionLaw::Bilateral { bound } => bound.as_ref().map_or(Ok(()), field),
        }
    }

    /// Does the bound follow the normal force?
    pub fn is_coulomb(&self) -> bool {
        matches!(self, FrictionLaw::Coulomb { .. })
    }

    /// The words for the laws, by [`FrictionLaw::number`]: the one list of them. Numbers stand in output files;
    /// a new law comes last.
    pub const NAMES: [&'static str; 6] = [
        "frictionless",
        "tresca",
        "orthotropic",
        "coulomb",
        "tied",
        "bilateral",
    ];

    /// The number of the law in [`FrictionLaw::NAMES`].
    pub fn number(&self) -> u8 {
        match self {
            FrictionLaw::Frictionless => 0,
            FrictionLaw::Tresca { .. } => 1,
            FrictionLaw::Orthotropic { .. } => 2,
            FrictionLaw::Coulomb { .. } => 3,
            FrictionLaw::Tied => 4,
            FrictionLaw::Bilateral { .. } => 5,
        }
    }

    /// The word for it.
    pub fn name(&self) -> &'static str {
        Self::NAMES[usize::from(self.number())]
    }

    /// What the pair may do along its normal.
    pub fn opening(&self) -> Opening {
        match self {
            FrictionLaw::Tied | FrictionLaw::Bilateral { .. } => Opening::Never,
            _ => Opening::Unilateral,
        }
    }

    /// The direction of axis 1, if the law has one.
    pub(crate) fn axis(&self) -> Option<[f64; 3]> {
        match self {
            FrictionLaw::Orthotropic { axis, .. } => Some(*axis),
            FrictionLaw::Coulomb { axis, .. } => *axis,
            _ => None,
        }
    }

    /// What a pair may do along its tangents τ1, τ2, where τ1 is axis 1.
    ///
    /// `value` evaluates a field at the pair; `area` is ∫ φ_i.
    pub(crate) fn sliding(
        &self,
        area: f64,
        point: [f64; 3],
        value: impl Fn(&Field) -> Result<f64, ContactError>,
    ) -> Result<Sliding, ContactError> {
        let force = |field: &Field| Ok(area * bound_at(value(field)?, Some(point))?);
        Ok(match self {
            FrictionLaw::Frictionless => Sliding::Bounded([0.0; 2]),
            FrictionLaw::Tresca { bound } => Sliding::Bounded([force(bound)?; 2]),
            FrictionLaw::Orthotropic { bounds, .. } => {
                Sliding::Bounded([force(&bounds[0])?, force(&bounds[1])?])
            }
            FrictionLaw::Coulomb {
                coefficients,
                limit,
                ..
            } => Sliding::Coulomb {
                coefficients: *coefficients,
                limit: limit.as_ref().map_or(Ok(f64::INFINITY), force)?,
            },
            FrictionLaw::Tied => Sliding::Never,
            FrictionLaw::Bilateral { bound } => {
                Sliding::Bounded([bound.as_ref().map_or(Ok(0.0), force)?; 2])
            }
        })
    }
}

impl Sliding {
    /// The same law in the tangents of another frame with the same normal, of which only the first is
    /// able to slide: the section of the ellipse with the line along it.
    pub(crate) fn along(self, from: &Frame, direction: [f64; 3]) -> Self {
        let [c, s] = from.tangents.map(|t| dot(t, unit(direction)));
        let radius = |[a, b]: [f64; 2]| {
            // A semi-axis of 0 leaves a segment; only the line along it has more than a point of it.
            let part = |share: f64, axis: f64| {
                if share == 0.0 {
                    0.0
                } else {
                    (share / axis).powi(2)
                }
            };
            let [c, s] = [c, s].map(|x: f64| if x.abs() < 1e-12 { 0.0 } else { x });
            (part(c, a) + part(s, b)).sqrt().recip()
        };
        match self {
            Sliding::Never => self,
            Sliding::Bounded(bounds) => Sliding::Bounded([radius(bounds), 0.0]),
            Sliding::Coulomb {
                coefficients,
                limit,
            } => {
                let coefficient = radius(coefficients);
                let largest = coefficients[0].max(coefficients[1]);
                let share = if largest > 0.0 {
                    coefficient / largest
                } else {
                    0.0
                };
                Sliding::Coulomb {
                    coefficients: [coefficient, 0.0],
                    limit: if share > 0.0 { share * limit } else { limit },
                }
            }
        }
    }
}

fn bound_at(value: f64, point: Option<[f64; 3]>) -> Result<f64, ContactError> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(ContactError::SlipBound {
            bound: value,
            point,
        })
    }
}
