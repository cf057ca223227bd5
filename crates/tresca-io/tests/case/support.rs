//! A good case file, its variations, and reports without colours at a fixed width.

use miette::{GraphicalReportHandler, GraphicalTheme};
use serde::Deserialize;
use tresca_io::case::{self, CaseError, CaseFile};

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

pub fn parse(text: &str) -> Result<CaseFile<Solver>, CaseError> {
    case::parse("case.toml", text)
}

/// The good case with one replacement, which must apply (to the first place where it does).
pub fn with(from: &str, to: &str) -> String {
    assert!(GOOD.contains(from), "`{from}` is not in the good case");
    GOOD.replacen(from, to, 1)
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
