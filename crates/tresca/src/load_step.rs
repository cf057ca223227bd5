//! What acts in a load step: forces, prescribed displacements, slip bounds.

use tresca_contact::{ScalarField, Sliding};
use tresca_fem::{assembly, loads};
use tresca_la::vector::{axpy, dot};

use crate::ModelError;
use crate::assemble::{Assembled, supports};
use crate::model::{Amount, Load, LoadKind, Model, Partner, Step, VectorField};

/// Everything that may change from step to step.
#[derive(Debug, Clone)]
pub struct Acting {
    /// Load on each body over its full dofs (held ones too: they go straight into the reactions).
    pub loads: Vec<Vec<f64>>,
    /// Prescribed displacement of each body over its full dofs, zero at free ones.
    pub prescribed: Vec<Vec<f64>>,
    /// f − K u for these displacements, over the free dofs: the right-hand side.
    pub free_loads: Vec<Vec<f64>>,
    /// The law of every pair, slip bounds as they are in this step.
    pub slidings: Vec<Sliding>,
    /// What the motion of obstacles adds to B u: \[−ν·v; −τ·v\] of pairs with an obstacle that moves by v, zero
    /// of all others. Length d m.
    pub obstacle_motion: Vec<f64>,
}

impl Acting {
    /// Approach and slip of every pair: B u less what the obstacles move.
    pub fn relative(&self, assembled: &Assembled, displacements: &[Vec<f64>]) -> Vec<f64> {
        let mut relative = assembled.relative(displacements);
        axpy(1.0, &self.obstacle_motion, &mut relative);
        relative
    }
}

/// What acts in a step.
///
/// # Errors
/// When a load is not finite somewhere, or two supports disagree about a displacement.
pub fn acting(model: &Model, assembled: &Assembled, step: &Step) -> Result<Acting, ModelError> {
    let bodies = model.bodies();
    let mut all_loads = Vec::with_capacity(bodies.len());
    let mut all_prescribed = Vec::with_capacity(bodies.len());
    let mut free_loads = Vec::with_capacity(bodies.len());
    for (index, (body, system)) in bodies.iter().zip(&assembled.bodies).enumerate() {
        let load = body_load(model, index, step)?;
        let values = |number: usize| amount_of_support(model, step, number);
        let prescribed = supports(model, index, values)?.values();
        let reduced = assembly::reduced_load(
            &body.mesh,
            &body.material,
            body.formulation,
            &system.dofs,
            &load,
            &prescribed,
        );
        free_loads.push(reduced.map_err(|source| ModelError::Body {
            body: body.name.clone(),
            source,
        })?);
        all_loads.push(load);
        all_prescribed.push(prescribed);
    }
    let slidings = assembled.contacts.iter().zip(&step.bounds);
    Ok(Acting {
        loads: all_loads,
        prescribed: all_prescribed,
        free_loads,
        slidings: slidings
            .flat_map(|(data, &amount)| {
                data.pairs
                    .iter()
                    .map(move |pair| sliding(pair.sliding, pair.area, amount))
            })
            .collect(),
        obstacle_motion: obstacle_motion(model, assembled, step),
    })
}

/// Displacement of an obstacle in a step.
fn motion_of_obstacle(model: &Model, step: &Step, number: usize) -> [f64; 3] {
    match step.obstacles[number] {
        Amount::Factor(factor) => model.obstacles()[number].motion.map(|x| factor * x),
        Amount::Value(value) => value,
    }
}

fn obstacle_motion(model: &Model, assembled: &Assembled, step: &Step) -> Vec<f64> {
    let layout = &assembled.layout;
    let (m, tangents) = (layout.pair_count(), layout.tangents());
    let mut moved = vec![0.0; layout.unknowns()];
    let mut i = 0;
    for (contact, data) in model.contacts().iter().zip(&assembled.contacts) {
        if let Partner::Obstacle(number) = contact.master {
            let v = motion_of_obstacle(model, step, number);
            for (offset, pair) in data.pairs.iter().enumerate() {
                moved[i + offset] = -dot(&pair.frame.normal, &v);
                for (t, tangent) in pair.frame.tangents.iter().take(tangents).enumerate() {
                    moved[m + tangents * (i + offset) + t] = -dot(tangent, &v);
                }
            }
        }
        i += data.pairs.len();
    }
    moved
}

fn amount_of_support(model: &Model, step: &Step, number: usize) -> [Option<f64>; 3] {
    match step.supports[number] {
        Amount::Factor(factor) => model.supports()[number]
            .components
            .map(|value| value.map(|value| factor * value)),
        Amount::Value(values) => values,
    }
}

fn sliding(own: Sliding, area: f64, amount: Amount<f64>) -> Sliding {
    match (own, amount) {
        (Sliding::Bounded(bounds), Amount::Factor(factor)) => {
            Sliding::Bounded(bounds.map(|bound| factor * bound))
        }
        // Only isotropic bounds can be replaced (`Model::add_step`); where supports leave the pair one
        // tangent, the other one's bound is never looked at.
        (Sliding::Bounded(_), Amount::Value(value)) => Sliding::Bounded([value * area; 2]),
        (other, _) => other,
    }
}

/// The load on a body over its full dofs.
fn body_load(model: &Model, index: usize, step: &Step) -> Result<Vec<f64>, ModelError> {
    let mesh = &model.bodies()[index].mesh;
    let mut sum = vec![0.0; mesh.dof_count()];
    for (number, (load, &amount)) in model.loads().iter().zip(&step.loads).enumerate() {
        add_load(model, index, load, amount, &mut sum);
        if !sum.iter().all(|x| x.is_finite()) {
            return Err(ModelError::NonFiniteLoad {
                load: number,
                body: model.bodies()[index].name.clone(),
            });
        }
    }
    Ok(sum)
}

/// Adds an amount of a load to what acts on a body.
pub(crate) fn add_load(
    model: &Model,
    index: usize,
    load: &Load,
    amount: Amount<[f64; 3]>,
    sum: &mut [f64],
) {
    let (factor, value) = match amount {
        Amount::Factor(factor) => (factor, None),
        Amount::Value(value) => (1.0, Some(value)),
    };
    add(model, index, &load.kind, value, factor, sum);
}

/// sum ← sum + factor · load, with `value` in the place of the load's own.
fn add(
    model: &Model,
    index: usize,
    kind: &LoadKind,
    value: Option<[f64; 3]>,
    factor: f64,
    sum: &mut [f64],
) {
    let body = &model.bodies()[index];
    let mesh = &body.mesh;
    match kind {
        LoadKind::Traction { on, value: own } => {
            let own = value.map_or_else(|| own.clone(), VectorField::Constant);
            for surface in on.iter().filter(|surface| surface.body == index) {
                let part = match &own {
                    VectorField::Constant(value) => {
                        loads::traction(mesh, model.faces(surface), *value)
                    }
                    VectorField::Function(function) => {
                        loads::traction_field(mesh, model.faces(surface), |x| function(x))
                    }
                };
                axpy(factor, &part, sum);
            }
        }
        LoadKind::Pressure { on, value: own } => {
            let pressure = |x| match (value, own) {
                (Some(value), _) => value[0],
                (None, ScalarField::Constant(value)) => *value,
                (None, ScalarField::Function(function)) => function(x),
                // `Model::add_load` refuses it.
                (None, ScalarField::Values(_)) => f64::NAN,
            };
            for surface in on.iter().filter(|surface| surface.body == index) {
                let part = loads::pressure_field(mesh, model.faces(surface), pressure);
                axpy(factor, &part, sum);
            }
        }
        LoadKind::BodyForce { bodies, value: own } if bodies.contains(&index) => {
            let force = value.unwrap_or(*own);
            axpy(factor, &loads::body_force(mesh, |_| force), sum);
        }
        LoadKind::Gravity { bodies, value: own } if bodies.contains(&index) => {
            let density = body.density.unwrap_or(0.0);
            let force = value.unwrap_or(*own).map(|g| density * g);
            axpy(factor, &loads::body_force(mesh, |_| force), sum);
        }
        LoadKind::BodyForce { .. } | LoadKind::Gravity { .. } => {}
    }
}
