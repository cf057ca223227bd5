//! What supports leave of the rigid motions of a mesh.

use super::coupled;
use super::free::FreeMotion;
use super::motion::{RigidMotion, combine, motions};
use crate::dofs::DofMap;
use crate::matrix3::symmetric_eigen;
use crate::mesh::data::Mesh;
use crate::mesh::parts::Part;
use crate::vector3::dot;
use std::sync::Arc;

/// The rigid motions of a mesh that vanish at all prescribed dofs and satisfy all equations (with right sides
/// of zero): a basis, part after part, empty when the supports hold the body. Parts that equations couple move
/// together, in motions that are one's own for each of them.
///
/// Where the supports leave a translation along an axis or a rotation about one, the basis may mix
/// several of them, but translations alone are listed before motions that turn. Motions are
/// normalised like [`motions`].
pub fn remaining(mesh: &Mesh, dofs: &DofMap) -> Vec<FreeMotion> {
    let parts = mesh.parts();
    if dofs.has_equations() {
        return coupled::remaining(mesh, dofs, &parts);
    }
    let count = parts.len();
    let of_part = |(index, part): (usize, Part)| {
        let all = motions(mesh, &part);
        let turning = all.iter().position(|m| m.rotation != [0.0; 3]);
        // Two stages, translations first, so that what is a pure translation is reported as one.
        let (held, first) = (
            Held {
                mesh,
                dofs,
                part: &part,
            },
            turning.unwrap_or(all.len()),
        );
        let translations = held.null_motions(&all[..first], &[]);
        let turning = held.null_motions(&all, &translations);
        let nodes: Arc<[usize]> = part.nodes.into();
        translations
            .into_iter()
            .chain(turning)
            .map(move |motion| FreeMotion::of_part(index, count, motion, nodes.clone()))
    };
    parts.into_iter().enumerate().flat_map(of_part).collect()
}

/// The supports of one part.
struct Held<'a> {
    mesh: &'a Mesh,
    dofs: &'a DofMap,
    part: &'a Part,
}

impl Held<'_> {
    /// Basis of the combinations of `candidates` that vanish at the part's prescribed dofs and are
    /// orthogonal (as coefficients) to the translations `except`.
    fn null_motions(&self, candidates: &[RigidMotion], except: &[RigidMotion]) -> Vec<RigidMotion> {
        // Gram matrix of the candidates restricted to the prescribed dofs; unused rows are made
        // regular.
        let mut gram = [[0.0; 6]; 6];
        let mut add = |row: [f64; 6]| {
            for k in 0..6 {
                for l in 0..6 {
                    gram[k][l] += row[k] * row[l];
                }
            }
        };
        let mut add_values = |value: &dyn Fn(&RigidMotion) -> f64| {
            let mut row = [0.0; 6];
            for (entry, motion) in row.iter_mut().zip(candidates) {
                *entry = value(motion);
            }
            add(row);
        };
        for &node in &self.part.nodes {
            for component in 0..self.dofs.components() {
                if self.dofs.free(node, component).is_none() {
                    add_values(&|motion| motion.at(self.mesh.points[node])[component]);
                }
            }
        }
        for motion in except {
            // Candidates translate by unit vectors or not at all: these are the coefficients.
            add_values(&|candidate| dot(candidate.translation, motion.translation));
        }
        for k in candidates.len()..6 {
            add(std::array::from_fn(|l| if l == k { 1.0 } else { 0.0 }));
        }
        let (values, vectors) = symmetric_eigen(gram);
        let largest = values.iter().fold(0.0_f64, |a, &b| a.max(b));
        (0..6)
            // Squares of singular values: a motion counts as held when a support sees more than 1e-6
            // of it.
            .filter(|&k| values[k] <= 1e-12 * largest)
            .map(|k| combine(candidates, &vectors[k]))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::kind::CellKind;
    use crate::mesh::rectangle::{RectangleSpec, rectangle};
    use crate::mesh::space::Space;
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
        let motion = motions[0].motion;
        assert_eq!(motion.rotation.map(|x| x != 0.0), [false, true, false]);
        let (u, on_axis) = (motions[0].displacement(&mesh), motion.at([0.0, 7.0, 0.0]));
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

    #[test]
    fn plane_and_axisymmetric_bodies_have_three_motions_and_one() {
        let mesh = |space| {
            rectangle(&RectangleSpec {
                space,
                min: [0.0, 0.0],
                max: [3.0, 4.0],
                nodes: [4, 4],
                cells: CellKind::Tri3,
            })
            .unwrap()
        };
        let names = |mesh: &Mesh, supports: &Supports| -> Vec<String> {
            let motions = remaining(mesh, &DofMap::new(supports));
            motions.iter().map(ToString::to_string).collect()
        };
        let plane = mesh(Space::Plane);
        let mut supports = Supports::new(16, 2);
        assert_eq!(names(&plane, &supports).len(), 3);
        supports.clamp(&[5]).unwrap();
        assert_eq!(
            names(&plane, &supports),
            ["rotation about (0, 0, 1) through (1.0000, 1.3333, 0.0000)"]
        );
        supports.hold(&[6], 1).unwrap();
        assert!(names(&plane, &supports).is_empty());

        let ring = mesh(Space::Axisymmetric);
        let mut supports = Supports::new(16, 2);
        supports.hold(&[0, 4, 8, 12], 0).unwrap();
        assert_eq!(names(&ring, &supports), ["translation along (0, 1, 0)"]);
        supports.hold(&[3], 1).unwrap();
        assert!(names(&ring, &supports).is_empty());
    }

    #[test]
    fn parts_move_on_their_own() {
        let mut mesh = block();
        // Of the 2 × 2 × 2 cells of unit (1, ½, ½) take those with z > ½ apart: a copy of the
        // interface nodes for the upper ones.
        let copies: Vec<usize> = (9..18).collect();
        let offset = mesh.node_count() - 9;
        for node in &copies {
            mesh.points.push(mesh.points[*node]);
        }
        for node in &mut mesh.cells[0].connectivity[4 * 8..] {
            if (9..18).contains(node) {
                *node += offset;
            }
        }
        mesh.validate().unwrap();
        let mut supports = Supports::new(mesh.node_count(), 3);
        supports.clamp(&mesh.nodes_of_set("z-").unwrap()).unwrap();
        let motions = remaining(&mesh, &DofMap::new(&supports));
        assert_eq!(motions.len(), 6);
        for motion in &motions {
            assert_eq!((motion.part, motion.parts), (1, 2));
            assert!(motion.to_string().ends_with(" of part 2 of 2"), "{motion}");
            let u = motion.displacement(&mesh);
            assert!(u[..18 * 3].iter().all(|&x| x == 0.0));
            let largest = u.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
            assert!((0.3..=1.5).contains(&largest), "{motion}: {largest}");
        }
    }
}
