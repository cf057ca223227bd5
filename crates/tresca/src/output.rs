//! The result files of a run.

use std::collections::BTreeMap;
use std::io::Write;
use std::iter;
use std::path::{Path, PathBuf};
use std::time::Instant;

use rayon::prelude::*;
use tresca_case::LAWS;
use tresca_fem::mesh::{CellKind, Mesh};
use tresca_fem::stress;
use tresca_io::atomic::OutputSet;
use tresca_io::history::{History, Value};
use tresca_io::pvd::{self, Part};
use tresca_io::results::{BodyFields, ContactFields};
use tresca_io::vtu::{CellShape, Cells, Fact, Field, Grid, Values};
use tresca_io::{WriteError, summary};
use tresca_qcqp::record::Entry;

use crate::check::Check;
use crate::model::{Body, Model};
use crate::outcome::{Outcome, StepOutcome};
use crate::pair_state::PairState;
use crate::{IterationRecord, Summary, VERSION};

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

    pub(crate) fn into_directory(self) -> PathBuf {
        self.directory
    }

    /// Writes all files of a run: `<body>.vtu` and `contact.vtu` (of a case with several load steps
    /// `<body>_0001.vtu` and so on for each), `<name>.pvd` that opens them together as a time series,
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
        let mut parts = Vec::new();
        for step in &outcome.steps {
            let suffix = match outcome.planned_steps {
                1 => String::new(),
                _ => format!("_{:04}", step.number),
            };
            let facts = facts(model, outcome, step);
            let mut stage =
                |part: &str, write: &dyn Fn(&mut dyn Write) -> Result<(), WriteError>| {
                    let file = format!("{part}{suffix}.vtu");
                    files.stage(&file, |out| write(out))?;
                    parts.push((part.to_owned(), file, step.time));
                    Ok::<(), WriteError>(())
                };
            let stresses: Vec<Vec<[f64; 6]>> = model
                .bodies()
                .par_iter()
                .zip(&step.displacements)
                .map(|(body, u)| {
                    stress::recover(&body.mesh, &body.material, body.formulation, u, None)
                })
                .collect();
            for (index, (body, stress)) in model.bodies().iter().zip(&stresses).enumerate() {
                stage(&body.name, &|out| {
                    write_body(body, index, step, stress, facts.clone(), out)
                })?;
            }
            stage(CONTACT, &|out| {
                write_contact(model, step, facts.clone(), out)
            })?;
        }
        files.stage("history.csv", |out| history(outcome)?.write(out))?;
        let parts: Vec<_> = parts
            .iter()
            .map(|(name, file, time)| Part {
                name,
                file,
                time: *time,
            })
            .collect();
        files.stage(&format!("{name}.pvd"), |out| pvd::write(out, &parts))?;
        let result = Summary::new(model, outcome, begin.elapsed().as_secs_f64());
        files.stage("summary.json", |out| summary::write(out, &result))?;
        files.commit()?;
        Ok(result)
    }
}

/// Writes a single file, whole or not at all, replacing an earlier one.
///
/// # Errors
/// Those of `write` and of the file system.
pub fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>,
) -> Result<(), WriteError> {
    let directory = path
        .parent()
        .filter(|parent| !parent.as_os_str().is_empty());
    let mut files = OutputSet::new(directory.unwrap_or(Path::new(".")))?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    files.stage(&name, write)?;
    files.commit()?;
    Ok(())
}

/// What every result file says about its origin.
fn facts(model: &Model, outcome: &Outcome, step: &StepOutcome) -> Vec<(String, Fact)> {
    let solution = &step.solution;
    let text = |name: &str, value: String| (name.to_owned(), Fact::Text(value));
    let number = |name: &str, value: f64| (name.to_owned(), Fact::Numbers(vec![value]));
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
        count("converged", usize::from(step.converged())),
        count("step", step.number),
        number("time", step.time),
        count("iterations", solution.figures.iterations),
        count("n_a", solution.figures.n_a),
        number(
            "relative_reduced_gradient",
            solution.figures.relative_reduced_gradient,
        ),
    ]
}

fn history(outcome: &Outcome) -> Result<History, WriteError> {
    history_table(
        outcome
            .steps
            .iter()
            .map(|step| (step.number, &step.solution.records[..])),
    )
}

/// The table of `history.csv`: the records of load steps, with their numbers.
pub(crate) fn history_table<'a>(
    steps: impl IntoIterator<Item = (usize, &'a [IterationRecord])>,
) -> Result<History, WriteError> {
    let columns = &IterationRecord::COLUMNS;
    let keys = columns.iter().map(|column| column.key);
    let mut table = History::new(&iter::once("step").chain(keys).collect::<Vec<_>>());
    for (number, records) in steps {
        for record in records {
            let entries = columns.iter().map(|column| match (column.entry)(record) {
                Entry::Count(count) => count.into(),
                Entry::Real(value) => value.into(),
            });
            let row: Vec<Value> = iter::once(number.into()).chain(entries).collect();
            table.push(&row)?;
        }
    }
    Ok(table)
}

fn write_body(
    body: &Body,
    index: usize,
    step: &StepOutcome,
    stress: &[[f64; 6]],
    facts: Vec<(String, Fact)>,
    out: &mut dyn Write,
) -> Result<(), WriteError> {
    let von_mises: Vec<f64> = stress.iter().map(|&s| stress::von_mises(s)).collect();
    let reaction = node_vectors(body, &step.reactions[index]);
    let surface = &step.surfaces[index];
    let count = body.mesh.node_count();
    let force = surface.expand(&surface.force, count);
    let pressure = surface.expand(&surface.pressure, count);
    let traction = surface.expand(&surface.traction, count);
    let gap = surface.expand(&surface.gap, count);
    let status = surface.expand(&surface.status, count);
    let mut extra = vec![Field::new("reaction", Values::Vectors(&reaction))];
    if !surface.nodes.is_empty() {
        extra.extend([
            Field::new("contact_force", Values::Vectors(&force)),
            Field::new("contact_pressure", Values::Scalars(&pressure)),
            Field::new("contact_traction", Values::Vectors(&traction)),
            Field::new("contact_gap", Values::Scalars(&gap)),
            Field::new("contact_status", Values::States(&status)),
        ]);
    }
    let motion = step.unresisted.as_ref();
    let motion = motion.map(|motion| node_vectors(body, &motion.displacements[index]));
    extra.extend(
        motion
            .iter()
            .map(|motion| Field::new("unresisted_motion", Values::Vectors(motion))),
    );
    BodyFields {
        mesh: &body.mesh,
        displacement: &step.displacements[index],
        stress,
        von_mises: &von_mises,
        extra,
        facts,
    }
    .write(out)
}

fn write_contact(
    model: &Model,
    step: &StepOutcome,
    facts: Vec<(String, Fact)>,
    out: &mut dyn Write,
) -> Result<(), WriteError> {
    let mut index = Vec::new();
    let mut laws = Vec::new();
    // The faces between the pairs, by kind.
    let mut cells: BTreeMap<CellKind, Vec<usize>> = BTreeMap::new();
    let mut first = 0;
    for (number, (contact, pairs)) in model.contacts().iter().zip(&step.contacts).enumerate() {
        let end = index.len() + pairs.len();
        index.resize(end, i32::try_from(number).unwrap_or(i32::MAX));
        let law = LAWS.iter().position(|law| *law == contact.friction.name());
        laws.resize(
            end,
            law.and_then(|law| u8::try_from(law).ok())
                .unwrap_or(u8::MAX),
        );
        let mesh = &model.bodies()[contact.slave.body].mesh;
        let point_of_node = points_of_nodes(mesh, pairs, first);
        for &face in model.faces(&contact.slave) {
            let nodes = mesh.face_nodes(face).into_iter();
            let points: Option<Vec<usize>> = nodes.map(|node| point_of_node[node]).collect();
            // A face with a pair that was left out (both nodes held, or no partner) is not shown.
            if let Some(points) = points {
                cells
                    .entry(mesh.face_kind(face))
                    .or_default()
                    .extend(points);
            }
        }
        first += pairs.len();
    }
    let pairs: Vec<&PairState> = step.pairs().collect();
    fn column<T>(pairs: &[&PairState], value: impl Fn(&PairState) -> T) -> Vec<T> {
        pairs.iter().map(|pair| value(pair)).collect()
    }
    let increment = column(&pairs, |state| {
        let [a, b] = state.local_slip_increment;
        state.pair.frame.to_global([0.0, a, b])
    });
    let largest_bound = |state: &PairState| state.slip_bounds.map_or(0.0, |[a, b]| a.max(b));
    ContactFields {
        points: &column(&pairs, |state| state.pair.point),
        faces: cells
            .iter()
            .map(|(&kind, points)| Cells {
                shape: CellShape::from(kind),
                connectivity: points,
            })
            .collect(),
        pair: &index,
        normal: &column(&pairs, |state| state.pair.frame.normal),
        normal_force: &column(&pairs, |state| state.normal_force),
        contact_pressure: &column(&pairs, PairState::pressure),
        tangential_force: &column(&pairs, |state| state.friction_force),
        tangential_traction: &column(&pairs, PairState::friction_traction),
        slip_bound: &column(&pairs, largest_bound),
        gap: &column(&pairs, |state| state.gap),
        slip: &column(&pairs, |state| state.slip),
        closed: &column(&pairs, |state| state.closed),
        sticking: &column(&pairs, |state| state.stick),
        friction_law: Some(&laws),
        law_names: &LAWS,
        extra: vec![Field::new("slip_increment", Values::Vectors(&increment))],
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

impl Destination {
    /// Writes what [`check`](crate::check()) put together: `<body>.vtu` with what holds and what pulls,
    /// `contact.vtu` with the contact points and their gaps, `<name>.pvd`, `check.json`. All or none.
    ///
    /// # Errors
    /// When a file cannot be written, or a field holds a number that is not finite.
    pub fn write_check(self, name: &str, model: &Model, check: &Check) -> Result<(), WriteError> {
        let mut files = OutputSet::new(self.directory)?;
        let mut parts = Vec::new();
        for (index, body) in model.bodies().iter().enumerate() {
            let file = format!("{}.vtu", body.name);
            files.stage(&file, |out| write_checked_body(body, check, index, out))?;
            parts.push((body.name.clone(), file));
        }
        let points: Vec<_> = check
            .contact_data
            .iter()
            .flat_map(|data| &data.pairs)
            .collect();
        if !points.is_empty() {
            let file = format!("{CONTACT}.vtu");
            files.stage(&file, |out| write_checked_contact(check, out))?;
            parts.push((CONTACT.to_owned(), file));
        }
        let parts: Vec<_> = parts
            .iter()
            .map(|(name, file)| Part {
                name,
                file,
                time: 0.0,
            })
            .collect();
        files.stage(&format!("{name}.pvd"), |out| pvd::write(out, &parts))?;
        files.stage("check.json", |out| summary::write(out, check))?;
        files.commit()?;
        Ok(())
    }
}

fn write_checked_body(
    body: &Body,
    check: &Check,
    index: usize,
    out: &mut dyn Write,
) -> Result<(), WriteError> {
    let load = node_vectors(body, &check.nodal_loads[index]);
    let mut grid = Grid::of_mesh(&body.mesh);
    grid.point_fields = vec![
        Field::new("held_components", Values::States(&check.held[index])),
        Field::new("load", Values::Vectors(&load)),
    ];
    grid.facts = vec![
        ("title".to_owned(), Fact::Text(check.title.clone())),
        (
            "version".to_owned(),
            Fact::Text(format!("tresca {VERSION}")),
        ),
    ];
    grid.write(out)
}

fn write_checked_contact(check: &Check, out: &mut dyn Write) -> Result<(), WriteError> {
    let pairs = || check.contact_data.iter().flat_map(|data| &data.pairs);
    let points: Vec<[f64; 3]> = pairs().map(|pair| pair.point).collect();
    let vertices: Vec<usize> = (0..points.len()).collect();
    let number = |(number, data): (usize, &tresca_contact::ContactData)| {
        std::iter::repeat_n(i32::try_from(number).unwrap_or(i32::MAX), data.pairs.len())
    };
    let index: Vec<i32> = check
        .contact_data
        .iter()
        .enumerate()
        .flat_map(number)
        .collect();
    let normals: Vec<[f64; 3]> = pairs().map(|pair| pair.frame.normal).collect();
    let gaps: Vec<f64> = pairs().map(|pair| pair.gap).collect();
    let areas: Vec<f64> = pairs().map(|pair| pair.area).collect();
    let mut grid = Grid::new(&points);
    grid.cells.push(Cells {
        shape: CellShape::Vertex,
        connectivity: &vertices,
    });
    grid.point_fields = vec![
        Field::new("pair", Values::Integers(&index)),
        Field::new("normal", Values::Vectors(&normals)),
        Field::new("gap", Values::Scalars(&gaps)),
        Field::new("area", Values::Scalars(&areas)),
    ];
    grid.write(out)
}

/// A field over the full dofs as vectors at the nodes; VTK's vectors have three components in the plane, too.
fn node_vectors(body: &Body, values: &[f64]) -> Vec<[f64; 3]> {
    let of_node = |u: &[f64]| [u[0], u[1], u.get(2).copied().unwrap_or(0.0)];
    let nodes = values.chunks_exact(body.mesh.dimension());
    nodes.map(of_node).collect()
}
