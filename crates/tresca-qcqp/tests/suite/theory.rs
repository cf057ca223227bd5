//! GIMSSN keeps the promises of its convergence theorem.

use crate::common::problems::{
    self, KINDS, Kind, geometric_spectrum, normals, random, rng, with_spectrum,
};
use crate::common::{Plain, distance, norm, settings};
use tresca_qcqp::operator::{Dense, LocalModel};
use tresca_qcqp::{
    DualOperator, DualProblem, Method, ProductSet, Settings, Status, Unobserved, solve,
};

/// q(λ^{k+1}) − q* ≤ η (q(λᵏ) − q*) and ‖λᵏ − λ*‖ ≤ √(2(q(λ⁰) − q*)/σmin) η^{k/2}, with
/// η = 1 − ρσmin for ρ ≤ 1/σmax and 1 − (2/σmax − ρ)σmin above.
#[test]
fn gimssn_descends_and_keeps_the_bounds_of_the_theorem() {
    let kinds = [
        Kind::Mixed,
        Kind::SomeFrictionless,
        Kind::AllStick,
        Kind::TwoDimensional,
    ];
    for (seed, kind) in kinds.into_iter().enumerate() {
        for condition in [3.0, 1e2] {
            let plain = random(kind, 10, condition, 20 + seed as u64);
            let (largest, smallest) = (1.0, 1.0 / condition);
            let exact = plain.solve(&settings(Method::Grssn, 1e-13), None);
            assert_eq!(exact.status, Status::Converged);
            let lowest = plain.objective(&exact.lambda);
            for relative_rho in [0.1, 0.5, 1.0, 1.5, 1.9] {
                let settings = Settings {
                    rho: relative_rho,
                    ..settings(Method::Gimssn, 1e-8)
                };
                let solution = plain.solve(&settings, None);
                assert_eq!(solution.status, Status::Converged);
                let rho = relative_rho / solution.figures.sigma_max;
                assert!(
                    rho < 2.0 / largest,
                    "the estimate of the largest eigenvalue is too low"
                );
                let gain = rho.min(2.0 / largest - rho);
                let eta = 1.0 - gain * smallest;
                let rounding = 1e-13 * lowest.abs();
                let excess: Vec<f64> = solution
                    .records
                    .iter()
                    .map(|record| record.objective - lowest)
                    .collect();
                for (k, pair) in excess.windows(2).enumerate() {
                    let what =
                        format!("{kind:?}, condition {condition}, rho {relative_rho}, step {k}");
                    assert!(pair[1] <= pair[0] + rounding, "{what}: q rises");
                    assert!(
                        pair[1] <= eta * pair[0] + rounding,
                        "{what}: rate {}",
                        pair[1] / pair[0]
                    );
                    assert!(solution.records[k + 1].decrease >= -rounding, "{what}");
                }
                assert_distances(&plain, &settings, &exact.lambda, excess[0], smallest, eta);
            }
        }
    }
}

/// The bound on the distance, at a few iterates.
fn assert_distances(
    plain: &Plain,
    settings: &Settings,
    exact: &[f64],
    first_excess: f64,
    smallest: f64,
    eta: f64,
) {
    for limit in [1, 3, 10, 30] {
        let solution = plain.solve(
            &Settings {
                max_iterations: limit,
                ..settings.clone()
            },
            None,
        );
        // The best iterate is returned, not always the last one.
        let k = solution
            .records
            .iter()
            .position(|r| r.relative_reduced_gradient == solution.figures.relative_reduced_gradient)
            .unwrap();
        let bound = (2.0 * first_excess / smallest).sqrt() * eta.powf(0.5 * k as f64);
        let off = distance(&solution.lambda, exact);
        assert!(
            off <= bound + 1e-10 * norm(exact),
            "iterate {k}: {off} above {bound}"
        );
    }
}

#[test]
fn grssn_never_raises_the_objective() {
    for (seed, kind) in KINDS.into_iter().enumerate() {
        for condition in [1e1, 1e4] {
            let plain = random(kind, 15, condition, 300 + seed as u64);
            let mut start = normals(&mut rng(seed as u64), plain.dim());
            start.iter_mut().for_each(|s| *s *= 30.0);
            let solution = plain.solve(&settings(Method::Grssn, 1e-10), Some(&start));
            assert_eq!(solution.status, Status::Converged, "{kind:?}");
            for record in &solution.records {
                let rounding = 1e-12 * record.objective.abs() + 1e-12;
                assert!(record.decrease >= -rounding, "{kind:?}: {record:?}");
            }
        }
    }
}

/// An underestimated σmax must not break the descent: the top eigenvector is
/// made all but invisible to the start vector of the Lanczos steps.
#[test]
fn grssn_survives_an_estimate_of_the_spectrum_that_is_too_low() {
    struct Spike {
        inner: Dense,
        calls: usize,
        quiet: usize,
        top: f64,
        count: tresca_qcqp::Tally,
    }
    impl DualOperator for Spike {
        fn dim(&self) -> usize {
            self.inner.dim()
        }
        fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
            self.inner.multiply(x, y);
            self.calls += 1;
            // While the spectrum is estimated the first unknown looks harmless.
            if self.calls > self.quiet {
                y[0] += self.top * x[0];
            }
        }
        fn tally(&mut self) -> &mut tresca_qcqp::Tally {
            &mut self.count
        }
        fn local_model(&self) -> LocalModel {
            self.inner.local_model()
        }
    }
    let rng = &mut rng(9);
    let n = 60;
    let set = ProductSet::contact_3d(&[0.5; 20]).unwrap();
    let a = with_spectrum(rng, &geometric_spectrum(n, 1e3));
    let mut plain = Plain {
        a,
        b: Vec::new(),
        set,
    };
    plain.b = plain.mul(&normals(rng, n));
    let quiet = plain.packed();
    let honest = plain.solve(&settings(Method::Grssn, 1e-10), None);
    let top = 100.0;
    plain.a[0][0] += top;
    // One inner iteration, so that the projected gradient step has to carry its share.
    let settings = Settings {
        max_inner_iterations: 1,
        ..settings(Method::Grssn, 1e-8)
    };
    let reference = plain.solve(&settings, None);
    for seed in 0..4 {
        let spike = Spike {
            inner: Dense::new(quiet.clone()),
            calls: 0,
            quiet: honest.figures.n_a_setup,
            top,
            count: Default::default(),
        };
        let mut problem = DualProblem::new(spike, plain.b.clone(), plain.set.clone()).unwrap();
        let start = normals(&mut problems::rng(seed), n);
        let solution = solve(
            &mut problem,
            &settings,
            Some(start[..].into()),
            &mut Unobserved,
        )
        .unwrap();
        assert!(solution.figures.sigma_max < 0.1 * top);
        assert_eq!(solution.status, Status::Converged);
        for record in &solution.records {
            assert!(
                record.decrease >= -1e-12 * record.objective.abs(),
                "{record:?}"
            );
        }
        assert!(distance(&solution.lambda, &reference.lambda) <= 1e-5 * norm(&reference.lambda));
    }
}
