//! Do the bounds settle?

use super::law::relative_change;
use crate::status::Status;

/// Outer iterations without a smaller change after which the bounds are said not to settle.
const PATIENCE: usize = 10;
/// Longest cycle that is looked for.
pub(super) const LONGEST_CYCLE: usize = 6;
/// Something has returned when it differs from what it was by this part of its last change.
pub(super) const RETURNED: f64 = 0.1;

/// The bounds of the last outer iterations, and the smallest change among all.
#[derive(Default)]
pub(super) struct History {
    bounds: Vec<Vec<f64>>,
    smallest: Option<f64>,
    idle: usize,
}

impl History {
    /// Notes the bounds that follow from an outer iteration and the residual of that iteration;
    /// says so when they do not settle.
    pub fn note(&mut self, bounds: Vec<f64>, residual: f64) -> Option<Status> {
        if self.smallest.is_none_or(|smallest| residual < smallest) {
            self.smallest = Some(residual);
            self.idle = 0;
        } else {
            self.idle += 1;
        }
        self.bounds.push(bounds);
        (self.idle >= PATIENCE).then(|| {
            if self.returns() {
                Status::CoulombCycles
            } else {
                Status::CoulombDiverges
            }
        })
    }

    /// Whether the last bounds are those of a few iterations ago.
    fn returns(&self) -> bool {
        let [earlier @ .., before, last] = &self.bounds[..] else {
            return false;
        };
        let change = relative_change(last, before);
        let recent = earlier.iter().rev().take(LONGEST_CYCLE - 1);
        recent
            .into_iter()
            .any(|old| relative_change(last, old) <= RETURNED * change)
    }
}
