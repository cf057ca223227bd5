//! K⁻¹ of all bodies.

use std::sync::Arc;
use std::time::Instant;

use rayon::prelude::*;
use serde::Serialize;
use tresca_la::{BodySolver, Parallelism};

use crate::body::{FactorFailure, SystemBody};

/// What the factorisation cost.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FactorWork {
    /// Nonzeros of all factors.
    pub nonzeros: f64,
    /// Floating-point operations of the numerical factorisations.
    pub flops: f64,
    /// Seconds for ordering, symbolic analysis and numerical factorisation of all bodies.
    pub seconds: f64,
}

impl FactorWork {
    /// GFLOP/s reached, ordering and analysis included.
    pub fn gigaflops_per_second(&self) -> f64 {
        self.flops / self.seconds / 1e9
    }
}

/// The threads for each of some bodies that are worked on side by side: they share them, and a body that
/// gets none of its own runs on one.
pub(crate) fn share_of_threads(bodies: usize) -> Parallelism {
    Parallelism::Threads((rayon::current_num_threads() / bodies.max(1)).max(1))
}

/// The factors of some bodies.
pub struct Factors {
    /// K⁻¹ of each body, `Arc` because the factored engine multiplies with it, too.
    pub bodies: Vec<Arc<dyn BodySolver>>,
    /// Sizes and speed.
    pub work: FactorWork,
}

impl Factors {
    /// Orders and factors all bodies (floating ones grounded), side by side.
    ///
    /// `contact_last` orders the contact dofs last, which the condensed and the explicit engine need;
    /// without it the ordering is plain nested dissection.
    ///
    /// # Errors
    /// When a stiffness matrix is not positive definite, with the number of the body.
    pub fn new(bodies: &[SystemBody], contact_last: bool) -> Result<Self, (usize, FactorFailure)> {
        let start = Instant::now();
        let parallelism = share_of_threads(bodies.len());
        let factors = bodies
            .par_iter()
            .enumerate()
            .map(|(index, body)| {
                body.factor(contact_last, parallelism)
                    .map_err(|failure| (index, failure))
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Self::of(factors, start.elapsed().as_secs_f64()))
    }

    /// Factors that are there, with the seconds that they took.
    pub(crate) fn of(bodies: Vec<Arc<dyn BodySolver>>, seconds: f64) -> Self {
        let works = || bodies.iter().map(|body| body.work());
        let work = FactorWork {
            nonzeros: works().map(|work| work.nonzeros as f64).sum(),
            flops: works().map(|work| work.flops).sum(),
            seconds,
        };
        Self { bodies, work }
    }

    /// K⁺(f − Bᵀλ) of each body, λ in the solver's unknowns μ.
    pub(crate) fn displacements(
        &self,
        bodies: &[SystemBody],
        loads: &[Vec<f64>],
        mu: &[f64],
    ) -> Vec<Vec<f64>> {
        let minus: Vec<f64> = mu.iter().map(|x| -x).collect();
        bodies
            .par_iter()
            .zip(&self.bodies)
            .zip(loads)
            .map(|((body, factor), load)| {
                let mut u = load.clone();
                body.coupling.add_transposed_product(&minus, &mut u);
                factor.solve_in_place(&mut u);
                u
            })
            .collect()
    }
}
