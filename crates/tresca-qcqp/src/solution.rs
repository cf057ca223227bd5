//! What a run returns.

use crate::active_set::ActiveSet;
use crate::equality::Statics;
use crate::figures::Figures;
use crate::record::IterationRecord;
use crate::settings::Method;
use crate::status::Status;

/// The outcome of one run.
///
/// Look at [`status`](DualSolution::status) first: `lambda` is always feasible, but
/// only with [`Status::Converged`] is it a solution.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct DualSolution {
    /// How the run ended.
    pub status: Status,
    /// The method that ran.
    pub method: Method,
    /// Iterations, multiplications, residuals, objective.
    pub figures: Figures,
    /// λ ∈ Λ: the last iterate if converged, else the best one seen (smallest
    /// reduced gradient).
    pub lambda: Vec<f64>,
    /// r(λ) = Aλ − b − Gᵀα as the method knew it (from its recurrences); Gᵀα is 0 without an
    /// equality constraint.
    pub gradient: Vec<f64>,
    /// State of every block at λ.
    pub active_set: ActiveSet,
    /// α, the multiplier of Gλ = e: the rigid motions. Empty without an equality constraint.
    pub multiplier: Vec<f64>,
    /// With [`Status::NoEquilibrium`] the proof, of unit length: a motion v with eᵀv > λᵀGᵀv for all
    /// λ ∈ Λ. The load drives it, and no admissible contact force can stop it.
    pub motion: Option<Vec<f64>>,
    /// With an equality constraint and an end without answer or proof: what statics say of it. `None` with
    /// any other end, and where Coulomb's bounds are what has not settled.
    pub statics: Option<Statics>,
    /// With [`Status::Infeasible`] the proof, of unit length: contact forces y that no sets limit, in the dual
    /// cone of the constraints, with Ay = 0 (and Gy = 0) and bᵀy > 0. Along y the dual objective falls
    /// without end; no displacement can satisfy the constraints whose entries in y are not zero.
    pub contradiction: Option<Vec<f64>>,
    /// One record per iteration, and one for each start.
    pub records: Vec<IterationRecord>,
}

impl DualSolution {
    /// Counts an earlier run, of which this is the continuation, as part of this one.
    pub fn follow(&mut self, earlier: &Self) {
        let (own, before) = (&mut self.figures, &earlier.figures);
        let (records, n_a) = (earlier.records.len(), before.n_a);
        let outer = earlier.records.last().map_or(0, |last| last.outer + 1);
        own.iterations += before.iterations;
        own.n_a += before.n_a;
        own.n_a_setup += before.n_a_setup;
        own.outer_iterations += before.outer_iterations;
        own.proximal_steps += before.proximal_steps;
        own.sweeps += before.sweeps;
        own.seconds_in_products += before.seconds_in_products;
        for record in &mut self.records {
            record.iteration += records;
            record.outer += outer;
            record.n_a += n_a;
        }
        self.records.splice(0..0, earlier.records.iter().cloned());
    }
}
