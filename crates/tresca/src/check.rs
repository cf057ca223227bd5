//! What a model says, put together without solving it: for the eyes of whoever wrote it.

use std::collections::BTreeMap;

use serde::Serialize;
use tresca_contact::{ContactData, Discretization};
use tresca_fem::dofs::DofMap;
use tresca_fem::loads::{nodal_areas, resultant};
use tresca_fem::rigid;

use crate::assemble::{couple_all, dof_maps};
use crate::error::SolveError;
use tresca_model::ModelError;
use tresca_model::{Amount, Body, LoadId, Model};

/// A body as it was understood.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct BodyCheck {
    /// Name.
    pub name: String,
    /// Nodes.
    pub nodes: usize,
    /// Cells by kind.
    pub cells: BTreeMap<String, usize>,
    /// Volume (per unit thickness in the plane, of the full circumference in an axisymmetric space).
    pub volume: f64,
    /// Density times volume, where a density is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Smallest and largest coordinates.
    pub extent: [[f64; 3]; 2],
    /// Face sets: name, number of faces, area.
    pub surfaces: Vec<(String, usize, f64)>,
    /// Node sets that are no face sets: name and number of nodes.
    pub node_sets: Vec<(String, usize)>,
    /// Rigid motions that the supports leave.
    pub motions: Vec<String>,
}

/// A support as it was understood.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct SupportCheck {
    /// Name, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Where, as `body.faces`.
    pub on: Vec<String>,
    /// Prescribed displacement of each held axis.
    pub components: BTreeMap<&'static str, f64>,
    /// Nodes that it holds.
    pub nodes: usize,
}

/// A load as it was understood.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct LoadCheck {
    /// Name, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// `traction`, `pressure`, `body force` or `gravity`.
    pub kind: &'static str,
    /// Where it acts: surfaces or bodies.
    pub on: Vec<String>,
    /// Resultant force.
    pub force: [f64; 3],
    /// Its moment about the origin of the coordinates.
    pub moment: [f64; 3],
}

/// A contact as it was understood.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct ContactCheck {
    /// Slave surface.
    pub slave: String,
    /// Master surface or obstacle.
    pub master: String,
    /// The friction law.
    pub friction: &'static str,
    /// How the surfaces are coupled.
    pub coupling: &'static str,
    /// Contact pairs.
    pub pairs: usize,
    /// Nodes left out because supports hold the pair.
    pub held: usize,
    /// Slave nodes that nothing faces.
    pub uncoupled: usize,
    /// Area of the slave surface that is covered.
    pub area: f64,
    /// Smallest and largest gap; negative where the surfaces overlap.
    pub gap: Option<[f64; 2]>,
}

/// Everything that was understood.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Check {
    /// Title of the case.
    pub title: String,
    /// Version of tresca.
    pub version: &'static str,
    /// Bodies.
    pub bodies: Vec<BodyCheck>,
    /// Supports.
    pub supports: Vec<SupportCheck>,
    /// Loads, in the amounts of the model itself.
    pub loads: Vec<LoadCheck>,
    /// Contacts.
    pub contacts: Vec<ContactCheck>,
    /// Load steps; 0 when the case has none of its own.
    pub steps: usize,
    /// What is likely to be a mistake.
    pub warnings: Vec<String>,
    /// What the written grids show.
    #[serde(skip)]
    pub(crate) contact_data: Vec<ContactData>,
    #[serde(skip)]
    pub(crate) nodal_loads: Vec<Vec<f64>>,
    #[serde(skip)]
    pub(crate) held: Vec<Vec<u8>>,
}

/// Puts together what a model says.
///
/// # Errors
/// When supports contradict each other, or the surfaces of a contact do not fit.
pub fn check(model: &Model) -> Result<Check, SolveError> {
    if model.bodies().is_empty() {
        return Err(ModelError::NoBodies.into());
    }
    let dofs = dof_maps(model)?;
    for body in model.bodies() {
        body.mesh.check_cells().map_err(|source| SolveError::Body {
            body: body.name.clone(),
            source,
        })?;
    }
    let contact_data = couple_all(model, &dofs)?;
    let bodies: Vec<BodyCheck> = model.bodies().iter().zip(&dofs).map(body_check).collect();
    let (loads, nodal_loads) = load_checks(model);
    let contacts: Vec<ContactCheck> = contact_checks(model, &contact_data);
    let warnings = warnings(model, &bodies, &contacts, &loads);
    Ok(Check {
        title: model.title().to_owned(),
        version: crate::version::VERSION,
        bodies,
        supports: support_checks(model),
        loads,
        contacts,
        steps: model.steps().len(),
        warnings,
        held: model.bodies().iter().zip(&dofs).map(held_mask).collect(),
        contact_data,
        nodal_loads,
    })
}

fn body_check((body, dofs): (&Body, &DofMap)) -> BodyCheck {
    let mesh = &body.mesh;
    let mut cells = BTreeMap::new();
    for block in &mesh.cells {
        *cells.entry(block.kind.to_string()).or_insert(0) += block.len();
    }
    let bounds = mesh.bounding_box();
    let volume = mesh.volume();
    let area = |faces| nodal_areas(mesh, faces).iter().sum();
    let sets = mesh.face_sets.iter();
    let points = mesh.node_sets.iter();
    BodyCheck {
        name: body.name.clone(),
        nodes: mesh.node_count(),
        cells,
        volume,
        mass: body.density.map(|density| density * volume),
        extent: [bounds.min, bounds.max],
        surfaces: sets
            .map(|(name, faces)| (name.clone(), faces.len(), area(faces)))
            .collect(),
        node_sets: points
            .filter(|(name, _)| !mesh.face_sets.contains_key(*name))
            .map(|(name, nodes)| (name.clone(), nodes.len()))
            .collect(),
        motions: rigid::remaining(mesh, dofs)
            .iter()
            .map(ToString::to_string)
            .collect(),
    }
}

/// For each node the held components: 1 for x, 2 for y, 4 for z.
fn held_mask((body, dofs): (&Body, &DofMap)) -> Vec<u8> {
    let bit = |node, component: usize| u8::from(!dofs.moves(node, component)) << component;
    let components = body.mesh.dimension();
    (0..body.mesh.node_count())
        .map(|node| (0..components).map(|component| bit(node, component)).sum())
        .collect()
}

fn support_checks(model: &Model) -> Vec<SupportCheck> {
    let supports = model.supports().iter();
    supports
        .map(|support| SupportCheck {
            name: support.name.clone(),
            on: support.on.iter().map(|on| model.surface_name(on)).collect(),
            components: ["x", "y", "z"]
                .into_iter()
                .zip(support.components)
                .filter_map(|(axis, value)| Some((axis, value?)))
                .collect(),
            nodes: support.on.iter().map(|on| model.nodes(on).len()).sum(),
        })
        .collect()
}

/// The loads one by one, and their sum at the nodes of every body.
fn load_checks(model: &Model) -> (Vec<LoadCheck>, Vec<Vec<f64>>) {
    let zero = || model.bodies().iter().map(|b| vec![0.0; b.mesh.dof_count()]);
    let mut sums: Vec<Vec<f64>> = zero().collect();
    let mut checks = Vec::new();
    for (number, load) in model.loads().iter().enumerate() {
        let mut check = LoadCheck {
            name: load.name.clone(),
            kind: load.kind.traits().word,
            on: load.on.names(model.bodies()),
            force: [0.0; 3],
            moment: [0.0; 3],
        };
        for (index, (body, mut own)) in model.bodies().iter().zip(zero()).enumerate() {
            model.add_forces(LoadId(number), index, Amount::WHOLE, &mut own);
            let part = resultant(&body.mesh, &own, [0.0; 3]);
            for k in 0..3 {
                check.force[k] += part.force[k];
                check.moment[k] += part.moment[k];
            }
            sums[index].iter_mut().zip(&own).for_each(|(s, x)| *s += x);
        }
        checks.push(check);
    }
    (checks, sums)
}

fn contact_checks(model: &Model, contacts: &[ContactData]) -> Vec<ContactCheck> {
    let contacts = model.contacts().iter().zip(contacts);
    contacts
        .map(|(contact, data)| ContactCheck {
            slave: model.surface_name(&contact.slave),
            master: model.partner_name(&contact.master),
            friction: contact.friction.name(),
            coupling: match data.discretization {
                Discretization::NodeByNode => "node by node",
                Discretization::Mortar => "mortar",
                Discretization::Obstacle => "obstacle",
            },
            pairs: data.pairs.len(),
            held: data.held_pairs,
            uncoupled: data.uncoupled.len(),
            area: data.overlap_area,
            gap: data.gap_range(),
        })
        .collect()
}

fn warnings(
    model: &Model,
    bodies: &[BodyCheck],
    contacts: &[ContactCheck],
    loads: &[LoadCheck],
) -> Vec<String> {
    let mut warnings = Vec::new();
    for (own, body) in bodies.iter().zip(model.bodies()) {
        let name = &own.name;
        if let Some(kind) = body.formulation.locking(&body.mesh, &body.material) {
            warnings.push(format!(
                "body `{name}` is nearly incompressible, and {kind} locks: take the formulation `b_bar` or \
                 quadratic cells"
            ));
        }
        let touched = model.contacts().iter().any(|contact| {
            let master = contact.master.surface();
            model.bodies()[contact.slave.body].name == *name
                || master.is_some_and(|master| model.bodies()[master.body].name == *name)
        });
        if !own.motions.is_empty() && !touched {
            warnings.push(format!(
                "body `{name}` is not held ({}), and no contact touches it",
                own.motions.join(", ")
            ));
        }
    }
    for contact in contacts {
        let pair = format!("contact {} – {}", contact.slave, contact.master);
        if contact.pairs == 0 {
            warnings.push(format!("{pair}: there is no pair; the surfaces do not face each other, or supports hold them"));
        }
        if contact.uncoupled > 0 {
            warnings.push(format!(
                "{pair}: nothing faces {} nodes of the slave surface",
                contact.uncoupled
            ));
        }
    }
    if contacts.is_empty() {
        warnings.push("there is no contact: nothing to solve".to_owned());
    }
    for load in loads {
        if !load.force.iter().chain(&load.moment).all(|x| x.is_finite()) {
            warnings.push(format!(
                "the {} on {} is not finite",
                load.kind,
                load.on.join(", ")
            ));
        }
    }
    warnings
}
