//! Is there an equilibrium?
//!
//! Whether Gλ = e has a solution in Λ is asked of statics alone, before any elasticity: the
//! distance ½‖ẽ − G̃λ‖² is made smallest over Λ by the proximal point method,
//!
//! ```text
//! λ⁺ = argmin ½‖ẽ − G̃λ‖² + δ/2 ‖λ − λᵏ‖²  =  P_Λ(λᵏ + G̃ᵀv/δ)   where   v = ẽ − G̃ P_Λ(λᵏ + G̃ᵀv/δ),
//! ```
//!
//! δ falling. The equation for v is that of a rigid body on a Winkler foundation of compliance δ.
//! Either the distance falls to rounding, or v
//! becomes a proof: ẽᵀv > sup λᵀG̃ᵀv over Λ. Where neither comes about, a conic solver answers the same
//! question; its answer is only where the proximal point method starts again, and what is looked at in the
//! same way.

use super::attainable::AttainableForces;
use super::balance::Balance;
use super::conic;
use super::foundation::Foundation;
use super::statics::Statics;
use tresca_la::vector::{dot, norm};

/// ‖ẽ − G̃λ‖/‖ẽ‖ that counts as equilibrium, and where nothing comes nearer.
const BALANCED: f64 = 1e-12;
const NEARLY_BALANCED: f64 = 1e-9;
/// Part of the load, as power on v, that must remain for the proof.
const LEAST_POWER: f64 = 1e-8;
/// What an entry of G̃ᵀv may be wrong by, relative to the length of its column, where a force has no
/// limit; and how many times the load such a force may be, while the proof stands.
const SLACK: f64 = 1e-10;
const MOST_FORCE: f64 = 1e6;
/// Friction less by this part makes the load impossible: it is at the limit.
const AT_THE_LIMIT: f64 = 1e-6;
const MAX_PROXIMAL_STEPS: usize = 40;
/// δ of the first step, and the smallest one, in squares of the longest column of G̃; what it is divided by.
const SOFTEST: f64 = 0.1;
const STIFFEST: f64 = 1e-9;
const STIFFENING: f64 = 10.0;
/// The same where the conic solver has said where to start.
const SOFTEST_AGAIN: f64 = 1e-3;
const MAX_PROXIMAL_STEPS_AGAIN: usize = 12;

/// What statics say.
pub(crate) enum Equilibrium {
    /// Some λ ∈ Λ balances the load.
    Possible,
    /// None does: the motion v in scaled coordinates, and the λ ∈ Λ that comes nearest.
    Impossible { motion: Vec<f64>, lambda: Vec<f64> },
    /// Neither is proved: the load is so close to the largest one that rounding decides, or no solver
    /// has an answer.
    Undecided,
}

/// Looks for a λ in `reach` that balances the load.
pub(crate) fn find(balance: &Balance, reach: &AttainableForces) -> Equilibrium {
    let question = Question::new(balance, reach);
    if question.load == 0.0 {
        return Equilibrium::Possible;
    }
    let nothing = vec![0.0; question.columns.len()];
    question
        .ascend(nothing, balance.load.clone(), SOFTEST, MAX_PROXIMAL_STEPS)
        .or_else(|| question.ask())
        .unwrap_or(Equilibrium::Undecided)
}

/// The same with the conic solver asked at once, for a load that is not known to be in equilibrium although
/// it may have seemed so.
pub(crate) fn find_anew(balance: &Balance, reach: &AttainableForces) -> Equilibrium {
    let question = Question::new(balance, reach);
    question.ask().unwrap_or(Equilibrium::Undecided)
}

/// What there is to say of a load that is not impossible.
pub(crate) fn statics(balance: &Balance, reach: &AttainableForces) -> Statics {
    let less = reach.with_less_friction(1.0 - AT_THE_LIMIT);
    if let Equilibrium::Impossible { .. } = find(balance, &less) {
        return Statics::AtTheLimit;
    }
    match find(balance, reach) {
        Equilibrium::Possible => Statics::Balanced,
        Equilibrium::Impossible { .. } | Equilibrium::Undecided => Statics::Undecided,
    }
}

/// The question, with what its answers are measured by.
struct Question<'a> {
    balance: &'a Balance,
    reach: &'a AttainableForces,
    /// Lengths of the columns of G̃.
    columns: Vec<f64>,
    /// Square of the largest.
    scale: f64,
    /// ‖ẽ‖.
    load: f64,
}

impl<'a> Question<'a> {
    fn new(balance: &'a Balance, reach: &'a AttainableForces) -> Self {
        let dim = balance.rows.first().map_or(0, Vec::len);
        let square = |i: usize| balance.rows.iter().map(|row| row[i] * row[i]).sum::<f64>();
        let columns: Vec<f64> = (0..dim).map(|i| square(i).sqrt()).collect();
        let largest = columns.iter().copied().fold(0.0, f64::max);
        Self {
            balance,
            reach,
            columns,
            // With no contact row at all any δ will do.
            scale: if largest > 0.0 {
                largest * largest
            } else {
                1.0
            },
            load: norm(&balance.load),
        }
    }

    /// The proximal point method from λ, v and δ.
    fn ascend(
        &self,
        mut lambda: Vec<f64>,
        mut v: Vec<f64>,
        softest: f64,
        steps: usize,
    ) -> Option<Equilibrium> {
        let mut delta = softest * self.scale;
        for _ in 0..steps {
            let step = Foundation {
                balance: self.balance,
                reach: self.reach,
                centre: &lambda,
                compliance: delta,
            };
            step.settle(&vec![0.0; v.len()], 1.0, &mut v);
            lambda = step.forces(&v).1;
            if self.misses(&lambda) <= BALANCED {
                return Some(Equilibrium::Possible);
            }
            if self.proves_impossible(&v) {
                return Some(Equilibrium::Impossible { motion: v, lambda });
            }
            delta = f64::max(delta / STIFFENING, STIFFEST * self.scale);
        }
        None
    }

    /// The conic solver's answer, made finer by the proximal point method where it is not good enough.
    fn ask(&self) -> Option<Equilibrium> {
        let columns: Vec<Vec<(usize, f64)>> = (0..self.columns.len())
            .map(|i| {
                let entries = self.balance.rows.iter().map(|row| row[i]).enumerate();
                entries.filter(|(_, g)| *g != 0.0).collect()
            })
            .collect();
        let nearest = conic::nearest(&conic::Question {
            columns: &columns,
            load: &self.balance.load,
            reach: self.reach,
        })?;
        let (mut lambda, motion) = (nearest.lambda, nearest.motion);
        self.reach.project(&mut lambda);
        let remains = self.balance.shortfall(&lambda);
        if self.misses(&lambda) <= BALANCED {
            return Some(Equilibrium::Possible);
        }
        if let Some(motion) = [&remains, &motion]
            .into_iter()
            .find(|v| self.proves_impossible(v))
        {
            let motion = motion.clone();
            return Some(Equilibrium::Impossible { motion, lambda });
        }
        let balanced = self.misses(&lambda) <= NEARLY_BALANCED;
        self.ascend(lambda, remains, SOFTEST_AGAIN, MAX_PROXIMAL_STEPS_AGAIN)
            .or(balanced.then_some(Equilibrium::Possible))
    }

    /// ‖ẽ − G̃λ‖/‖ẽ‖.
    fn misses(&self, lambda: &[f64]) -> f64 {
        norm(&self.balance.shortfall(lambda)) / self.load
    }

    /// ẽᵀv > sup λᵀG̃ᵀv.
    fn proves_impossible(&self, v: &[f64]) -> bool {
        let mut driven = vec![0.0; self.columns.len()];
        self.balance.add_transposed(v, &mut driven);
        let size = norm(v);
        let held = self
            .reach
            .support(&driven, &self.columns, |driven, column| {
                if driven <= SLACK * column * size {
                    driven * MOST_FORCE * self.load / column
                } else {
                    f64::INFINITY
                }
            });
        dot(&self.balance.load, v) - held > LEAST_POWER * self.load * size
    }
}
