//! APGD: the accelerated projected gradient with restart, the baseline.
//!
//! Nesterov's method with the gradient restart of B. O'Donoghue and E. Candès,
//! *Adaptive restart for accelerated gradient schemes*, Found. Comput. Math. 15 (2015).

use super::run::{Advance, Run};
use crate::point::{Point, gradient_step};
use crate::status::Status;

/// λ⁺ = P_Λ(z − ρ r(z)), z⁺ = λ⁺ + β (λ⁺ − λ); one multiplication per
/// iteration, since r is affine: r(z⁺) = r(λ⁺) + β (r(λ⁺) − r(λ)).
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut x = start;
    let mut z = x.clone();
    let mut t = 1.0_f64;
    let mut step = Advance::START;
    loop {
        if let Some(status) = run.judge(&x, step) {
            return status;
        }
        let mut lambda = gradient_step(&z, run.rho);
        run.set.project(&mut lambda);
        let next = run.point(lambda);
        if moves_uphill(&z, &next, &x) {
            t = 1.0;
            z = next.clone();
        } else {
            let t_next = 0.5 * (1.0 + (1.0 + 4.0 * t * t).sqrt());
            z = extrapolate(&next, &x, (t - 1.0) / t_next);
            t = t_next;
        }
        x = next;
        step = Advance::full(0);
    }
}

/// (z − λ⁺)ᵀ(λ⁺ − λ) > 0: the momentum points against the gradient step.
fn moves_uphill(z: &Point, next: &Point, x: &Point) -> bool {
    let terms = z.lambda.iter().zip(&next.lambda).zip(&x.lambda);
    terms.map(|((z, n), x)| (z - n) * (n - x)).sum::<f64>() > 0.0
}

fn extrapolate(next: &Point, x: &Point, beta: f64) -> Point {
    let beyond = |next: &[f64], x: &[f64]| {
        next.iter()
            .zip(x)
            .map(|(n, x)| n + beta * (n - x))
            .collect::<Vec<_>>()
    };
    Point {
        lambda: beyond(&next.lambda, &x.lambda),
        gradient: beyond(&next.gradient, &x.gradient),
    }
}
