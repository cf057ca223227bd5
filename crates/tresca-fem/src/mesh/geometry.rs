//! Measures of a mesh: volumes, area vectors, bounds.

use super::data::{Face, Mesh};
use super::kind::CellKind;
use super::space::Space;
use crate::element::table::{ShapeTable, interpolate, jacobian};
use crate::matrix3::determinant;
use crate::vector3::{cross, norm};

/// The smallest axis-parallel box around a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundingBox {
    /// Lowest corner.
    pub min: [f64; 3],
    /// Highest corner.
    pub max: [f64; 3],
}

impl BoundingBox {
    /// The box around some points; empty (min > max) without points.
    pub fn around(points: impl IntoIterator<Item = [f64; 3]>) -> Self {
        let start = Self {
            min: [f64::INFINITY; 3],
            max: [f64::NEG_INFINITY; 3],
        };
        points.into_iter().fold(start, |bounds, p| Self {
            min: std::array::from_fn(|i| bounds.min[i].min(p[i])),
            max: std::array::from_fn(|i| bounds.max[i].max(p[i])),
        })
    }

    /// Length of the diagonal: the length scale of a body.
    pub fn diagonal(&self) -> f64 {
        norm(std::array::from_fn(|i| self.max[i] - self.min[i]))
    }
}

/// det of the Jacobian with the given columns: a volume in space, an area in the plane.
pub(crate) fn cell_determinant(dimension: usize, columns: &[[f64; 3]; 3]) -> f64 {
    match dimension {
        2 => columns[0][0] * columns[1][1] - columns[0][1] * columns[1][0],
        _ => determinant(columns),
    }
}

impl Mesh {
    /// The smallest axis-parallel box around all points; empty (min > max) without points.
    pub fn bounding_box(&self) -> BoundingBox {
        BoundingBox::around(self.points.iter().copied())
    }

    /// Volume of every cell (area in the plane, the ring's volume in an axisymmetric space), negative
    /// for a cell that is turned inside out.
    pub fn cell_volumes(&self) -> Vec<f64> {
        let mut volumes = vec![0.0; self.cell_count()];
        self.for_each_cell_point(|point| volumes[point.cell] += point.volume);
        volumes
    }

    /// Volume of the body (area in the plane).
    pub fn volume(&self) -> f64 {
        self.cell_volumes().iter().sum()
    }

    /// The centre of the volume, ∫ x dΩ / |Ω|: the centre of mass of a body of one density. On the axis
    /// in an axisymmetric space.
    pub fn centroid(&self) -> [f64; 3] {
        let (mut volume, mut moment) = (0.0, [0.0; 3]);
        self.for_each_cell_point(|point| {
            volume += point.volume;
            for i in 0..3 {
                moment[i] += point.volume * point.position[i];
            }
        });
        if self.space == Space::Axisymmetric {
            moment[0] = 0.0;
        }
        moment.map(|x| x / volume)
    }

    /// Visits the points of the cells' mass rules, cell after cell.
    pub(crate) fn for_each_cell_point(&self, mut visit: impl FnMut(CellPoint<'_>)) {
        let mut cell = 0;
        for block in &self.cells {
            let table = ShapeTable::mass(block.kind);
            let mut points = vec![[0.0; 3]; table.nodes];
            for nodes in block.cells() {
                gather_points(self, nodes, &mut points);
                for q in 0..table.len() {
                    let columns = jacobian(table.gradients(q), &points);
                    let position = interpolate(table.values(q), &points);
                    let determinant = cell_determinant(self.dimension(), &columns);
                    visit(CellPoint {
                        cell,
                        nodes,
                        values: table.values(q),
                        position,
                        volume: table.weights[q] * determinant * self.space.circumference(position),
                    });
                }
                cell += 1;
            }
        }
    }

    /// ∫ n dΓ over some faces, n the outward unit normal. For a plane face its length is the area.
    ///
    /// In an axisymmetric space n is taken in the meridian plane, so that the first entry is the area
    /// seen in radial direction, not the sum of vectors around the axis, which is zero.
    pub fn area_vector(&self, faces: &[Face]) -> [f64; 3] {
        let mut total = [0.0; 3];
        FaceTables::new(self).for_each_point(faces, |point| {
            for i in 0..3 {
                total[i] += point.area[i];
            }
        });
        total
    }

    /// Area of some faces, ∫ dΓ.
    pub fn area(&self, faces: &[Face]) -> f64 {
        let mut total = 0.0;
        FaceTables::new(self).for_each_point(faces, |point| total += norm(point.area));
        total
    }
}

/// Copies the coordinates of a cell's nodes.
pub(crate) fn gather_points(mesh: &Mesh, nodes: &[usize], points: &mut [[f64; 3]]) {
    for (point, &node) in points.iter_mut().zip(nodes) {
        *point = mesh.points[node];
    }
}

/// An integration point of a cell.
pub(crate) struct CellPoint<'a> {
    /// Number of the cell.
    pub cell: usize,
    /// Its node numbers.
    pub nodes: &'a [usize],
    /// φ_a of the cell's nodes.
    pub values: &'a [f64],
    /// The point.
    pub position: [f64; 3],
    /// dΩ, weight (and circumference) included.
    pub volume: f64,
}

/// An integration point of a face.
pub(crate) struct FacePoint<'a> {
    /// Node numbers of the face.
    pub nodes: &'a [usize],
    /// φ_a of the face's nodes.
    pub values: &'a [f64],
    /// The point.
    pub position: [f64; 3],
    /// n dΓ, weight (and circumference) included: its length is the share of the area.
    pub area: [f64; 3],
}

/// Tabulated face elements of a mesh.
pub(crate) struct FaceTables<'a> {
    mesh: &'a Mesh,
    tables: Vec<(CellKind, ShapeTable)>,
}

impl<'a> FaceTables<'a> {
    /// Tabulates every face kind that occurs in the mesh at its mass rule.
    pub fn new(mesh: &'a Mesh) -> Self {
        let mut tables: Vec<(CellKind, ShapeTable)> = Vec::new();
        for face in mesh.cells.iter().flat_map(|block| block.kind.faces()) {
            if tables.iter().all(|(kind, _)| *kind != face.kind) {
                tables.push((face.kind, ShapeTable::mass(face.kind)));
            }
        }
        Self { mesh, tables }
    }

    /// Visits the integration points of some faces, face after face.
    pub fn for_each_point(&self, faces: &[Face], mut visit: impl FnMut(FacePoint<'_>)) {
        for &face in faces {
            let nodes = self.mesh.face_nodes(face);
            let points: Vec<[f64; 3]> = nodes.iter().map(|&node| self.mesh.points[node]).collect();
            let kind = self.mesh.face_kind(face);
            for (_, table) in self.tables.iter().filter(|(k, _)| *k == kind) {
                for q in 0..table.len() {
                    let [t1, t2, _] = jacobian(table.gradients(q), &points);
                    let normal = match self.mesh.dimension() {
                        2 => [t1[1], -t1[0], 0.0],
                        _ => cross(t1, t2),
                    };
                    let position = interpolate(table.values(q), &points);
                    let weight = table.weights[q] * self.mesh.space.circumference(position);
                    visit(FacePoint {
                        nodes: &nodes,
                        values: table.values(q),
                        position,
                        area: normal.map(|x| x * weight),
                    });
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::data::{CellBlock, Mesh};
    use crate::mesh::kind::CellKind;
    use crate::mesh::rectangle::{RectangleSpec, rectangle};
    use crate::mesh::space::Space;
    use std::collections::BTreeMap;

    #[test]
    fn a_closed_surface_has_no_area_vector_and_the_divergence_theorem_holds() {
        let mut mesh = brick(&BrickSpec {
            min: [0.0; 3],
            max: [1.0; 3],
            nodes: [4, 4, 4],
        })
        .unwrap();
        for p in &mut mesh.points {
            let [x, y, z] = *p;
            *p = [x + 0.1 * y * z, y + 0.2 * (3.0 * x).sin(), z - 0.1 * x * x];
        }
        let surface = mesh.boundary_faces();
        let total = mesh.area_vector(&surface);
        assert!(total.iter().all(|x| x.abs() < 1e-14), "{total:?}");
        // ∫ x·n dΓ = 3 |Ω|
        let mut flux = 0.0;
        super::FaceTables::new(&mesh).for_each_point(&surface, |p| {
            for (&node, value) in p.nodes.iter().zip(p.values) {
                flux += value * crate::vector3::dot(mesh.points[node], p.area);
            }
        });
        assert!((flux - 3.0 * mesh.volume()).abs() < 1e-13);
    }

    #[test]
    fn a_plane_mesh_has_areas_and_outward_edges() {
        let points = vec![
            [0.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [3.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
        ];
        let block = CellBlock {
            kind: CellKind::Quad4,
            connectivity: vec![0, 1, 2, 3],
        };
        let mesh = Mesh::new(Space::Plane, points, vec![block], BTreeMap::new()).unwrap();
        assert!((mesh.volume() - 2.0).abs() < 1e-15);
        let faces = mesh.boundary_faces();
        let bottom = mesh.area_vector(&faces[..1]);
        assert!(
            (bottom[1] + 2.0).abs() < 1e-15 && bottom[0] == 0.0,
            "{bottom:?}"
        );
        assert!((mesh.area(&faces) - 4.0 - 2.0 * 2f64.sqrt()).abs() < 1e-14);
        let total = mesh.area_vector(&faces);
        assert!(total.iter().all(|x| x.abs() < 1e-15));
    }

    #[test]
    fn the_divergence_theorem_holds_for_a_body_of_revolution() {
        for cells in [CellKind::Quad4, CellKind::Tri3] {
            let mesh = rectangle(&RectangleSpec {
                space: Space::Axisymmetric,
                min: [0.0, -1.0],
                max: [1.0, 2.0],
                nodes: [4, 5],
                cells,
            })
            .unwrap()
            .mapped(|[x, y, _]| [x * (1.0 + 0.1 * y * y), y + 0.2 * x * x, 0.0])
            .unwrap();
            mesh.check_cells().unwrap();
            // ∫ x·n dΓ = 3 |Ω| with x = (r, y): the faces on the axis have no area.
            let mut flux = 0.0;
            super::FaceTables::new(&mesh).for_each_point(&mesh.boundary_faces(), |p| {
                flux += crate::vector3::dot(p.position, p.area);
            });
            assert!((flux - 3.0 * mesh.volume()).abs() < 1e-13 * flux);
            // ∫ n_y dΓ = 0 over a closed surface.
            assert!(mesh.area_vector(&mesh.boundary_faces())[1].abs() < 1e-13);
        }
    }

    #[test]
    fn curved_cells_have_curved_measures() {
        // A quarter of a tube 1 ≤ r ≤ 2 of length 3, its ends turned by the map from bricks.
        let quarter = |n: usize, kind: CellKind| {
            let spec = BrickSpec {
                min: [1.0, 0.0, 0.0],
                max: [2.0, std::f64::consts::FRAC_PI_2, 3.0],
                nodes: [2, n + 1, 2],
            };
            let straight = brick(&spec).unwrap().with_cells(kind).unwrap();
            straight
                .mapped(|[r, angle, z]| [r * angle.cos(), r * angle.sin(), z])
                .unwrap()
        };
        let pi = std::f64::consts::PI;
        for kind in [CellKind::Tet10, CellKind::Hex20, CellKind::Hex27] {
            let errors = [4, 8].map(|n| {
                let mesh = quarter(n, kind);
                mesh.check_cells().unwrap();
                let outside = mesh.area(mesh.faces_of_set("x+").unwrap());
                let centroid = mesh.centroid();
                // The centroid of a ring's quarter: 4/(3π) (b³ − a³)/(b² − a²) from the axes.
                let arm = 4.0 / (3.0 * pi) * 7.0 / 3.0;
                [
                    mesh.volume() / (0.75 * pi * 3.0) - 1.0,
                    outside / (3.0 * pi) - 1.0,
                    centroid[0] / arm - 1.0,
                    centroid[1] / arm - 1.0,
                ]
                .map(f64::abs)
            });
            for k in 0..4 {
                // A parabola through three points of an arc is of fourth order.
                let rate = (errors[0][k] / errors[1][k]).log2();
                assert!(errors[1][k] < 1e-5 && rate > 3.7, "{kind}: {errors:?}");
            }
            assert!((quarter(2, kind).centroid()[2] - 1.5).abs() < 1e-13);
        }
    }

    #[test]
    fn centroids_are_those_of_the_space() {
        for cells in [CellKind::Tri3, CellKind::Quad4] {
            for (space, x, y) in [(Space::Plane, 2.5, 1.0), (Space::Axisymmetric, 0.0, 1.0)] {
                let mesh = rectangle(&RectangleSpec {
                    space,
                    min: [1.0, 0.0],
                    max: [4.0, 2.0],
                    nodes: [4, 3],
                    cells,
                })
                .unwrap();
                let centroid = mesh.centroid();
                assert!((centroid[0] - x).abs() + (centroid[1] - y).abs() < 1e-14);
                assert_eq!(centroid[2], 0.0);
            }
        }
    }

    #[test]
    fn an_inverted_cell_has_negative_volume() {
        let mut mesh = brick(&BrickSpec {
            min: [0.0; 3],
            max: [1.0; 3],
            nodes: [2, 2, 2],
        })
        .unwrap();
        mesh.cells[0].connectivity.swap(0, 4);
        mesh.cells[0].connectivity.swap(1, 5);
        mesh.cells[0].connectivity.swap(2, 6);
        mesh.cells[0].connectivity.swap(3, 7);
        assert!((mesh.volume() + 1.0).abs() < 1e-15);
        assert!(matches!(
            mesh.check_cells(),
            Err(crate::FemError::InvertedCell { cell: 0, .. })
        ));
    }
}
