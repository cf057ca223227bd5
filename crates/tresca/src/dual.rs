//! From matrices to the dual problem: factorisation, choice of engine, A.

use std::sync::Arc;

use tresca_la::SparseCholesky;
use tresca_qcqp::operator::groups;
use tresca_qcqp::{DualProblem, Engine};

use crate::SolveError;
use crate::assemble::Assembled;
use crate::elastic::{self, FactorFailure};
use crate::model::Model;

/// Up to this many dual unknowns A is formed by default, and its active blocks are factored: no
/// inner iteration at all. Above, forming A costs more than the some fifty multiplications that a
/// solve takes (it pays after about 120; measured on the two bricks).
const EXPLICIT_UP_TO: usize = 300;

/// Up to this many it is formed when several problems with the same A are to be solved: Coulomb's law
/// or load steps. 6000 unknowns take 144 MB.
const EXPLICIT_FOR_MANY_UP_TO: usize = 6000;

/// Largest patch of the local model of A (see `docs/reproduction.md` for what its size does).
pub(crate) const PAIRS_PER_PATCH: usize = 24;

/// The factored bodies.
pub struct Factored {
    /// One factor per body, `Arc` because the factored engine multiplies with it, too.
    pub factors: Vec<Arc<SparseCholesky>>,
    /// Sizes and speed.
    pub work: FactorWork,
}

/// What the factorisation cost.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
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

/// Which engine multiplies by A, and why.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct EngineChoice {
    /// The engine, never [`Engine::Auto`].
    pub engine: Engine,
    /// Why this one.
    pub reason: String,
}

/// Chooses the engine: what the user asked for, or by the size of the dual problem and by whether A
/// serves for `many` solves.
pub fn choose_engine(asked: Engine, unknowns: usize, many: bool) -> EngineChoice {
    let (engine, reason) = match asked {
        Engine::Auto if unknowns <= EXPLICIT_UP_TO => (
            Engine::Explicit,
            format!(
                "{unknowns} dual unknowns: A is small enough to be formed and its active blocks factored"
            ),
        ),
        Engine::Auto if many && unknowns <= EXPLICIT_FOR_MANY_UP_TO => (
            Engine::Explicit,
            format!(
                "{unknowns} dual unknowns, and A serves many solves (Coulomb friction or load steps): \
                 forming it pays"
            ),
        ),
        Engine::Auto => (
            Engine::Condensed,
            format!(
                "{unknowns} dual unknowns: triangular solves with the contact block of the factor \
                 cost less than forming A"
            ),
        ),
        asked => (asked, "asked for".to_owned()),
    };
    EngineChoice { engine, reason }
}

/// Orders and factors every body (a floating one grounded), the bodies side by side.
///
/// `contact_last` orders the contact dofs last, which the condensed and the explicit engine need;
/// without it the ordering is plain nested dissection.
///
/// # Errors
/// When a stiffness matrix is not positive definite.
pub fn factor(
    model: &Model,
    assembled: &Assembled,
    contact_last: bool,
) -> Result<Factored, SolveError> {
    elastic::factor(&assembled.elastic(), contact_last).map_err(|(body, failure)| {
        let body = model.bodies()[body].name.clone();
        match failure {
            FactorFailure::Ordering(source) => SolveError::Ordering { body, source },
            FactorFailure::Factor(source) => SolveError::Factorization { body, source },
        }
    })
}

/// The dual problem of the model, A applied by the chosen engine. b, e and the slip bounds are those of
/// no load at all: every load step sets its own.
///
/// # Errors
/// When the dual problem is refused (never for a checked model).
pub fn dual_problem(
    model: &Model,
    assembled: &Assembled,
    factored: &Factored,
    engine: Engine,
) -> Result<DualProblem<'static>, SolveError> {
    let slidings: Vec<_> = assembled.pairs().map(|pair| pair.sliding).collect();
    let groups = groups_of_neighbours(model.dimension(), assembled);
    let bodies = assembled.elastic();
    let layout = &assembled.layout;
    Ok(elastic::dual_problem(
        &bodies, factored, layout, &slidings, groups, engine,
    )?)
}

/// The unknowns of neighbouring pairs, contact by contact: the patches of the local model of A.
fn groups_of_neighbours(dimension: usize, assembled: &Assembled) -> Vec<Vec<usize>> {
    let mut first = 0;
    let mut pairs = Vec::new();
    for contact in &assembled.contacts {
        let points: Vec<[f64; 3]> = contact.pairs.iter().map(|pair| pair.point).collect();
        let patches = groups::neighbours(&points, PAIRS_PER_PATCH);
        pairs.extend(
            patches
                .into_iter()
                .map(|patch| patch.into_iter().map(|i| first + i).collect::<Vec<_>>()),
        );
        first += points.len();
    }
    groups::unknowns_of_pairs(&pairs, dimension)
}

/// Displacements over the full dofs from their free parts and the prescribed rest.
pub(crate) fn full_displacements(
    assembled: &Assembled,
    free: &[Vec<f64>],
    prescribed: &[Vec<f64>],
) -> Vec<Vec<f64>> {
    let bodies = assembled.bodies.iter().zip(free).zip(prescribed);
    bodies
        .map(|((system, free), prescribed)| {
            let mut u = prescribed.clone();
            system.dofs.write_free(free, &mut u);
            u
        })
        .collect()
}
