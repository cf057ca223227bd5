//! The structured rectangle of quadrilaterals or triangles.

use super::data::{CellBlock, Face, Mesh};
use super::grid;
use super::kind::CellKind;
use super::space::Space;
use crate::error::FemError;
use std::collections::BTreeMap;

/// An axis-parallel rectangle divided into equal cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectangleSpec {
    /// [`Space::Plane`] or [`Space::Axisymmetric`].
    pub space: Space,
    /// Lowest corner.
    pub min: [f64; 2],
    /// Highest corner.
    pub max: [f64; 2],
    /// Nodes along x and y; at least 2 each.
    pub nodes: [usize; 2],
    /// [`CellKind::Quad4`] or [`CellKind::Tri3`]. A triangle is half a quadrilateral, cut from its
    /// lower left to its upper right corner.
    pub cells: CellKind,
}

/// Meshes a rectangle. Nodes and cells are numbered with x fastest (of two triangles the lower one
/// first); the face sets are "x-", "x+", "y-", "y+".
///
/// Two rectangles that share an edge and the node count on it have the same coordinates there bit
/// for bit, as long as their bounds are equal.
///
/// # Errors
/// [`FemError::TooFewNodes`], [`FemError::EmptyBox`], [`FemError::RectangleCells`];
/// [`FemError::SolidRectangle`] for [`Space::Solid`]; [`FemError::NegativeRadius`].
pub fn rectangle(spec: &RectangleSpec) -> Result<Mesh, FemError> {
    if spec.space == Space::Solid {
        return Err(FemError::SolidRectangle);
    }
    grid::check(&spec.min, &spec.max, &spec.nodes)?;
    let [nx, ny] = spec.nodes;
    let points = (0..ny)
        .flat_map(|j| (0..nx).map(move |i| [i, j]))
        .map(|index| {
            let [x, y] = std::array::from_fn(|axis| {
                let (min, max) = (spec.min[axis], spec.max[axis]);
                grid::coordinate(min, max, spec.nodes[axis], index[axis])
            });
            [x, y, 0.0]
        })
        .collect();

    let Tile { corners, sides } = Tile::of(spec.cells)?;
    let mut connectivity = Vec::new();
    let mut face_sets: BTreeMap<String, Vec<Face>> = BTreeMap::new();
    let mut first = 0;
    for j in 0..ny - 1 {
        for i in 0..nx - 1 {
            let node = i + nx * j;
            let quadrilateral = [node, node + 1, node + nx + 1, node + nx];
            let of_cells = corners.iter().flat_map(|cell| cell.iter());
            connectivity.extend(of_cells.map(|&a| quadrilateral[a]));
            let on_edge = [i == 0, i + 2 == nx, j == 0, j + 2 == ny];
            for (side, name) in ["x-", "x+", "y-", "y+"].into_iter().enumerate() {
                if on_edge[side] {
                    let Face { cell, local } = sides[side];
                    let cell = first + cell;
                    let set = face_sets.entry(name.to_owned()).or_default();
                    set.push(Face { cell, local });
                }
            }
            first += corners.len();
        }
    }
    let block = CellBlock {
        kind: spec.cells,
        connectivity,
    };
    Mesh::new(spec.space, points, vec![block], face_sets)
}

/// How cells fill one quadrilateral of the grid.
struct Tile {
    /// For each cell, which of the four corners (counter-clockwise) are its nodes.
    corners: &'static [&'static [usize]],
    /// The faces on the sides x-, x+, y-, y+; cells are counted within the tile.
    sides: [Face; 4],
}

impl Tile {
    fn of(kind: CellKind) -> Result<Self, FemError> {
        let (corners, sides): (&[&[usize]], _) = match kind {
            CellKind::Quad4 => (&[&[0, 1, 2, 3]], [(0, 3), (0, 1), (0, 0), (0, 2)]),
            CellKind::Tri3 => (&[&[0, 1, 2], &[0, 2, 3]], [(1, 2), (0, 1), (0, 0), (1, 1)]),
            kind => return Err(FemError::RectangleCells { kind }),
        };
        let sides = sides.map(|(cell, local)| Face { cell, local });
        Ok(Self { corners, sides })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEC: RectangleSpec = RectangleSpec {
        space: Space::Plane,
        min: [0.5, -1.0],
        max: [2.0, 1.0],
        nodes: [4, 3],
        cells: CellKind::Quad4,
    };

    #[test]
    fn counts_measures_and_outward_edges() {
        for (cells, count) in [(CellKind::Quad4, 6), (CellKind::Tri3, 12)] {
            let mesh = rectangle(&RectangleSpec { cells, ..SPEC }).unwrap();
            assert_eq!((mesh.node_count(), mesh.cell_count()), (12, count));
            mesh.check_cells().unwrap();
            assert!((mesh.volume() - 3.0).abs() < 1e-14);
            for (name, area) in [
                ("x-", [-2.0, 0.0]),
                ("x+", [2.0, 0.0]),
                ("y-", [0.0, -1.5]),
                ("y+", [0.0, 1.5]),
            ] {
                let total = mesh.area_vector(mesh.faces_of_set(name).unwrap());
                assert!(
                    (0..2).all(|i| (total[i] - area[i]).abs() < 1e-14),
                    "{name}: {total:?}"
                );
                let axis = usize::from(name.starts_with('y'));
                let bound = if name.ends_with('-') {
                    SPEC.min
                } else {
                    SPEC.max
                }[axis];
                for node in mesh.nodes_of_set(name).unwrap() {
                    assert_eq!(mesh.points[node][axis], bound);
                }
            }
            let mut of_sets: Vec<Face> = mesh.face_sets.values().flatten().copied().collect();
            of_sets.sort_unstable();
            assert_eq!(mesh.boundary_faces(), of_sets);
        }
    }

    #[test]
    fn an_axisymmetric_rectangle_is_a_tube() {
        for cells in [CellKind::Quad4, CellKind::Tri3] {
            let space = Space::Axisymmetric;
            let mesh = rectangle(&RectangleSpec {
                space,
                cells,
                ..SPEC
            })
            .unwrap();
            let pi = std::f64::consts::PI;
            assert!((mesh.volume() - pi * (4.0 - 0.25) * 2.0).abs() < 1e-13);
            let outside = mesh.faces_of_set("x+").unwrap();
            assert!((mesh.area(outside) - 2.0 * pi * 2.0 * 2.0).abs() < 1e-13);
            let top = mesh.faces_of_set("y+").unwrap();
            assert!((mesh.area(top) - pi * (4.0 - 0.25)).abs() < 1e-13);
        }
    }

    #[test]
    fn senseless_rectangles_are_refused() {
        let refused = |spec: RectangleSpec| rectangle(&spec).unwrap_err();
        let few = refused(RectangleSpec {
            nodes: [1, 3],
            ..SPEC
        });
        assert_eq!(
            few,
            FemError::TooFewNodes {
                axis: 'x',
                found: 1
            }
        );
        let empty = refused(RectangleSpec {
            max: [2.0, f64::NAN],
            ..SPEC
        });
        assert!(matches!(empty, FemError::EmptyBox { axis: 'y', .. }));
        let cells = refused(RectangleSpec {
            cells: CellKind::Hex8,
            ..SPEC
        });
        assert_eq!(
            cells,
            FemError::RectangleCells {
                kind: CellKind::Hex8
            }
        );
        let solid = refused(RectangleSpec {
            space: Space::Solid,
            ..SPEC
        });
        assert_eq!(solid, FemError::SolidRectangle);
        let negative = refused(RectangleSpec {
            space: Space::Axisymmetric,
            min: [-0.5, -1.0],
            ..SPEC
        });
        assert_eq!(
            negative,
            FemError::NegativeRadius {
                node: 0,
                radius: -0.5
            }
        );
    }
}
