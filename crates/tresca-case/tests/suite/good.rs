//! A good file gives the values that stand in it.

use tresca_case::{CaseError, FaultKind, Friction, Mesh};

use crate::support::{GOOD, Method, Solver, pair, parse, render, with};

#[test]
fn the_founding_benchmark_is_read_as_it_stands() {
    let case = parse(GOOD).unwrap();
    assert_eq!(case.title, "Two bricks with Tresca friction");
    assert_eq!(case.bodies.len(), 2);

    let upper = &case.bodies[0];
    assert_eq!(upper.name.get_ref(), "upper");
    let Mesh::Brick(brick) = upper.mesh.get_ref() else {
        panic!("no brick");
    };
    assert_eq!(brick.min.get_ref().values(), [0.0, 0.0, 1.0]);
    assert_eq!(brick.max.get_ref().values(), [2.0, 1.0, 2.0]);
    assert_eq!(brick.nodes.get_ref().values(), [16, 16, 16]);
    let material = upper.material.get_ref();
    assert_eq!(*material.young.get_ref(), 5.0e4);
    assert_eq!(*material.poisson.get_ref(), 0.277);

    let clamped: Vec<_> = case.clamps[0]
        .on
        .iter()
        .map(|s| (s.body, s.face.as_str()))
        .collect();
    assert_eq!(clamped, [(0, "x+"), (1, "x-")]);
    assert_eq!(case.tractions[0].value.constant(), Some([0.0, 0.0, -1.0]));

    let contact = &case.contacts[0];
    let (slave, master) = pair(contact);
    assert_eq!((slave.body, slave.face.as_str()), (0, "z-"));
    assert_eq!((master.body, master.face.as_str()), (1, "z+"));
    let Friction::Tresca { bound } = &contact.friction else {
        panic!("another law");
    };
    assert_eq!(bound.get_ref().constant(), Some(0.09));

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
    let Mesh::Brick(brick) = case.bodies[0].mesh.get_ref() else {
        panic!("no brick");
    };
    assert_eq!(brick.max.get_ref().values(), [2.0, 1.0, 2.0]);
    assert_eq!(*case.bodies[1].material.get_ref().young.get_ref(), 5.0e4);
}

#[test]
fn what_may_be_absent_gets_its_default() {
    let body = GOOD
        .split("[[body]]")
        .nth(1)
        .map(|rest| format!("[[body]]{rest}"))
        .unwrap();
    let case = parse(&body).unwrap();
    assert_eq!(case.title, "case");
    assert!(case.clamps.is_empty() && case.tractions.is_empty() && case.contacts.is_empty());
    assert_eq!(case.solver, Solver::default());
}

#[test]
fn line_ends_and_a_byte_order_mark_make_no_difference() {
    let windows = format!("\u{feff}{}", GOOD.replace('\n', "\r\n"));
    let case = parse(&windows).unwrap();
    let span = case.bodies[1].material.get_ref().poisson.span();
    assert_eq!(&case.source.text()[span.clone()], "0.35");
    assert_eq!(case.source.line_column(span.start), (11, 39));
}

#[test]
fn spans_cover_what_they_belong_to() {
    let case = parse(GOOD).unwrap();
    let text = |span: std::ops::Range<usize>| &GOOD[span];
    let contact = &case.contacts[0];
    assert_eq!(text(pair(contact).1.span.clone()), "\"lower.z+\"");
    assert_eq!(text(contact.span.clone()), "[[contact]]");
    let Friction::Tresca { bound } = &contact.friction else {
        panic!("another law");
    };
    assert_eq!(text(bound.span()), "0.09");
    assert_eq!(
        text(case.tractions[0].value.span.clone()),
        "[0.0, 0.0, -1.0]"
    );
}

#[test]
fn later_checks_find_the_place_of_a_key() {
    let source = parse(GOOD).unwrap().source;
    let text = |path: &str| source.locate(path).map(|span| &GOOD[span]);
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
    let (slave, master) = pair(&case.contacts[0]);
    let error = CaseError::semantic(
        &case.source,
        slave.span.clone(),
        "the two surfaces do not match node by node",
        "16 × 16 nodes",
        "give both bodies the same `nodes` along the contact surface",
    )
    .and_at(master.span.clone(), "16 × 15 nodes");
    assert_eq!(error.line_column(), Some((21, 9)));
    let CaseError::Fault(fault) = &error else {
        panic!("{error:?}");
    };
    assert_eq!(fault.kind(), FaultKind::Semantic);
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
