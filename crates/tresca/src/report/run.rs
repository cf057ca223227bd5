//! The report: a run, its steps.

use serde::Serialize;
use tresca_qcqp::{Figures, Settings, StateCounts, Status};
use tresca_system::certificate::{Certificate, Failure};

use super::contact::{ContactReport, ContactResultant};
use super::contradiction::ContradictionReport;
use super::motion::MotionReport;
use super::posed::{FclibReport, Reference};
use super::reactions::SupportReaction;
use super::system::SystemReport;
use super::times::TimesReport;
use crate::fclib::reduced::MatrixFacts;
use crate::fclib::residual::Residuals;

/// Version of the keys and their meaning. It grows when a key goes or comes to mean something else; new keys leave
/// it as it is.
pub const SCHEMA: u32 = 1;

/// Where a problem came in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Source {
    /// A model: a case file, or built by hand.
    Case,
    /// K, N, T and f as matrices.
    Matrices,
    /// A and b alone.
    Dual,
    /// A problem of FCLIB or Siconos.
    Fclib,
}

/// A run in figures, in the user's units.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct RunReport {
    /// [`SCHEMA`].
    pub schema: u32,
    /// Where the problem came in.
    pub door: Source,
    /// What the run is called: the name of the file without its extension.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Title of the case, or of the problem where its author gave one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Version of tresca.
    pub version: &'static str,
    /// How the run ended: as its last step, `interrupted` when steps are missing.
    pub status: Status,
    /// The method.
    pub method: &'static str,
    /// Iterations of all steps.
    pub iterations: usize,
    /// Multiplications by A in all steps, estimate of σmax included.
    pub n_a: usize,
    /// Multiplications that went into the estimate of σmax.
    pub n_a_setup: usize,
    /// Bodies and how A is applied; of cases and matrices.
    #[serde(flatten)]
    pub system: Option<SystemReport>,
    /// What was posed; of problems of FCLIB and Siconos.
    #[serde(flatten)]
    pub fclib: Option<FclibReport>,
    /// Steps that the run has.
    pub planned_steps: usize,
    /// The steps that were made.
    pub steps: Vec<StepReport>,
    /// Seconds.
    pub times: TimesReport,
    /// Peak memory of the process, where the system tells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_memory_bytes: Option<u64>,
    /// What the user should know about the input.
    pub notes: Vec<String>,
    /// Threads.
    pub threads: usize,
    /// All settings, resolved.
    pub settings: Settings,
}

/// A load step.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct StepReport {
    /// Its number, from 1.
    pub step: usize,
    /// Instant in the time series.
    pub time: f64,
    /// Its name in the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// How the method ended.
    pub status: Status,
    /// What the method did.
    #[serde(flatten)]
    pub figures: Figures,
    /// How many blocks of unknowns are open, closed, sticking, slipping.
    pub counts: StateCounts,
    /// The contact in figures.
    pub contact: ContactReport,
    /// The force that each contact hands from the slave to the master; of cases.
    pub resultants: Vec<ContactResultant>,
    /// What each support carries; of cases.
    pub reactions: Vec<SupportReaction>,
    /// Independent check of the result.
    pub certificate: Certificate,
    /// Distances to a solution, computed without the solver; of FCLIB.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub residuals: Option<Residuals>,
    /// What W is like; of FCLIB.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub matrix: Option<MatrixFacts>,
    /// Differences to the solution that came with the problem; of FCLIB.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference: Option<Reference>,
    /// With `no_equilibrium`: what moves without resistance; of cases.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unresisted_motion: Option<MotionReport>,
    /// With `inaccurate`: what of the certificate fails.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
    /// With `infeasible`: the pairs whose constraints contradict each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contradiction: Option<ContradictionReport>,
}

impl RunReport {
    /// A report of these steps, everything else left out.
    pub(super) fn new(
        door: Source,
        settings: &Settings,
        status: Status,
        steps: Vec<StepReport>,
    ) -> Self {
        let sum = |pick: fn(&Figures) -> usize| steps.iter().map(|step| pick(&step.figures)).sum();
        Self {
            schema: SCHEMA,
            door,
            name: None,
            title: None,
            version: crate::version::VERSION,
            status,
            method: settings.method.name(),
            iterations: sum(|figures| figures.iterations),
            n_a: sum(|figures| figures.n_a),
            n_a_setup: sum(|figures| figures.n_a_setup),
            system: None,
            fclib: None,
            planned_steps: 1,
            steps,
            times: TimesReport::default(),
            peak_memory_bytes: crate::memory::peak_bytes(),
            notes: Vec::new(),
            threads: rayon::current_num_threads(),
            settings: settings.clone(),
        }
    }

    /// Gives the run a name.
    #[must_use]
    pub fn named(mut self, name: &str) -> Self {
        self.name = Some(name.to_owned());
        self
    }

    /// Adds the seconds spent on the result files so far.
    #[must_use]
    pub fn with_output(mut self, seconds: f64) -> Self {
        self.times.output += seconds;
        self.times.total += seconds;
        self
    }

    /// Did every step reach its tolerance?
    pub fn converged(&self) -> bool {
        self.status.is_converged()
    }

    /// The step made last.
    ///
    /// # Panics
    /// Never: a run without a step has no report.
    pub fn last(&self) -> &StepReport {
        self.steps.last().expect("a run has at least one step")
    }
}

impl StepReport {
    /// A step with what every door knows.
    pub(super) fn new(
        status: Status,
        figures: Figures,
        counts: StateCounts,
        contact: ContactReport,
        certificate: Certificate,
    ) -> Self {
        Self {
            step: 1,
            time: 1.0,
            name: None,
            status,
            figures,
            counts,
            contact,
            resultants: Vec::new(),
            reactions: Vec::new(),
            certificate,
            residuals: None,
            matrix: None,
            reference: None,
            unresisted_motion: None,
            failure: None,
            contradiction: None,
        }
    }
}
