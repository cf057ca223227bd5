//! Rigid obstacles as partners of a body.

mod analytic;

use tresca_fem::mesh::CellKind;

use self::analytic::Analytic;
use crate::frame::dot;
use crate::geometry::{FACING, MAX_NODES, Patch, Patches};
use crate::mortar::{SlaveSurface, assemble, couple_patches, over_faces, reach};
use crate::{ContactData, ContactError, Discretization, Interface, Side};

/// A rigid obstacle.
///
/// In the plane (and in the meridian section of an axisymmetric space) a plane is a line, spheres and
/// cylinders are circles; the axis of such a cylinder is the z axis.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Obstacle {
    /// The half-space behind a plane.
    Plane {
        /// A point of the plane.
        point: [f64; 3],
        /// Direction out of the obstacle, of any length.
        normal: [f64; 3],
    },
    /// A ball, or everything but a ball.
    Sphere {
        /// The centre.
        center: [f64; 3],
        /// The radius.
        radius: f64,
        /// Is the body in a spherical cavity?
        inside: bool,
    },
    /// A round bar of infinite length, or everything around a round hole.
    Cylinder {
        /// A point of the axis.
        point: [f64; 3],
        /// Direction of the axis, of any length.
        axis: [f64; 3],
        /// The radius.
        radius: f64,
        /// Is the body in the hole?
        inside: bool,
    },
    /// A surface of faces.
    Surface(RigidSurface),
}

/// The surface of an obstacle as faces.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidSurface {
    /// Points; the third coordinate is zero in the plane.
    pub points: Vec<[f64; 3]>,
    /// Faces with their nodes (numbers of points), counter-clockwise as seen from outside of the
    /// obstacle. In the plane lines, with the outside on the right.
    pub faces: Vec<(CellKind, Vec<usize>)>,
}

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
    obstacle: &Obstacle,
    interface: Interface<'_>,
    search: Option<f64>,
) -> Result<ContactData, ContactError> {
    match obstacle {
        Obstacle::Surface(surface) => {
            let faces = surface.faces.iter();
            let patches = faces.map(|(kind, nodes)| Patch::new(*kind, nodes, &surface.points));
            let patches: Vec<Patch> = patches.collect::<Result<_, _>>()?;
            if patches.is_empty() {
                return Err(ContactError::Empty);
            }
            let patches = Patches::new(slave.mesh.space, patches)?;
            let rigid = Discretization::Obstacle;
            couple_patches(slave, &patches, None, interface, search, rigid)
        }
        analytic => couple_analytic(slave, analytic, interface, search),
    }
}

fn couple_analytic(
    slave: Side<'_>,
    obstacle: &Obstacle,
    interface: Interface<'_>,
    search: Option<f64>,
) -> Result<ContactData, ContactError> {
    let obstacle = Analytic::new(obstacle, slave.mesh.dimension())?;
    let slave = SlaveSurface::new(slave)?;
    let reach = reach(search, &slave.patches)?;
    let nodes = &slave.surface.nodes;
    let nearest: Vec<_> = nodes
        .iter()
        .map(|node| obstacle.nearest(node.point))
        .collect();
    let looks = |i: usize| dot(nodes[i].normal, nearest[i].normal) < FACING;
    let takes_part = |patch: &Patch| {
        let radius = patch.radius();
        let limit = reach.between(radius, radius);
        let mut indices = patch.nodes().iter().map(|&node| slave.index_of(node));
        indices.any(|i| looks(i) && nearest[i].distance <= limit)
    };
    for patch in slave
        .patches
        .patches
        .iter()
        .filter(|patch| takes_part(patch))
    {
        for &node in patch.nodes() {
            let i = slave.index_of(node);
            obstacle.check(nodes[i].point, &nearest[i])?;
        }
    }
    let integrals = over_faces(&slave.patches, |patch| {
        takes_part(patch).then(|| {
            let mut gaps = [0.0; MAX_NODES];
            for (gap, &node) in gaps.iter_mut().zip(patch.nodes()) {
                *gap = nearest[slave.index_of(node)].distance;
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
