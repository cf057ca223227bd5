//! The result files of a run.

use std::path::{Path, PathBuf};
use std::time::Instant;

use rayon::prelude::*;
use tresca_fem::mesh::{CellKind, Mesh};
use tresca_fem::stress;
use tresca_io::atomic::OutputSet;
use tresca_io::history::History;
use tresca_io::pvd::{self, Part};
use tresca_io::results::{BodyFields, ContactFields};
use tresca_io::vtu::{CellShape, Cells, Fact};
use tresca_io::{WriteError, summary};
use tresca_qcqp::IterationRecord;

use crate::model::Model;
use crate::outcome::{Outcome, PairState};
use crate::{Summary, VERSION};

/// Name of the file with the contact fields.
const CONTACT: &str = "contact";

/// A directory that result files can be written to. Made before a run, so that a run does not
/// find out at its end that it has no place for its results.
#[derive(Debug)]
pub struct Destination {
    directory: PathBuf,
}

impl Destination {
    /// A directory that exists or can be made; nothing is made yet.
    ///
    /// # Errors
    /// When a file stands where the directory, or one of its parents, should be.
    pub fn new(directory: &Path) -> Result<Self, WriteError> {
        let existing = directory.ancestors().find(|path| path.exists());
        if let Some(obstacle) = existing.filter(|path| !path.is_dir()) {
            return Err(WriteError::Io {
                action: "create the directory",
                path: directory.to_owned(),
                source: std::io::Error::new(
                    std::io::ErrorKind::NotADirectory,
                    format!("`{}` is a file", obstacle.display()),
                ),
            });
        }
        Ok(Self {
            directory: directory.to_owned(),
        })
    }

    /// Writes all files of a run: `<body>.vtu`, `contact.vtu`, `<name>.pvd` that opens them together,
    /// `history.csv` and `summary.json`. All of them appear, or none: earlier results stay as they
    /// were when anything fails.
    ///
    /// # Errors
    /// When a file cannot be written, or a field holds a number that is not finite.
    pub fn write(
        self,
        name: &str,
        model: &Model,
        outcome: &Outcome,
    ) -> Result<Summary, WriteError> {
        let begin = Instant::now();
        let mut files = OutputSet::new(self.directory)?;
        let facts = facts(model, outcome);
        let stresses: Vec<Vec<[f64; 6]>> = model
            .bodies()
            .par_iter()
            .zip(&outcome.displacements)
            .map(|(body, u)| stress::recover(&body.mesh, &body.material, u))
            .collect();
        let mut parts = Vec::new();
        for ((body, u), stress) in model
            .bodies()
            .iter()
            .zip(&outcome.displacements)
            .zip(&stresses)
        {
            let file = format!("{}.vtu", body.name);
            let von_mises: Vec<f64> = stress.iter().map(|&s| stress::von_mises(s)).collect();
            let fields = BodyFields {
                mesh: &body.mesh,
                displacement: u,
                stress,
                von_mises: &von_mises,
                facts: facts.clone(),
            };
            files.stage(&file, |out| fields.write(out))?;
            parts.push((body.name.clone(), file));
        }
        let file = format!("{CONTACT}.vtu");
        files.stage(&file, |out| write_contact(model, outcome, facts, out))?;
        parts.push((CONTACT.to_owned(), file));
        files.stage("history.csv", |out| {
            history(&outcome.solution.records)?.write(out)
        })?;
        let parts: Vec<_> = parts
            .iter()
            .map(|(name, file)| Part {
                name,
                file,
                time: 0.0,
            })
            .collect();
        files.stage(&format!("{name}.pvd"), |out| pvd::write(out, &parts))?;
        let result = Summary::new(model.title(), outcome, begin.elapsed().as_secs_f64());
        files.stage("summary.json", |out| summary::write(out, &result))?;
        files.commit()?;
        Ok(result)
    }
}

/// What every result file says about its origin.
fn facts(model: &Model, outcome: &Outcome) -> Vec<(String, Fact)> {
    let solution = &outcome.solution;
    let text = |name: &str, value: String| (name.to_owned(), Fact::Text(value));
    let count = |name: &str, value: usize| {
        (
            name.to_owned(),
            Fact::Integers(vec![i64::try_from(value).unwrap_or(i64::MAX)]),
        )
    };
    vec![
        text("title", model.title().to_owned()),
        text("version", format!("tresca {VERSION}")),
        text("status", solution.status.to_string()),
        text("method", solution.method.to_string()),
        text("settings", format!("{:?}", outcome.settings)),
        (
            "converged".to_owned(),
            Fact::Integers(vec![i64::from(outcome.converged())]),
        ),
        count("iterations", solution.iterations),
        count("n_a", solution.n_a),
        (
            "relative_reduced_gradient".to_owned(),
            Fact::Numbers(vec![solution.relative_reduced_gradient]),
        ),
    ]
}

fn history(records: &[IterationRecord]) -> Result<History, WriteError> {
    let mut table = History::new(&[
        "iteration",
        "relative_reduced_gradient",
        "dual_objective",
        "decrease",
        "open",
        "closed",
        "stick",
        "slip",
        "set_changes",
        "inner_iterations",
        "n_a",
        "step_length",
    ]);
    for record in records {
        let counts = record.counts;
        table.push(&[
            record.iteration.into(),
            record.relative_reduced_gradient.into(),
            record.objective.into(),
            record.decrease.into(),
            counts.open.into(),
            counts.closed.into(),
            counts.stick.into(),
            counts.slip.into(),
            record.set_changes.into(),
            record.inner_iterations.into(),
            record.n_a.into(),
            record.step_length.into(),
        ])?;
    }
    Ok(table)
}

fn write_contact(
    model: &Model,
    outcome: &Outcome,
    facts: Vec<(String, Fact)>,
    out: &mut dyn std::io::Write,
) -> Result<(), WriteError> {
    let mut index = Vec::new();
    let mut quads = Vec::new();
    let mut first = 0;
    for (number, (contact, pairs)) in model.contacts().iter().zip(&outcome.contacts).enumerate() {
        index.resize(
            index.len() + pairs.len(),
            i32::try_from(number).unwrap_or(i32::MAX),
        );
        let mesh = &model.bodies()[contact.slave.body].mesh;
        let point_of_node = points_of_nodes(mesh, pairs, first);
        for &face in model.faces(&contact.slave) {
            if mesh.face_kind(face) != CellKind::Quad4 {
                continue;
            }
            let points: Option<Vec<usize>> = mesh
                .face_nodes(face)
                .into_iter()
                .map(|node| point_of_node[node])
                .collect();
            // A face with a pair that was left out (both nodes held) is not shown.
            quads.extend(points.into_iter().flatten());
        }
        first += pairs.len();
    }
    fn column<T>(outcome: &Outcome, value: impl Fn(&PairState) -> T) -> Vec<T> {
        outcome.pairs().map(value).collect()
    }
    let faces = if quads.is_empty() {
        Vec::new()
    } else {
        vec![Cells {
            shape: CellShape::Quad,
            connectivity: &quads,
        }]
    };
    ContactFields {
        points: &column(outcome, |state| state.pair.point),
        faces,
        pair: &index,
        normal: &column(outcome, |state| state.pair.frame.normal),
        normal_force: &column(outcome, |state| state.normal_force),
        contact_pressure: &column(outcome, PairState::pressure),
        tangential_force: &column(outcome, |state| state.friction_force),
        tangential_traction: &column(outcome, PairState::friction_traction),
        slip_bound: &column(outcome, |state| state.pair.slip_bound),
        gap: &column(outcome, |state| state.gap),
        slip: &column(outcome, |state| state.slip),
        closed: &column(outcome, |state| state.closed),
        sticking: &column(outcome, |state| state.stick),
        facts,
    }
    .write(out)
}

/// The contact point at each node of the slave body.
fn points_of_nodes(mesh: &Mesh, pairs: &[PairState], first: usize) -> Vec<Option<usize>> {
    let mut points = vec![None; mesh.node_count()];
    for (offset, state) in pairs.iter().enumerate() {
        points[state.pair.slave_node] = Some(first + offset);
    }
    points
}
