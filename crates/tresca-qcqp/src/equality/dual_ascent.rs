//! The next multiplier.
//!
//! The dual function d(β) = min over Λ of q(λ) − βᵀ(G̃λ − ẽ) is concave with gradient ẽ − G̃λ(β) and
//! generalised Hessian −H, 0 ⪯ H ⪯ I, since the operator holds G̃ᵀG̃. So
//!
//! ```text
//! δβ = (H + εI)⁻¹ (ẽ − G̃λ)
//! ```
//!
//! is Newton's step for ε → 0, and for ε = 1 as careful as the method of multipliers (δβ = ẽ − G̃λ),
//! which always converges. A body that has not landed has H = 0: it then falls in strides that grow.

use super::compliance::Compliance;
use faer::linalg::solvers::{Llt, Solve};
use faer::{ColMut, Side};
use tresca_la::vector::{axpy, dot, norm};

/// ε of the first step.
const FIRST: f64 = 1e-3;
/// ε is divided by this after a full step that was taken, down to [`LEAST`]; after a shortened one it is divided
/// by the length, up to 1.
const EASING: f64 = 10.0;
const LEAST: f64 = 1e-13;
/// Part of the slope that d must gain (Armijo).
const SUFFICIENT: f64 = 1e-4;
/// A residual smaller by this factor is a gain too, for d itself is as good as the inner solves and rounding
/// allow; unless d seems to have fallen by this part of its slope, and the slope at the end of the step is as
/// much against it. Else a body may slide past where it sticks, to and fro, ever further.
const CONTRACTION: f64 = 0.7;
const PAST: f64 = 0.03;
/// Where so much of the slope is left at the end of a shortened step that gained, the next may go further: to
/// the geometric mean of this length and the one that failed.
const FLAT: f64 = 0.5;
/// Bounds of the factor by which a step is shortened, and how often, before the step of the method
/// of multipliers is made. Where d is known a step that is short enough gains: it takes as many to find the
/// narrow range in which a body sticks, far beyond which it slides to and fro.
const SHORTENED: (f64, f64) = (0.05, 0.7);
const SHORTENED_AGAIN: f64 = 0.4;
const MAX_SHORTENINGS: usize = 10;
const MAX_SHORTENINGS_BLIND: usize = 5;

/// A multiplier with what is known there.
pub(super) struct Station {
    pub beta: Vec<f64>,
    /// λ(β).
    pub lambda: Vec<f64>,
    /// ẽ − G̃λ.
    pub shortfall: Vec<f64>,
    /// d(β), as good as the inner solve; `None` where there is no such function (bounds that follow λ).
    pub value: Option<f64>,
}

/// A step, and what it is expected to do to λ.
struct Direction {
    beta: Vec<f64>,
    lambda: Vec<f64>,
}

/// Where the ascent stands between two inner solves.
enum Trial {
    /// The end of the step of this length is awaited.
    /// and `failed` is the length that did not gain before.
    Step {
        length: f64,
        failed: f64,
        shortenings: usize,
    },
    /// The full step failed, with this slope at its end; what a step from there leads to is awaited.
    Excursion { slope: f64 },
    /// The step of the method of multipliers is awaited: it counts, come what may.
    Careful,
}

/// The ascent of d.
pub(super) struct DualAscent {
    base: Option<(Station, Direction)>,
    trial: Trial,
    epsilon: f64,
}

impl DualAscent {
    pub fn new() -> Self {
        Self {
            base: None,
            trial: Trial::Careful,
            epsilon: FIRST,
        }
    }

    /// The next β after that of `station`, and the λ to be expected there (not projected).
    /// `compliance` is asked for H at the station where it is needed.
    pub fn next(
        &mut self,
        station: Station,
        compliance: impl FnOnce() -> Compliance,
    ) -> (Vec<f64>, Vec<f64>) {
        let Some((base, direction)) = self.base.take() else {
            return self.leave(station, compliance());
        };
        if self.gains(&base, &direction, &station) {
            match self.trial {
                // As short a step would have come from so much more ε where H vanishes.
                Trial::Step {
                    length,
                    failed,
                    shortenings,
                } if shortenings > 0 => {
                    let slope = dot(&station.shortfall, &direction.beta);
                    let flat = slope > FLAT * dot(&base.shortfall, &direction.beta);
                    self.stiffen(if flat {
                        (length * failed).sqrt()
                    } else {
                        length
                    });
                }
                Trial::Excursion { .. } => {
                    let moved = distance(&station.beta, &base.beta);
                    self.stiffen(f64::min(moved / norm(&direction.beta), 1.0));
                }
                _ => self.epsilon = f64::max(self.epsilon / EASING, LEAST),
            }
            return self.leave(station, compliance());
        }
        let slope = dot(&station.shortfall, &direction.beta);
        let next = match self.trial {
            Trial::Careful => return self.leave(station, compliance()),
            Trial::Step { shortenings: 0, .. } => {
                self.trial = Trial::Excursion { slope };
                let onwards = direction_at(&station, &compliance(), self.epsilon);
                along(&station, &onwards, 1.0)
            }
            Trial::Excursion { slope } => self.shorten(&base, &direction, 1.0, slope, 0),
            Trial::Step {
                length,
                shortenings,
                ..
            } => self.shorten(&base, &direction, length, slope, shortenings),
        };
        self.base = Some((base, direction));
        next
    }

    /// A new base, and the full step from there.
    fn leave(&mut self, station: Station, compliance: Compliance) -> (Vec<f64>, Vec<f64>) {
        let direction = direction_at(&station, &compliance, self.epsilon);
        let next = along(&station, &direction, 1.0);
        self.base = Some((station, direction));
        self.trial = Trial::Step {
            length: 1.0,
            failed: 1.0,
            shortenings: 0,
        };
        next
    }

    /// The step of a length that failed with `slope` at its end, cut where the slope along it would
    /// vanish if it fell linearly; after a few such cuts, the step of the method of multipliers.
    fn shorten(
        &mut self,
        base: &Station,
        direction: &Direction,
        length: f64,
        slope: f64,
        shortenings: usize,
    ) -> (Vec<f64>, Vec<f64>) {
        let allowed = if base.value.is_some() {
            MAX_SHORTENINGS
        } else {
            MAX_SHORTENINGS_BLIND
        };
        if shortenings >= allowed {
            self.stiffen(length);
            self.trial = Trial::Careful;
            let mut beta = base.beta.clone();
            axpy(1.0, &base.shortfall, &mut beta);
            return (beta, base.lambda.clone());
        }
        let first = dot(&base.shortfall, &direction.beta);
        let most = if shortenings > 0 {
            SHORTENED_AGAIN
        } else {
            SHORTENED.1
        };
        let factor = (first / (first - slope)).clamp(SHORTENED.0, most);
        // A slope that has not fallen says nothing of where to stop.
        let factor = if slope < first { factor } else { most };
        self.trial = Trial::Step {
            length: factor * length,
            failed: length,
            shortenings: shortenings + 1,
        };
        along(base, direction, factor * length)
    }

    /// More ε, after a step of which only this length was of use.
    fn stiffen(&mut self, length: f64) {
        self.epsilon = f64::min(self.epsilon / length, 1.0);
    }

    /// Whether d has risen enough at the station, or the residual has fallen.
    fn gains(&self, base: &Station, direction: &Direction, station: &Station) -> bool {
        let length = match self.trial {
            Trial::Step { length, .. } => length,
            Trial::Excursion { .. } | Trial::Careful => 1.0,
        };
        let contracts = norm(&station.shortfall) < CONTRACTION * norm(&base.shortfall);
        let (Some(value), Some(before)) = (station.value, base.value) else {
            return contracts;
        };
        let first = length * dot(&base.shortfall, &direction.beta);
        let last = length * dot(&station.shortfall, &direction.beta);
        let gain = value - before;
        let past = f64::max(gain, last) < -PAST * first;
        gain >= SUFFICIENT * first || contracts && !past
    }
}

/// (H + εI)⁻¹ (ẽ − G̃λ).
fn direction_at(from: &Station, compliance: &Compliance, epsilon: f64) -> Direction {
    let mut matrix = compliance.matrix.clone();
    (0..matrix.nrows()).for_each(|i| matrix[(i, i)] += epsilon);
    let mut beta = from.shortfall.clone();
    // H is positive semidefinite but for the accuracy of its columns; if that was too little, the
    // step of the method of multipliers stands.
    if let Ok(factor) = Llt::new(matrix.as_ref(), Side::Lower) {
        factor.solve_in_place(ColMut::from_slice_mut(&mut beta));
    }
    let mut lambda = vec![0.0; from.lambda.len()];
    for (response, change) in compliance.responses.iter().zip(&beta) {
        axpy(*change, response, &mut lambda);
    }
    Direction { beta, lambda }
}

fn distance(x: &[f64], y: &[f64]) -> f64 {
    let squares = x.iter().zip(y).map(|(x, y)| (x - y).powi(2));
    squares.sum::<f64>().sqrt()
}

fn along(from: &Station, direction: &Direction, length: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut beta, mut lambda) = (from.beta.clone(), from.lambda.clone());
    axpy(length, &direction.beta, &mut beta);
    axpy(length, &direction.lambda, &mut lambda);
    (beta, lambda)
}
