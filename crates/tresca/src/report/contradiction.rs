//! Constraints that contradict each other, as a reader finds them again.

use serde::Serialize;
use tresca_model::Model;
use tresca_system::contradiction::{ContradictingPair, Contradiction};

use crate::pair_state::PairState;

/// Constraints that no displacement satisfies together.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct ContradictionReport {
    /// By how much they miss each other, a length.
    pub by: f64,
    /// The pairs that take part.
    pub pairs: Vec<PairReport>,
}

/// A pair that takes part in a contradiction.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct PairReport {
    /// Its number among all pairs, from 0.
    pub pair: usize,
    /// Slave and master surface; of cases.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact: Option<String>,
    /// Where it is; of cases.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub point: Option<[f64; 3]>,
    /// Its normal force in the proof, the largest force of all being 1.
    pub normal: f64,
    /// Its tangential force in the proof.
    pub tangential: [f64; 2],
}

impl From<&Contradiction> for ContradictionReport {
    fn from(contradiction: &Contradiction) -> Self {
        Self {
            by: contradiction.by,
            pairs: contradiction.pairs.iter().map(PairReport::new).collect(),
        }
    }
}

impl PairReport {
    fn new(own: &ContradictingPair) -> Self {
        Self {
            pair: own.pair,
            contact: None,
            point: None,
            normal: own.normal,
            tangential: own.tangential,
        }
    }
}

impl ContradictionReport {
    /// Of a model: with the surfaces of the pairs and their places.
    pub(super) fn of_model(
        contradiction: &Contradiction,
        model: &Model,
        contacts: &[Vec<PairState>],
    ) -> Self {
        let mut report = Self::from(contradiction);
        let mut first = 0;
        for (contact, pairs) in model.contacts().iter().zip(contacts) {
            let own = first..first + pairs.len();
            for entry in report.pairs.iter_mut().filter(|p| own.contains(&p.pair)) {
                let slave = model.surface_name(&contact.slave);
                let master = model.partner_name(&contact.master);
                entry.contact = Some(format!("{slave} – {master}"));
                entry.point = Some(pairs[entry.pair - first].pair.point);
            }
            first = own.end;
        }
        report
    }
}
