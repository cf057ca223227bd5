//! SSN: the semismooth Newton method as it stands.
//!
//! Newton's method for λ = P_Λ(λ − ρ r(λ)) with the slanting function G of P_Λ:
//!
//! <div>
//! $$
//! \bigl(I - G\,(I - \rho A)\bigr)\,\delta = P_\Lambda(y) - \lambda \qquad \text{at} \quad y = \lambda - \rho\, r(\lambda).
//! $$
//! </div>
//!
//! Nonsymmetric where pairs slip, so BiCGSTAB: two multiplications per inner iteration.

use super::run::{Advance, Run};
use crate::operator::dual_operator::DualOperator;
use crate::point::Point;
use crate::sets::product::ProductSet;
use crate::status::Status;
use tresca_la::LinearOperator;
use tresca_la::krylov::{Identity, bicgstab};

/// δ ↦ δ − G(y)(δ − ρ A δ).
pub(crate) struct NewtonOperator<'a> {
    pub operator: &'a mut dyn DualOperator,
    pub set: &'a ProductSet,
    pub y: &'a [f64],
    pub rho: f64,
    pub slanted: Vec<f64>,
}

impl LinearOperator for NewtonOperator<'_> {
    fn dim(&self) -> usize {
        self.y.len()
    }

    fn apply(&mut self, delta: &[f64], out: &mut [f64]) {
        self.operator.apply(delta, out);
        for ((slanted, d), a) in self.slanted.iter_mut().zip(delta).zip(&*out) {
            *slanted = d - self.rho * a;
        }
        self.set.slant(self.y, &mut self.slanted);
        for ((out, d), s) in out.iter_mut().zip(delta).zip(&self.slanted) {
            *out = d - s;
        }
    }
}

/// λ⁺ = λ + δ. Iterates may leave Λ; the projected ones are judged and returned.
pub(super) fn run(run: &mut Run, start: Point) -> Status {
    let mut x = start;
    let mut step = Advance::START;
    let mut workspace = bicgstab::Workspace::with_capacity(run.rhs.len());
    loop {
        let feasible = run.projected(&x);
        if let Some(status) = run.judge(&feasible, step) {
            return status;
        }
        let y = run.y(&x);
        let mut rhs = y.clone();
        run.set.project(&mut rhs);
        for (rhs, l) in rhs.iter_mut().zip(&x.lambda) {
            *rhs -= l;
        }
        let (delta, iterations) = newton_direction(run, &y, &rhs, &mut workspace);
        let lambda = x.lambda.iter().zip(&delta).map(|(l, d)| l + d).collect();
        x = run.point(lambda);
        step = Advance::full(iterations);
    }
}

/// Solves (I − G (I − ρA)) δ = rhs; returns δ and the number of inner iterations.
fn newton_direction(
    run: &mut Run,
    y: &[f64],
    rhs: &[f64],
    workspace: &mut bicgstab::Workspace,
) -> (Vec<f64>, usize) {
    // The rows are those of the reduced gradient times ρ.
    let tolerance = run.full_accuracy() * run.rho;
    let limit = run.settings.max_inner_iterations;
    let rho = run.rho;
    let slanted = vec![0.0; y.len()];
    let mut system = NewtonOperator {
        operator: &mut *run.operator,
        set: &run.set,
        y,
        rho,
        slanted,
    };
    // Bound rows read δ = rhs: started from there they stay solved, and BiCGSTAB works on the rest.
    let mut delta = rhs.to_vec();
    let mut iterations = 0;
    // After a breakdown a fresh shadow residual helps; without an iteration gained it is final.
    loop {
        let record = bicgstab::solve(
            &mut system,
            &mut Identity(y.len()),
            rhs,
            &mut delta,
            limit - iterations,
            |norm| norm <= tolerance,
            workspace,
        );
        iterations += record.iterations;
        let broken = record.outcome == bicgstab::BicgstabOutcome::Breakdown;
        if !broken || record.iterations == 0 || iterations >= limit {
            return (delta, iterations);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::newton::reduced_space::{ReducedOperator, ReducedSpace};
    use crate::operator::dense::Dense;
    use crate::sets::convex_set::{BlockState, ConvexSet};
    use proptest::prelude::*;
    use tresca_la::PackedLower;
    use tresca_la::krylov::cg::{self, ConjugateGradient};
    use tresca_la::vector::norm;

    const PAIRS: usize = 5;
    const DIM: usize = 3 * PAIRS;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]

        /// The reduced system is not an approximation: with tangents and curvature taken at
        /// y = λ − ρ r(λ) its solution is the step of SSN.
        #[test]
        fn the_reduced_step_is_the_semismooth_newton_step(
            factor in prop::collection::vec(-1.0..1.0, DIM * DIM),
            lambda in prop::collection::vec(-2.0..2.0, DIM),
            b in prop::collection::vec(-3.0..3.0, DIM),
            bounds in prop::collection::vec(prop_oneof![Just(0.0), 0.1..3.0], PAIRS),
            rho in 0.05..2.0,
        ) {
            let mut packed = PackedLower::zeros(DIM);
            for j in 0..DIM {
                for i in j..DIM {
                    let dot: f64 = (0..DIM).map(|k| factor[i * DIM + k] * factor[j * DIM + k]).sum();
                    packed.set(i, j, dot / DIM as f64 + f64::from(u8::from(i == j)));
                }
            }
            let set = ProductSet::contact_3d(&bounds).unwrap();
            let mut dense = Dense::new(packed);
            let mut gradient = vec![0.0; DIM];
            DualOperator::apply(&mut dense, &lambda, &mut gradient);
            gradient.iter_mut().zip(&b).for_each(|(r, b)| *r -= b);
            let y: Vec<f64> = lambda.iter().zip(&gradient).map(|(l, r)| l - rho * r).collect();

            let full = full_step(&mut dense, &set, &lambda, &y, rho);
            let reduced = reduced_step(&mut dense, &set, &lambda, &y, &b, rho);
            let off = full.iter().zip(&reduced).map(|(f, r)| (f - r).powi(2)).sum::<f64>().sqrt();
            prop_assert!(off <= 1e-10 * norm(&full), "off by {:e}", off / norm(&full));
        }
    }

    /// λ + δ with (I − G(I − ρA)) δ = P(y) − λ solved to rounding.
    fn full_step(
        dense: &mut Dense,
        set: &ProductSet,
        lambda: &[f64],
        y: &[f64],
        rho: f64,
    ) -> Vec<f64> {
        let mut rhs = y.to_vec();
        set.project(&mut rhs);
        rhs.iter_mut().zip(lambda).for_each(|(p, l)| *p -= l);
        let slanted = vec![0.0; DIM];
        let mut system = NewtonOperator {
            operator: dense,
            set,
            y,
            rho,
            slanted,
        };
        let mut matrix = faer::Mat::zeros(DIM, DIM);
        for j in 0..DIM {
            let mut unit = vec![0.0; DIM];
            unit[j] = 1.0;
            let mut column = vec![0.0; DIM];
            system.apply(&unit, &mut column);
            (0..DIM).for_each(|i| matrix[(i, j)] = column[i]);
        }
        use faer::prelude::Solve;
        let delta = matrix
            .partial_piv_lu()
            .solve(faer::ColRef::from_slice(&rhs));
        (0..DIM).map(|i| lambda[i] + delta[i]).collect()
    }

    /// x̂ + Z s with (ZᵀAZ + C) s = −Zᵀ(A x̂ − b), c̃ = (‖y‖/g − 1)/ρ.
    fn reduced_step(
        dense: &mut Dense,
        set: &ProductSet,
        lambda: &[f64],
        y: &[f64],
        b: &[f64],
        rho: f64,
    ) -> Vec<f64> {
        let active = set.classify(y);
        let space = ReducedSpace::with_tangents(set, &active, y, |i, bound| {
            (y[i].hypot(y[i + 1]) / bound - 1.0) / rho
        });
        let mut fixed = lambda.to_vec();
        for (block, state) in set.blocks().iter().zip(active.states()) {
            if *state == BlockState::Bound {
                let range = block.range();
                fixed[range.clone()].copy_from_slice(&y[range.clone()]);
                block.set.project(&mut fixed[range]);
            }
        }
        let mut gradient = vec![0.0; DIM];
        DualOperator::apply(dense, &fixed, &mut gradient);
        let mut rhs = vec![0.0; space.dim()];
        gradient.iter_mut().zip(b).for_each(|(r, b)| *r -= b);
        space.restrict(&gradient, &mut rhs);
        rhs.iter_mut().for_each(|r| *r = -*r);
        let mut s = vec![0.0; space.dim()];
        let mut system = ReducedOperator::new(dense, &space);
        let (identity, tolerance) = (&mut Identity(space.dim()), 1e-14 * norm(&rhs));
        let workspace = &mut ConjugateGradient::default();
        cg::solve(
            &mut system,
            identity,
            &rhs,
            &mut s,
            tolerance,
            1000,
            workspace,
        );
        let mut direction = vec![0.0; DIM];
        space.expand(&s, &mut direction);
        fixed.iter().zip(&direction).map(|(x, d)| x + d).collect()
    }
}
