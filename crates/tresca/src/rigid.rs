//! Rigid motions that the supports of a body leave free.

use std::fmt;

use faer::{Mat, Side};

/// A rigid motion x ↦ t + ω × (x − c) about the centre c of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidMotion {
    /// Translation t.
    pub translation: [f64; 3],
    /// Rotation vector ω, scaled by the body's radius so that it compares with t.
    pub rotation: [f64; 3],
}

impl fmt::Display for RigidMotion {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let largest = |v: [f64; 3]| v.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
        let (kind, vector) = if largest(self.translation) >= largest(self.rotation) {
            ("translation along", self.translation)
        } else {
            ("rotation about", self.rotation)
        };
        let scale = 1.0 / largest(vector);
        let names = ["x", "y", "z"];
        match (0..3).find(|&k| (0..3).all(|j| j == k || (vector[j] * scale).abs() < 1e-6)) {
            Some(k) => write!(out, "{kind} {}", names[k]),
            None => {
                let [x, y, z] = vector.map(|v| v * scale);
                write!(out, "{kind} ({x:.2}, {y:.2}, {z:.2})")
            }
        }
    }
}

/// A combination of rigid motions counts as free when the support resists it with less than this
/// share (squared, of one held dof at the body's rim).
const HELD_THRESHOLD: f64 = 1e-10;

/// The rigid motions (up to six, orthonormal) of which no held dof knows anything.
///
/// `held(node, component)` says whether the supports hold that displacement component.
pub fn free_motions(points: &[[f64; 3]], held: impl Fn(usize, usize) -> bool) -> Vec<RigidMotion> {
    let count = points.len().max(1) as f64;
    let centre: [f64; 3] =
        std::array::from_fn(|k| points.iter().map(|point| point[k]).sum::<f64>() / count);
    let arm = |point: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| point[k] - centre[k]) };
    let radius = points
        .iter()
        .map(|point| arm(point).iter().map(|x| x * x).sum::<f64>().sqrt())
        .fold(0.0, f64::max);

    // Gram matrix of the six motions, sampled at the held dofs.
    let mut gram = Mat::<f64>::zeros(6, 6);
    for (node, point) in points.iter().enumerate() {
        let [x, y, z] = arm(point).map(|a| a / radius);
        let displacement = [
            [1.0, 0.0, 0.0, 0.0, z, -y],
            [0.0, 1.0, 0.0, -z, 0.0, x],
            [0.0, 0.0, 1.0, y, -x, 0.0],
        ];
        for (component, row) in displacement.iter().enumerate() {
            if held(node, component) {
                for i in 0..6 {
                    for j in 0..6 {
                        gram[(i, j)] += row[i] * row[j];
                    }
                }
            }
        }
    }
    // A 6×6 matrix of finite numbers: the eigenvalue iteration does not fail; if it did, the
    // body counts as unsupported, which is the safe side.
    let Ok(eigen) = gram.self_adjoint_eigen(Side::Lower) else {
        return all_motions().to_vec();
    };
    if gram.norm_max() == 0.0 {
        return all_motions().to_vec();
    }
    (0..6)
        .filter(|&k| eigen.S().column_vector()[k] < HELD_THRESHOLD)
        .map(|k| RigidMotion {
            translation: std::array::from_fn(|i| eigen.U()[(i, k)]),
            rotation: std::array::from_fn(|i| eigen.U()[(i + 3, k)]),
        })
        .collect()
}

fn all_motions() -> [RigidMotion; 6] {
    std::array::from_fn(|k| {
        let unit = std::array::from_fn(|i| f64::from(u8::from(i == k % 3)));
        let zero = [0.0; 3];
        let (translation, rotation) = if k < 3 { (unit, zero) } else { (zero, unit) };
        RigidMotion {
            translation,
            rotation,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 3]; 8] = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [2.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [2.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
        [2.0, 1.0, 1.0],
    ];

    #[test]
    fn an_unsupported_body_has_six_free_motions_and_a_clamped_face_leaves_none() {
        assert_eq!(free_motions(&CORNERS, |_, _| false).len(), 6);
        assert!(free_motions(&CORNERS, |node, _| CORNERS[node][0] == 0.0).is_empty());
    }

    #[test]
    fn a_clamped_edge_leaves_the_rotation_about_it() {
        let on_edge = |node: usize, _| CORNERS[node][0] == 0.0 && CORNERS[node][2] == 0.0;
        let free = free_motions(&CORNERS, on_edge);
        assert_eq!(free.len(), 1);
        let [wx, wy, wz] = free[0].rotation;
        assert!(wy.abs() > 0.1 && wx.abs() < 1e-12 && wz.abs() < 1e-12);
    }

    #[test]
    fn a_symmetry_plane_leaves_two_translations_and_one_rotation() {
        let free = free_motions(&CORNERS, |node, c| CORNERS[node][2] == 0.0 && c == 2);
        assert_eq!(free.len(), 3);
    }

    #[test]
    fn motions_are_named_for_people() {
        let slide = RigidMotion {
            translation: [0.0, -1.0, 0.0],
            rotation: [0.0; 3],
        };
        assert_eq!(slide.to_string(), "translation along y");
    }
}
