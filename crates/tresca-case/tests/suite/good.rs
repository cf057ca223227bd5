//! A good file gives the values that stand in it.

use tresca_case::FaultKind;
use tresca_fem::material::Isotropic;
use tresca_model::{ContactId, LoadId, LoadKind, Subject};

use crate::support::{GOOD, Method, Solver, bound, constant, parse, place, render, with};

#[test]
fn the_founding_benchmark_is_read_as_it_stands() {
    let case = parse(GOOD).unwrap();
    let model = &case.model;
    assert_eq!(model.title(), "Two bricks with Tresca friction");
    assert_eq!(model.bodies().len(), 2);

    let upper = &model.bodies()[0];
    assert_eq!(upper.name, "upper");
    let extent = upper.mesh.bounding_box();
    assert_eq!((extent.min, extent.max), ([0.0, 0.0, 1.0], [2.0, 1.0, 2.0]));
    assert_eq!(upper.mesh.node_count(), 16 * 16 * 16);
    assert_eq!(upper.material, Isotropic::new(5.0e4, 0.277).unwrap());

    let clamps = model.supports().iter();
    let clamped: Vec<_> = clamps.flat_map(|s| &s.on).map(place).collect();
    assert_eq!(clamped, [(0, "x+"), (1, "x-")]);
    let LoadKind::Traction(traction) = &model.loads()[0].kind else {
        panic!("another load");
    };
    assert_eq!(traction.value.constant(), Some([0.0, 0.0, -1.0]));

    let contact = &model.contacts()[0];
    assert_eq!(place(&contact.slave), (0, "z-"));
    assert_eq!(contact.master.surface().map(place), Some((1, "z+")));
    assert_eq!(constant(bound(&contact.friction)), Some(0.09));

    assert_eq!(
        case.solver,
        Solver {
            method: Method::Grssn,
            tolerance: Some(1e-8),
            max_iterations: None,
        }
    );
}

#[test]
fn whole_numbers_are_numbers() {
    let text = with("[2.0, 1.0, 2.0]", "[2, 1, 2]").replace("5.0e4", "50_000");
    let case = parse(&text).unwrap();
    let bodies = case.model.bodies();
    assert_eq!(bodies[0].mesh.bounding_box().max, [2.0, 1.0, 2.0]);
    assert_eq!(bodies[1].material, Isotropic::new(5.0e4, 0.35).unwrap());
}

#[test]
fn what_may_be_absent_gets_its_default() {
    let body = GOOD
        .split("[[body]]")
        .nth(1)
        .map(|rest| format!("[[body]]{rest}"))
        .unwrap();
    let case = parse(&body).unwrap();
    let model = &case.model;
    assert_eq!(model.title(), "case");
    assert!(model.supports().is_empty() && model.loads().is_empty());
    assert!(model.contacts().is_empty() && model.steps().is_empty());
    assert_eq!(case.solver, Solver::default());
}

#[test]
fn line_ends_and_a_byte_order_mark_make_no_difference() {
    let windows = format!("\u{feff}{}", GOOD.replace('\n', "\r\n"));
    let case = parse(&windows).unwrap();
    let span = case.locate("body[1].material.poisson").unwrap();
    assert_eq!(&case.source.text()[span.clone()], "0.35");
    assert_eq!(case.source.line_column(span.start), (11, 39));
}

/// What is said of a part of the model is said where it stands.
#[test]
fn parts_of_the_model_have_their_places() {
    let case = parse(GOOD).unwrap();
    let place = |subject: Subject| {
        let error = case.fault(subject, "wrong", "this", "");
        let line = error.line_column().unwrap().0;
        GOOD.lines().nth(line - 1).unwrap().to_owned()
    };
    assert_eq!(place(Subject::Body(1)), "name = \"lower\"");
    assert_eq!(place(LoadId(0).into()), "[[traction]]");
    assert_eq!(place(ContactId(0).into()), "[[contact]]");
    assert_eq!(place(Subject::Model), GOOD.lines().next().unwrap());
}

#[test]
fn later_checks_find_the_place_of_a_key() {
    let case = parse(GOOD).unwrap();
    let text = |path: &str| case.locate(path).map(|span| &GOOD[span]);
    assert_eq!(text("solver.tolerance"), Some("1e-8"));
    assert_eq!(text("body[1].material.poisson"), Some("0.35"));
    assert_eq!(text("body[0].mesh.brick.nodes"), Some("[16, 16, 16]"));
    for missing in [
        "",
        "solver.rho",
        "body[2].name",
        "body[x]",
        "title.x",
        "body[0",
    ] {
        assert_eq!(text(missing), None, "{missing}");
    }
}

#[test]
fn later_checks_report_like_the_early_ones() {
    let case = parse(GOOD).unwrap();
    let span = |word: &str| {
        let start = GOOD.find(word).unwrap();
        start..start + word.len()
    };
    let error = case
        .fault_at(
            span("\"upper.z-\""),
            "the two surfaces do not match node by node",
            "16 × 16 nodes",
            "give both bodies the same `nodes` along the contact surface",
        )
        .and_at(span("\"lower.z+\""), "16 × 15 nodes");
    assert_eq!(error.line_column(), Some((21, 9)));
    assert_eq!(error.fault().kind, FaultKind::Semantic);
    insta::assert_snapshot!(render(&error), @r#"
    case::semantic

      × the two surfaces do not match node by node
        ╭─[case.toml:21:9]
     20 │ [[contact]]
     21 │ pair = ["upper.z-", "lower.z+"]
        ·         ─────┬────  ─────┬────
        ·              │           ╰── 16 × 15 nodes
        ·              ╰── 16 × 16 nodes
     22 │ friction = { law = "tresca", bound = 0.09 }
        ╰────
      help: give both bodies the same `nodes` along the contact surface
    "#);
}
