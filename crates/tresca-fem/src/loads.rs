//! Consistent nodal loads, and what they add up to.
//!
//! A load is a vector over the full dofs. Its entries are forces: per unit thickness in the plane, of
//! the full circumference in an axisymmetric space (where the given vectors are radial, axial).

use crate::mesh::data::{Face, Mesh};
use crate::mesh::geometry::FaceTables;
use crate::mesh::space::Space;
use crate::vector3::{cross, norm, sub};

/// f_a = ∫ φ_a t dΓ for a constant traction t (force per area) on some faces.
///
/// t is taken out of the integral: nodes that share an area get the same force to the last bit.
pub fn traction(mesh: &Mesh, faces: &[Face], traction: [f64; 3]) -> Vec<f64> {
    let areas = nodal_areas(mesh, faces).into_iter();
    areas
        .flat_map(|area| {
            traction
                .into_iter()
                .take(mesh.dimension())
                .map(move |t| area * t)
        })
        .collect()
}

/// f_a = ∫ φ_a t dΓ for a traction t (force per area) that depends on the point, by each face's mass
/// rule. What is no finite number enters the load as it is.
pub fn traction_field(
    mesh: &Mesh,
    faces: &[Face],
    traction: impl Fn([f64; 3]) -> [f64; 3],
) -> Vec<f64> {
    let d = mesh.dimension();
    let mut load = vec![0.0; mesh.dof_count()];
    FaceTables::new(mesh).for_each_point(faces, |point| {
        let (area, t) = (norm(point.area), traction(point.position));
        for (&node, value) in point.nodes.iter().zip(point.values) {
            for i in 0..d {
                load[d * node + i] += value * area * t[i];
            }
        }
    });
    load
}

/// f_a = −p ∫ φ_a n dΓ for a constant pressure p (force per area) on some faces: p > 0 presses on
/// the body, against the outward unit normal n.
pub fn pressure(mesh: &Mesh, faces: &[Face], pressure: f64) -> Vec<f64> {
    pressure_field(mesh, faces, |_| pressure)
}

/// f_a = −∫ φ_a p n dΓ for a pressure p that depends on the point, by each face's mass rule.
pub fn pressure_field(mesh: &Mesh, faces: &[Face], pressure: impl Fn([f64; 3]) -> f64) -> Vec<f64> {
    let d = mesh.dimension();
    let mut load = vec![0.0; mesh.dof_count()];
    FaceTables::new(mesh).for_each_point(faces, |point| {
        let p = pressure(point.position);
        for (&node, value) in point.nodes.iter().zip(point.values) {
            for i in 0..d {
                load[d * node + i] -= value * p * point.area[i];
            }
        }
    });
    load
}

/// ∫ φ_a dΓ over some faces, by node of the mesh; zero off the faces. The shares of a flat quadratic
/// face are uneven: zero at the corners of tri6, negative at those of quad8.
pub fn nodal_areas(mesh: &Mesh, faces: &[Face]) -> Vec<f64> {
    let mut areas = vec![0.0; mesh.node_count()];
    FaceTables::new(mesh).for_each_point(faces, |point| {
        let area = norm(point.area);
        for (&node, value) in point.nodes.iter().zip(point.values) {
            areas[node] += value * area;
        }
    });
    areas
}

/// ∫ φ_a n dΓ over some faces, by node of the mesh, n the outward unit normal; zero off the faces.
/// Its direction is the area-weighted mean normal of the faces at the node (in an axisymmetric space
/// the one in the meridian plane; a node on the axis has a share of the faces next to it).
pub fn nodal_area_vectors(mesh: &Mesh, faces: &[Face]) -> Vec<[f64; 3]> {
    let mut areas = vec![[0.0; 3]; mesh.node_count()];
    FaceTables::new(mesh).for_each_point(faces, |point| {
        for (&node, value) in point.nodes.iter().zip(point.values) {
            for i in 0..3 {
                areas[node][i] += value * point.area[i];
            }
        }
    });
    areas
}

/// f_a = ∫ φ_a b dΩ for a body force b (force per volume) given at points, by each cell's mass rule.
pub fn body_force(mesh: &Mesh, density: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<f64> {
    let d = mesh.dimension();
    let mut load = vec![0.0; mesh.dof_count()];
    mesh.for_each_cell_point(|point| {
        let b = density(point.position);
        for (&node, value) in point.nodes.iter().zip(point.values) {
            for i in 0..d {
                load[d * node + i] += value * point.volume * b[i];
            }
        }
    });
    load
}

/// Force and moment that a load adds up to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Resultant {
    /// Σ f_a.
    pub force: [f64; 3],
    /// Σ (x_a − x_0) × f_a about the point x_0 that was asked for.
    pub moment: [f64; 3],
}

/// Resultant of a load (full dofs) about the point `about`.
///
/// In an axisymmetric space the radial forces cancel around the circumference and no moment is left:
/// only the axial force is reported.
///
/// # Panics
/// When the load's length is not [`Mesh::dof_count`].
pub fn resultant(mesh: &Mesh, load: &[f64], about: [f64; 3]) -> Resultant {
    assert_eq!(load.len(), mesh.dof_count());
    let mut sum = Resultant {
        force: [0.0; 3],
        moment: [0.0; 3],
    };
    let d = mesh.dimension();
    for (&point, f) in mesh.points.iter().zip(load.chunks_exact(d)) {
        if mesh.space == Space::Axisymmetric {
            sum.force[1] += f[1];
            continue;
        }
        let mut force = [0.0; 3];
        force[..d].copy_from_slice(f);
        let moment = cross(sub(point, about), force);
        for i in 0..3 {
            sum.force[i] += force[i];
            sum.moment[i] += moment[i];
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::brick::{BrickSpec, brick};
    use crate::mesh::kind::CellKind;
    use crate::mesh::rectangle::{RectangleSpec, rectangle};

    fn block() -> Mesh {
        brick(&BrickSpec {
            min: [1.0, 0.0, -1.0],
            max: [3.0, 1.0, 2.0],
            nodes: [5, 3, 4],
        })
        .unwrap()
    }

    fn close(a: [f64; 3], b: [f64; 3]) {
        assert!(
            (0..3).all(|i| (a[i] - b[i]).abs() < 1e-12),
            "{a:?} against {b:?}"
        );
    }

    #[test]
    fn a_traction_has_the_resultant_of_statics() {
        let mesh = block();
        let t = [0.5, -1.0, 2.0];
        let load = traction(&mesh, mesh.faces_of_set("z+").unwrap(), t);
        let sum = resultant(&mesh, &load, [0.0; 3]);
        // Area 2 × 1, centre (2, 0.5, 2).
        let force = t.map(|x| 2.0 * x);
        close(sum.force, force);
        close(sum.moment, cross([2.0, 0.5, 2.0], force));
        // A corner node has a quarter of a cell's face.
        let areas = nodal_areas(&mesh, mesh.faces_of_set("z+").unwrap());
        assert!((areas[mesh.node_count() - 1] - 0.25 * 0.5 * 0.5).abs() < 1e-15);
        assert_eq!(areas[0], 0.0);
    }

    #[test]
    fn nodal_area_vectors_point_outwards_and_average_at_edges() {
        let mesh = block();
        let mut faces = mesh.faces_of_set("x-").unwrap().to_vec();
        faces.extend(mesh.faces_of_set("z-").unwrap());
        let vectors = nodal_area_vectors(&mesh, &faces);
        // Node 0 has a quarter of an x- face (0.5 × 1) and a quarter of a z- face (0.5 × 0.5).
        close(vectors[0], [-0.125, 0.0, -0.0625]);
    }

    #[test]
    fn a_body_force_has_the_resultant_of_statics() {
        let mesh = block();
        let load = body_force(&mesh, |[x, _, _]| [0.0, 0.0, -x]);
        let sum = resultant(&mesh, &load, [0.0; 3]);
        // ∫ x over (1,3)×(0,1)×(−1,2) = 12, ∫ x² = 26.
        close(sum.force, [0.0, 0.0, -12.0]);
        // The moment −Σ x_a f_a uses the nodal interpolant of x, which is x itself.
        close(sum.moment, [-6.0, 26.0, 0.0]);
    }

    fn plate(space: Space, cells: CellKind) -> Mesh {
        rectangle(&RectangleSpec {
            space,
            min: [1.0, 0.0],
            max: [3.0, 2.0],
            nodes: [5, 4],
            cells,
        })
        .unwrap()
        // Straight edges, so that the closed forms hold on the mesh.
        .mapped(|[x, y, _]| [x + 0.25 * y, y, 0.0])
        .unwrap()
    }

    const PI: f64 = std::f64::consts::PI;

    #[test]
    fn measures_are_those_of_the_space() {
        for cells in [CellKind::Quad4, CellKind::Tri3] {
            let mesh = plate(Space::Plane, cells);
            let top = mesh.faces_of_set("y+").unwrap();
            let sum = resultant(&mesh, &traction(&mesh, top, [0.5, -2.0, 9.0]), [0.0; 3]);
            // Length 2, centre (2.5, 2).
            close(sum.force, [1.0, -4.0, 0.0]);
            close(sum.moment, [0.0, 0.0, -2.5 * 4.0 - 2.0]);
            let weight = resultant(&mesh, &body_force(&mesh, |_| [0.0, -1.0, 0.0]), [0.0; 3]);
            // Area 4, centre of gravity at x = 2.25.
            close(weight.force, [0.0, -4.0, 0.0]);
            close(weight.moment, [0.0, 0.0, -9.0]);

            let mesh = plate(Space::Axisymmetric, cells);
            let top = mesh.faces_of_set("y+").unwrap();
            let sum = resultant(&mesh, &traction(&mesh, top, [0.5, -2.0, 9.0]), [0.0; 3]);
            // An annulus from 1.5 to 3.5.
            close(sum.force, [0.0, -2.0 * PI * (12.25 - 2.25), 0.0]);
            close(sum.moment, [0.0; 3]);
            let weight = resultant(&mesh, &body_force(&mesh, |_| [3.0, -1.0, 0.0]), [0.0; 3]);
            // Pappus: area 4 on the circle through its centre of gravity, r = 2.25.
            close(weight.force, [0.0, -4.0 * 2.0 * PI * 2.25, 0.0]);
            close(weight.moment, [0.0; 3]);
            // The radial load on a straight tube is traction times the face, node by node.
            let outside = mesh.faces_of_set("x+").unwrap();
            let load = traction(&mesh, outside, [2.0, 0.0, 0.0]);
            let radial: f64 = load.iter().step_by(2).sum();
            // A cone between the radii 3 and 3.5 of slant √(4 + ¼).
            assert!((radial - 2.0 * 2.0 * PI * 3.25 * 4.25f64.sqrt()).abs() < 1e-12);
        }
    }

    #[test]
    fn a_node_on_the_axis_has_its_share_of_area() {
        let mesh = rectangle(&RectangleSpec {
            space: Space::Axisymmetric,
            min: [0.0, 0.0],
            max: [2.0, 1.0],
            nodes: [3, 2],
            cells: CellKind::Quad4,
        })
        .unwrap();
        let areas = nodal_areas(&mesh, mesh.faces_of_set("y-").unwrap());
        // ∫ (1 − r) 2πr over (0, 1), and so on: π/3, 2π, 5π/3; together π 2².
        for (area, expected) in areas.iter().zip([1.0 / 3.0, 2.0, 5.0 / 3.0, 0.0, 0.0, 0.0]) {
            assert!((area - PI * expected).abs() < 1e-14);
        }
        let on_axis = nodal_areas(&mesh, mesh.faces_of_set("x-").unwrap());
        assert!(on_axis.iter().all(|&area| area == 0.0));
    }

    #[test]
    fn pressure_presses_and_a_closed_surface_under_it_rests() {
        let brick = block();
        let load = pressure(&brick, brick.faces_of_set("x+").unwrap(), 4.0);
        // Area 3 at (3, 0.5, 0.5).
        let sum = resultant(&brick, &load, [0.0; 3]);
        close(sum.force, [-12.0, 0.0, 0.0]);
        close(sum.moment, [0.0, -6.0, 6.0]);
        let plane = |space| plate(space, CellKind::Tri3);
        for mesh in [brick, plane(Space::Plane), plane(Space::Axisymmetric)] {
            let surface = mesh.boundary_faces();
            let sum = resultant(&mesh, &pressure(&mesh, &surface, 7.0), [1.0, 2.0, 3.0]);
            close(sum.force, [0.0; 3]);
            close(sum.moment, [0.0; 3]);
            // Archimedes: p = 5 − 0.7 y lifts the volume.
            let load = pressure_field(&mesh, &surface, |[_, y, _]| 5.0 - 0.7 * y);
            let lift = resultant(&mesh, &load, [0.0; 3]).force;
            assert!((lift[1] - 0.7 * mesh.volume()).abs() < 1e-12, "{lift:?}");
            assert!(lift[0].abs() + lift[2].abs() < 1e-12);
        }
    }

    #[test]
    fn loads_on_curved_quadratic_and_mixed_faces_are_in_balance() {
        for kind in CellKind::ALL
            .into_iter()
            .filter(|kind| kind.dimension() == 3)
        {
            let mesh = block().with_cells(kind).unwrap();
            let mesh = mesh
                .mapped(|[x, y, z]| [x + 0.1 * y * z, y + 0.05 * x * x, z + 0.1 * (x - y) * z])
                .unwrap();
            mesh.check_cells().unwrap();
            // Under constant pressure a closed surface rests, and Archimedes holds.
            let surface = mesh.boundary_faces();
            let sum = resultant(&mesh, &pressure(&mesh, &surface, 7.0), [1.0, 2.0, 3.0]);
            close(sum.force, [0.0; 3]);
            close(sum.moment, [0.0; 3]);
            let lift = pressure_field(&mesh, &surface, |[_, y, _]| 5.0 - 0.7 * y);
            let volume = mesh.volume();
            close(
                resultant(&mesh, &lift, [0.0; 3]).force,
                [0.0, 0.7 * volume, 0.0],
            );
            // Weight acts at the centroid.
            let weight = body_force(&mesh, |_| [0.0, 0.0, -2.0]);
            let sum = resultant(&mesh, &weight, mesh.centroid());
            close(sum.force, [0.0, 0.0, -2.0 * volume]);
            close(sum.moment, [0.0; 3]);
            let areas = nodal_areas(&mesh, &surface);
            assert!((areas.iter().sum::<f64>() / mesh.area(&surface) - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn quadratic_faces_share_an_area_unevenly() {
        for (kind, corner, middle) in [
            (CellKind::Hex20, -1.0 / 12.0, 1.0 / 3.0),
            (CellKind::Hex27, 1.0 / 36.0, 1.0 / 9.0),
        ] {
            let mesh = brick(&BrickSpec {
                min: [0.0; 3],
                max: [1.0; 3],
                nodes: [2; 3],
            })
            .unwrap()
            .with_cells(kind)
            .unwrap();
            let top = mesh.faces_of_set("z+").unwrap();
            let areas = nodal_areas(&mesh, top);
            let nodes = mesh.face_nodes(top[0]);
            assert!((areas[nodes[0]] - corner).abs() < 1e-15);
            assert!((areas[nodes[4]] - middle).abs() < 1e-15);
        }
    }

    #[test]
    fn a_traction_may_depend_on_the_point() {
        let mesh = block();
        let top = mesh.faces_of_set("z+").unwrap();
        let load = traction_field(&mesh, top, |[x, y, _]| [0.0, 0.0, x * y]);
        let sum = resultant(&mesh, &load, [0.0; 3]);
        // ∫ xy over (1, 3) × (0, 1) = 4 · ½; ∫ x y² = 4/3; ∫ x² y = 26/3 · ½, the last two exact
        // because x and y are nodal interpolants of themselves.
        close(sum.force, [0.0, 0.0, 2.0]);
        close(sum.moment, [4.0 / 3.0, -13.0 / 3.0, 0.0]);
    }
}
