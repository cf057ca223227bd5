//! docs/summary.md beside what is written: every key of a summary is on the page, and every key on the page is
//! written through the doors that the page names, through no other.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tresca::algebraic::{self, Assembly, Dual, Matrix, MatrixProblem, Operator, PairLaw};
use tresca::case::Case;
use tresca::fclib::{self, Document, FclibProblem, GlobalProblem, LocalProblem, State};
use tresca::output::Destination;
use tresca::report::{RunReport, SCHEMA};
use tresca::{Settings, Silent};

const PAGE: &str = include_str!("../../../../docs/summary.md");
const DOORS: [&str; 4] = ["case", "matrices", "dual", "fclib"];

const DRAGGED: &str = r#"
title = "A brick on a table"

[[body]]
name = "brick"
mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 2.0, 2.0], nodes = [3, 3, 2] } }
material = { young = 100.0, poisson = 0.3 }

[[body]]
name = "table"
mesh = { brick = { min = [0.0, 0.0, 0.0], max = [2.0, 2.0, 1.0], nodes = [3, 3, 2] } }
material = { young = 100.0, poisson = 0.3 }

[[support]]
name = "foot"
on = ["table.z-"]
x = 0.0
y = 0.0
z = 0.0

[[traction]]
name = "weight"
on = ["brick.z+"]
value = [0.0, 0.0, -1.0]

[[contact]]
name = "joint"
pair = ["brick.z-", "table.z+"]
friction = { law = "tresca", bound = 0.5 }

[[step]]
name = "press"

[[step]]
name = "press-more"
factors = { weight = 2.0 }
"#;

/// The same pulled away.
fn lifted() -> String {
    let steps = DRAGGED.find("[[step]]").unwrap();
    DRAGGED[..steps].replace("[0.0, 0.0, -1.0]", "[0.0, 0.0, 1.0]")
}

/// A beam on two blocks, all glued to each other, one joint with a step: around the edge where the three meet the
/// steps do not add up to nothing.
const TORN: &str = r#"
[[body]]
name = "beam"
mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [3, 2, 2] } }
material = { young = 100.0, poisson = 0.3 }

[[body]]
name = "left"
mesh = { brick = { min = [0.0, 0.0, 0.0], max = [1.0, 1.0, 1.0], nodes = [2, 2, 2] } }
material = { young = 100.0, poisson = 0.3 }

[[body]]
name = "right"
mesh = { brick = { min = [1.0, 0.0, 0.0], max = [2.0, 1.0, 1.0], nodes = [2, 2, 2] } }
material = { young = 100.0, poisson = 0.3 }

[[clamp]]
on = ["left.z-", "right.z-", "beam.z+"]

[[contact]]
pair = ["left.z+", "beam.z-"]
friction = { law = "tied" }

[[contact]]
pair = ["beam.z-", "right.z+"]
gap = 0.1
friction = { law = "tied" }

[[contact]]
pair = ["right.x-", "left.x+"]
friction = { law = "tied" }
"#;

/// What was written into a folder.
fn written(folder: &Path) -> Value {
    let text = std::fs::read_to_string(folder.join("summary.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn case(text: &str, folder: &Path) -> Value {
    let case = Case::parse("case.toml", text).unwrap();
    let outcome = tresca::solve_with(&case.model, case.settings(), &mut Silent).unwrap();
    let to = Destination::new(folder).unwrap();
    to.write("case", &case.model, &outcome).unwrap();
    written(folder)
}

fn matrices(folder: &Path) -> Value {
    let case = Case::parse("case.toml", DRAGGED).unwrap();
    let assembly = Assembly::new(&case.model, &case.model.whole_step()).unwrap();
    let solution = algebraic::solve(&assembly.problem, &Settings::default(), &mut Silent).unwrap();
    let to = Destination::new(folder).unwrap();
    to.write_matrices("matrices", &solution).unwrap();
    written(folder)
}

/// One dof, tied twice with different gaps.
fn torn(folder: &Path) -> Value {
    let one = |values: &[f64]| Matrix::from_dense((values.len(), 1), values).unwrap();
    let problem = MatrixProblem::new(vec![one(&[2.0])], one(&[1.0, 1.0]), vec![0.0])
        .with_tangential(one(&[1.0, 1.0]))
        .with_gap(vec![0.1, 0.2])
        .with_friction(PairLaw::Tied);
    let solution = algebraic::solve(&problem, &Settings::default(), &mut Silent).unwrap();
    let to = Destination::new(folder).unwrap();
    to.write_matrices("matrices", &solution).unwrap();
    written(folder)
}

fn torn_dual() -> Value {
    let operator = Operator::dense(2, &[1.0; 4]).unwrap();
    let dual = Dual::new(
        operator,
        vec![1.0, 2.0],
        0,
        PairLaw::Bilateral { bound: 0.0 },
    );
    let solution = algebraic::solve_dual(dual, &Settings::default(), &mut Silent).unwrap();
    serde_json::to_value(RunReport::of_matrices(&solution)).unwrap()
}

/// As Python has it: nothing is written.
fn dual() -> Value {
    let operator = Operator::dense(2, &[2.0, 0.5, 0.5, 1.0]).unwrap();
    let dual = Dual::new(operator, vec![1.0, 1.0], 1, PairLaw::tresca(0.2));
    let solution = algebraic::solve_dual(dual, &Settings::default(), &mut Silent).unwrap();
    serde_json::to_value(RunReport::of_matrices(&solution)).unwrap()
}

fn fclib(document: &Document, law: fclib::FclibLaw, folder: &Path) -> Value {
    let settings = Settings::default();
    let outcome = fclib::solve(&document.problem, law, &settings, &mut Silent).unwrap();
    let to = Destination::new(folder).unwrap();
    to.write_fclib("problem", document, &outcome, &settings)
        .unwrap();
    written(folder)
}

fn fclibs(folder: &Path) -> Vec<Value> {
    let data = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tresca-io/tests/data/fclib");
    let mut local = fclib::read(&data.join("Rover1039.dat")).unwrap();
    local.info.title = Some("A rover".to_owned());
    local.solution = Some(State {
        v: None,
        u: vec![1.0; local.problem.unknowns()],
        r: vec![1.0; local.problem.unknowns()],
    });
    let identity = || fclib::FclibMatrix::new(3, 3, (0..3).map(|i| (i, i, 1.0)).collect()).unwrap();
    let global = Document {
        problem: FclibProblem::Global(GlobalProblem {
            dimension: 3,
            m: identity(),
            h: identity(),
            f: vec![0.0; 3],
            w: vec![-1.0, 2.0, 0.0],
            friction: vec![0.5],
        }),
        solution: None,
        ..local.clone()
    };
    let tresca = fclib::FclibLaw::Tresca { bound: 0.5 };
    let torn = Document {
        problem: FclibProblem::Local(LocalProblem {
            dimension: 2,
            w: fclib::FclibMatrix::new(
                4,
                4,
                vec![(0, 0, 1.0), (0, 2, -1.0), (2, 0, -1.0), (2, 2, 1.0)],
            )
            .unwrap(),
            q: vec![-1.0, 0.0, 0.5, 0.0],
            friction: vec![0.0; 2],
        }),
        solution: None,
        ..local.clone()
    };
    vec![
        fclib(&torn, fclib::FclibLaw::Coulomb, folder),
        fclib(&local, fclib::FclibLaw::Coulomb, folder),
        fclib(&global, tresca, folder),
    ]
}

/// The keys of a summary; options have a page of their own.
fn keys(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(entries) => {
            for (key, entry) in entries {
                let path = match path {
                    "" => key.clone(),
                    _ => format!("{path}.{key}"),
                };
                if path != "settings" {
                    keys(entry, &path, found);
                }
                found.insert(path);
            }
        }
        Value::Array(entries) => {
            for entry in entries {
                keys(entry, &format!("{path}[]"), found);
            }
        }
        Value::Null => panic!("`{path}` is null"),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// The keys on the page that a door writes.
fn listed(door: &str) -> BTreeSet<String> {
    let rows = PAGE.lines().filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| {
        let (key, rest) = row.split_once("` | ")?;
        let place = rest.split(" | ").nth(1)?;
        let mut words = place.split(|c: char| !c.is_alphanumeric());
        words
            .any(|word| word == "all" || word == door)
            .then(|| key.to_owned())
    })
    .collect()
}

#[test]
fn the_page_lists_what_the_doors_write() {
    let scene = tempfile::tempdir().unwrap();
    let folder = scene.path();
    let summaries = [
        vec![
            case(DRAGGED, folder),
            case(&lifted(), folder),
            case(TORN, folder),
        ],
        vec![matrices(folder), torn(folder)],
        vec![dual(), torn_dual()],
        fclibs(folder),
    ];
    for (door, summaries) in DOORS.into_iter().zip(&summaries) {
        let mut found = BTreeSet::new();
        for summary in summaries {
            assert_eq!(summary["door"], door);
            assert_eq!(summary["schema"], SCHEMA);
            keys(summary, "", &mut found);
        }
        let mut listed = listed(door);
        if tresca::memory::peak_bytes().is_none() {
            listed.remove("peak_memory_bytes");
        }
        let missing: Vec<_> = found.difference(&listed).collect();
        assert!(
            missing.is_empty(),
            "{door} writes, the page does not say: {missing:?}"
        );
        let idle: Vec<_> = listed.difference(&found).collect();
        assert!(
            idle.is_empty(),
            "the page says, {door} does not write: {idle:?}"
        );
    }
    assert!(PAGE.contains(&format!("`schema` is {SCHEMA}.")));
    assert!(PAGE.contains(&format!("| `schema` | number | all | {SCHEMA} |")));
}
