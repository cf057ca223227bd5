//! Coupling of a surface to faces that belong to a body or to nobody.

use super::integrals::over_segments;
use super::rows::{Master, assemble};
use super::slave::SlaveSurface;
use crate::data::{ContactData, Discretization};
use crate::error::ContactError;
use crate::geometry::faces::FaceShapes;
use crate::geometry::search::Reach;
use crate::interface::{Interface, Side};

/// Couples a surface to a deformable one.
pub(crate) fn couple_mortar(
    slave: Side<'_>,
    master: Side<'_>,
    interface: Interface<'_>,
    search: Option<f64>,
) -> Result<ContactData, ContactError> {
    let shapes = FaceShapes::of_mesh(master.mesh, master.faces)?;
    let side = Master {
        side: master,
        faces: &shapes,
    };
    couple_shapes(
        slave,
        &shapes,
        Some(side),
        interface,
        search,
        Discretization::Mortar,
    )
}

/// Couples a surface to faces that belong to a body (`master`) or to nobody.
pub(crate) fn couple_shapes(
    slave: Side<'_>,
    shapes: &FaceShapes,
    master: Option<Master<'_>>,
    interface: Interface<'_>,
    search: Option<f64>,
    discretization: Discretization,
) -> Result<ContactData, ContactError> {
    let slave = SlaveSurface::new(slave)?;
    let reach = reach(search, &slave.faces)?;
    let normals = slave.normals();
    let integrals = over_segments(&slave.faces, shapes, reach, |face, node| {
        normals[slave.index_of(face, node)]
    });
    let normal = |i: usize| slave.surface.nodes[i].normal;
    assemble(
        &slave,
        normal,
        &integrals,
        master,
        interface,
        discretization,
    )
}

/// The distance within which partners are looked for.
pub(crate) fn reach(search: Option<f64>, slave: &FaceShapes) -> Result<Reach, ContactError> {
    match search {
        // NaN is refused too; infinity looks everywhere.
        Some(search) if search.is_nan() || search <= 0.0 => Err(ContactError::Search { search }),
        Some(search) => Ok(Reach::new(Some(search), 0.0)),
        None => Ok(Reach::new(None, slave.diagonal())),
    }
}
