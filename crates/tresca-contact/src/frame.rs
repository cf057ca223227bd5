//! The local orthonormal frame (ν, τ1, τ2) of a contact pair.

use tresca_fem::vector3::{cross, dot, unit};

/// A right-handed orthonormal frame: unit normal ν and two unit tangents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Unit normal ν, out of the slave body.
    pub normal: [f64; 3],
    /// Unit tangents τ1, τ2 with τ1 × τ2 = ν.
    pub tangents: [[f64; 3]; 2],
}

impl Frame {
    /// The frame of a unit normal. τ1 is the projection of the x axis on the tangent plane (of the
    /// y axis where ν is within 30° of x), so that neighbouring pairs of a smooth surface
    /// get neighbouring frames and a flat face gets one frame.
    pub fn from_normal(normal: [f64; 3]) -> Self {
        let axis = if normal[0].abs() < 0.75f64.sqrt() {
            [1.0, 0.0, 0.0]
        } else {
            [0.0, 1.0, 0.0]
        };
        let along = dot(axis, normal);
        let first = unit(std::array::from_fn(|k| axis[k] - along * normal[k]));
        Self {
            normal,
            tangents: [first, cross(normal, first)],
        }
    }

    /// The frame of a unit normal whose τ1 is the projection of `axis` on the tangent plane; `None`
    /// where the axis is within 0.5° of the normal.
    pub fn with_axis(normal: [f64; 3], axis: [f64; 3]) -> Option<Self> {
        let along = dot(axis, normal);
        let projected: [f64; 3] = std::array::from_fn(|k| axis[k] - along * normal[k]);
        let sine = (dot(projected, projected) / dot(axis, axis)).sqrt();
        // Also `None` for an axis that is zero or not finite.
        (sine > 0.01).then(|| {
            let first = unit(projected);
            Self {
                normal,
                tangents: [first, cross(normal, first)],
            }
        })
    }

    /// The three directions in the order ν, τ1, τ2.
    pub fn directions(&self) -> [[f64; 3]; 3] {
        [self.normal, self.tangents[0], self.tangents[1]]
    }

    /// The global vector of local components (ν, τ1, τ2).
    pub fn to_global(&self, local: [f64; 3]) -> [f64; 3] {
        let directions = self.directions();
        std::array::from_fn(|k| (0..3).map(|d| local[d] * directions[d][k]).sum())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_orthonormal_and_right_handed_in_every_direction() {
        for i in 0..20 {
            for j in 0..40 {
                let (theta, phi) = (f64::from(i) * 0.16, f64::from(j) * 0.16);
                let normal = [
                    theta.sin() * phi.cos(),
                    theta.sin() * phi.sin(),
                    theta.cos(),
                ];
                let frame = Frame::from_normal(unit(normal));
                let d = frame.directions();
                for a in 0..3 {
                    for b in 0..3 {
                        let expected = if a == b { 1.0 } else { 0.0 };
                        assert!((dot(d[a], d[b]) - expected).abs() < 1e-14);
                    }
                }
                assert!((dot(cross(d[1], d[2]), d[0]) - 1.0).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_horizontal_face_has_its_tangents_along_x_and_y() {
        let frame = Frame::from_normal([0.0, 0.0, -1.0]);
        assert_eq!(frame.tangents, [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]);
        assert_eq!(frame.to_global([2.0, 3.0, 5.0]), [3.0, -5.0, -2.0]);
    }
}
