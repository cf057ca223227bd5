//! How A is applied: the choice of the engine, and A as an operator of the dual problem.

use std::sync::Arc;

use rayon::prelude::*;
use tresca_contact::Sliding;
use tresca_la::Parallelism;
use tresca_qcqp::operator::{Condensed, Factored};
use tresca_qcqp::{DualProblem, Engine, Equality, QcqpError};

use crate::body::SystemBody;
use crate::description::EngineChoice;
use crate::factors::Factors;
use crate::layout::Layout;

/// Up to this many dual unknowns A is formed by default, and its active blocks are factored: no
/// inner iteration at all. Above, forming A costs more than the some fifty multiplications that a
/// solve takes (it pays after about 120; measured on the two bricks).
const EXPLICIT_UP_TO: usize = 300;

/// Up to this many it is formed when several problems with the same A are to be solved: Coulomb's law
/// or load steps. 6000 unknowns take 144 MB.
const EXPLICIT_FOR_MANY_UP_TO: usize = 6000;

/// Largest patch of the local model of A (see `docs/reproduction.md` for what its size does).
pub const PAIRS_PER_PATCH: usize = 24;

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

/// The dual problem of the bodies, A applied by the engine (which is chosen already). b and e are zero.
pub(crate) fn dual_problem(
    bodies: &[SystemBody],
    factors: &Factors,
    layout: &Layout,
    slidings: &[Sliding],
    patches: Vec<Vec<usize>>,
    engine: Engine,
) -> Result<DualProblem<'static>, QcqpError> {
    let set = layout.set(slidings)?;
    let rhs = vec![0.0; layout.unknowns()];
    let problem = match engine {
        Engine::Factored => {
            let parts = bodies.iter().zip(&factors.bodies);
            let parts = parts
                .map(|(body, factor)| (&body.stiffness, Arc::clone(factor), body.coupling.clone()));
            DualProblem::new(Factored::new(parts.collect(), &patches), rhs, set)
        }
        Engine::Condensed => DualProblem::new(condensed(bodies, factors, patches)?, rhs, set),
        Engine::Explicit | Engine::Auto => {
            let all = Parallelism::Threads(rayon::current_num_threads());
            let explicit = condensed(bodies, factors, patches)?.explicit(all);
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
    bodies: &[SystemBody],
    factors: &Factors,
    patches: Vec<Vec<usize>>,
) -> Result<Condensed, QcqpError> {
    let parts = bodies.par_iter().zip(&factors.bodies);
    let parts: Option<Vec<_>> = parts
        .map(|(body, solver)| {
            Some((
                solver.trailing()?,
                body.coupling.restricted(body.trailing()),
            ))
        })
        .collect();
    let parts = parts.ok_or(QcqpError::NoTrailingBlock)?;
    Ok(Condensed::new(parts, patches))
}

/// G and S of all floating bodies, e left at zero; `None` when every body is held.
fn equality(bodies: &[SystemBody], unknowns: usize) -> Option<Equality> {
    let floating = || {
        bodies
            .iter()
            .filter_map(|body| Some((body, body.grounding.as_ref()?)))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factors::FactorWork;
    use faer::MatMut;
    use faer::sparse::{SparseColMat, SparseRowMat, Triplet};
    use tresca_la::{BodySolver, SolverWork, SymmetricMatrix};
    use tresca_qcqp::operator::Coupling;

    /// K⁻¹ = 1, without a factor.
    struct Factorless;

    impl BodySolver for Factorless {
        fn order(&self) -> usize {
            1
        }

        fn solve_many(&self, _: MatMut<'_, f64>) {}

        fn work(&self) -> SolverWork {
            SolverWork::default()
        }
    }

    #[test]
    fn engines_that_need_a_factor_refuse_solvers_without_one() {
        let entry = [Triplet::new(0, 0, 1.0)];
        let stiffness = SparseColMat::try_new_from_triplets(1, 1, &entry).unwrap();
        let coupling = SparseRowMat::try_new_from_triplets(1, 1, &entry).unwrap();
        let stiffness = SymmetricMatrix::from_lower(stiffness);
        let body = SystemBody::new(stiffness, None, Coupling::new(coupling));
        let factors = Factors {
            bodies: vec![Arc::new(Factorless)],
            work: FactorWork {
                nonzeros: 0.0,
                flops: 0.0,
                seconds: 0.0,
            },
        };
        let refused = condensed(&[body], &factors, vec![vec![0]]);
        assert!(matches!(refused, Err(QcqpError::NoTrailingBlock)));
    }
}
