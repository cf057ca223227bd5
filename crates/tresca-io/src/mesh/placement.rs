//! Rigid placement and scale of a mesh.

use tresca_fem::vector3::{cross, unit};

/// Where the points of a mesh go: first the scale, then the rotation, then the translation. The
/// default leaves them where they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Factor of all coordinates, positive; 1e-3 from millimetres to metres.
    pub scale: f64,
    /// The rotation, if any.
    pub rotation: Option<Rotation>,
    /// The translation (length, after the scale).
    pub translation: [f64; 3],
}

/// A rotation about an axis, by the right-hand rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// Direction of the axis, not zero.
    pub axis: [f64; 3],
    /// Angle in degrees.
    pub angle: f64,
    /// A point of the axis (length, after the scale).
    pub about: [f64; 3],
}

impl Default for Placement {
    fn default() -> Self {
        Self {
            scale: 1.0,
            rotation: None,
            translation: [0.0; 3],
        }
    }
}

impl Placement {
    /// The placed point.
    pub fn apply(&self, point: [f64; 3]) -> [f64; 3] {
        let scaled = point.map(|x| self.scale * x);
        let turned = match &self.rotation {
            Some(rotation) => rotation.apply(scaled),
            None => scaled,
        };
        std::array::from_fn(|i| turned[i] + self.translation[i])
    }

    /// Whether points stay where they are.
    pub fn is_identity(&self) -> bool {
        *self == Self::default()
    }
}

impl Rotation {
    /// Rodrigues' formula, x + sin α (k × x) + (1 − cos α) k × (k × x) for the unit axis k.
    fn apply(&self, point: [f64; 3]) -> [f64; 3] {
        let axis = unit(self.axis);
        let (sine, cosine) = sine_cosine(self.angle);
        let arm: [f64; 3] = std::array::from_fn(|i| point[i] - self.about[i]);
        let across = cross(axis, arm);
        let inwards = cross(axis, across);
        std::array::from_fn(|i| {
            self.about[i] + arm[i] + sine * across[i] + (1.0 - cosine) * inwards[i]
        })
    }
}

/// Sine and cosine of an angle in degrees, exact for multiples of a right angle: a mesh that is
/// turned by 90° still lies on its planes.
fn sine_cosine(degrees: f64) -> (f64, f64) {
    let quarters = degrees / 90.0;
    if quarters == quarters.round() {
        match quarters.rem_euclid(4.0) as u8 {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        }
    } else {
        degrees.to_radians().sin_cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scale_comes_first_then_rotation_then_translation() {
        let placement = Placement {
            scale: 2.0,
            rotation: Some(Rotation {
                axis: [0.0, 0.0, 5.0],
                angle: 90.0,
                about: [1.0, 0.0, 0.0],
            }),
            translation: [0.0, 0.0, -3.0],
        };
        // (1, 1, 1) → (2, 2, 2) → about x = 1: (1 − 2, 0 + 1, 2) → z − 3
        assert_eq!(placement.apply([1.0, 1.0, 1.0]), [-1.0, 1.0, -1.0]);
        assert_eq!(Placement::default().apply([0.1, 0.2, 0.3]), [0.1, 0.2, 0.3]);
    }

    #[test]
    fn a_rotation_is_right_handed_and_keeps_the_axis() {
        let turn = |axis, angle, point| {
            Rotation {
                axis,
                angle,
                about: [0.0; 3],
            }
            .apply(point)
        };
        assert_eq!(
            turn([1.0, 0.0, 0.0], 90.0, [0.0, 1.0, 0.0]),
            [0.0, 0.0, 1.0]
        );
        assert_eq!(
            turn([0.0, 1.0, 0.0], -270.0, [0.0, 0.0, 1.0]),
            [1.0, 0.0, 0.0]
        );
        assert_eq!(
            turn([0.0, 0.0, 2.0], 180.0, [3.0, 1.0, 7.0]),
            [-3.0, -1.0, 7.0]
        );
        // A third of a turn about the diagonal goes x → y → z.
        let third = turn([1.0; 3], 120.0, [1.0, 0.0, 0.0]);
        assert!(
            (0..3).all(|i| (third[i] - [0.0, 1.0, 0.0][i]).abs() < 1e-15),
            "{third:?}"
        );
    }
}
