//! Cattaneo and Mindlin in plane strain: a cylinder pressed on a flat and pulled sideways.
//!
//! With E* = E/(2(1 − ν²)) for two bodies of the same material, P and Q the forces per length:
//!
//! a = √(4PR/(πE*)), p(x) = p₀ √(1 − x²/a²), p₀ = 2P/(πa);
//! stick within c = a √(1 − Q/(FP)), q(x) = F p(x) − (c/a) F p₀ √(1 − x²/c²) there, F p(x) outside; so
//! the largest traction is q(c) = F p₀ √(Q/(FP)).
//!
//! (K. L. Johnson, Contact Mechanics, sections 4.2 and 7.2.)

use super::support::{report, resultant, solved, variant};
use std::f64::consts::PI;
use tresca::{Outcome, PairState};

const FRICTION: f64 = 0.3;
const RADIUS: f64 = 100.0;

/// Relative errors against the closed form for the forces found.
#[derive(Debug)]
struct Errors {
    /// Half-width of contact, from the second moment of the pressure: ⟨x²⟩ = a²/4.
    contact_width: f64,
    peak_pressure: f64,
    /// Half-width of stick, from the second moment of the traction: ⟨x²⟩ = (a²/4)(1 + c²/a²).
    stick_width: f64,
    peak_traction: f64,
    /// ∫ |q − q_exact| over ∫ q.
    traction: f64,
    /// Distance of the outermost sticking node from c, in elements.
    stick_edge: f64,
}

fn errors(outcome: &Outcome) -> Errors {
    let star = 2.1e5 / (2.0 * (1.0 - 0.09));
    let (force, [pull, _, _]) = resultant(outcome, 1, 0);
    let a = (4.0 * force * RADIUS / (PI * star)).sqrt();
    let peak = 2.0 * force / (PI * a);
    let share = pull / (FRICTION * force);
    assert!((0.3..0.8).contains(&share), "partial slip: {share}");
    let c = a * (1.0 - share).sqrt();

    let pairs: Vec<&PairState> = outcome.last().pairs().collect();
    let x = |pair: &PairState| pair.pair.point[0];
    let pull_of = |pair: &PairState| pair.friction_force[0];
    let moment = |force: &dyn Fn(&PairState) -> f64| -> f64 {
        let total: f64 = pairs.iter().map(|pair| force(pair)).sum();
        pairs
            .iter()
            .map(|pair| force(pair) * x(pair).powi(2))
            .sum::<f64>()
            / total
    };
    let closed = 2.0 * moment(&|pair| pair.normal_force).sqrt();
    let stick = (4.0 * moment(&pull_of) - closed * closed).sqrt();
    let largest = |value: &dyn Fn(&PairState) -> f64| {
        pairs.iter().map(|pair| value(pair)).fold(0.0, f64::max)
    };
    let exact = |x: f64| {
        let arc = |radius: f64| (1.0 - (x / radius).powi(2)).max(0.0).sqrt();
        FRICTION * peak * (arc(a) - c / a * arc(c))
    };
    let deviation = |pair: &&PairState| (pull_of(pair) - pair.pair.area * exact(x(pair))).abs();
    let sticking = pairs.iter().filter(|pair| pair.closed && pair.stick);
    let outermost = sticking
        .max_by(|p, q| x(p).abs().total_cmp(&x(q).abs()))
        .unwrap();
    Errors {
        contact_width: (closed / a - 1.0).abs(),
        peak_pressure: (largest(&PairState::pressure) / peak - 1.0).abs(),
        stick_width: (stick / c - 1.0).abs(),
        peak_traction: (largest(&|pair| pull_of(pair) / pair.pair.area)
            / (FRICTION * peak * share.sqrt())
            - 1.0)
            .abs(),
        traction: pairs.iter().map(deviation).sum::<f64>() / pull,
        stick_edge: (x(outermost).abs() - c).abs() / outermost.pair.area,
    }
}

#[test]
fn stick_width_and_traction_converge_to_the_closed_form() {
    let solve = |nodes: &str| {
        let outcome = solved(&variant(
            "cylinder-on-flat.toml",
            &[("nodes = [129, 49]", nodes)],
        ));
        errors(&outcome)
    };
    let all: [Errors; 3] = [
        solve("nodes = [65, 25]"),
        solve("nodes = [129, 49]"),
        solve("nodes = [257, 97]"),
    ];
    for errors in &all {
        report(&format!("Cattaneo–Mindlin: {errors:.5?}"));
    }
    let [coarse, middle, fine] = &all;
    // Widths and peak pressure fall with h² in the mean, the peak traction, a kink, with h.
    for (name, first, last, bound) in [
        (
            "contact width",
            coarse.contact_width,
            fine.contact_width,
            5e-4,
        ),
        (
            "peak pressure",
            coarse.peak_pressure,
            fine.peak_pressure,
            5e-4,
        ),
        ("stick width", coarse.stick_width, fine.stick_width, 1e-3),
    ] {
        assert!(last < bound && last < 0.1 * first, "{name}: {all:#?}");
    }
    assert!(
        fine.peak_traction < 0.04 && fine.peak_traction < 0.6 * coarse.peak_traction,
        "{all:#?}"
    );
    assert!(
        fine.traction < middle.traction && middle.traction < 0.5 * coarse.traction,
        "{all:#?}"
    );
    assert!(all.iter().all(|errors| errors.stick_edge < 1.0), "{all:#?}");
}
