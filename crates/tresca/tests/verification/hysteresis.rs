//! A tangential load cycle over a normally loaded contact: stick-slip hysteresis.

use super::support::{report, resultant, solved, variant};

#[test]
fn every_cycle_dissipates_the_same_work() {
    let outcome = solved(&variant("hysteresis.toml", &[]));
    let steps = &outcome.steps;
    assert_eq!(steps.len(), 1 + 6 + 6 * 12);
    // Cycle k: back k and forth k + 1.
    let cycle = |k: usize| -> f64 {
        let first = 7 + 24 * k;
        steps[first..first + 24]
            .iter()
            .map(|step| step.dissipation())
            .sum()
    };
    let work = [cycle(0), cycle(1), cycle(2)];
    report(&format!("hysteresis: work of three cycles {work:.12?}"));
    assert!(work[0] > 0.0, "{work:?}");
    assert!((work[1] / work[2] - 1.0).abs() < 1e-6, "{work:?}");
    assert!((work[0] / work[2] - 1.0).abs() < 1e-6, "{work:?}");
    // The loop: at the same displacement of the ram, another force on the way back than on the way forth.
    let force = |step: usize| resultant(&outcome, step, 0).1[0];
    let (forth, back) = (force(6 + 24 - 6), force(6 + 6));
    assert!(
        forth > 0.0 && back < 0.0 || forth < 0.0 && back > 0.0,
        "{forth} and {back}"
    );
    // Work of the ram over a closed cycle is what friction dissipates (the area of the loop), up to the
    // error of the trapezoidal rule between increments.
    let ram: Vec<f64> = (6..=30)
        .map(|step| match step - 6 {
            k @ 0..=12 => 0.012 - 0.002 * k as f64,
            k => -0.012 + 0.002 * (k - 12) as f64,
        })
        .collect();
    let area: f64 = (1..ram.len())
        .map(|k| 0.5 * (force(6 + k) + force(5 + k)) * (ram[k] - ram[k - 1]))
        .sum();
    assert!(
        (area.abs() / work[0] - 1.0).abs() < 0.05,
        "{area} and {}",
        work[0]
    );
    // It is partial slip: the middle of the contact sticks throughout, and at the end of every stroke its
    // edges slip.
    for step in &steps[7..] {
        let closed = || step.pairs().filter(|pair| pair.closed);
        assert!(
            closed().any(|pair| pair.stick),
            "step {} slips as a whole",
            step.number
        );
        if (step.number - 7) % 12 == 0 {
            assert!(closed().any(|pair| !pair.stick), "step {}", step.number);
        }
    }
}
