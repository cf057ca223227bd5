//! What result files say about their origin.

use crate::vtu::Fact;

/// Where a file comes from.
pub fn origin(title: &str, version: &str) -> Vec<(String, Fact)> {
    vec![
        text("title", title.to_owned()),
        text("version", format!("tresca {version}")),
    ]
}

/// How the load step ended that a file shows.
#[derive(Clone, Debug)]
pub struct StepFacts {
    /// Number of the step, from 1.
    pub step: usize,
    /// Instant in the time series.
    pub time: f64,
    /// How the method ended, in a word.
    pub status: String,
    /// Whether that is convergence.
    pub converged: bool,
    /// The method.
    pub method: String,
    /// All settings.
    pub settings: String,
    /// Iterations.
    pub iterations: usize,
    /// Multiplications by A.
    pub n_a: usize,
    /// What the tolerance is on.
    pub relative_reduced_gradient: f64,
}

impl StepFacts {
    /// The facts, behind those of the origin.
    pub fn behind(self, mut facts: Vec<(String, Fact)>) -> Vec<(String, Fact)> {
        facts.extend([
            text("status", self.status),
            text("method", self.method),
            text("settings", self.settings),
            count("converged", usize::from(self.converged)),
            count("step", self.step),
            number("time", self.time),
            count("iterations", self.iterations),
            count("n_a", self.n_a),
            number("relative_reduced_gradient", self.relative_reduced_gradient),
        ]);
        facts
    }
}

fn text(name: &str, value: String) -> (String, Fact) {
    (name.to_owned(), Fact::Text(value))
}

fn number(name: &str, value: f64) -> (String, Fact) {
    (name.to_owned(), Fact::Numbers(vec![value]))
}

fn count(name: &str, value: usize) -> (String, Fact) {
    let value = i64::try_from(value).unwrap_or(i64::MAX);
    (name.to_owned(), Fact::Integers(vec![value]))
}
