//! The pure dual form: A, b and the laws; no K, no displacements.

use std::time::Instant;

use tresca_contact::{Mobility, Sliding};
use tresca_la::SymmetricEntries;
use tresca_la::vector::{dot, norm};
use tresca_qcqp::{DualProblem, Settings, Start};

use super::error::AlgebraicError;
use super::friction::{Friction, PairLaw};
use super::note::Note;
use super::operator::{FunctionOperator, MatrixOperator, Operator, Scaling};
use super::solution::{Forces, Solution};
use super::{check, lengths};
use crate::contradiction::Contradiction;
use crate::description::Times;
use crate::judge;
use crate::layout::Layout;
use crate::load_case;
use crate::measures::{Elastic, largest, scale};
use crate::progress::{Progress, Stage, begin};
use crate::run;
use crate::solved::{Measured, Solved};
use crate::units::Units;

/// min ½ λᵀAλ − λᵀb over the admissible λ = \[λν (m); λτ ((d−1)m, components of a pair adjacent)\].
///
/// Aλ − b is \[gap left; −slip\]: with the matrices of a [`MatrixProblem`](super::MatrixProblem), A = B K⁻¹ Bᵀ and
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
    begin(progress, Stage::Assembly)?;
    let clock = Instant::now();
    let Dual {
        operator,
        rhs,
        tangents,
        friction,
        start,
    } = dual;
    let order = operator.order();
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
    let mut layout = check::layout(&laws, &vec![Mobility::FULL; m], tangents)?;
    let diagonal: Option<Vec<f64>> = match &operator {
        Operator::Dense { matrix, .. } => Some((0..order).map(|i| matrix.entry(i, i)).collect()),
        Operator::Product { diagonal, .. } => diagonal.clone(),
    };
    if let Some(diagonal) = diagonal.filter(|diagonal| diagonal.len() == order) {
        let lengths: Vec<f64> = diagonal.iter().map(|a| a.max(0.0).sqrt()).collect();
        if let Some(scales) = lengths::scales(&lengths, m, tangents) {
            layout = layout.with_scales(scales);
        }
    }
    let units = Units::of_rhs(&layout.dual(&rhs));
    let own = 1.0 / units.force();
    let rhs: Vec<f64> = rhs.iter().map(|b| own * b).collect();
    let theirs: Vec<_> = laws.iter().map(PairLaw::sliding).collect();
    let slidings: Vec<_> = theirs.iter().map(|law| law.scaled(own)).collect();
    let mut notes = Vec::new();
    check::note_ignored_figures(&laws, tangents, &mut notes);
    if let Operator::Dense { asymmetry, .. } = operator
        && asymmetry > 0.0
    {
        notes.push(Note::DualSymmetrised { asymmetry });
    }
    let coulomb = layout.coulomb(&slidings);
    let warm = match &start {
        None => None,
        Some(start) => {
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
            let mut mu = start.warm(&layout).mu;
            mu.iter_mut().for_each(|x| *x *= own);
            Some(mu)
        }
    };
    let set = load_case::set(&layout, &slidings, &coulomb, warm.as_deref())?;
    let weighted_rhs = layout.dual(&rhs);
    let scaling = Scaling::new(&layout);
    let mut problem = match operator {
        Operator::Dense { matrix, .. } => {
            DualProblem::new(MatrixOperator::new(matrix, scaling), weighted_rhs, set)?
        }
        Operator::Product {
            apply, diagonal, ..
        } => {
            if let Some(diagonal) = &diagonal {
                check::vector("the diagonal of A", diagonal, order, "order of A")?;
            }
            let diagonal = diagonal.unwrap_or_else(|| vec![1.0; order]);
            DualProblem::new(
                FunctionOperator::new(apply, diagonal, scaling),
                weighted_rhs,
                set,
            )?
        }
    }
    .with_coulomb(coulomb)?;
    let mut times = Times {
        assembly: clock.elapsed().as_secs_f64(),
        ..Times::default()
    };
    let start = warm.as_deref().map(Start::from);
    let solution = run::solve(&mut problem, start, settings, &mut times, progress)?;
    let clock = Instant::now();
    let solved = recover(&mut problem, &layout, &slidings, &rhs, solution);
    times.recovery += clock.elapsed().as_secs_f64();
    let mut solved = judge::judge(solved, settings, 1.0, |finer, last| {
        let start = Start::from(&last.dual.lambda[..]);
        let solution = run::solve(&mut problem, Some(start), finer, &mut times, progress)?;
        Ok(recover(&mut problem, &layout, &slidings, &rhs, solution))
    })?;
    units.leave(&mut solved, &theirs);
    Ok(Solution {
        notes,
        ..Solution::new(solved, settings, times)
    })
}

fn recover(
    problem: &mut DualProblem<'_>,
    layout: &Layout,
    slidings: &[Sliding],
    rhs: &[f64],
    solution: tresca_qcqp::DualSolution,
) -> Solved {
    let mu = &solution.lambda;
    let mut product = vec![0.0; mu.len()];
    problem.operator_mut().multiply(mu, &mut product);
    // B u = b − Aλ: less the gap left, and the slip.
    let weights = layout.weights();
    let relative: Vec<f64> = (0..mu.len())
        .map(|i| rhs[i] - product[i] / weights[i])
        .collect();
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
        load_work_size: 0.0,
        // Without contact the pairs would move by b: a force that takes that back.
        largest_load: match solution.figures.sigma_max {
            0.0 => 0.0,
            sigma => largest(&layout.forces(own)) / sigma,
        },
    };
    let nothing = vec![0.0; mu.len()];
    let gaps = &nothing[..layout.pair_count()];
    let proof = solution.contradiction.as_deref();
    let minus: Vec<f64> = rhs.iter().map(|b| -b).collect();
    let contradiction = proof.map(|y| Contradiction::new(layout, layout.forces(y), &minus));
    let measured = Measured {
        displacements: Vec::new(),
        moved: largest(&layout.dual(&relative)).max(largest(own)),
        free: largest(own),
        relative,
        elastic,
        dual_energy: None,
        unresisted: None,
        contradiction,
    };
    Solved::new(layout, gaps, slidings, &nothing, solution, measured)
}
