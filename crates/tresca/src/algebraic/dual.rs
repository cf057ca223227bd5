//! The pure dual form: A, b and the laws; no K, no displacements.

use std::time::Instant;

use tresca_contact::Mobility;
use tresca_la::vector::{dot, norm};
use tresca_qcqp::{DualProblem, Settings, Start};

use super::operator::{Function, Matrix, Operator, Scaling};
use super::{AlgebraicError, Forces, Friction, Law, Note, Solution, check};
use crate::layout::Layout;
use crate::measures::{Elastic, Interface, Pairs, certificate, largest, scale};
use crate::progress::{Progress, Stage};
use crate::{Certificate, Times};

/// min ½ λᵀAλ − λᵀb over the admissible λ = \[λν (m); λτ ((d−1)m, components of a pair adjacent)\].
///
/// Aλ − b is \[gap left; −slip\]: with the matrices of a [`Problem`](super::Problem), A = B K⁻¹ Bᵀ and
/// b = B K⁻¹ f − \[d; 0\].
pub struct Dual<'a> {
    /// A.
    pub operator: Operator<'a>,
    /// b.
    pub rhs: Vec<f64>,
    /// Tangents per pair: 0, 1 or 2.
    pub tangents: usize,
    /// The friction laws of the pairs.
    pub friction: Friction,
    /// Where to start from.
    pub start: Option<Forces>,
}

impl<'a> Dual<'a> {
    /// A problem without a start.
    pub fn new(
        operator: Operator<'a>,
        rhs: Vec<f64>,
        tangents: usize,
        friction: impl Into<Friction>,
    ) -> Self {
        Self {
            operator,
            rhs,
            tangents,
            friction: friction.into(),
            start: None,
        }
    }

    /// Sets the forces to start from.
    #[must_use]
    pub fn with_start(mut self, start: Forces) -> Self {
        self.start = Some(start);
        self
    }
}

/// Solves the pure dual form. `displacement` of the solution is empty.
///
/// # Errors
/// When A, b, a law or a setting is wrong. How the solve ended stands in the solution.
pub fn solve_dual(
    dual: Dual,
    settings: &Settings,
    progress: &mut dyn Progress,
) -> Result<Solution, AlgebraicError> {
    settings.validate()?;
    let begin = Instant::now();
    let mut stopped = progress.stage(Stage::Assembly).is_break();
    let Dual {
        operator,
        rhs,
        tangents,
        friction,
        start,
    } = dual;
    let order = operator.order();
    if order == 0 {
        return Err(AlgebraicError::NoPairs);
    }
    if tangents > 2 || !order.is_multiple_of(tangents + 1) {
        return Err(AlgebraicError::Shape {
            what: "A",
            rows: order,
            columns: order,
            expected: format!("an order of {} per contact pair", tangents.min(2) + 1),
        });
    }
    let m = order / (tangents + 1);
    check::vector("the right-hand side b", &rhs, order, "order of A")?;
    let laws = friction.laws(m)?;
    let layout = check::layout(&laws, &vec![Mobility::FULL; m], tangents)?;
    let slidings: Vec<_> = laws.iter().map(Law::sliding).collect();
    let mut notes = Vec::new();
    check::note_ignored_figures(&laws, tangents, &mut notes);
    if let Operator::Dense { asymmetry, .. } = operator
        && asymmetry > 0.0
    {
        notes.push(Note::DualSymmetrised { asymmetry });
    }
    let mut set = layout.set(&slidings)?;
    let coulomb = layout.coulomb(&slidings);
    let mut lambda = None;
    if let Some(start) = &start {
        check::vector(
            "the start of the normal forces",
            &start.normal,
            m,
            "one per contact pair",
        )?;
        let tangential = &start.tangential;
        check::vector(
            "the start of the tangential forces",
            tangential,
            tangents * m,
            "tangents",
        )?;
        for bound in &coulomb {
            let guess = (bound.coefficient * start.normal[bound.normal].max(0.0)).min(bound.limit);
            set.set_bound(bound.block, guess)?;
        }
        lambda = Some(layout.unknowns_of(&[&start.normal[..], &start.tangential].concat()));
    }
    let weighted_rhs = layout.dual(&rhs);
    let scaling = Scaling::new(&layout);
    let mut problem = match operator {
        Operator::Dense { matrix, .. } => {
            DualProblem::new(Matrix::new(matrix, scaling), weighted_rhs, set)?
        }
        Operator::Product {
            apply, diagonal, ..
        } => {
            if let Some(diagonal) = &diagonal {
                check::vector("the diagonal of A", diagonal, order, "order of A")?;
            }
            let diagonal = diagonal.unwrap_or_else(|| vec![1.0; order]);
            DualProblem::new(Function::new(apply, diagonal, scaling), weighted_rhs, set)?
        }
    }
    .with_coulomb(coulomb)?;
    let assembly = begin.elapsed().as_secs_f64();

    stopped |= progress.stage(Stage::Solve).is_break();
    let begin = Instant::now();
    let mut observer = |record: &tresca_qcqp::IterationRecord| {
        let flow = progress.iteration(record);
        if std::mem::take(&mut stopped) {
            std::ops::ControlFlow::Break(())
        } else {
            flow
        }
    };
    let start = lambda.as_deref().map(Start::from);
    let solution = tresca_qcqp::solve(&mut problem, settings, start, &mut observer)?;
    let solve = begin.elapsed().as_secs_f64();
    let multiplications = solution.seconds_in_products;

    let _ = progress.stage(Stage::Recovery);
    let begin = Instant::now();
    let mut outcome = recover(&mut problem, &layout, &slidings, &rhs, solution);
    outcome.notes = notes;
    outcome.settings = settings.clone();
    outcome.times = Times {
        assembly,
        contact: 0.0,
        factorization: 0.0,
        solve,
        multiplications,
        recovery: begin.elapsed().as_secs_f64(),
    };
    Ok(outcome)
}

fn recover(
    problem: &mut DualProblem,
    layout: &Layout,
    slidings: &[tresca_contact::Sliding],
    rhs: &[f64],
    solution: tresca_qcqp::Solution,
) -> Solution {
    let m = layout.pair_count();
    let mu = &solution.lambda;
    let mut product = vec![0.0; mu.len()];
    problem.operator_mut().multiply(mu, &mut product);
    // r = Aλ − b, its first part the gap left, its second part the negative slip.
    let weights = layout.weights();
    let r: Vec<f64> = (0..mu.len())
        .map(|i| product[i] / weights[i] - rhs[i])
        .collect();
    let lambda = layout.forces(mu);
    let relative: Vec<f64> = r.iter().map(|r| -r).collect();
    let interface = Interface::new(&Pairs {
        layout,
        gaps: &vec![0.0; m],
        slidings,
        lambda: &lambda,
        relative: &relative,
        previous: &vec![0.0; r.len()],
    });
    let own = problem.rhs();
    let inconsistency: Vec<f64> = (0..mu.len())
        .map(|i| product[i] - own[i] - solution.gradient[i])
        .collect();
    let energy = 0.5 * dot(mu, &product);
    // The energy of the dual form itself takes the place of the elastic one: the primal energy less that of
    // the bodies without contact is ½λᵀAλ + Σ h.
    let elastic = Elastic {
        residual: norm(&inconsistency) / scale(norm(own)),
        strain_work: 2.0 * energy,
        load_work: 0.0,
        energy: scale(energy),
    };
    let certificate = Certificate {
        duality_gap: interface.duality_gap() / elastic.energy,
        ..certificate(&elastic, &interface, largest(&r).max(largest(rhs)), 0.0)
    };
    let states: Vec<_> = (0..m)
        .map(|i| layout.state(&solution.active_set, i))
        .collect();
    let bounds = slidings.iter().zip(&lambda);
    Solution {
        status: solution.status,
        displacement: Vec::new(),
        normal_force: lambda[..m].to_vec(),
        tangential_force: lambda[m..].to_vec(),
        closed: states.iter().map(|state| state.0).collect(),
        stick: states.iter().map(|state| state.1).collect(),
        gap: r[..m].to_vec(),
        slip: relative[m..].to_vec(),
        slip_bounds: bounds.map(|(law, &normal)| law.bounds(normal)).collect(),
        certificate,
        relative_reduced_gradient: solution.relative_reduced_gradient,
        dual_objective: solution.objective,
        equality_residual: solution.equality_residual,
        outer_iterations: solution.outer_iterations,
        outer_residual: solution.outer_residual,
        iterations: solution.iterations,
        records: solution.records,
        n_a: solution.n_a,
        n_a_setup: solution.n_a_setup,
        sigma_max: solution.sigma_max,
        kernel_amounts: Vec::new(),
        unresisted_motion: None,
        notes: Vec::new(),
        description: None,
        settings: Settings::default(),
        times: Times::default(),
    }
}
