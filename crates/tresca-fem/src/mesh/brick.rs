//! The structured brick of hexahedra.

use super::data::{CellBlock, Face, Mesh};
use super::grid;
use super::kind::CellKind;
use super::space::Space;
use crate::error::FemError;
use std::collections::BTreeMap;

/// An axis-parallel box divided into equal hexahedra.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrickSpec {
    /// Lowest corner.
    pub min: [f64; 3],
    /// Highest corner.
    pub max: [f64; 3],
    /// Nodes along x, y, z; at least 2 each.
    pub nodes: [usize; 3],
}

/// Meshes a brick with hex8 cells. Nodes and cells are numbered with x fastest, z slowest; the
/// face sets are "x-", "x+", "y-", "y+", "z-", "z+".
///
/// Two bricks that share a face and the node counts on it have the same coordinates there bit for
/// bit, as long as their bounds are equal.
///
/// # Errors
/// [`FemError::TooFewNodes`], [`FemError::EmptyBox`].
pub fn brick(spec: &BrickSpec) -> Result<Mesh, FemError> {
    let [nx, ny, nz] = spec.nodes;
    grid::check(&spec.min, &spec.max, &spec.nodes)?;

    let coordinate = |axis: usize, i: usize| {
        grid::coordinate(spec.min[axis], spec.max[axis], spec.nodes[axis], i)
    };
    let node = |i: usize, j: usize, k: usize| i + nx * (j + ny * k);
    let mut points = Vec::with_capacity(nx * ny * nz);
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                points.push([coordinate(0, i), coordinate(1, j), coordinate(2, k)]);
            }
        }
    }

    let mut connectivity = Vec::with_capacity(8 * (nx - 1) * (ny - 1) * (nz - 1));
    let mut face_sets: BTreeMap<String, Vec<Face>> = BTreeMap::new();
    let mut cell = 0;
    for k in 0..nz - 1 {
        for j in 0..ny - 1 {
            for i in 0..nx - 1 {
                for k in [k, k + 1] {
                    connectivity.extend([
                        node(i, j, k),
                        node(i + 1, j, k),
                        node(i + 1, j + 1, k),
                        node(i, j + 1, k),
                    ]);
                }
                let on_surface = [
                    i == 0,
                    i + 2 == nx,
                    j == 0,
                    j + 2 == ny,
                    k == 0,
                    k + 2 == nz,
                ];
                for (local, name) in ["x-", "x+", "y-", "y+", "z-", "z+"].into_iter().enumerate() {
                    if on_surface[local] {
                        face_sets
                            .entry(name.to_owned())
                            .or_default()
                            .push(Face { cell, local });
                    }
                }
                cell += 1;
            }
        }
    }
    Mesh::new(
        Space::Solid,
        points,
        vec![CellBlock {
            kind: CellKind::Hex8,
            connectivity,
        }],
        face_sets,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEC: BrickSpec = BrickSpec {
        min: [-1.0, 0.5, 2.0],
        max: [1.0, 1.25, 5.0],
        nodes: [4, 3, 5],
    };

    #[test]
    fn counts_and_bounds() {
        let mesh = brick(&SPEC).unwrap();
        assert_eq!(mesh.node_count(), 60);
        assert_eq!(mesh.cell_count(), 24);
        assert_eq!(mesh.face_sets["y-"].len(), 12);
        let bounds = mesh.bounding_box();
        assert_eq!((bounds.min, bounds.max), (SPEC.min, SPEC.max));
        assert!((mesh.volume() - 4.5).abs() < 1e-13);
    }

    #[test]
    fn face_sets_lie_on_their_planes_with_outward_area() {
        let mesh = brick(&SPEC).unwrap();
        for (axis, letter) in ['x', 'y', 'z'].into_iter().enumerate() {
            let size = [2.0, 0.75, 3.0];
            let area = size.iter().product::<f64>() / size[axis];
            for (sign, plane) in [(-1.0, SPEC.min[axis]), (1.0, SPEC.max[axis])] {
                let name = format!("{letter}{}", if sign < 0.0 { '-' } else { '+' });
                let faces = mesh.faces_of_set(&name).unwrap();
                for &node in &mesh.nodes_of_set(&name).unwrap() {
                    assert_eq!(mesh.points[node][axis], plane);
                }
                let total = mesh.area_vector(faces);
                for i in 0..3 {
                    let expected = if i == axis { sign * area } else { 0.0 };
                    assert!((total[i] - expected).abs() < 1e-13, "{name}: {total:?}");
                }
            }
        }
    }

    #[test]
    fn the_sets_are_the_whole_boundary() {
        let mesh = brick(&SPEC).unwrap();
        let mut of_sets: Vec<Face> = mesh.face_sets.values().flatten().copied().collect();
        of_sets.sort_unstable();
        assert_eq!(mesh.boundary_faces(), of_sets);
    }

    #[test]
    fn senseless_bricks_are_refused() {
        let error = brick(&BrickSpec {
            nodes: [4, 1, 5],
            ..SPEC
        })
        .unwrap_err();
        assert_eq!(
            error,
            FemError::TooFewNodes {
                axis: 'y',
                found: 1
            }
        );
        for max in [2.0, 1.0, f64::NAN, f64::INFINITY] {
            let error = brick(&BrickSpec {
                max: [1.0, 1.25, max],
                ..SPEC
            })
            .unwrap_err();
            assert!(
                matches!(error, FemError::EmptyBox { axis: 'z', .. }),
                "{error}"
            );
        }
    }
}
