//! Cattaneo and Mindlin in plane strain: a cylinder pressed on a flat and pulled sideways.
//!
//! With E* = E/(2(1 − ν²)) for two bodies of the same material, P and Q the forces per length:
//!
//! a = √(4PR/(πE*)), p(x) = p₀ √(1 − x²/a²), p₀ = 2P/(πa);
//! stick within c = a √(1 − Q/(FP)), q(x) = F p(x) − (c/a) F p₀ √(1 − x²/c²) there, F p(x) outside; so
//! the largest traction is q(c) = F p₀ √(Q/(FP)).
//!
//! (K. L. Johnson, Contact Mechanics, sections 4.2 and 7.2.)

use super::support::{resultant, solved, variant};
use std::f64::consts::PI;
use tresca::{Outcome, PairState};

const FRICTION: f64 = 0.3;
const RADIUS: f64 = 100.0;

/// Relative errors of the half-width of contact, of the peak pressure, of the half-width of stick, of the
/// peak traction, and of the traction over all points, each against the closed form for the forces found.
fn errors(outcome: &Outcome) -> [f64; 5] {
    let star = 2.1e5 / (2.0 * (1.0 - 0.09));
    let (force, _) = resultant(outcome, 1, 0);
    let (_, [pull, _, _]) = resultant(outcome, 1, 0);
    let a = (4.0 * force * RADIUS / (PI * star)).sqrt();
    let peak = 2.0 * force / (PI * a);
    let share = pull / (FRICTION * force);
    assert!((0.3..0.8).contains(&share), "partial slip: {share}");
    let c = a * (1.0 - share).sqrt();

    let mut pairs: Vec<&PairState> = outcome.last().pairs().collect();
    pairs.sort_by(|p, q| p.pair.point[0].total_cmp(&q.pair.point[0]));
    // Where a state ends: half-way between the last node in it and the next.
    let width = |inside: &dyn Fn(&PairState) -> bool| {
        let first = pairs.iter().position(|pair| inside(pair)).unwrap();
        let last = pairs.iter().rposition(|pair| inside(pair)).unwrap();
        let x = |k: usize| pairs[k].pair.point[0];
        0.25 * (x(last) + x(last + 1) - x(first) - x(first - 1))
    };
    let closed = width(&|pair| pair.closed);
    let stick = width(&|pair| pair.closed && pair.stick);
    let largest = |value: &dyn Fn(&PairState) -> f64| pairs.iter().map(|pair| value(pair)).fold(0.0, f64::max);
    let traction = |pair: &PairState| pair.friction_force[0] / pair.pair.area;
    let exact = |x: f64| {
        let arc = |radius: f64| (1.0 - (x / radius).powi(2)).max(0.0).sqrt();
        FRICTION * peak * (arc(a) - c / a * arc(c))
    };
    let deviation = pairs
        .iter()
        .map(|pair| pair.pair.area * (traction(pair) - exact(pair.pair.point[0])).abs())
        .sum::<f64>();
    [
        (closed / a - 1.0).abs(),
        (largest(&|pair| pair.pressure()) / peak - 1.0).abs(),
        (stick / c - 1.0).abs(),
        (largest(&traction) / (FRICTION * peak * share.sqrt()) - 1.0).abs(),
        deviation / pull,
    ]
}

#[test]
fn stick_width_and_peak_traction_converge_to_the_closed_form() {
    let solve = |nodes: &str| {
        let outcome = solved(&variant("cylinder-on-flat.toml", &[("nodes = [129, 49]", nodes)]));
        errors(&outcome)
    };
    let coarse = solve("nodes = [65, 25]");
    let middle = solve("nodes = [129, 49]");
    let fine = solve("nodes = [257, 97]");
    let all = format!("\n{coarse:.4?}\n{middle:.4?}\n{fine:.4?}");
    for (name, k, last) in [
        ("contact half-width", 0, 0.02),
        ("peak pressure", 1, 0.01),
        ("stick half-width", 2, 0.03),
        ("peak traction", 3, 0.03),
        ("traction in the mean", 4, 0.02),
    ] {
        assert!(fine[k] < last, "{name}: {all}");
        assert!(fine[k] < coarse[k], "{name} falls with h: {all}");
    }
    // Widths are known to half an element only; the mean error knows no such steps.
    assert!(coarse[4] > 1.6 * middle[4] && middle[4] > 1.6 * fine[4], "{all}");
}
