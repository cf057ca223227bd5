//! Units of force, displacement and stiffness in which numbers of any size can be squared.
//!
//! Small displacements: what is 1e200 times as stiff, under the same load, moves 1e-200 times as far, and all that a
//! solve decides stays. The solver works in units of its own where the figures of a problem would over- or underflow
//! in sums of squares; they are powers of two, so that no digit changes. Everywhere else the units are 1.

use tresca_contact::Sliding;

use crate::load_case::{LoadCase, WarmStart};
use crate::measures::largest;
use crate::solved::Solved;
use crate::tame::unit_of;

/// The units of one solve; displacements are measured in force / stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Units {
    force: f64,
    stiffness: f64,
}

impl Units {
    /// Units for a load case of bodies whose stiffness is measured in `stiffness` already.
    pub fn of(case: &LoadCase, stiffness: f64) -> Self {
        let loads = case.loads.iter().map(|f| largest(f)).fold(0.0, f64::max);
        let lengths = [&case.gaps, &case.base, &case.origin];
        let lengths = lengths.into_iter().map(|x| largest(x));
        let length = lengths.fold(case.held, f64::max);
        Self {
            force: unit_of(loads.max(length * stiffness)),
            stiffness,
        }
    }

    /// Units for a problem of A and b alone, whose stiffness is in the weights of its unknowns.
    pub fn of_rhs(rhs: &[f64]) -> Self {
        Self {
            force: unit_of(largest(rhs)),
            stiffness: 1.0,
        }
    }

    /// The unit of force.
    pub fn force(self) -> f64 {
        self.force
    }

    /// Whether nothing changes.
    fn trivial(self) -> bool {
        self.force == 1.0 && self.stiffness == 1.0
    }

    fn length(self) -> f64 {
        self.force / self.stiffness
    }

    /// The load case in these units; `None` where it stays as it is.
    pub fn enter(self, case: &LoadCase) -> Option<LoadCase> {
        if self.trivial() {
            return None;
        }
        let (force, length) = (1.0 / self.force, 1.0 / self.length());
        let mut case = case.clone();
        case.loads.iter_mut().for_each(|f| scale(f, force));
        [&mut case.base, &mut case.gaps, &mut case.origin]
            .into_iter()
            .for_each(|x| scale(x, length));
        case.held *= length;
        let laws = case.slidings.iter_mut();
        laws.for_each(|law| *law = law.scaled(force));
        Some(case)
    }

    /// A start in these units.
    pub fn enter_start(self, start: &WarmStart) -> WarmStart {
        let (force, length) = (1.0 / self.force, 1.0 / self.length());
        let mut start = start.clone();
        scale(&mut start.mu, force);
        scale(&mut start.multiplier, length);
        let laws = start.slidings.iter_mut().flatten();
        laws.for_each(|law| *law = law.scaled(force));
        start
    }

    /// The result in the caller's units.
    pub fn leave(self, solved: &mut Solved, slidings: &[Sliding]) {
        if self.trivial() {
            return;
        }
        let (force, length) = (self.force, self.length());
        let work = force * length;
        solved
            .displacements
            .iter_mut()
            .for_each(|u| scale(u, length));
        scale(&mut solved.forces, force);
        scale(&mut solved.relative, length);
        scale(&mut solved.gaps, length);
        let bounds = solved.slip_bounds.iter_mut().flatten().flatten();
        bounds.for_each(|bound| *bound *= force);
        if let Some(contradiction) = &mut solved.contradiction {
            contradiction.by *= length;
        }
        solved.set_slidings(slidings);
        let dual = &mut solved.dual;
        scale(&mut dual.lambda, force);
        scale(&mut dual.gradient, length);
        scale(&mut dual.multiplier, length);
        dual.figures.sigma_max *= length / force;
        dual.figures.objective *= work;
        for record in &mut dual.records {
            record.objective *= work;
            record.decrease *= work;
        }
    }
}

fn scale(values: &mut [f64], factor: f64) {
    values.iter_mut().for_each(|x| *x *= factor);
}
