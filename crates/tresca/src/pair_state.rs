//! The state of every contact pair.

use tresca_contact::ContactPair;
use tresca_system::solved::Solved;

use crate::assemble::Assembled;

/// The state of one contact pair.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PairState {
    /// The pair: nodes, frame, gap, area, law.
    pub pair: ContactPair,
    /// Does it carry a normal force? Tied and bilateral pairs always count as closed.
    pub closed: bool,
    /// Is the friction force below the slip bound?
    pub stick: bool,
    /// λν, positive in compression; negative only where the law never lets the pair open.
    pub normal_force: f64,
    /// λτ in global components: the force that the slave puts on the master.
    pub friction_force: [f64; 3],
    /// λτ in the pair's frame.
    pub local_friction: [f64; 2],
    /// The slip bounds (forces) along τ1, τ2 that hold in this step; `None` where nothing slides.
    pub slip_bounds: Option<[f64; 2]>,
    /// Gap left, d − N u.
    pub gap: f64,
    /// Slip T u in global components: motion of the slave relative to the master, since the start.
    pub slip: [f64; 3],
    /// The two components of the slip in the pair's frame.
    pub local_slip: [f64; 2],
    /// The same since the step before: what friction acts on.
    pub local_slip_increment: [f64; 2],
}

impl PairState {
    /// Contact pressure λν / area.
    pub fn pressure(&self) -> f64 {
        self.normal_force / self.pair.area
    }

    /// Tangential traction λτ / area.
    pub fn friction_traction(&self) -> [f64; 3] {
        self.friction_force.map(|x| x / self.pair.area)
    }

    /// Work that friction dissipates in the step, λτ·ΔTu.
    pub fn dissipation(&self) -> f64 {
        self.local_friction[0] * self.local_slip_increment[0]
            + self.local_friction[1] * self.local_slip_increment[1]
    }
}

/// The pairs of a step, contact by contact. `previous` is B u of the step before.
pub(crate) fn pair_states(
    assembled: &Assembled,
    solved: &Solved,
    previous: &[f64],
) -> Vec<Vec<PairState>> {
    let layout = &assembled.layout;
    let state = |i: usize, pair: &ContactPair| {
        let global = |[a, b]: [f64; 2]| pair.frame.to_global([0.0, a, b]);
        let local_slip = layout.tangential(&solved.relative, i);
        let before = layout.tangential(previous, i);
        let local_friction = layout.tangential(&solved.forces, i);
        PairState {
            closed: solved.closed[i],
            stick: solved.stick[i],
            normal_force: solved.forces[i],
            friction_force: global(local_friction),
            local_friction,
            slip_bounds: solved.slip_bounds[i],
            gap: solved.gaps[i],
            slip: global(local_slip),
            local_slip,
            local_slip_increment: std::array::from_fn(|k| local_slip[k] - before[k]),
            pair: pair.clone(),
        }
    };
    let mut first = 0;
    let contact = |data: &tresca_contact::ContactData| {
        let base = first;
        first += data.pairs.len();
        let pairs = data.pairs.iter().enumerate();
        pairs
            .map(|(offset, pair)| state(base + offset, pair))
            .collect()
    };
    assembled.contacts.iter().map(contact).collect()
}
