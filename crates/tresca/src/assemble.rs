//! From the model to matrices: K of each body, B, d and the friction data of each contact.

use std::time::Instant;

use faer::sparse::{SparseRowMat, SymbolicSparseRowMat};
use rayon::prelude::*;
use tresca_contact::{
    ContactData, ContactError, ContactPair, Interface, SharedNode, Side, couple, couple_obstacle,
};
use tresca_fem::assembly;
use tresca_fem::dofs::DofMap;
use tresca_fem::rigid::FreeMotion;
use tresca_fem::supports::Supports;
use tresca_la::vector::dot;
use tresca_qcqp::operator::{Coupling, groups};
use tresca_system::body::SystemBody;
use tresca_system::engine::PAIRS_PER_PATCH;
use tresca_system::layout::Layout;

use crate::error::SolveError;
use crate::floating::floating;
use tresca_model::ModelError;
use tresca_model::{Contact, Model, Partner, Place};

/// A body between its mesh and its matrices.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct MeshedBody {
    /// Which full dofs are free.
    pub dofs: DofMap,
    /// A basis of the rigid motions that the supports leave; empty for a body that is held.
    pub motions: Vec<FreeMotion>,
    /// Rows of B = \[N; T\] over all contacts of the model, columns = *full* dofs of this body.
    pub contact: Coupling,
}

/// What ties the model to its matrices: the dofs, and the pairs with their frames, gaps and areas.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Assembled {
    /// One per body.
    pub bodies: Vec<MeshedBody>,
    /// One record per contact of the model.
    pub contacts: Vec<ContactData>,
    /// Where every pair stands in λ.
    pub layout: Layout,
    /// Seconds that contact search and coupling took.
    pub contact_seconds: f64,
}

impl Assembled {
    /// m, the number of contact pairs.
    pub fn pair_count(&self) -> usize {
        self.layout.pair_count()
    }

    /// All pairs in the order of λν.
    pub fn pairs(&self) -> impl Iterator<Item = &ContactPair> {
        self.contacts.iter().flat_map(|contact| &contact.pairs)
    }

    /// n, free and held dofs of all bodies.
    pub fn dof_count(&self) -> usize {
        self.bodies.iter().map(|body| body.dofs.full_len()).sum()
    }

    /// B u = \[Nu; Tu\] of displacements over the full dofs, body by body: approach and slip.
    pub fn relative(&self, displacements: &[Vec<f64>]) -> Vec<f64> {
        let mut relative = vec![0.0; self.layout.unknowns()];
        for (body, u) in self.bodies.iter().zip(displacements) {
            body.contact.add_product(u, &mut relative);
        }
        relative
    }

    /// Displacements over the full dofs from their free parts and the prescribed rest.
    pub fn full_displacements(&self, free: &[Vec<f64>], prescribed: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let bodies = self.bodies.iter().zip(free).zip(prescribed);
        bodies
            .map(|((body, free), prescribed)| {
                let mut u = prescribed.clone();
                body.dofs.write_free(free, &mut u);
                u
            })
            .collect()
    }

    /// The unknowns of neighbouring pairs, contact by contact: the patches of the local model of A.
    pub(crate) fn patches(&self) -> Vec<Vec<usize>> {
        let mut first = 0;
        let mut pairs = Vec::new();
        for contact in &self.contacts {
            let points: Vec<[f64; 3]> = contact.pairs.iter().map(|pair| pair.point).collect();
            let patches = groups::neighbours(&points, PAIRS_PER_PATCH);
            let patches = patches.into_iter();
            pairs.extend(patches.map(|patch| patch.iter().map(|i| first + i).collect::<Vec<_>>()));
            first += points.len();
        }
        groups::unknowns_of_pairs(&pairs, self.layout.tangents() + 1)
    }

    /// −Bᵀλ: what the contact forces λ put on a body, over its full dofs.
    pub fn contact_forces(&self, body: usize, lambda: &[f64]) -> Vec<f64> {
        let minus: Vec<f64> = lambda.iter().map(|x| -x).collect();
        let system = &self.bodies[body];
        let mut forces = vec![0.0; system.dofs.full_len()];
        system.contact.add_transposed_product(&minus, &mut forces);
        forces
    }
}

/// Assembles the model: the bodies as linear algebra (K, grounding, B), and what ties them to it.
///
/// # Errors
/// When the model has no body or no contact, a floating body is touched by no contact, an element is
/// degenerate, or the surfaces of a contact do not fit.
pub fn assemble(model: &Model) -> Result<(Assembled, Vec<SystemBody>), SolveError> {
    if model.bodies().is_empty() {
        return Err(ModelError::NoBodies.into());
    }
    if model.contacts().is_empty() {
        return Err(SolveError::NoContact);
    }
    let dof_maps = dof_maps(model)?;
    // Contact geometry first: it is quick, and its errors should not wait for the stiffness.
    let begin = Instant::now();
    let contacts = couple_all(model, &dof_maps)?;
    let contact_seconds = begin.elapsed().as_secs_f64();
    if contacts.iter().all(|data| data.pairs.is_empty()) {
        return Err(SolveError::NoFreePairs);
    }
    let openings = model
        .contacts()
        .iter()
        .map(|contact| contact.friction.opening());
    let pairs = openings.zip(&contacts).flat_map(|(opening, data)| {
        data.pairs
            .iter()
            .map(move |pair| (opening, pair.mobility, pair.sliding))
    });
    let layout = Layout::new(model.dimension(), pairs);

    let parts = dof_maps
        .into_par_iter()
        .enumerate()
        .map(|(body, dofs)| body_parts(model, &contacts, &layout, body, dofs))
        .collect::<Result<Vec<_>, _>>()?;
    let (bodies, elastic) = parts.into_iter().unzip();
    let assembled = Assembled {
        bodies,
        contacts,
        layout,
        contact_seconds,
    };
    Ok((assembled, elastic))
}

/// The free and held dofs of every body.
pub(crate) fn dof_maps(model: &Model) -> Result<Vec<DofMap>, SolveError> {
    let components = |k: usize| model.supports()[k].components;
    (0..model.bodies().len())
        .map(|body| Ok(DofMap::new(&supports(model, body, components)?)))
        .collect()
}

/// The geometry of every contact, one after the other: where two contacts of a slave body share an edge, its
/// nodes belong to the first one.
pub(crate) fn couple_all(model: &Model, dofs: &[DofMap]) -> Result<Vec<ContactData>, SolveError> {
    let mut contacts: Vec<ContactData> = Vec::with_capacity(model.contacts().len());
    for (index, contact) in model.contacts().iter().enumerate() {
        let before = model.contacts().iter().zip(&contacts);
        let same_slave = before.filter(|(other, _)| other.slave.body == contact.slave.body);
        let taken: Vec<usize> = same_slave
            .flat_map(|(_, data)| data.pairs.iter().map(|pair| pair.slave_node))
            .collect();
        let bodies = |contact: &Contact| {
            let master = contact.master.surface().map(|master| master.body);
            (contact.slave.body, master)
        };
        let same_bodies: Vec<usize> = (0..index)
            .filter(|&k| bodies(&model.contacts()[k]) == bodies(contact))
            .collect();
        let partners: Vec<usize> = same_bodies
            .iter()
            .flat_map(|&k| contacts[k].pairs.iter().filter_map(|pair| pair.master_node))
            .collect();
        let data = coupled(model, contact, dofs, [&taken, &partners]);
        let data = data.map_err(|source| SolveError::Coupling {
            contact: index,
            slave: model.surface_name(&contact.slave),
            master: model.partner_name(&contact.master),
            source,
        })?;
        hand_over(&mut contacts, &data.shared, &same_bodies);
        contacts.push(data);
    }
    Ok(contacts)
}

/// Adds the areas of shared nodes to the pairs that have them; the law of these pairs holds there. Of several
/// pairs of a node it is the one whose normal is nearest.
fn hand_over(contacts: &mut [ContactData], shared: &[SharedNode], same_bodies: &[usize]) {
    for node in shared {
        let pairs = same_bodies.iter().flat_map(|&k| {
            let pairs = contacts[k].pairs.iter().enumerate();
            let own = pairs.filter(|(_, pair)| pair.slave_node == node.node);
            own.map(move |(i, pair)| (k, i, dot(&pair.frame.normal, &node.normal)))
        });
        let nearest = pairs.reduce(|best, pair| if pair.2 > best.2 { pair } else { best });
        if let Some((contact, index, _)) = nearest {
            let pair = &mut contacts[contact].pairs[index];
            let grown = (pair.area + node.area) / pair.area;
            pair.area += node.area;
            pair.sliding = pair.sliding.scaled(grown);
        }
    }
}

/// The geometry of a contact; `taken` are nodes of both sides that other contacts have.
fn coupled(
    model: &Model,
    contact: &Contact,
    dofs: &[DofMap],
    taken: [&[usize]; 2],
) -> Result<ContactData, ContactError> {
    let side = |surface: &Place, taken| Side {
        mesh: &model.bodies()[surface.body].mesh,
        faces: model.faces(surface),
        dofs: &dofs[surface.body],
        patches: None,
        taken,
    };
    let interface = Interface {
        friction: &contact.friction,
        gap: &contact.gap,
    };
    let slave = side(&contact.slave, taken[0]);
    match &contact.master {
        Partner::Surface(master) => couple(
            slave,
            side(master, taken[1]),
            interface,
            contact.coupling,
            contact.search,
        ),
        Partner::Obstacle(id) => {
            let shape = &model.obstacles()[id.0].shape;
            couple_obstacle(slave, shape, interface, contact.search)
        }
    }
}

/// The supports of a body with the displacements that `components` gives for each support of the model.
pub(crate) fn supports(
    model: &Model,
    index: usize,
    components: impl Fn(usize) -> [Option<f64>; 3],
) -> Result<Supports, SolveError> {
    let body = &model.bodies()[index];
    let mut supports = Supports::new(body.mesh.node_count(), body.mesh.dimension());
    for (number, support) in model.supports().iter().enumerate() {
        let values = components(number);
        for place in support.on.iter().filter(|place| place.body == index) {
            for node in model.nodes(place) {
                for (component, value) in values.into_iter().enumerate() {
                    if let Some(value) = value {
                        supports
                            .prescribe(node, component, value)
                            .map_err(|source| SolveError::Body {
                                body: body.name.clone(),
                                source,
                            })?;
                    }
                }
            }
        }
    }
    Ok(supports)
}

fn body_parts(
    model: &Model,
    contacts: &[ContactData],
    layout: &Layout,
    index: usize,
    dofs: DofMap,
) -> Result<(MeshedBody, SystemBody), SolveError> {
    let body = &model.bodies()[index];
    let contact = body_contact(model, contacts, index, dofs.full_len());
    let coupling = weighted_free_part(&contact, &dofs, layout.weights());
    let (motions, grounding) = floating(body, &dofs, &contact)?.unzip();
    let stiffness = assembly::stiffness(&body.mesh, &body.material, body.formulation, &dofs)
        .map_err(|source| SolveError::Body {
            body: body.name.clone(),
            source,
        })?;
    let meshed = MeshedBody {
        dofs,
        motions: motions.unwrap_or_default(),
        contact,
    };
    Ok((meshed, SystemBody::new(stiffness, grounding, coupling)))
}

/// Stacks a body's share of all contacts: the normal rows of every contact, then the tangential.
fn body_contact(model: &Model, contacts: &[ContactData], body: usize, columns: usize) -> Coupling {
    let dimension = model.dimension();
    let mut rows = RowStack::default();
    for tangential in [false, true] {
        for (contact, data) in model.contacts().iter().zip(contacts) {
            let pairs = data.pairs.len();
            let range = if tangential {
                pairs..dimension * pairs
            } else {
                0..pairs
            };
            let matrix = if contact.slave.body == body {
                Some(&data.slave_coupling)
            } else if contact.master.surface().is_some_and(|on| on.body == body) {
                data.master_coupling.as_ref()
            } else {
                None
            };
            for row in range {
                if let Some(matrix) = matrix {
                    let matrix = matrix.as_ref();
                    let entries = matrix.col_idx_of_row(row).zip(matrix.val_of_row(row));
                    rows.extend(entries.map(|(column, &value)| (column, value)));
                }
                rows.end_row();
            }
        }
    }
    rows.finish(columns)
}

/// diag(weights) B C on the free dofs.
fn weighted_free_part(contact: &Coupling, dofs: &DofMap, weights: &[f64]) -> Coupling {
    let mut rows = RowStack::default();
    for (row, weight) in weights.iter().enumerate() {
        let weighted = contact
            .row(row)
            .map(|(column, value)| (column, weight * value));
        rows.extend(dofs.restrict_row(weighted).into_iter());
        rows.end_row();
    }
    rows.finish(dofs.free_len())
}

#[derive(Default)]
struct RowStack {
    ends: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl RowStack {
    fn extend(&mut self, entries: impl Iterator<Item = (usize, f64)>) {
        for (column, value) in entries {
            self.columns.push(column);
            self.values.push(value);
        }
    }

    fn end_row(&mut self) {
        self.ends.push(self.columns.len());
    }

    fn finish(self, columns: usize) -> Coupling {
        let rows = self.ends.len();
        let row_ptr = std::iter::once(0).chain(self.ends).collect();
        let symbolic =
            SymbolicSparseRowMat::new_checked(rows, columns, row_ptr, None, self.columns);
        Coupling::new(SparseRowMat::new(symbolic, self.values))
    }
}
