//! What a solve of an algebraic problem gives back.

use tresca_qcqp::{Figures, IterationRecord, Settings, StateCounts, Status};

use super::note::Note;
use crate::certificate::{Certificate, Failure};
use crate::contradiction::Contradiction;
use crate::description::{Description, Times};
use crate::layout::Layout;
use crate::load_case::WarmStart;
use crate::solved::Solved;

/// Contact forces, as a start for a solve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Forces {
    /// λν, length m.
    pub normal: Vec<f64>,
    /// λτ, length (d−1)m.
    pub tangential: Vec<f64>,
    /// Amounts of the kernel vectors, as in [`Solution::kernel_amounts`]; empty stands for 0.
    pub kernel_amounts: Vec<f64>,
}

impl Forces {
    /// The start in the solver's unknowns.
    pub(super) fn warm(&self, layout: &Layout) -> WarmStart {
        WarmStart {
            mu: layout.unknowns_of(&[&self.normal[..], &self.tangential].concat()),
            multiplier: self.kernel_amounts.clone(),
            slidings: None,
        }
    }
}

/// The outcome of a solve, everything in the caller's order and signs.
///
/// Look at [`status`](Solution::status) first: the forces are always admissible, but only with
/// [`Status::Converged`] are they a solution.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Solution {
    /// How the run ended.
    pub status: Status,
    /// u, length n. Zero with [`Status::NoEquilibrium`] and [`Status::Infeasible`]; empty for the pure dual form.
    pub displacement: Vec<f64>,
    /// λν, length m, positive in compression; negative only for pairs that never open.
    pub normal_force: Vec<f64>,
    /// λτ, length (d−1)m.
    pub tangential_force: Vec<f64>,
    /// Which pairs carry a normal force. Tied and bilateral pairs always do.
    pub closed: Vec<bool>,
    /// Which pairs have a friction force below their bound. Pairs without friction never do.
    pub stick: Vec<bool>,
    /// The gap left, d − N u, length m.
    pub gap: Vec<f64>,
    /// T u, length (d−1)m: what the next step takes as its previous slip.
    pub slip: Vec<f64>,
    /// The two slip bounds (forces) of each pair that hold at the solution; `None` for tied pairs.
    pub slip_bounds: Vec<Option<[f64; 2]>>,
    /// Independent check of the result. `bodies` is empty: without a mesh there are no moments. Of the pure
    /// dual form `equilibrium` compares the solver's Aλ − b with a fresh product.
    pub certificate: Certificate,
    /// Iterations, multiplications by A (the one for the certificate of a pure dual problem is not
    /// among them), residuals, objective.
    pub figures: Figures,
    /// One record per iteration, and one for each start.
    pub records: Vec<IterationRecord>,
    /// How many blocks of unknowns are open, closed, sticking, slipping.
    pub states: StateCounts,
    /// α: how much of each kernel vector there is in u beyond K⁺(f − Bᵀλ); a start for the next step.
    pub kernel_amounts: Vec<f64>,
    /// With [`Status::NoEquilibrium`]: a motion of the parts that float which nothing resists enough, over
    /// all dofs, the largest entry 1.
    pub unresisted_motion: Option<Vec<f64>>,
    /// With [`Status::Inaccurate`]: what of the certificate fails.
    pub failure: Option<Failure>,
    /// With [`Status::Infeasible`]: the pairs whose constraints contradict each other.
    pub contradiction: Option<Contradiction>,
    /// What the user should know about the input.
    pub notes: Vec<Note>,
    /// Sizes, engine, factorisation; `None` for the pure dual form.
    pub description: Option<Description>,
    /// The settings that were in force.
    pub settings: Settings,
    /// Wall-clock times. Here `assembly` is the checking of the input.
    pub times: Times,
}

impl Solution {
    /// What does not depend on the caller's numbering; no displacement, no notes.
    pub(super) fn new(solved: Solved, settings: &Settings, times: Times) -> Self {
        Self {
            displacement: Vec::new(),
            unresisted_motion: None,
            notes: Vec::new(),
            description: None,
            normal_force: solved.normal_forces().to_vec(),
            tangential_force: solved.tangential_forces().to_vec(),
            slip: solved.slip().to_vec(),
            failure: solved.failure,
            contradiction: solved.contradiction,
            closed: solved.closed,
            stick: solved.stick,
            gap: solved.gaps,
            slip_bounds: solved.slip_bounds,
            certificate: solved.certificate,
            status: solved.dual.status,
            figures: solved.dual.figures,
            states: solved.dual.active_set.counts(),
            records: solved.dual.records,
            kernel_amounts: solved.dual.multiplier,
            settings: settings.clone(),
            times,
        }
    }

    /// The forces, as a start for another solve.
    pub fn forces(&self) -> Forces {
        Forces {
            normal: self.normal_force.clone(),
            tangential: self.tangential_force.clone(),
            kernel_amounts: self.kernel_amounts.clone(),
        }
    }

    /// Did the method reach its tolerance?
    pub fn converged(&self) -> bool {
        self.status == Status::Converged
    }
}
