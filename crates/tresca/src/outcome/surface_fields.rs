//! Contact as fields on the bodies: at the nodes of slave *and* master surfaces.

use faer::sparse::SparseRowMatRef;
use tresca_contact::ContactData;

use crate::assemble::Assembled;
use crate::pair_state::PairState;
use tresca_model::{Contact, Model};

/// What a node of a body does; written as the field `contact_status`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
enum NodeState {
    /// No contact point.
    None = 0,
    /// Without normal force.
    Open = 1,
    /// Closed; the friction force is below its bound.
    Stick = 2,
    /// Closed; the friction force is at its bound.
    Slip = 3,
}

impl NodeState {
    fn of(state: &PairState) -> Self {
        match (state.closed, state.stick) {
            (false, _) => NodeState::Open,
            (true, true) => NodeState::Stick,
            (true, false) => NodeState::Slip,
        }
    }
}

/// Contact fields on those nodes of one body that contacts reach.
///
/// A slave node has the figures of its pair. A master node has the mean of those of the pairs that reach
/// it, weighted by the parts of their forces that it takes.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct SurfaceFields {
    /// The nodes, ascending; all other fields have one entry per node.
    pub nodes: Vec<usize>,
    /// Nodal contact force on this body, all contacts together.
    pub force: Vec<[f64; 3]>,
    /// Contact pressure.
    pub pressure: Vec<f64>,
    /// Tangential traction on this body.
    pub traction: Vec<[f64; 3]>,
    /// Gap left.
    pub gap: Vec<f64>,
    /// 1 open, 2 sticking, 3 slipping; 0 is left for nodes that no contact reaches.
    pub status: Vec<u8>,
}

/// What reaches a node.
#[derive(Clone, Copy)]
struct Share {
    weight: f64,
    largest: f64,
    pressure: f64,
    traction: [f64; 3],
    gap: f64,
    state: NodeState,
}

impl Share {
    const NOTHING: Share = Share {
        weight: 0.0,
        largest: 0.0,
        pressure: 0.0,
        traction: [0.0; 3],
        gap: 0.0,
        state: NodeState::None,
    };

    /// Adds a pair; `sign` is that of its tractions on this side.
    fn add(&mut self, weight: f64, sign: f64, state: &PairState) {
        let traction = state.friction_traction();
        self.weight += weight;
        self.pressure += weight * state.pressure();
        self.gap += weight * state.gap;
        for (sum, t) in self.traction.iter_mut().zip(traction) {
            *sum += weight * sign * t;
        }
        if weight > self.largest {
            self.largest = weight;
            self.state = NodeState::of(state);
        }
    }
}

impl SurfaceFields {
    /// The fields of a body; `forces` are the contact forces over its full dofs.
    pub(crate) fn new(
        model: &Model,
        assembled: &Assembled,
        states: &[Vec<PairState>],
        forces: &[f64],
        body: usize,
    ) -> Self {
        let mesh = &model.bodies()[body].mesh;
        let dimension = mesh.dimension();
        let mut shares = vec![Share::NOTHING; mesh.node_count()];
        let contacts = model.contacts().iter().zip(&assembled.contacts);
        for ((contact, data), states) in contacts.zip(states) {
            if contact.slave.body == body {
                for state in states {
                    // The friction force of a pair is what the slave puts on the master.
                    shares[state.pair.slave_node].add(state.pair.area, -1.0, state);
                }
            }
            if let Some(rows) = master_rows(contact, data, body) {
                for (row, state) in states.iter().enumerate() {
                    for (column, value) in rows.col_idx_of_row(row).zip(rows.val_of_row(row)) {
                        let weight = state.pair.area * value.abs();
                        shares[column / dimension].add(weight, 1.0, state);
                    }
                }
            }
        }
        let reached = shares.iter().enumerate();
        let reached = reached.filter(|(_, share)| share.weight > 0.0);
        let mut fields = Self::default();
        for (node, share) in reached {
            let first = dimension * node;
            let force = |k| {
                if k < dimension {
                    forces[first + k]
                } else {
                    0.0
                }
            };
            fields.nodes.push(node);
            fields.force.push(std::array::from_fn(force));
            fields.pressure.push(share.pressure / share.weight);
            fields
                .traction
                .push(share.traction.map(|t| t / share.weight));
            fields.gap.push(share.gap / share.weight);
            fields.status.push(share.state as u8);
        }
        fields
    }

    /// One of the fields over all `count` nodes of the body, `T::default()` where no contact reaches.
    pub fn expand<T: Copy + Default>(&self, values: &[T], count: usize) -> Vec<T> {
        let mut all = vec![T::default(); count];
        for (&node, &value) in self.nodes.iter().zip(values) {
            all[node] = value;
        }
        all
    }
}

/// The rows of the master side, if the body is the master. The first rows are the normal ones.
fn master_rows<'a>(
    contact: &Contact,
    data: &'a ContactData,
    body: usize,
) -> Option<SparseRowMatRef<'a, usize, f64>> {
    let on_body = contact.master.surface().is_some_and(|on| on.body == body);
    let rows = data.master_coupling.as_ref().filter(|_| on_body)?;
    Some(rows.as_ref())
}
