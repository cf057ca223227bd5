//! A good case file, its variations, and reports without colours at a fixed width.

use miette::{GraphicalReportHandler, GraphicalTheme};
use serde::Deserialize;
use tresca_case::{Case, CaseError};
use tresca_contact::{FrictionLaw, ScalarField};
use tresca_model::Place;

/// The founding benchmark: two bricks.
pub const GOOD: &str = r#"title = "Two bricks with Tresca friction"

[[body]]
name = "upper"
mesh = { brick = { min = [0.0, 0.0, 1.0], max = [2.0, 1.0, 2.0], nodes = [16, 16, 16] } }
material = { young = 5.0e4, poisson = 0.277 }

[[body]]
name = "lower"
mesh = { brick = { min = [0.0, 0.0, 0.0], max = [2.0, 1.0, 1.0], nodes = [16, 16, 16] } }
material = { young = 5.0e4, poisson = 0.35 }

[[clamp]]
on = ["upper.x+", "lower.x-"]

[[traction]]
on = ["upper.z+", "upper.x-"]
value = [0.0, 0.0, -1.0]

[[contact]]
pair = ["upper.z-", "lower.z+"]
friction = { law = "tresca", bound = 0.09 }

[solver]
method = "grssn"
tolerance = 1e-8
"#;

/// Every table and every law.
pub const RICH: &str = r#"title = "Everything"
analysis = "solid"

[[body]]
name = "upper"
mesh = { brick = { min = [0, 0, 1], max = [2, 1, 2], nodes = [5, 3, 3] } }
map = ["x + 0.1*z", "y", "z"]
material = { young = 5.0e4, poisson = 0.277, density = 7.8 }

[[body]]
name = "lower"
mesh = { brick = { min = [0, 0, 0], max = [2, 1, 1], nodes = [5, 3, 3] } }
material = { young = 5.0e4, poisson = 0.35 }

[[support]]
name = "drag"
on = ["upper.x+"]
x = 0.5
z = -0.25

[[support]]
on = ["lower.z-"]
y = 0

[[traction]]
name = "push"
on = ["upper.z+"]
value = [0, 0, -1]

[[traction]]
name = "wave"
on = ["upper.y+"]
value = [0, "sin(x)", -1]

[[pressure]]
name = "water"
on = ["lower.x-"]
value = 2

[[pressure]]
name = "wind"
on = ["upper.x-"]
value = "2*z"

[[body_force]]
name = "swirl"
value = [0.1, 0.2, 0.3]

[[gravity]]
name = "weight"
bodies = ["upper"]
value = [0, 0, -10]

[[contact]]
name = "joint"
pair = ["upper.z-", "lower.z+"]
friction = { law = "tresca", bound = 0.09 }
gap = "0.001*x"

[[contact]]
name = "grain"
pair = ["upper.x-", "lower.x+"]
friction = { law = "orthotropic", bounds = [1, "2 + x"], axis = [1, 0, 0] }

[[contact]]
name = "rub"
pair = ["upper.y-", "lower.y+"]
friction = { law = "coulomb", coefficient = 0.3, limit = 7 }

[[contact]]
name = "rail"
pair = ["upper.y+", "lower.y-"]
friction = { law = "bilateral", bound = "0.5*z" }

[[contact]]
name = "glue"
pair = ["upper.x+", "lower.x-"]
friction = { law = "tied" }

[[step]]
name = "first"
factors = { push = 0.5 }

[[step]]
increments = 2
factors = { wave = 2, joint = 0.5 }
values = { push = [0, 0, -3], drag = { z = 1 } }
"#;

/// Obstacles of every shape in space, and the contacts with them.
pub const OBSTACLES: &str = r#"
[[body]]
name = "block"
mesh = { brick = { min = [0, 0, 0], max = [1, 1, 1], nodes = [3, 3, 3], cells = "tet10" }, scale = 2, rotate = { axis = [0, 0, 1], angle = 90 }, translate = [0, 0, 1] }
material = { young = 1, poisson = 0.49 }
formulation = "full"

[[body]]
name = "lid"
mesh = { brick = { min = [-2, 0, 3.01], max = [0, 2, 4], nodes = [2, 2, 2] } }
material = { young = 1, poisson = 0.49 }
formulation = "b_bar"

[[obstacle]]
name = "table"
plane = { point = [0, 0, 1], normal = [0, 0, 3] }
motion = [0, 0, 0.5]

[[obstacle]]
name = "ball"
sphere = { center = [5, 0, 2], radius = 2 }

[[obstacle]]
name = "bore"
cylinder = { point = [0, 0, 0], axis = [0, 0, 1], radius = 4, inside = true }

[[obstacle]]
name = "tool"
surface = { file = "../../../tresca-io/tests/suite/mesh/data/ball-4.1-binary.msh", group = "round", scale = 0.5, translate = [0, 0, 9] }

[[contact]]
name = "stand"
pair = ["block.z-", "table"]
friction = { law = "coulomb", coefficient = 0.2 }
coupling = "mortar"
search = 0.5

[[contact]]
within = 0.1
bodies = ["lid", "block"]
friction = { law = "frictionless" }

[[contact]]
pair = ["lid.z+", "tool"]
friction = { law = "frictionless" }

[[step]]
factors = { table = 0.5 }

[[step]]
increments = 2
values = { table = [0, 0, -1], ball = [1, 0, 0] }
"#;

/// A plane case.
pub const PLANE: &str = r#"analysis = "plane_strain"

[[body]]
name = "block"
mesh = { rectangle = { min = [0, 0], max = [2, 1], nodes = [5, 3] } }
material = { young = 1, poisson = 0.3 }

[[body]]
name = "ground"
mesh = { rectangle = { min = [0, -1], max = [2, 0], nodes = [5, 3], cells = "triangle" } }
map = ["x", "y - 0.1*x^2"]
material = { young = 1, poisson = 0.3 }

[[support]]
name = "roller"
on = ["ground.y-"]
y = 0

[[traction]]
on = ["block.y+"]
value = [0, -1]

[[contact]]
pair = ["block.y-", "ground.y+"]
friction = { law = "coulomb", coefficient = 0.3 }
"#;

/// Stands for the settings that the caller brings.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Solver {
    pub method: Method,
    pub tolerance: Option<f64>,
    pub max_iterations: Option<u32>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    Ssn,
    Apgd,
    #[default]
    Grssn,
}

pub fn parse(text: &str) -> Result<Case<Solver>, CaseError> {
    Case::parse_with("case.toml", text)
}

/// Body and set of a place.
pub fn place(place: &Place) -> (usize, &str) {
    (place.body, &place.set)
}

/// The value of a field at a point.
pub fn at(field: &ScalarField, point: [f64; 3]) -> f64 {
    match field {
        ScalarField::Constant(value) => *value,
        ScalarField::Function(function) => function(point),
        ScalarField::Values(_) => panic!("no key gives values at nodes"),
    }
}

/// The value of a field that is the same everywhere.
pub fn constant(field: &ScalarField) -> Option<f64> {
    match field {
        ScalarField::Constant(value) => Some(*value),
        _ => None,
    }
}

/// The bound of Tresca's law.
pub fn bound(law: &FrictionLaw) -> &ScalarField {
    match law {
        FrictionLaw::Tresca { bound } => bound,
        other => panic!("{other:?}"),
    }
}

/// A text beside which relative paths start.
pub fn parse_here(text: &str) -> Result<Case<Solver>, CaseError> {
    let here = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/suite/case.toml");
    Case::parse_with(here, text)
}

/// The report on a text of [`parse_here`] that must be refused, from its first line to its place.
pub fn report_here(text: &str) -> String {
    let error = parse_here(text).map(|_| ()).expect_err("must be refused");
    let report = render_in(400, &error);
    report.replace(env!("CARGO_MANIFEST_DIR"), "")
}

/// The good case with one replacement, which must apply (to the first place where it does).
pub fn with(from: &str, to: &str) -> String {
    changed(GOOD, from, to)
}

/// A text with one replacement, which must apply (to the first place where it does).
pub fn changed(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "`{from}` is not in this case");
    text.replacen(from, to, 1)
}

/// The report on a text that must be refused.
pub fn report(text: &str) -> String {
    render(&parse(text).map(|_| ()).expect_err("must be refused"))
}

pub fn render(error: &CaseError) -> String {
    render_in(100, error)
}

pub fn render_in(width: usize, error: &CaseError) -> String {
    let mut text = String::new();
    GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor())
        .with_width(width)
        .with_links(false)
        .render_report(&mut text, error)
        .unwrap();
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    lines.join("\n")
}
