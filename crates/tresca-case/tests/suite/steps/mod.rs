//! Load steps: what acts when.

mod faults;

use insta::assert_snapshot;
use tresca_model::Amount::{self, Factor, Scalar, Vector};
use tresca_model::{Model, Quantity, Step};

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
    parse(&steps(text)).unwrap().model.steps().to_vec()
}

/// What a name of the rich case means.
fn quantity(model: &Model, name: &str) -> Quantity {
    let names = model.supports().iter().map(|support| &support.name);
    let names = names.chain(model.loads().iter().map(|load| &load.name));
    let mut names = names.chain(model.contacts().iter().map(|contact| &contact.name));
    let index = names.position(|own| own.as_deref() == Some(name)).unwrap();
    model.quantities().nth(index).unwrap()
}

/// How much of something acts in each of some steps.
fn amounts(steps: &[Step], name: &str) -> Vec<Amount> {
    let quantity = quantity(&parse(RICH).unwrap().model, name);
    steps.iter().map(|step| step.amount(quantity)).collect()
}

/// The displacements along x and z that a support prescribes in each of some steps.
fn drag(steps: &[Step]) -> Vec<[f64; 2]> {
    let model = parse(RICH).unwrap().model;
    let of = |amount: Amount| match model.supports()[0].components_by(amount) {
        [Some(x), None, Some(z)] => [x, z],
        other => panic!("{other:?}"),
    };
    amounts(steps, "drag").into_iter().map(of).collect()
}

const LOADS: [&str; 6] = ["push", "wave", "water", "wind", "swirl", "weight"];
const CONTACTS: [&str; 5] = ["joint", "grain", "rub", "rail", "glue"];

#[test]
fn without_steps_everything_acts_at_once() {
    assert!(read("").is_empty() && parse(GOOD).unwrap().model.steps().is_empty());
    // A step that says nothing says the same.
    let [step] = &read("[[step]]\n")[..] else {
        panic!("not one step");
    };
    assert_eq!((step.time, step.name.as_ref()), (1.0, None));
    assert!(step.amounts.is_empty());
    assert_eq!(drag(std::slice::from_ref(step)), [[0.5, -0.25]]);
}

#[test]
fn steps_carry_over_and_increments_interpolate() {
    let case = parse(RICH).unwrap();
    let steps = case.model.steps();
    assert_eq!(steps.len(), 3);
    let name: Vec<Option<&str>> = steps.iter().map(|step| step.name.as_deref()).collect();
    assert_eq!(name, [Some("first"), None, None]);
    let time: Vec<f64> = steps.iter().map(|step| step.time).collect();
    assert_eq!(time, [1.0, 1.5, 2.0]);

    // The push goes from half of its own value to a new one: by values.
    let push = [
        Factor(0.5),
        Vector([0.0, 0.0, -1.75]),
        Vector([0.0, 0.0, -3.0]),
    ];
    assert_eq!(amounts(steps, "push"), push);
    // The wave goes from once to twice, by factors, for it varies.
    let wave = [Factor(1.0), Factor(1.5), Factor(2.0)];
    assert_eq!(amounts(steps, "wave"), wave);
    let joint = [Factor(1.0), Factor(0.75), Factor(0.5)];
    assert_eq!(amounts(steps, "joint"), joint);
    // Of the support one component gets a new value, the other stays.
    assert_eq!(drag(steps), [[0.5, -0.25], [0.5, 0.375], [0.5, 1.0]]);
    for name in ["weight", "water", "wind"] {
        assert_eq!(amounts(steps, name), [Factor(1.0); 3]);
    }
}

#[test]
fn increments_are_named_after_their_step() {
    let steps = read("[[step]]\nname = \"up\"\nincrements = 2\n");
    let name: Vec<Option<&str>> = steps.iter().map(|step| step.name.as_deref()).collect();
    let parts = ["up, increment 1 of 2", "up, increment 2 of 2"];
    assert_eq!(name, parts.map(Some));
}

#[test]
fn the_first_increments_start_from_rest() {
    let steps = read("[[step]]\nincrements = 4\nfactors = { water = 2, joint = 3 }\n");
    let time: Vec<f64> = steps.iter().map(|step| step.time).collect();
    assert_eq!(time, [0.25, 0.5, 0.75, 1.0]);
    for (step, t) in steps.iter().zip([0.25, 0.5, 0.75, 1.0]) {
        let step = std::slice::from_ref(step);
        assert_eq!(drag(step), [[0.5 * t, -0.25 * t]]);
        for name in LOADS {
            let factor = if name == "water" { 2.0 * t } else { t };
            assert_eq!(amounts(step, name), [Factor(factor)]);
        }
        // Slip bounds come from their own values, not from nothing.
        for name in CONTACTS {
            let factor = if name == "joint" { 1.0 + 2.0 * t } else { 1.0 };
            assert_eq!(amounts(step, name), [Factor(factor)]);
        }
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
    for (name, amount) in [
        ("push", Factor(1.0)),
        ("wave", Vector([1.0, 2.0, 3.0])),
        ("water", Factor(1.0)),
        ("wind", Scalar(4.0)),
        ("swirl", Vector([5.0, 6.0, 7.0])),
        ("weight", Vector([8.0, 9.0, 10.0])),
        ("joint", Factor(1.0)),
        ("grain", Factor(2.0)),
        ("rub", Factor(1.0)),
        ("rail", Scalar(11.0)),
        ("glue", Factor(1.0)),
    ] {
        assert_eq!(amounts(&steps[..1], name), [amount], "{name}");
    }
    assert_eq!(drag(&steps), [[12.0, 13.0], [1.5, -0.75]]);
    // A factor is one of the table's own value, not of the value before.
    assert_eq!(amounts(&steps[1..], "wave"), [Factor(0.5)]);
    assert_eq!(amounts(&steps[1..], "wind"), [Scalar(4.0)]);
}

/// Nothing is nothing of a formula, too; and a single increment needs no way.
#[test]
fn a_varying_load_may_grow_from_nothing_to_a_value() {
    let steps = read("[[step]]\nincrements = 2\nvalues = { wind = 4 }\n");
    assert_eq!(amounts(&steps, "wind")[0], Scalar(2.0));
    let steps = read("[[step]]\n[[step]]\nvalues = { wind = 4 }\n");
    assert_eq!(amounts(&steps, "wind")[1], Scalar(4.0));
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
