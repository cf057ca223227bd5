//! From the model to matrices: K and f of each body, B, d and g of each contact.

use faer::sparse::SparseRowMat;
use rayon::prelude::*;
use tresca_contact::{ContactData, Side, couple_node_by_node};
use tresca_fem::dofs::DofMap;
use tresca_fem::supports::Supports;
use tresca_fem::{assembly, loads, rigid};
use tresca_la::SymmetricMatrix;
use tresca_qcqp::operator::Coupling;

use crate::ModelError;
use crate::model::{Model, Surface};

/// One body as linear algebra.
#[derive(Debug, Clone)]
pub struct BodySystem {
    /// Which full dofs are free.
    pub dofs: DofMap,
    /// Stiffness K over the free dofs.
    pub stiffness: SymmetricMatrix,
    /// Load over all dofs of the body (held ones too: they go straight into the reactions).
    pub load: Vec<f64>,
    /// The free dofs that some contact touches, ascending: they come last in the factorisation.
    pub contact_dofs: Vec<usize>,
    /// Rows of B = \[N; T\] over all contacts of the model, columns = free dofs of this body.
    pub coupling: Coupling,
}

impl BodySystem {
    /// The load on the free dofs, f.
    pub fn free_load(&self) -> Vec<f64> {
        self.dofs.restrict(&self.load)
    }
}

/// The whole model as linear algebra.
#[derive(Debug, Clone)]
pub struct Assembled {
    /// One system per body.
    pub bodies: Vec<BodySystem>,
    /// One record per contact of the model.
    pub contacts: Vec<ContactData>,
}

impl Assembled {
    /// m, the number of contact pairs.
    pub fn pair_count(&self) -> usize {
        self.contacts
            .iter()
            .map(|contact| contact.pairs.len())
            .sum()
    }

    /// All pairs in the order of λν.
    pub fn pairs(&self) -> impl Iterator<Item = &tresca_contact::ContactPair> {
        self.contacts.iter().flat_map(|contact| &contact.pairs)
    }

    /// n, free and held dofs of all bodies.
    pub fn dof_count(&self) -> usize {
        self.bodies.iter().map(|body| body.dofs.full_len()).sum()
    }
}

/// Assembles the model.
///
/// # Errors
/// When the model has no body or no contact, a body is not held, an element is degenerate, or the
/// surfaces of a contact do not fit.
pub fn assemble(model: &Model) -> Result<Assembled, ModelError> {
    if model.bodies().is_empty() {
        return Err(ModelError::NoBodies);
    }
    if model.contacts().is_empty() {
        return Err(ModelError::NoContact);
    }
    let dof_maps = (0..model.bodies().len())
        .map(|body| dof_map(model, body))
        .collect::<Result<Vec<_>, _>>()?;
    // Contact geometry first: it is quick, and its errors should not wait for the stiffness.
    let contacts = model
        .contacts()
        .iter()
        .enumerate()
        .map(|(index, contact)| {
            let side = |surface: &Surface| Side {
                mesh: &model.bodies()[surface.body].mesh,
                faces: model.faces(surface),
                dofs: &dof_maps[surface.body],
            };
            couple_node_by_node(
                side(&contact.slave),
                side(&contact.master),
                contact.friction,
            )
            .map_err(|source| ModelError::Coupling {
                contact: index,
                slave: model.surface_name(&contact.slave),
                master: model.surface_name(&contact.master),
                source,
            })
        })
        .collect::<Result<Vec<_>, _>>()?;
    let couplings: Vec<_> = (0..dof_maps.len())
        .map(|body| body_coupling(model, &contacts, body, dof_maps[body].free_len()))
        .collect();

    let bodies = dof_maps
        .into_par_iter()
        .zip(couplings)
        .enumerate()
        .map(|(body, (dofs, coupling))| body_system(model, body, dofs, coupling))
        .collect::<Result<_, _>>()?;
    Ok(Assembled { bodies, contacts })
}

fn dof_map(model: &Model, index: usize) -> Result<DofMap, ModelError> {
    let body = &model.bodies()[index];
    let in_body = |source| ModelError::Body {
        body: body.name.clone(),
        source,
    };
    let mut supports = Supports::new(body.mesh.node_count(), body.mesh.dimension);
    for surface in model.clamps().iter().filter(|clamp| clamp.body == index) {
        let nodes = body.mesh.nodes_of_faces(model.faces(surface));
        supports.clamp(&nodes).map_err(in_body)?;
    }
    let dofs = DofMap::new(&supports);
    let free = rigid::remaining(&body.mesh, &dofs);
    if free.is_empty() {
        return Ok(dofs);
    }
    Err(ModelError::Floating {
        body: body.name.clone(),
        motions: free.iter().map(ToString::to_string).collect(),
    })
}

fn body_system(
    model: &Model,
    index: usize,
    dofs: DofMap,
    coupling: Coupling,
) -> Result<BodySystem, ModelError> {
    let body = &model.bodies()[index];
    let stiffness = assembly::stiffness(&body.mesh, &body.material, &dofs).map_err(|source| {
        ModelError::Body {
            body: body.name.clone(),
            source,
        }
    })?;
    let mut load = vec![0.0; dofs.full_len()];
    for traction in model.tractions() {
        for surface in traction.on.iter().filter(|surface| surface.body == index) {
            let part = loads::traction(&body.mesh, model.faces(surface), traction.value);
            tresca_la::vector::axpy(1.0, &part, &mut load);
        }
    }
    Ok(BodySystem {
        dofs,
        stiffness,
        load,
        contact_dofs: coupling.touched(),
        coupling,
    })
}

/// Stacks a body's share of all contacts: the normal rows of every contact, then the tangential.
fn body_coupling(model: &Model, contacts: &[ContactData], body: usize, columns: usize) -> Coupling {
    let mut rows = RowStack::default();
    for tangential in [false, true] {
        for (contact, data) in model.contacts().iter().zip(contacts) {
            let pairs = data.pairs.len();
            let range = if tangential {
                pairs..3 * pairs
            } else {
                0..pairs
            };
            let matrix = if contact.slave.body == body {
                Some(&data.slave_coupling)
            } else if contact.master.body == body {
                Some(&data.master_coupling)
            } else {
                None
            };
            for row in range {
                rows.push(matrix.map(|matrix| (matrix, row)));
            }
        }
    }
    rows.finish(columns)
}

#[derive(Default)]
struct RowStack {
    ends: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl RowStack {
    fn push(&mut self, source: Option<(&SparseRowMat<usize, f64>, usize)>) {
        if let Some((matrix, row)) = source {
            let matrix = matrix.as_ref();
            self.columns.extend(matrix.col_idx_of_row(row));
            self.values.extend(matrix.val_of_row(row));
        }
        self.ends.push(self.columns.len());
    }

    fn finish(self, columns: usize) -> Coupling {
        let rows = self.ends.len();
        let row_ptr = std::iter::once(0).chain(self.ends).collect();
        let symbolic = faer::sparse::SymbolicSparseRowMat::new_checked(
            rows,
            columns,
            row_ptr,
            None,
            self.columns,
        );
        Coupling::new(SparseRowMat::new(symbolic, self.values))
    }
}
