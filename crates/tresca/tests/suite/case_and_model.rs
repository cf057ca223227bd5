//! A case file and a model built by hand are the same thing.

use tresca::Method;
use tresca::case::Case;
use tresca_bench::two_bricks::{Units, two_bricks};

const TWO_BRICKS: &str = include_str!("../../../../cases/two-bricks.toml");

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
    assert_eq!(case.model.supports(), model.supports());
    let contacts = |model: &tresca::Model| -> Vec<_> {
        let contacts = model.contacts().iter();
        contacts
            .map(|c| {
                let sides = [model.surface_name(&c.slave), model.partner_name(&c.master)];
                format!("{sides:?} {:?} {:?}", c.friction, c.gap)
            })
            .collect()
    };
    assert_eq!(contacts(&case.model), contacts(&model));
    let loaded = |model: &tresca::Model| -> Vec<_> {
        let loads = model.loads().iter();
        loads
            .map(|load| format!("{:?} on {:?}", load.kind, load.on))
            .collect()
    };
    assert_eq!(loaded(&case.model), loaded(&model));
}

/// The clamps hold what a total force pushes.
#[test]
fn reactions_balance_a_total_force() {
    let traction = "[[traction]]\non = [\"upper.z+\", \"upper.x-\"]\nvalue = [0.0, 0.0, -1.0]";
    let force = "[[force]]\non = [\"upper.z+\", \"upper.x-\"]\nvalue = [0.1, -0.2, -3.0]";
    assert!(TWO_BRICKS.contains(traction));
    let text = TWO_BRICKS
        .replace(traction, force)
        .replace("[16, 16, 16]", "[5, 4, 4]");
    let case = Case::parse("two-bricks.toml", &text).unwrap();
    let outcome = tresca::solve(&case.model).unwrap();
    assert!(outcome.converged());
    let reactions = outcome.last().reactions.iter();
    let sum = reactions.fold([0.0; 3], |sum, body| {
        body.chunks(3)
            .fold(sum, |sum, r| std::array::from_fn(|k| sum[k] + r[k]))
    });
    for (reaction, force) in sum.iter().zip([0.1, -0.2, -3.0]) {
        assert!((reaction + force).abs() < 1e-9, "{sum:?}");
    }
}

/// Solves as far as the first error and gives the report's message with line and column.
fn refused(text: &str) -> (String, (usize, usize)) {
    let error = match Case::parse("case.toml", text) {
        Err(error) => error,
        Ok(case) => {
            let run = tresca::solve_with(&case.model, case.settings(), &mut tresca::Silent);
            tresca::case::locate(&case, &run.expect_err("this case is wrong"))
        }
    };
    (error.to_string(), error.line_column().unwrap_or((0, 0)))
}

#[test]
fn a_body_that_nothing_holds_is_named_with_its_free_motions() {
    let alone = r#"
[[body]]
name = "satellite"
mesh = { brick = { min = [5.0, 0.0, 0.0], max = [6.0, 1.0, 1.0], nodes = [2, 2, 2] } }
material = { young = 5.0e4, poisson = 0.3 }
"#;
    let text = TWO_BRICKS.to_owned() + alone;
    let text = text.replace("[solver]", "[ solver ]");
    let (message, (line, _)) = refused(&text);
    assert!(
        message.contains("`satellite` is not held") && message.contains("6 rigid motion"),
        "{message}"
    );
    assert_eq!(text.lines().nth(line - 1).unwrap(), r#"name = "satellite""#);
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
        let pair = "pair = [\"upper.z-\", \"lower.z+\"]";
        let matching = format!("{pair}\ncoupling = \"node_by_node\"");
        let text = TWO_BRICKS.replace(from, to).replace(pair, &matching);
        let (message, (line, _)) = refused(&text);
        assert!(
            message.contains("do not match node by node") && message.contains(part),
            "{message}"
        );
        assert_eq!(text.lines().nth(line - 1).unwrap(), "[[contact]]");
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
