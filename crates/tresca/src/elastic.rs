//! What of a body the dual problem needs: K, its grounding, B. The same for bodies that were meshed here
//! and for matrices that were brought along.

use std::borrow::Cow;
use std::sync::Arc;
use std::time::Instant;

use rayon::prelude::*;
use tresca_contact::Sliding;
use tresca_fem::rigid::Grounding;
use tresca_la::vector::{axpy, dot};
use tresca_la::{
    FactorError, Ordering, OrderingError, Parallelism, SparseCholesky, SymmetricMatrix,
};
use tresca_qcqp::operator::{Condensed, Coupling, Factored as FactoredOperator};
use tresca_qcqp::{DualProblem, Engine, Equality, QcqpError};

use crate::dual::{FactorWork, Factored};
use crate::layout::Layout;

/// A body over its free dofs.
#[derive(Clone, Copy)]
pub(crate) struct ElasticBody<'a> {
    /// K, singular when the body floats.
    pub stiffness: &'a SymmetricMatrix,
    /// C, R and S of a body that floats.
    pub grounding: Option<&'a Grounding>,
    /// The dofs that come last in the factorisation, ascending: those that B or C touches.
    pub trailing: &'a [usize],
    /// B over all unknowns of λ, weighted for the solver's unknowns (see [`Layout`]).
    pub coupling: &'a Coupling,
}

/// Why a body has no factor.
pub(crate) enum FactorFailure {
    Ordering(OrderingError),
    Factor(FactorError),
}

impl ElasticBody<'_> {
    /// K, or K + CCᵀ of a body that floats.
    pub fn regular_stiffness(&self) -> Cow<'_, SymmetricMatrix> {
        match self.grounding {
            None => Cow::Borrowed(self.stiffness),
            Some(grounding) => Cow::Owned(grounding.add_to(self.stiffness)),
        }
    }

    /// Orders and factors.
    pub fn factor(
        &self,
        contact_last: bool,
        parallelism: Parallelism,
    ) -> Result<SparseCholesky, FactorFailure> {
        let stiffness = self.regular_stiffness();
        let ordering = if contact_last {
            Ordering::nested_dissection_with_trailing(&stiffness, self.trailing)
        } else {
            Ordering::nested_dissection(&stiffness)
        };
        let ordering = ordering.map_err(FactorFailure::Ordering)?;
        SparseCholesky::factor(&stiffness, ordering, parallelism).map_err(FactorFailure::Factor)
    }
}

/// The threads for each of some bodies that are worked on side by side: they share them, and a body that
/// gets none of its own runs on one.
pub(crate) fn share_of_threads(bodies: usize) -> Parallelism {
    Parallelism::Threads((rayon::current_num_threads() / bodies.max(1)).max(1))
}

/// Orders and factors all bodies, side by side. A failure names the body.
pub(crate) fn factor(
    bodies: &[ElasticBody<'_>],
    contact_last: bool,
) -> Result<Factored, (usize, FactorFailure)> {
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
    Ok(Factored::new(factors, start.elapsed().as_secs_f64()))
}

impl Factored {
    /// The factors with what they cost.
    pub(crate) fn new(factors: Vec<SparseCholesky>, seconds: f64) -> Self {
        let factors: Vec<_> = factors.into_iter().map(Arc::new).collect();
        let work = FactorWork {
            nonzeros: factors
                .iter()
                .map(|factor| factor.factor_nonzeros() as f64)
                .sum(),
            flops: factors.iter().map(|factor| factor.flops()).sum(),
            seconds,
        };
        Self { factors, work }
    }
}

/// The dual problem of the bodies, A applied by the engine (which is chosen already). b and e are zero.
pub(crate) fn dual_problem(
    bodies: &[ElasticBody<'_>],
    factored: &Factored,
    layout: &Layout,
    slidings: &[Sliding],
    groups: Vec<Vec<usize>>,
    engine: Engine,
) -> Result<DualProblem<'static>, QcqpError> {
    let set = layout.set(slidings)?;
    let rhs = vec![0.0; layout.unknowns()];
    let problem = match engine {
        Engine::Factored => {
            let parts = bodies.iter().zip(&factored.factors);
            let parts = parts
                .map(|(body, factor)| (body.stiffness, Arc::clone(factor), body.coupling.clone()));
            DualProblem::new(FactoredOperator::new(parts.collect(), &groups), rhs, set)
        }
        Engine::Condensed => DualProblem::new(condensed(bodies, factored, groups), rhs, set),
        Engine::Explicit | Engine::Auto => {
            let all = Parallelism::Threads(rayon::current_num_threads());
            let explicit = condensed(bodies, factored, groups).explicit(all);
            DualProblem::new(explicit, rhs, set)
        }
    }?
    .with_coulomb(layout.coulomb(slidings))?;
    match equality(bodies, layout.unknowns()) {
        None => Ok(problem),
        Some(equality) => problem.with_equality(&equality),
    }
}

fn condensed(
    bodies: &[ElasticBody<'_>],
    factored: &Factored,
    groups: Vec<Vec<usize>>,
) -> Condensed {
    let parts = bodies.par_iter().zip(&factored.factors);
    let parts = parts
        .map(|(body, factor)| (factor.trailing(), body.coupling.restricted(body.trailing)))
        .collect();
    Condensed::new(parts, groups)
}

/// G and S of all floating bodies, e left at zero; `None` when every body is held.
fn equality(bodies: &[ElasticBody<'_>], unknowns: usize) -> Option<Equality> {
    let floating = || {
        bodies
            .iter()
            .filter_map(|body| Some((body, body.grounding?)))
    };
    let count: usize = floating().map(|(_, grounding)| grounding.r.len()).sum();
    if count == 0 {
        return None;
    }
    let mut rows = Vec::with_capacity(count);
    let mut metric = vec![vec![0.0; count]; count];
    for (body, grounding) in floating() {
        let first = rows.len();
        for (k, motion) in grounding.r.iter().enumerate() {
            let mut row = vec![0.0; unknowns];
            body.coupling.add_product(motion, &mut row);
            rows.push(row);
            for (l, &entry) in grounding.s[k].iter().enumerate() {
                metric[first + k][first + l] = entry;
            }
        }
    }
    Some(Equality {
        rows,
        rhs: vec![0.0; count],
        metric,
    })
}

/// e = Rᵀf of all floating bodies for loads over their free dofs.
pub(crate) fn load_on_motions(bodies: &[ElasticBody<'_>], loads: &[Vec<f64>]) -> Vec<f64> {
    let floating = bodies
        .iter()
        .zip(loads)
        .filter_map(|(body, f)| Some((body.grounding?, f)));
    floating
        .flat_map(|(grounding, f)| grounding.r.iter().map(move |r| dot(r, f)))
        .collect()
}

/// Adds R α to displacements over the free dofs; `alpha` holds the motions of all bodies in order.
pub(crate) fn add_motions(
    bodies: &[ElasticBody<'_>],
    alpha: &[f64],
    displacements: &mut [Vec<f64>],
) {
    let mut alpha = alpha.iter();
    for (body, u) in bodies.iter().zip(displacements) {
        for r in body.grounding.iter().flat_map(|grounding| &grounding.r) {
            if let Some(&amount) = alpha.next() {
                axpy(amount, r, u);
            }
        }
    }
}

/// K⁺(f − Bᵀλ) of each body over its free dofs, λ in the solver's unknowns μ.
pub(crate) fn displacements(
    bodies: &[ElasticBody<'_>],
    factored: &Factored,
    loads: &[Vec<f64>],
    mu: &[f64],
) -> Vec<Vec<f64>> {
    let minus: Vec<f64> = mu.iter().map(|x| -x).collect();
    bodies
        .par_iter()
        .zip(&factored.factors)
        .zip(loads)
        .map(|((body, factor), load)| {
            let mut u = load.clone();
            body.coupling.add_transposed_product(&minus, &mut u);
            factor.solve_in_place(&mut u);
            u
        })
        .collect()
}
