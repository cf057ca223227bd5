//! What acts in a load step: forces, prescribed displacements, slip bounds.

use tresca_contact::Sliding;
use tresca_fem::assembly;
use tresca_la::vector::{axpy, dot};
use tresca_system::load_case::LoadCase;

use crate::assemble::{Assembled, supports};
use crate::error::SolveError;
use tresca_model::{Amount, ContactId, LoadId, Model, Partner, Step, SupportId};

/// Everything that may change from step to step.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Acting {
    /// Load on each body over its full dofs (held ones too: they go straight into the reactions).
    pub loads: Vec<Vec<f64>>,
    /// Prescribed displacement of each body over its full dofs, zero at free ones.
    pub prescribed: Vec<Vec<f64>>,
    /// The same as linear algebra.
    pub case: LoadCase,
}

/// What acts in a step; `relative` is B u of the step before.
///
/// # Errors
/// When a load is not finite somewhere, or two supports disagree about a displacement.
pub fn acting(
    model: &Model,
    assembled: &Assembled,
    step: &Step,
    relative: &[f64],
) -> Result<Acting, SolveError> {
    let bodies = model.bodies();
    let mut all_loads = Vec::with_capacity(bodies.len());
    let mut all_prescribed = Vec::with_capacity(bodies.len());
    let mut free_loads = Vec::with_capacity(bodies.len());
    for (index, (body, system)) in bodies.iter().zip(&assembled.bodies).enumerate() {
        let load = body_load(model, index, step)?;
        let values =
            |number: usize| model.supports()[number].components_by(step.amount(SupportId(number)));
        let prescribed = supports(model, index, values)?.values();
        let reduced = assembly::reduced_load(
            &body.mesh,
            &body.material,
            body.formulation,
            &system.dofs,
            &load,
            &prescribed,
        );
        free_loads.push(reduced.map_err(|source| SolveError::Body {
            body: body.name.clone(),
            source,
        })?);
        all_loads.push(load);
        all_prescribed.push(prescribed);
    }
    let slidings: Vec<Sliding> = assembled
        .contacts
        .iter()
        .enumerate()
        .flat_map(|(contact, data)| {
            let amount = step.amount(ContactId(contact));
            let pairs = data.pairs.iter();
            pairs.map(move |pair| sliding(pair.sliding, pair.area, amount))
        })
        .collect();
    let mut base = assembled.relative(&all_prescribed);
    axpy(1.0, &obstacle_motion(model, assembled, step), &mut base);
    let sizes = all_prescribed.iter().flatten();
    let held = sizes.fold(0.0, |a: f64, u| a.max(u.abs()));
    Ok(Acting {
        loads: all_loads,
        prescribed: all_prescribed,
        case: LoadCase {
            loads: free_loads,
            base,
            gaps: assembled.pairs().map(|pair| pair.gap).collect(),
            origin: LoadCase::origin_after(&assembled.layout, &slidings, relative),
            slidings,
            held,
        },
    })
}

/// What the motion of obstacles adds to B u: \[−ν·v; −τ·v\] of pairs with an obstacle that moves by v, zero of all
/// others. Length d m.
fn obstacle_motion(model: &Model, assembled: &Assembled, step: &Step) -> Vec<f64> {
    let layout = &assembled.layout;
    let (m, tangents) = (layout.pair_count(), layout.tangents());
    let mut moved = vec![0.0; layout.unknowns()];
    let mut i = 0;
    for (contact, data) in model.contacts().iter().zip(&assembled.contacts) {
        if let Partner::Obstacle(id) = contact.master {
            let v = model.obstacles()[id.0].motion_by(step.amount(id));
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

fn sliding(own: Sliding, area: f64, amount: Amount) -> Sliding {
    match (own, amount) {
        (Sliding::Bounded(bounds), Amount::Factor(factor)) => {
            Sliding::Bounded(bounds.map(|bound| factor * bound))
        }
        // Only isotropic bounds can be replaced (`Model::add_step`); where supports leave the pair one
        // tangent, the other one's bound is never looked at.
        (Sliding::Bounded(_), Amount::Scalar(value)) => Sliding::Bounded([value * area; 2]),
        (other, _) => other,
    }
}

/// The load on a body over its full dofs.
fn body_load(model: &Model, index: usize, step: &Step) -> Result<Vec<f64>, SolveError> {
    let mesh = &model.bodies()[index].mesh;
    let mut sum = vec![0.0; mesh.dof_count()];
    for number in 0..model.loads().len() {
        let id = LoadId(number);
        model.add_forces(id, index, step.amount(id), &mut sum);
        if !sum.iter().all(|x| x.is_finite()) {
            return Err(SolveError::NonFiniteLoad {
                load: number,
                body: model.bodies()[index].name.clone(),
            });
        }
    }
    Ok(sum)
}
