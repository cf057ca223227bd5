//! Rigid motions and their names.

use crate::mesh::data::Mesh;
use crate::mesh::parts::Part;
use crate::mesh::space::Space;
use crate::vector3::{cross, dot, norm, sub};
use std::fmt;

/// An infinitesimal rigid motion u(x) = t + ω × (x − c).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion {
    /// The displacement t of the centre.
    pub translation: [f64; 3],
    /// The rotation vector ω.
    pub rotation: [f64; 3],
    /// The centre c.
    pub center: [f64; 3],
}

impl RigidMotion {
    /// Displacement of a point.
    pub fn at(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = cross(self.rotation, sub(point, self.center));
        std::array::from_fn(|i| self.translation[i] + turned[i])
    }

    /// Adds an amount of a motion with the same centre.
    pub(super) fn add(&mut self, amount: f64, other: &RigidMotion) {
        for i in 0..3 {
            self.translation[i] += amount * other.translation[i];
            self.rotation[i] += amount * other.rotation[i];
        }
    }

    /// Displacement of all nodes, over the full dofs.
    pub fn displacement(&self, mesh: &Mesh) -> Vec<f64> {
        mesh.points
            .iter()
            .flat_map(|&p| self.at(p).into_iter().take(mesh.dimension()))
            .collect()
    }
}

impl fmt::Display for RigidMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let direction = |v: [f64; 3]| {
            let length = norm(v);
            // + 0.0 turns a negative zero into a zero.
            let [x, y, z] = v.map(|x| (x / length * 1e3).round() / 1e3 + 0.0);
            format!("({x}, {y}, {z})")
        };
        let omega = dot(self.rotation, self.rotation);
        if omega == 0.0 {
            return write!(f, "translation along {}", direction(self.translation));
        }
        // Of all points the axis is nearest to, c + ω × t / ω² moves along the axis alone.
        let arm = cross(self.rotation, self.translation).map(|x| x / omega);
        let through: [f64; 3] = std::array::from_fn(|i| self.center[i] + arm[i]);
        let [x, y, z] = through;
        write!(
            f,
            "rotation about {} through ({x:.4}, {y:.4}, {z:.4})",
            direction(self.rotation)
        )?;
        let along = dot(self.rotation, self.translation) / omega.sqrt();
        if along.abs() > 1e-6 * norm(self.translation) {
            write!(f, " with translation along it")?;
        }
        Ok(())
    }
}

/// All rigid motions of a connected part: the translations along the axes, then the rotations about
/// the axes through the centre of the part's bounding box, as large as the translations at a distance
/// of half the box's diagonal. Six in space, three in the plane; in an axisymmetric space only the
/// translation along the axis y.
pub fn motions(mesh: &Mesh, part: &Part) -> Vec<RigidMotion> {
    let bounds = part.bounding_box(mesh);
    let center = std::array::from_fn(|i| 0.5 * (bounds.min[i] + bounds.max[i]));
    let angle = 2.0 / bounds.diagonal();
    let unit =
        |axis: usize, length: f64| std::array::from_fn(|i| if i == axis { length } else { 0.0 });
    let (translations, rotations) = match mesh.space {
        Space::Solid => (0..3, 0..3),
        Space::Plane => (0..2, 2..3),
        Space::Axisymmetric => (1..2, 0..0),
    };
    let translation = |axis| RigidMotion {
        translation: unit(axis, 1.0),
        rotation: [0.0; 3],
        center,
    };
    let rotation = |axis| RigidMotion {
        translation: [0.0; 3],
        rotation: unit(axis, angle),
        center,
    };
    translations
        .map(translation)
        .chain(rotations.map(rotation))
        .collect()
}

/// A combination of motions with the same centre.
pub(super) fn combine(motions: &[RigidMotion], coefficients: &[f64]) -> RigidMotion {
    let clean = |x: f64| if x.abs() < 1e-9 { 0.0 } else { x };
    let mut sum = RigidMotion {
        translation: [0.0; 3],
        rotation: [0.0; 3],
        center: motions[0].center,
    };
    for (motion, &c) in motions.iter().zip(coefficients) {
        sum.add(clean(c), motion);
    }
    sum
}
