//! Rigid motions: what a body can do without being strained, and what its supports leave of it.

use crate::dofs::DofMap;
use crate::mesh::Mesh;
use crate::tensor::{cross, dot, norm, sub, symmetric_eigen};
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

    /// Displacement of all nodes, over the full dofs.
    pub fn displacement(&self, mesh: &Mesh) -> Vec<f64> {
        mesh.points
            .iter()
            .flat_map(|&p| self.at(p).into_iter().take(mesh.dimension))
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

/// All rigid motions of a connected mesh: the translations along the axes, then the rotations about
/// the axes through the centre of the bounding box, as large as the translations at a distance of
/// half the box's diagonal. Six in space, three in the plane.
pub fn motions(mesh: &Mesh) -> Vec<RigidMotion> {
    let bounds = mesh.bounding_box();
    let center = std::array::from_fn(|i| 0.5 * (bounds.min[i] + bounds.max[i]));
    let angle = 2.0 / bounds.diagonal();
    let unit =
        |axis: usize, length: f64| std::array::from_fn(|i| if i == axis { length } else { 0.0 });
    let rotations = if mesh.dimension == 2 { 2..3 } else { 0..3 };
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
    (0..mesh.dimension)
        .map(translation)
        .chain(rotations.map(rotation))
        .collect()
}

/// The rigid motions of a connected mesh that vanish at all prescribed dofs: a basis, empty when
/// the supports hold the body.
///
/// Where the supports leave a translation along an axis or a rotation about one, the basis may mix
/// several of them, but translations alone are listed before motions that turn.
pub fn remaining(mesh: &Mesh, dofs: &DofMap) -> Vec<RigidMotion> {
    let all = motions(mesh);
    // Two stages, translations first, so that what is a pure translation is reported as one.
    let translations = null_motions(mesh, dofs, &all[..mesh.dimension], &[]);
    let turning = null_motions(mesh, dofs, &all, &translations);
    translations.into_iter().chain(turning).collect()
}

/// Basis of the combinations of `candidates` that vanish at prescribed dofs and are orthogonal (as
/// coefficients) to `except`.
fn null_motions(
    mesh: &Mesh,
    dofs: &DofMap,
    candidates: &[RigidMotion],
    except: &[RigidMotion],
) -> Vec<RigidMotion> {
    // Gram matrix of the candidates restricted to the prescribed dofs; unused rows are made regular.
    let mut gram = [[0.0; 6]; 6];
    let mut add = |row: [f64; 6]| {
        for k in 0..6 {
            for l in 0..6 {
                gram[k][l] += row[k] * row[l];
            }
        }
    };
    for dof in dofs.prescribed() {
        let (node, component) = (dof / dofs.components(), dof % dofs.components());
        let mut row = [0.0; 6];
        for (entry, motion) in row.iter_mut().zip(candidates) {
            *entry = motion.at(mesh.points[node])[component];
        }
        add(row);
    }
    for motion in except {
        // `except` holds translations, and the first candidates are the unit translations.
        let mut row = [0.0; 6];
        row[..3].copy_from_slice(&motion.translation);
        add(row);
    }
    for k in candidates.len()..6 {
        add(std::array::from_fn(|l| if l == k { 1.0 } else { 0.0 }));
    }
    let (values, vectors) = symmetric_eigen(gram);
    let largest = values.iter().fold(0.0_f64, |a, &b| a.max(b));
    (0..6)
        // Squares of singular values: a motion counts as held when a support sees more than 1e-6 of it.
        .filter(|&k| values[k] <= 1e-12 * largest)
        .map(|k| combine(candidates, &vectors[k]))
        .collect()
}

fn combine(motions: &[RigidMotion], coefficients: &[f64; 6]) -> RigidMotion {
    let clean = |x: f64| if x.abs() < 1e-9 { 0.0 } else { x };
    let mut sum = RigidMotion {
        translation: [0.0; 3],
        rotation: [0.0; 3],
        center: motions[0].center,
    };
    for (motion, &c) in motions.iter().zip(coefficients) {
        for i in 0..3 {
            sum.translation[i] += clean(c) * motion.translation[i];
            sum.rotation[i] += clean(c) * motion.rotation[i];
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{BrickSpec, brick};
    use crate::supports::Supports;

    fn block() -> Mesh {
        brick(&BrickSpec {
            min: [0.0; 3],
            max: [2.0, 1.0, 1.0],
            nodes: [3, 3, 3],
        })
        .unwrap()
    }

    #[test]
    fn supports_take_away_motions_one_by_one() {
        let mesh = block();
        let mut supports = Supports::new(mesh.node_count(), 3);
        let left = |supports: &Supports| remaining(&mesh, &DofMap::new(supports));
        assert_eq!(left(&supports).len(), 6);

        supports.hold(&mesh.nodes_of_set("z-").unwrap(), 2).unwrap();
        let motions = left(&supports);
        assert_eq!(motions.len(), 3);
        assert_eq!(
            motions[2].to_string().split(" through").next(),
            Some("rotation about (0, 0, 1)")
        );

        supports.hold(&mesh.nodes_of_set("x-").unwrap(), 0).unwrap();
        let motions = left(&supports);
        assert_eq!(motions.len(), 1);
        assert_eq!(motions[0].to_string(), "translation along (0, 1, 0)");
        for dof in DofMap::new(&supports).prescribed() {
            assert!(motions[0].displacement(&mesh)[dof].abs() < 1e-12);
        }

        supports.prescribe(0, 1, 0.1).unwrap();
        assert!(left(&supports).is_empty());
    }

    #[test]
    fn a_hinge_leaves_a_rotation_about_its_axis() {
        let mesh = block();
        let mut supports = Supports::new(mesh.node_count(), 3);
        // The edge x = 0, z = 0.
        supports.clamp(&[0, 3, 6]).unwrap();
        let motions = remaining(&mesh, &DofMap::new(&supports));
        assert_eq!(motions.len(), 1);
        assert_eq!(motions[0].rotation.map(|x| x != 0.0), [false, true, false]);
        let (u, on_axis) = (
            motions[0].displacement(&mesh),
            motions[0].at([0.0, 7.0, 0.0]),
        );
        assert!(on_axis.iter().all(|x| x.abs() < 1e-12));
        assert!(u.iter().any(|x| x.abs() > 0.1));
        assert!(
            motions[0]
                .to_string()
                .contains("through (0.0000, 0.5000, 0.0000)"),
            "{}",
            motions[0]
        );
    }
}
