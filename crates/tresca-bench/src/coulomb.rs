//! What Coulomb's law costs beside Tresca's on the two bricks.

use tresca::{
    CoulombMethod, Engine, FrictionLaw, Model, Outcome, PairState, ScalarField, Settings, Silent,
};

use crate::BenchError;
use crate::table1::Counts;
use crate::two_bricks::{Units, two_bricks_with};

/// Both variants of Coulomb's law for one coefficient, and one solve with the final bounds frozen.
pub struct Comparison {
    /// Bounds by a fixed point around the whole solve.
    pub fixed_point: Outcome,
    /// Bounds that follow in every Newton step.
    pub in_loop: Outcome,
    /// Tresca's law with the bounds that the fixed point ends with.
    pub frozen: Outcome,
}

impl Comparison {
    /// Solves the bricks with s nodes per edge three times (condensed engine, GRSSN, zero start).
    ///
    /// # Errors
    /// When s < 2, or the coefficient or the tolerance is out of range.
    pub fn run(s: usize, coefficient: f64, tolerance: f64) -> Result<Self, BenchError> {
        let bricks = |law| two_bricks_with(s, Units::METRE_MEGAPASCAL, law);
        let settings = |coulomb| Settings {
            coulomb,
            tolerance,
            engine: Engine::Condensed,
            ..Settings::default()
        };
        let model = bricks(FrictionLaw::coulomb(coefficient))?;
        let fixed_point = solve(&model, &settings(CoulombMethod::FixedPoint))?;
        let in_loop = solve(&model, &settings(CoulombMethod::InLoop))?;
        let bound = |pair: &PairState| pair.slip_bounds.map_or(0.0, |[a, _]| a) / pair.pair.area;
        let bounds = fixed_point.last().pairs().map(bound).collect();
        let frozen = bricks(FrictionLaw::tresca(ScalarField::Values(bounds)))?;
        let frozen = solve(&frozen, &settings(CoulombMethod::FixedPoint))?;
        Ok(Self {
            fixed_point,
            in_loop,
            frozen,
        })
    }

    /// Updates of the bounds by the fixed point.
    pub fn updates(&self) -> usize {
        self.fixed_point.last().solution.figures.outer_iterations
    }

    /// Multiplications by A in the loop, as a multiple of those with frozen bounds.
    pub fn ratio(&self) -> f64 {
        let multiplications = |outcome| Counts::of(outcome).multiplications as f64;
        multiplications(&self.in_loop) / multiplications(&self.frozen)
    }

    /// ‖λ − λ'‖/‖λ'‖ of the two variants, λ' that of the fixed point.
    pub fn difference(&self) -> f64 {
        let [a, b] =
            [&self.in_loop, &self.fixed_point].map(|outcome| &outcome.last().solution.lambda);
        let norm = |squares: &mut dyn Iterator<Item = f64>| squares.sum::<f64>().sqrt();
        norm(&mut a.iter().zip(b).map(|(a, b)| (a - b).powi(2)))
            / norm(&mut b.iter().map(|b| b * b))
    }

    /// The three solves.
    pub fn outcomes(&self) -> [&Outcome; 3] {
        [&self.frozen, &self.fixed_point, &self.in_loop]
    }
}

fn solve(model: &Model, settings: &Settings) -> Result<Outcome, BenchError> {
    Ok(tresca::solve_with(model, settings, &mut Silent)?)
}
