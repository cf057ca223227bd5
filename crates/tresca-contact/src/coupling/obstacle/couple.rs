//! Rigid obstacles as partners of a body.

use tresca_fem::vector3::dot;

use super::analytic::Analytic;
use super::shape::RigidShape;
use crate::coupling::mortar::couple::{couple_shapes, reach};
use crate::coupling::mortar::integrals::over_faces;
use crate::coupling::mortar::rows::assemble;
use crate::coupling::mortar::slave::SlaveSurface;
use crate::data::{ContactData, Discretization};
use crate::error::ContactError;
use crate::geometry::face::{FaceShape, MAX_NODES};
use crate::geometry::faces::FaceShapes;
use crate::geometry::search::FACING;
use crate::interface::{Interface, Side};

/// Couples a surface to a rigid obstacle: B has a slave part only.
///
/// For planes, spheres and cylinders distances are exact at the slave nodes, which lie on the true
/// surface of the body (points between the nodes of a curved face do not); ν is minus the
/// obstacle's normal at the nearest point. On quadratic faces the nodal distances are
/// interpolated, d_j = (1/a_j) Σ_k D_jk g(x_k); on linear ones that is g(x_j).
/// Faces with a node that looks at the obstacle (within 73°) and is closer than `search` take part, by
/// default closer than the face's size or a tenth of the slave surface's diagonal.
///
/// A surface of faces is treated as a mortar master whose displacement is known to be zero.
///
/// # Errors
/// [`ContactError`] when the obstacle's numbers make no sense, nothing of it is within reach, or a node
/// lies deeper in it than half of its radius; and as for [`crate::couple`].
pub fn couple_obstacle(
    slave: Side<'_>,
    obstacle: &RigidShape,
    interface: Interface<'_>,
    search: Option<f64>,
) -> Result<ContactData, ContactError> {
    match obstacle {
        RigidShape::Surface(surface) => {
            let faces = surface.faces.iter();
            let shapes = faces.map(|(kind, nodes)| FaceShape::new(*kind, nodes, &surface.points));
            let shapes: Vec<FaceShape> = shapes.collect::<Result<_, _>>()?;
            if shapes.is_empty() {
                return Err(ContactError::Empty);
            }
            let shapes = FaceShapes::new(slave.mesh.space, shapes)?;
            let rigid = Discretization::Obstacle;
            couple_shapes(slave, &shapes, None, interface, search, rigid)
        }
        analytic => couple_analytic(slave, analytic, interface, search),
    }
}

fn couple_analytic(
    slave: Side<'_>,
    obstacle: &RigidShape,
    interface: Interface<'_>,
    search: Option<f64>,
) -> Result<ContactData, ContactError> {
    let obstacle = Analytic::new(obstacle, slave.mesh.dimension())?;
    let slave = SlaveSurface::new(slave)?;
    let reach = reach(search, &slave.faces)?;
    let nodes = &slave.surface.nodes;
    let nearest: Vec<_> = nodes
        .iter()
        .map(|node| obstacle.nearest(node.point))
        .collect();
    let looks = |i: usize| dot(nodes[i].normal, nearest[i].normal) < FACING;
    let indices = |face: usize, shape: &FaceShape| -> Vec<usize> {
        let nodes = shape.nodes().iter();
        nodes.map(|&node| slave.index_of(face, node)).collect()
    };
    let takes_part = |face: usize, shape: &FaceShape| {
        let radius = shape.radius();
        let limit = reach.between(radius, radius);
        let mut indices = indices(face, shape).into_iter();
        indices.any(|i| looks(i) && nearest[i].distance <= limit)
    };
    let faces = slave.faces.shapes.iter().enumerate();
    for (face, shape) in faces.filter(|&(face, shape)| takes_part(face, shape)) {
        for i in indices(face, shape) {
            obstacle.check(nodes[i].point, &nearest[i])?;
        }
    }
    let integrals = over_faces(&slave.faces, |face, shape| {
        takes_part(face, shape).then(|| {
            let mut gaps = [0.0; MAX_NODES];
            for (gap, i) in gaps.iter_mut().zip(indices(face, shape)) {
                *gap = nearest[i].distance;
            }
            gaps
        })
    });
    let normal = |i: usize| nearest[i].normal.map(|x| -x);
    assemble(
        &slave,
        normal,
        &integrals,
        None,
        interface,
        Discretization::Obstacle,
    )
}
