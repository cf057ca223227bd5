//! Contact by contact, where bounds that lag behind never settle.

use super::run;
use crate::common::{Plain, dot, norm};
use faer::Mat;
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use tresca_qcqp::{CoulombBound, CoulombMethod, Method, ProductSet, Settings, Status};

fn law(friction: &[f64]) -> Vec<CoulombBound> {
    let m = friction.len();
    let bound = |(i, &coefficient): (usize, &f64)| CoulombBound {
        block: m + i,
        normal: i,
        coefficient,
        limit: f64::INFINITY,
    };
    friction.iter().enumerate().map(bound).collect()
}

#[test]
fn two_contacts_in_the_plane_whose_bounds_return_for_ever_are_solved() {
    // Contact 1 opens, contact 2 slides; λ = [λν; λτ].
    let plain = Plain {
        a: vec![
            vec![0.399, -0.292, -0.348, -0.011],
            vec![-0.292, 0.786, 0.166, -0.565],
            vec![-0.348, 0.166, 0.573, 0.187],
            vec![-0.011, -0.565, 0.187, 0.693],
        ],
        b: vec![-0.341, 0.83, 1.42, -1.623],
        set: ProductSet::contact_2d(&[0.0; 2]).unwrap(),
    };
    for coulomb in [
        CoulombMethod::Auto,
        CoulombMethod::FixedPoint,
        CoulombMethod::InLoop,
    ] {
        let settings = Settings {
            coulomb,
            ..Settings::default()
        };
        let (_, solution) = run(&plain, law(&[0.7726, 1.4329]), &settings);
        assert_eq!(solution.status, Status::Converged, "{coulomb}");
        assert!(solution.figures.sweeps > 0);
        let expected = [0.0, 0.520_184_25, 0.0, -0.745_372_01];
        for (found, expected) in solution.lambda.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-7,
                "{coulomb}: {:?}",
                solution.lambda
            );
        }
    }
}

/// How far λ is from the law, every contact by itself: gaps against forces, friction against its bound, and against
/// the direction of slip, relative to forces and displacements.
fn distance_from_the_law(plain: &Plain, lambda: &[f64], friction: &[f64]) -> f64 {
    let m = friction.len();
    let tangents = lambda.len() / m - 1;
    let product = plain.mul(lambda);
    let r: Vec<f64> = product.iter().zip(&plain.b).map(|(x, b)| x - b).collect();
    let (force, length) = (norm(lambda), norm(&plain.b));
    let mut worst = 0.0_f64;
    for (i, mu) in friction.iter().enumerate() {
        let own = m + tangents * i..m + tangents * (i + 1);
        let (n, t, slip) = (lambda[i], &lambda[own.clone()], &r[own]);
        let bound = mu * n;
        worst = worst.max(-n / force).max(-r[i] / length);
        worst = worst.max((n * r[i]).abs() / (force * length));
        worst = worst.max((norm(t) - bound) / force);
        worst = worst.max((dot(t, slip) + bound * norm(slip)).abs() / (force * length));
    }
    worst
}

#[test]
fn friction_coefficients_up_to_five_are_solved() {
    let (mut swept, mut unsolved) = (0, Vec::new());
    for seed in 0..1000 {
        let mut rng = StdRng::seed_from_u64(seed);
        let tangents = 1 + (seed % 2) as usize;
        let m = rng.random_range(1..8);
        let order = (1 + tangents) * m;
        // W of a rigid multibody problem is singular; without friction there is a force then for every b in its range.
        let rank = if seed % 5 == 0 {
            order - order / 3
        } else {
            order + 2
        };
        let half = Mat::from_fn(order, rank, |_, _| rng.random_range(-1.0..1.0));
        let entry = |i: usize, j: usize| (0..rank).map(|k| half[(i, k)] * half[(j, k)]).sum();
        let plain = Plain {
            a: (0..order)
                .map(|i| (0..order).map(|j| entry(i, j)).collect())
                .collect(),
            b: {
                let v: Vec<f64> = (0..rank).map(|_| rng.random_range(-1.0..1.0)).collect();
                (0..order)
                    .map(|i| (0..rank).map(|k| half[(i, k)] * v[k]).sum())
                    .collect()
            },
            set: match tangents {
                1 => ProductSet::contact_2d(&vec![0.0; m]),
                _ => ProductSet::contact_3d(&vec![0.0; m]),
            }
            .unwrap(),
        };
        let friction: Vec<f64> = (0..m).map(|_| rng.random_range(0.0..5.0)).collect();
        let settings = Settings {
            method: Method::Grssn,
            ..Settings::default()
        };
        let (_, solution) = run(&plain, law(&friction), &settings);
        if solution.status != Status::Converged {
            unsolved.push(seed);
            continue;
        }
        if norm(&solution.lambda) > 0.0 {
            let off = distance_from_the_law(&plain, &solution.lambda, &friction);
            assert!(off < 1e-5, "seed {seed}: {off:e}");
        }
        swept += usize::from(solution.figures.sweeps > 0);
    }
    // One of a thousand neither sweeps nor anything else solves.
    assert!(unsolved.len() <= 1, "{unsolved:?}");
    assert!(swept > 10, "sweeps are hardly needed: {swept}");
}
