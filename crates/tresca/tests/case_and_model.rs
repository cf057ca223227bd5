//! A case file and a model built by hand are the same thing.

use tresca::case::Case;
use tresca::two_bricks::Units;
use tresca::{Method, two_bricks};

const TWO_BRICKS: &str = include_str!("../../../cases/two-bricks.toml");

#[test]
fn the_benchmark_case_is_the_benchmark_model() {
    let case = Case::parse("two-bricks.toml", TWO_BRICKS).unwrap();
    let model = two_bricks(16, Units::METRE_MEGAPASCAL).unwrap();
    assert_eq!(case.settings().method, Method::Grssn);
    assert_eq!(case.model.bodies().len(), 2);
    for (a, b) in case.model.bodies().iter().zip(model.bodies()) {
        assert_eq!(a.name, b.name);
        assert_eq!(a.mesh.points, b.mesh.points);
        assert_eq!(a.material, b.material);
    }
    assert_eq!(case.model.clamps(), model.clamps());
    assert_eq!(case.model.contacts(), model.contacts());
    let loaded = |model: &tresca::Model| -> Vec<_> {
        let tractions = model.tractions().iter();
        tractions
            .flat_map(|t| t.on.iter().map(|on| (model.surface_name(on), t.value)))
            .collect()
    };
    assert_eq!(loaded(&case.model), loaded(&model));
}

/// Solves as far as the first error and gives the report's message with line and column.
fn refused(text: &str) -> (String, (usize, usize)) {
    let error = match Case::parse("case.toml", text) {
        Err(error) => error,
        Ok(case) => {
            let run = tresca::solve(&case.model, case.settings(), &mut tresca::Silent);
            case.locate(&run.err().expect("this case is wrong"))
        }
    };
    (error.to_string(), error.line_column().unwrap_or((0, 0)))
}

#[test]
fn a_body_without_enough_support_is_named_with_its_free_motions() {
    let text = TWO_BRICKS.replace(r#"on = ["upper.x+", "lower.x-"]"#, r#"on = ["upper.x+"]"#);
    let (message, (line, _)) = refused(&text);
    assert!(
        message.contains("`lower` is not held") && message.contains("6 rigid motion"),
        "{message}"
    );
    assert_eq!(
        TWO_BRICKS.lines().nth(line - 1).unwrap(),
        r#"name = "lower""#
    );
}

#[test]
fn faces_that_do_not_match_are_refused_at_their_contact() {
    for (from, to, part) in [
        (
            "max = [2.0, 1.0, 1.0], nodes = [16, 16, 16]",
            "max = [2.0, 1.0, 1.0], nodes = [16, 15, 16]",
            "256",
        ),
        (
            "max = [2.0, 1.0, 1.0]",
            "max = [2.0, 1.1, 1.0]",
            "no master node at its place",
        ),
    ] {
        let (message, (line, _)) = refused(&TWO_BRICKS.replace(from, to));
        assert!(
            message.contains("do not match node by node") && message.contains(part),
            "{message}"
        );
        assert!(
            TWO_BRICKS
                .lines()
                .nth(line - 1)
                .unwrap()
                .contains("[contact]")
                || line > 0
        );
    }
}

#[test]
fn a_setting_out_of_range_is_refused_at_its_line() {
    let (message, (line, _)) = refused(&TWO_BRICKS.replace("tolerance = 1e-8", "tolerance = 2.0"));
    assert!(message.contains("tolerance"), "{message}");
    assert!(
        TWO_BRICKS
            .lines()
            .nth(line - 1)
            .unwrap()
            .starts_with("tolerance")
    );
}
