//! The result files of a model.

use std::collections::BTreeMap;
use std::io::Write;
use std::time::Instant;

use rayon::prelude::*;
use tresca_contact::FrictionLaw;
use tresca_fem::mesh::{CellKind, Mesh};
use tresca_fem::stress;
use tresca_io::atomic::OutputSet;
use tresca_io::pvd::{self, PvdPart};
use tresca_io::results::{BodyFields, ContactFields, NodeContactFields, StepFacts, origin};
use tresca_io::vtu::{CellShape, Cells, Fact};
use tresca_io::{WriteError, summary};

use super::{CONTACT, Destination, SUMMARY, history, node_vectors};
use crate::outcome::{Outcome, StepOutcome};
use crate::pair_state::PairState;
use crate::report::run::RunReport;
use crate::version::VERSION;
use tresca_model::{Body, Model};

impl Destination {
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
    ) -> Result<RunReport, WriteError> {
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
        let records = outcome.steps.iter();
        let records = records.map(|step| (step.number, &step.solution.records[..]));
        files.stage("history.csv", |out| history::write(records, out))?;
        let parts: Vec<_> = parts
            .iter()
            .map(|(name, file, time)| PvdPart {
                name,
                file,
                time: *time,
            })
            .collect();
        files.stage(&format!("{name}.pvd"), |out| pvd::write(out, &parts))?;
        let report = RunReport::of_model(model, outcome)
            .named(name)
            .with_output(begin.elapsed().as_secs_f64());
        files.stage(SUMMARY, |out| summary::write(out, &report))?;
        files.commit()?;
        Ok(report)
    }
}

/// What every result file says about its origin.
fn facts(model: &Model, outcome: &Outcome, step: &StepOutcome) -> Vec<(String, Fact)> {
    let solution = &step.solution;
    StepFacts {
        step: step.number,
        time: step.time,
        status: solution.status.to_string(),
        converged: step.converged(),
        method: solution.method.to_string(),
        settings: format!("{:?}", outcome.settings),
        iterations: solution.figures.iterations,
        n_a: solution.figures.n_a,
        relative_reduced_gradient: solution.figures.relative_reduced_gradient,
    }
    .behind(origin(model.title(), VERSION))
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
    let surface = &step.surfaces[index];
    let count = body.mesh.node_count();
    let motion = step.unresisted.as_ref();
    let motion = motion.map(|motion| node_vectors(body, &motion.displacements[index]));
    BodyFields {
        mesh: &body.mesh,
        displacement: &step.displacements[index],
        stress,
        von_mises: &von_mises,
        reaction: Some(&node_vectors(body, &step.reactions[index])),
        surface: (!surface.nodes.is_empty()).then_some(NodeContactFields {
            force: &surface.expand(&surface.force, count),
            pressure: &surface.expand(&surface.pressure, count),
            traction: &surface.expand(&surface.traction, count),
            gap: &surface.expand(&surface.gap, count),
            status: &surface.expand(&surface.status, count),
        }),
        unresisted_motion: motion.as_deref(),
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
        laws.resize(end, contact.friction.number());
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
        slip_increment: &increment,
        closed: &column(&pairs, |state| state.closed),
        sticking: &column(&pairs, |state| state.stick),
        friction_law: &laws,
        law_names: &FrictionLaw::NAMES,
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
