//! What a solve of a system gives back, whoever brought the matrices.

use tresca_contact::Sliding;
use tresca_qcqp::{DualSolution, Settings, Status};

use crate::certificate::{Certificate, Failure};
use crate::contradiction::Contradiction;
use crate::layout::Layout;
use crate::load_case::{LoadCase, WarmStart};
use crate::measures::{Elastic, Interface, Pairs, Scales};

/// Forces, displacements, states of the pairs and the certificate of a solve.
///
/// Look at the status of [`dual`](Solved::dual) first: the forces are always admissible, but only with
/// [`Status::Converged`] are they a solution.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Solved {
    /// Status, figures, iteration records; its vectors are in the solver's unknowns μ.
    pub dual: DualSolution,
    /// u of each body over its free dofs; zero with [`Status::NoEquilibrium`] and [`Status::Infeasible`], no body for a pure dual form.
    pub displacements: Vec<Vec<f64>>,
    /// λ = \[λν (m); λτ ((d−1) m)\], the contact forces.
    pub forces: Vec<f64>,
    /// B u = \[N u; T u\], approach and slip.
    pub relative: Vec<f64>,
    /// d − N u, length m.
    pub gaps: Vec<f64>,
    /// Which pairs carry a normal force. Tied and bilateral pairs always do.
    pub closed: Vec<bool>,
    /// Which pairs have a friction force below their bound. Pairs without tangents never do.
    pub stick: Vec<bool>,
    /// The two slip bounds (forces) of each pair that hold at the solution; `None` for tied pairs.
    pub slip_bounds: Vec<Option<[f64; 2]>>,
    /// Independent check of the result; the balances of bodies are added by those who know their geometry.
    pub certificate: Certificate,
    /// With [`Status::NoEquilibrium`]: a motion of the floating bodies which nothing resists enough, over their
    /// free dofs, the largest entry 1.
    pub unresisted: Option<Vec<Vec<f64>>>,
    /// With [`Status::Inaccurate`]: what of the certificate fails.
    pub failure: Option<Failure>,
    /// With [`Status::Infeasible`]: the pairs whose constraints contradict each other.
    pub contradiction: Option<Contradiction>,
    /// The laws that held.
    slidings: Vec<Sliding>,
}

/// What of a solve is measured where displacements are known, and where only A is.
pub(crate) struct Measured {
    pub displacements: Vec<Vec<f64>>,
    pub relative: Vec<f64>,
    pub elastic: Elastic,
    /// The largest displacement, free or prescribed.
    pub moved: f64,
    /// The largest displacement that the loads would cause without contact, or gap.
    pub free: f64,
    /// The dual energy; `None`: equilibrium holds by construction, and the gap follows from the pairs alone.
    pub dual_energy: Option<f64>,
    pub unresisted: Option<Vec<Vec<f64>>>,
    pub contradiction: Option<Contradiction>,
}

impl Solved {
    pub(crate) fn new(
        layout: &Layout,
        gaps: &[f64],
        slidings: &[Sliding],
        origin: &[f64],
        dual: DualSolution,
        measured: Measured,
    ) -> Self {
        let m = layout.pair_count();
        let Measured {
            displacements,
            relative,
            elastic,
            moved,
            free,
            dual_energy,
            unresisted,
            contradiction,
        } = measured;
        let forces = layout.forces(&dual.lambda);
        let since: Vec<f64> = relative.iter().zip(origin).map(|(r, o)| r - o).collect();
        let interface = Interface::new(&Pairs {
            layout,
            gaps,
            slidings,
            forces: &forces,
            relative: &since,
            largest_load: elastic.largest_load,
        });
        let scales = Scales::new(&elastic, &interface, moved, free);
        let (closed, stick) = (0..m).map(|i| layout.state(&dual.active_set, i)).unzip();
        let bounds = slidings.iter().zip(&forces);
        Self {
            gaps: gaps.iter().zip(&relative).map(|(d, r)| d - r).collect(),
            closed,
            stick,
            slip_bounds: bounds.map(|(law, &normal)| law.bounds(normal)).collect(),
            certificate: Certificate::new(&elastic, &interface, scales, dual_energy),
            slidings: slidings.to_vec(),
            dual,
            displacements,
            forces,
            relative,
            unresisted,
            failure: None,
            contradiction,
        }
    }

    /// The same under these laws, which differ in their units alone.
    pub(crate) fn set_slidings(&mut self, slidings: &[Sliding]) {
        self.slidings = slidings.to_vec();
    }

    /// Judges the answer once more, by those who have added to its certificate.
    pub fn judge_again(&mut self, settings: &Settings) {
        if self.dual.status == Status::Converged
            && let Some(failure) = self.certificate.failure(settings, 1.0)
        {
            self.dual.status = Status::Inaccurate;
            self.failure = Some(failure);
        }
    }

    /// λν.
    pub fn normal_forces(&self) -> &[f64] {
        &self.forces[..self.gaps.len()]
    }

    /// λτ.
    pub fn tangential_forces(&self) -> &[f64] {
        &self.forces[self.gaps.len()..]
    }

    /// T u.
    pub fn slip(&self) -> &[f64] {
        &self.relative[self.gaps.len()..]
    }

    /// A start for another solve of the same system.
    pub fn start(&self) -> WarmStart {
        WarmStart {
            mu: self.dual.lambda.clone(),
            multiplier: self.dual.multiplier.clone(),
            slidings: Some(self.slidings.clone()),
        }
    }

    /// Whether the run ended with a proof that nothing can hold the load.
    pub fn no_equilibrium(&self) -> bool {
        self.dual.status == Status::NoEquilibrium
    }
}

impl LoadCase {
    /// The slip origin of a step: friction counts slip from where the step before ended, glue from the start.
    pub fn origin_after(layout: &Layout, slidings: &[Sliding], relative: &[f64]) -> Vec<f64> {
        let mut origin = vec![0.0; layout.unknowns()];
        for i in layout.frictional(slidings) {
            origin[i] = relative[i];
        }
        origin
    }
}
