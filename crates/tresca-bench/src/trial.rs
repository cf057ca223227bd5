//! A model on the bench: the whole way to written files, timed, beside one linear solve of the same bodies.

use std::hint::black_box;
use std::time::Instant;

use tresca::output::Destination;
use tresca::{
    Description, FactorWork, Factors, Model, Outcome, PreparedModel, Settings, Silent, SolveError,
    Times, factor_error, memory,
};

use crate::BenchError;

/// A stopwatch for time and memory.
#[derive(Debug, Clone, Copy)]
pub struct Watch {
    begin: Instant,
}

impl Watch {
    /// Starts; the peak of memory counts from here, where the operating system allows it.
    pub fn start() -> Self {
        memory::reset_peak();
        Self {
            begin: Instant::now(),
        }
    }

    /// Seconds since the start.
    pub fn seconds(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }
}

/// A model that went the whole way once and is ready for more solves.
pub struct Trial<'a> {
    model: &'a Model,
    prepared: PreparedModel<'a>,
    first: Outcome,
    seconds: f64,
}

/// What the whole way cost.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Cost {
    /// Seconds from the start of the watch to the written files.
    pub seconds: f64,
    /// Seconds by stage.
    pub times: Times,
    /// Its factorisation, with the dofs of contact last where the engine wants it so.
    pub factorization: FactorWork,
    /// Peak memory of all solves in bytes, the yardstick's left out; `None` where the operating system does not tell.
    pub peak_memory_bytes: Option<u64>,
    /// The yardstick.
    pub linear: LinearSolve,
}

/// The yardstick: one linear solve of all bodies as if they did not touch. Plain nested dissection,
/// factorisation, one pair of sweeps; assembly is not part of it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LinearSolve {
    /// Seconds in all.
    pub seconds: f64,
    /// The factorisation.
    pub factorization: FactorWork,
}

impl<'a> Trial<'a> {
    /// Assembles, factors, solves and writes all files into a directory that is thrown away. The watch
    /// runs already, so that reading a case can be part of the way.
    ///
    /// # Errors
    /// When model or settings are wrong, or the files cannot be written.
    pub fn run(
        watch: Watch,
        name: &str,
        model: &'a Model,
        settings: &Settings,
    ) -> Result<Self, BenchError> {
        settings.validate().map_err(SolveError::from)?;
        let directory = tempfile::tempdir().map_err(BenchError::Directory)?;
        let mut prepared = tresca::prepare(model, settings, &mut Silent)?;
        let first = prepared.solve(settings, &mut Silent)?;
        Destination::new(directory.path())?.write(name, model, &first)?;
        Ok(Self {
            model,
            prepared,
            first,
            seconds: watch.seconds(),
        })
    }

    /// Sizes of the problem and the engine.
    pub fn description(&self) -> &Description {
        &self.first.description
    }

    /// The solve that belongs to the timed run.
    pub fn first(&self) -> &Outcome {
        &self.first
    }

    /// Seconds of the timed run.
    pub fn seconds(&self) -> f64 {
        self.seconds
    }

    /// Solves once more with other settings, from a zero start and with the factors that are there. The engine
    /// stays what it is.
    ///
    /// # Errors
    /// When the settings are wrong.
    pub fn again(&mut self, settings: &Settings) -> Result<Outcome, BenchError> {
        Ok(self.prepared.solve(settings, &mut Silent)?)
    }

    /// Lays the yardstick beside the timed run.
    ///
    /// # Errors
    /// When a stiffness matrix is not positive definite.
    pub fn cost(self) -> Result<Cost, BenchError> {
        let peak_memory_bytes = memory::peak_bytes();
        // Two sets of factors at a time are none of the contact solve's memory: the first goes here.
        let bodies = self.prepared.into_bodies();
        let begin = Instant::now();
        let plain = Factors::new(&bodies, false)
            .map_err(|(body, failure)| factor_error(self.model, body, failure))?;
        for factor in &plain.bodies {
            let mut u = vec![1.0; factor.order()];
            factor.solve_in_place(black_box(&mut u));
        }
        Ok(Cost {
            seconds: self.seconds,
            times: self.first.times,
            factorization: self.first.description.factorization,
            peak_memory_bytes,
            linear: LinearSolve {
                seconds: begin.elapsed().as_secs_f64(),
                factorization: plain.work,
            },
        })
    }
}
