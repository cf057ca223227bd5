//! Load steps: what acts when.

mod faults;

use insta::assert_snapshot;
use tresca_case::{Amount, Step};

use crate::support::{GOOD, RICH, changed, parse, report};

fn rich(from: &str, to: &str) -> String {
    changed(RICH, from, to)
}

/// The rich case with other steps.
fn steps(text: &str) -> String {
    let (before, _) = RICH.split_once("[[step]]").unwrap();
    format!("{before}{text}")
}

fn read(text: &str) -> Vec<Step> {
    parse(&steps(text)).unwrap().steps
}

use Amount::{Factor, Value};

#[test]
fn without_steps_everything_acts_at_once() {
    let steps = read("");
    let [step] = steps.as_slice() else {
        panic!("not one step");
    };
    assert_eq!((step.number, step.increment, step.increments), (0, 1, 1));
    assert_eq!((step.time, step.name.as_ref()), (1.0, None));
    let amounts = &step.amounts;
    let held = [[Some(0.5), None, Some(-0.25)], [None, Some(0.0), None]];
    assert_eq!(amounts.supports, held);
    assert_eq!(amounts.tractions, [Factor(1.0); 2]);
    assert_eq!(amounts.pressures, [Factor(1.0); 2]);
    assert_eq!(amounts.body_forces, [Factor(1.0)]);
    assert_eq!(amounts.gravities, [Factor(1.0)]);
    assert_eq!(amounts.bounds, [Factor(1.0); 5]);
    // A step that says nothing says the same.
    assert_eq!(read("[[step]]\n"), steps);
    assert_eq!(parse(GOOD).unwrap().steps.len(), 1);
}

#[test]
fn steps_carry_over_and_increments_interpolate() {
    let steps = parse(RICH).unwrap().steps;
    assert_eq!(steps.len(), 3);
    let name: Vec<Option<&str>> = steps.iter().map(|step| step.name.as_deref()).collect();
    assert_eq!(name, [Some("first"), None, None]);
    let place: Vec<_> = steps
        .iter()
        .map(|s| (s.number, s.increment, s.increments))
        .collect();
    assert_eq!(place, [(0, 1, 1), (1, 1, 2), (1, 2, 2)]);
    let time: Vec<f64> = steps.iter().map(|step| step.time).collect();
    assert_eq!(time, [1.0, 1.5, 2.0]);

    let amounts: Vec<_> = steps.iter().map(|step| &step.amounts).collect();
    // The push goes from half of its own value to a new one: by values.
    let push: Vec<_> = amounts.iter().map(|a| a.tractions[0]).collect();
    assert_eq!(
        push,
        [
            Factor(0.5),
            Value([0.0, 0.0, -1.75]),
            Value([0.0, 0.0, -3.0])
        ]
    );
    // The wave goes from once to twice, by factors, for it varies.
    let wave: Vec<_> = amounts.iter().map(|a| a.tractions[1]).collect();
    assert_eq!(wave, [Factor(1.0), Factor(1.5), Factor(2.0)]);
    let joint: Vec<_> = amounts.iter().map(|a| a.bounds[0]).collect();
    assert_eq!(joint, [Factor(1.0), Factor(0.75), Factor(0.5)]);
    // Of the support one component gets a new value, the other stays.
    let drag: Vec<_> = amounts.iter().map(|a| a.supports[0]).collect();
    let held = |z| [Some(0.5), None, Some(z)];
    assert_eq!(drag, [held(-0.25), held(0.375), held(1.0)]);
    for step in &steps {
        assert_eq!(step.amounts.gravities, [Factor(1.0)]);
        assert_eq!(step.amounts.pressures, [Factor(1.0); 2]);
        assert_eq!(step.amounts.supports[1], [None, Some(0.0), None]);
    }
}

#[test]
fn the_first_increments_start_from_rest() {
    let steps = read("[[step]]\nincrements = 4\nfactors = { water = 2, joint = 3 }\n");
    let time: Vec<f64> = steps.iter().map(|step| step.time).collect();
    assert_eq!(time, [0.25, 0.5, 0.75, 1.0]);
    for (step, t) in steps.iter().zip([0.25, 0.5, 0.75, 1.0]) {
        let amounts = &step.amounts;
        assert_eq!(amounts.supports[0], [Some(0.5 * t), None, Some(-0.25 * t)]);
        assert_eq!(amounts.tractions, [Factor(t); 2]);
        assert_eq!(amounts.pressures, [Factor(2.0 * t), Factor(t)]);
        assert_eq!(amounts.body_forces, [Factor(t)]);
        assert_eq!(amounts.gravities, [Factor(t)]);
        // Slip bounds come from their own values, not from nothing.
        assert_eq!(amounts.bounds[0], Factor(1.0 + 2.0 * t));
        assert_eq!(amounts.bounds[1..], [Factor(1.0); 4]);
    }
}

#[test]
fn values_of_every_kind() {
    let steps = read(
        "[[step]]\ntime = 0.5\nvalues = { wave = [1, 2, 3], wind = 4, swirl = [5, 6, 7], \
         weight = [8, 9, 10], rail = 11, drag = { x = 12, z = 13 } }\nfactors = { grain = 2 }\n\
         [[step]]\nfactors = { wave = 0.5, drag = 3 }\n",
    );
    let [first, second] = steps.as_slice() else {
        panic!("not two steps");
    };
    assert_eq!((first.time, second.time), (0.5, 1.5));
    let amounts = &first.amounts;
    assert_eq!(amounts.tractions, [Factor(1.0), Value([1.0, 2.0, 3.0])]);
    assert_eq!(amounts.pressures, [Factor(1.0), Value(4.0)]);
    assert_eq!(amounts.body_forces, [Value([5.0, 6.0, 7.0])]);
    assert_eq!(amounts.gravities, [Value([8.0, 9.0, 10.0])]);
    let one = Factor(1.0);
    assert_eq!(amounts.bounds, [one, Factor(2.0), one, Value(11.0), one]);
    assert_eq!(amounts.supports[0], [Some(12.0), None, Some(13.0)]);
    // A factor is one of the table's own value, not of the value before.
    assert_eq!(second.amounts.tractions[1], Factor(0.5));
    assert_eq!(second.amounts.supports[0], [Some(1.5), None, Some(-0.75)]);
    assert_eq!(second.amounts.pressures[1], Value(4.0));
}

#[test]
fn an_amount_of_its_own_value() {
    assert_eq!(Factor(0.5).of([2.0, 4.0, 6.0]), [1.0, 2.0, 3.0]);
    assert_eq!(Value(0.5).of(3.0), 0.5);
}

/// Nothing is nothing of a formula, too; and a single increment needs no way.
#[test]
fn a_varying_load_may_grow_from_nothing_to_a_value() {
    let steps = read("[[step]]\nincrements = 2\nvalues = { wind = 4 }\n");
    assert_eq!(steps[0].amounts.pressures[1], Value(2.0));
    let steps = read("[[step]]\n[[step]]\nvalues = { wind = 4 }\n");
    assert_eq!(steps[1].amounts.pressures[1], Value(4.0));
}

#[test]
fn a_varying_load_does_not_interpolate_to_a_value() {
    let text =
        steps("[[step]]\n[[step]]\nincrements = 2\nvalues = { push = [0, 0, 1], wind = 4 }\n");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × there is no way from the step before to this one in increments
        ╭─[case.toml:83:30]
     82 │ increments = 2
     83 │ values = { push = [0, 0, 1], wind = 4 }
        ·                              ──┬─
        ·                                ╰── from a multiple of something that varies to a constant, or back
        ╰────
      help: use factors in both steps, or a single increment
    "#);
}

#[test]
fn a_varying_bound_does_not_interpolate_to_a_value() {
    let text = steps("[[step]]\nincrements = 2\nvalues = { rail = 4 }\n");
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × there is no way from the step before to this one in increments
        ╭─[case.toml:82:12]
     81 │ increments = 2
     82 │ values = { rail = 4 }
        ·            ──┬─
        ·              ╰── from a multiple of something that varies to a constant, or back
        ╰────
      help: use factors in both steps, or a single increment
    "#);
}

#[test]
fn a_varying_load_does_not_interpolate_back_from_a_value() {
    let text = steps(
        "[[step]]\nvalues = { wave = [0, 0, 4] }\n[[step]]\nincrements = 2\nfactors = { wave = 1 }\n",
    );
    assert_snapshot!(report(&text), @r#"
    case::bad_value

      × there is no way from the step before to this one in increments
        ╭─[case.toml:84:13]
     83 │ increments = 2
     84 │ factors = { wave = 1 }
        ·             ──┬─
        ·               ╰── from a multiple of something that varies to a constant, or back
        ╰────
      help: use factors in both steps, or a single increment
    "#);
}
