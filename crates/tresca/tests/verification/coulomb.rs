//! Coulomb's law: both variants, their limits, their work.

use super::support::{assert_close, report, settings, solved, solved_with, variant};
use tresca::{CoulombMethod, Engine, FrictionLaw, Outcome, ScalarField};
use tresca_bench::two_bricks::{Units, two_bricks_with};

fn bricks(coefficient: &str) -> tresca::case::Case {
    let law = ("coefficient = 0.3", coefficient);
    variant(
        "two-bricks-coulomb.toml",
        &[law, ("nodes = [16, 16, 16]", "nodes = [9, 9, 9]")],
    )
}

fn forces(outcome: &Outcome) -> Vec<f64> {
    let pairs = outcome.last().pairs();
    pairs
        .flat_map(|pair| {
            let [x, y, z] = pair.friction_force;
            [pair.normal_force, x, y, z]
        })
        .collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    let norm = |values: &mut dyn Iterator<Item = f64>| values.map(|x| x * x).sum::<f64>().sqrt();
    norm(&mut a.iter().zip(b).map(|(a, b)| a - b)) / norm(&mut b.iter().copied())
}

#[test]
fn both_variants_agree_within_ten_updates() {
    for coefficient in ["0.1", "0.3", "0.6", "1.0"] {
        let case = bricks(&format!("coefficient = {coefficient}"));
        let by = |coulomb| {
            let settings = settings(&case, |settings| settings.coulomb = coulomb);
            solved_with(&case, &settings)
        };
        let fixed_point = by(CoulombMethod::FixedPoint);
        let in_loop = by(CoulombMethod::InLoop);
        let updates = fixed_point.last().solution.figures.outer_iterations;
        report(&format!(
            "Coulomb, F = {coefficient}: {updates} updates by fixed point, {} steps in the loop",
            in_loop.last().solution.figures.iterations
        ));
        assert!(
            (1..=10).contains(&updates),
            "F = {coefficient}: {updates} updates"
        );
        let difference = distance(&forces(&in_loop), &forces(&fixed_point));
        assert!(difference < 1e-5, "F = {coefficient}: {difference:e}");
        // The law itself, pair by pair.
        let factor: f64 = coefficient.parse().unwrap();
        for pair in fixed_point.last().pairs() {
            let [a, b] = pair.local_friction;
            let bound = factor * pair.normal_force;
            assert!(a.hypot(b) <= bound * (1.0 + 1e-4) + 1e-9);
            if pair.closed && !pair.stick {
                assert_close(a.hypot(b), bound, 1e-3);
            }
        }
    }
}

/// The variant that updates inside of the Newton loop costs at most 2.5 Tresca solves with the final bounds.
#[test]
fn in_loop_updates_cost_little_more_than_a_tresca_solve() {
    for coefficient in ["0.1", "0.3", "0.6", "1.0"] {
        let case = bricks(&format!("coefficient = {coefficient}"));
        let settings = settings(&case, |settings| {
            settings.coulomb = CoulombMethod::InLoop;
            settings.engine = Engine::Condensed;
            settings.tolerance = 1e-6;
        });
        let coulomb = solved_with(&case, &settings);
        // Tresca's law with these bounds, point by point.
        let bounds: Vec<f64> = coulomb
            .last()
            .pairs()
            .map(|pair| pair.slip_bounds.unwrap()[0] / pair.pair.area)
            .collect();
        let law = FrictionLaw::tresca(ScalarField::Values(bounds));
        let model = two_bricks_with(9, Units::METRE_MEGAPASCAL, law).unwrap();
        let tresca = tresca::solve_with(&model, &settings, &mut tresca::Silent).unwrap();
        let (ours, theirs) = (&coulomb.last().solution, &tresca.last().solution);
        let (ours, theirs) = (
            ours.figures.n_a - ours.figures.n_a_setup,
            theirs.figures.n_a - theirs.figures.n_a_setup,
        );
        assert!(
            2 * ours <= 5 * theirs,
            "F = {coefficient}: {ours} against {theirs}"
        );
    }
}

#[test]
fn without_friction_coulomb_is_frictionless() {
    let coulomb = solved(&bricks("coefficient = 0.0"));
    let law = (
        "law = \"coulomb\", coefficient = 0.3",
        "law = \"frictionless\"",
    );
    let nodes = ("nodes = [16, 16, 16]", "nodes = [9, 9, 9]");
    let frictionless = solved(&variant("two-bricks-coulomb.toml", &[law, nodes]));
    assert!(distance(&forces(&coulomb), &forces(&frictionless)) < 1e-6);
}

/// A wide block pressed over all of its face stays closed; with huge friction it is as good as glued.
#[test]
fn with_huge_friction_a_closed_contact_sticks() {
    let exchange = |law: &'static str| {
        variant(
            "two-bricks-coulomb.toml",
            &[
                ("law = \"coulomb\", coefficient = 0.3", law),
                ("nodes = [16, 16, 16]", "nodes = [9, 9, 9]"),
                ("[\"upper.x+\", \"lower.x-\"]", "[\"lower.z-\"]"),
                ("[\"upper.z+\", \"upper.x-\"]", "[\"upper.z+\"]"),
                ("[0.0, 0.0, -1.0]", "[0.1, 0.0, -1.0]"),
            ],
        )
    };
    let huge = solved(&exchange("law = \"coulomb\", coefficient = 1e3"));
    let glued = solved(&exchange("law = \"tied\""));
    assert!(glued.last().pairs().all(|pair| pair.normal_force > 0.0));
    assert!(huge.last().pairs().all(|pair| pair.closed && pair.stick));
    let difference = distance(&forces(&huge), &forces(&glued));
    assert!(difference < 1e-5, "{difference:e}");
}
