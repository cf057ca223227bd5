//! Loads that no contact can balance, and the proof of it.

use super::*;
use tresca_qcqp::{CoulombBound, Statics};

#[test]
fn loads_that_nothing_holds_are_proved_so() {
    let mut impossible = 0;
    for seed in 0..12 {
        for kind in [Kind::TwoDimensional, Kind::Mixed, Kind::Everything] {
            // Some of these still find a way: the proof decides, and Clarabel confirms.
            let floating = random_floating(
                kind,
                4,
                if seed % 2 == 0 { -1.0 } else { -30.0 },
                300 + seed,
            );
            let Equality { rows, rhs, .. } = &floating.equality;
            let reference = oracle::constrained_minimiser(&floating.plain, rows, rhs);
            let solution = solve(
                &mut floating.problem(),
                &Settings::default(),
                None,
                &mut Unobserved,
            )
            .unwrap();
            assert_eq!(
                solution.status == Status::NoEquilibrium,
                reference.is_none(),
                "{kind:?} {seed}: {}",
                solution.status
            );
            if solution.status == Status::NoEquilibrium {
                impossible += 1;
                assert_proof(&floating, &solution);
            } else {
                assert_solves(&floating, &solution, 1e-8, "possible");
            }
        }
    }
    assert!(impossible >= 3, "only {impossible} impossible problems");
}

/// eᵀv > sup over Λ of λᵀGᵀv, computed here.
fn assert_proof(floating: &Floating, solution: &DualSolution) {
    assert_proof_over(floating, &[], solution);
}

/// The same where the bounds of a law follow their normal forces: over the friction cones, or, since a motion
/// that slides without opening is preferred, over the bounds that belong to the λ handed out.
pub(super) fn assert_proof_over(
    floating: &Floating,
    law: &[CoulombBound],
    solution: &DualSolution,
) {
    let Equality { rows, rhs, .. } = &floating.equality;
    let motion = solution.motion.as_ref().expect("a proof");
    assert!((norm(motion) - 1.0).abs() <= 1e-12);
    let mut set = floating.plain.set.clone();
    for own in law {
        let bound = own.coefficient * solution.lambda[own.normal];
        set.set_bound(own.block, bound).unwrap();
    }
    assert!(set.contains(&solution.lambda));
    let power = dot(rhs, motion);
    assert!(power > 0.0);
    let driven: Vec<f64> = (0..set.dimension())
        .map(|i| rows.iter().zip(motion).map(|(row, v)| row[i] * v).sum())
        .collect();
    let nothing = 1e-8 * norm(&driven).max(1.0);
    let (mut held, mut held_by_cones) = (0.0, 0.0);
    for (number, block) in set.blocks().iter().enumerate() {
        let own = norm(&driven[block.range()]);
        match block.set {
            BlockSet::Line(_) => assert!(own <= nothing),
            BlockSet::HalfLine(_) => assert!(driven[block.start] <= nothing),
            set => held += set.bound().unwrap() * own,
        }
        if let Some(bound) = law.iter().find(|bound| bound.block == number) {
            let opens = bound.coefficient * own + driven[bound.normal] <= nothing;
            held_by_cones += if opens { 0.0 } else { f64::INFINITY };
        }
    }
    if !law.is_empty() {
        held = f64::min(held, held_by_cones);
    }
    assert!(power > held, "power {power:e}, held {held:e}");
}

/// A block on a half-space with slip bounds: the load that slides it, tips it, or turns it is known.
#[test]
fn the_limit_load_is_sharp() {
    let half = HalfSpace::new(6, 0.3);
    let m = half.pairs();
    let bound = 0.4 / m as f64;
    let outermost = half.points.iter().map(|p| p[0]).fold(0.0, f64::max);
    // Sliding: |fx| ≤ Σg. Tipping about the outermost row: |fx| · height ≤ |fz| · arm.
    let cases = [
        ([0.4, 0.0, -1.0], 0.0, bound),
        ([outermost, 0.0, -1.0], 1.0, 1.0),
    ];
    for (number, (limit, height, bound)) in cases.into_iter().enumerate() {
        for (share, possible) in [(0.5, true), (0.999, true), (1.001, false), (2.0, false)] {
            let mut floating = half.block([share * limit[0], limit[1], limit[2]], height, |_| 0.0);
            floating.plain.set = ProductSet::contact_3d(&vec![bound; m]).unwrap();
            let what = format!("case {number}, {share} of the limit");
            let solution = solve(
                &mut floating.problem(),
                &Settings::default(),
                None,
                &mut Unobserved,
            )
            .unwrap();
            if possible {
                assert_solves(&floating, &solution, 1e-8, &what);
            } else {
                assert_eq!(solution.status, Status::NoEquilibrium, "{what}");
                assert_proof(&floating, &solution);
                // It slides along x, or turns about an axis along y.
                let motion = solution.motion.unwrap();
                if number == 0 {
                    assert!(motion[0] > 0.9, "{what}: {motion:?}");
                } else {
                    assert!(motion[4] > 0.5, "{what}: {motion:?}");
                }
            }
        }
        // Exactly there, any honest end will do.
        let mut floating = half.block(limit, height, |_| 0.0);
        floating.plain.set = ProductSet::contact_3d(&vec![bound; m]).unwrap();
        let solution = solve(
            &mut floating.problem(),
            &Settings::default(),
            None,
            &mut Unobserved,
        )
        .unwrap();
        match solution.status {
            Status::Converged => assert_solves(&floating, &solution, 1e-8, "at the limit"),
            Status::NoEquilibrium => {}
            Status::IterationLimit | Status::Stagnated => {
                assert_eq!(solution.statics, Some(Statics::AtTheLimit), "case {number}");
            }
            status => panic!("case {number}: {status}"),
        }
    }
    // Lifted, or pulled down beside a support that has no friction.
    let frictionless = half.block([0.0, 0.0, 1e-3], 0.0, |_| 0.0);
    let solution = solve(
        &mut frictionless.problem(),
        &Settings::default(),
        None,
        &mut Unobserved,
    )
    .unwrap();
    assert_eq!(solution.status, Status::NoEquilibrium);
    assert_proof(&frictionless, &solution);
    assert_eq!(
        solution.figures.n_a - solution.figures.n_a_setup,
        0,
        "λ = 0 is nearest, and costs nothing"
    );
}

#[test]
fn a_motion_that_no_contact_feels_is_decided_by_its_load() {
    let base = random_floating(Kind::Mixed, 2, 1.0, 9);
    for load in [0.0, 1e-3] {
        let mut equality = base.equality.clone();
        equality.rows.push(vec![0.0; base.plain.dim()]);
        equality.rhs.push(load);
        equality.metric.iter_mut().for_each(|row| row.push(0.0));
        equality.metric.push(vec![0.0, 0.0, 1.0]);
        let floating = Floating {
            plain: base.plain.clone(),
            equality,
        };
        let solution = solve(
            &mut floating.problem(),
            &Settings::default(),
            None,
            &mut Unobserved,
        )
        .unwrap();
        if load == 0.0 {
            assert_solves(&floating, &solution, 1e-8, "no load");
            assert_eq!(solution.multiplier[2], 0.0);
        } else {
            assert_eq!(solution.status, Status::NoEquilibrium);
            assert!(solution.motion.unwrap()[2] > 0.999);
        }
    }
}

/// The load that friction can just hold, and what is within rounding of it, is never said to be impossible; and
/// an end without answer says where the load is.
#[test]
fn a_load_at_the_limit_is_not_called_impossible() {
    let half = HalfSpace::new(4, 0.3);
    let m = half.pairs();
    let bound = 1.0 / m as f64;
    // Bounds that are all needed, along directions that differ by a little.
    for (number, share) in [1.0, 1.0 + 1e-12, 1.0 + 1e-10, 1.0 - 1e-10]
        .into_iter()
        .enumerate()
    {
        for turned in [0.0, 0.3] {
            let along = [share * f64::cos(turned), share * f64::sin(turned), -1.0];
            let mut floating = half.block(along, 0.0, |_| 0.0);
            floating.plain.set = ProductSet::contact_3d(&vec![bound; m]).unwrap();
            let solution = solve(
                &mut floating.problem(),
                &Settings::default(),
                None,
                &mut Unobserved,
            )
            .unwrap();
            match solution.status {
                Status::Converged => assert_solves(&floating, &solution, 1e-8, "at the limit"),
                Status::IterationLimit | Status::Stagnated => assert_eq!(
                    solution.statics,
                    Some(Statics::AtTheLimit),
                    "{number}, {turned}"
                ),
                status => panic!("{number}, {turned}: {status}"),
            }
        }
    }
    for share in [1.0 + 1e-7, 1.0 + 1e-5] {
        let mut floating = half.block([share, 0.0, -1.0], 0.0, |_| 0.0);
        floating.plain.set = ProductSet::contact_3d(&vec![bound; m]).unwrap();
        let solution = solve(
            &mut floating.problem(),
            &Settings::default(),
            None,
            &mut Unobserved,
        )
        .unwrap();
        assert_eq!(solution.status, Status::NoEquilibrium, "{share}");
        assert_proof(&floating, &solution);
    }
}
