//! What supports carry.

use serde::Serialize;
use tresca_fem::loads::resultant;

use tresca_model::{Model, Support};

/// Resultant of the forces that a support puts on its bodies.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SupportReaction {
    /// Name of the support in the case, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// What it holds, as `body.faces`.
    pub on: Vec<String>,
    /// Force.
    pub force: [f64; 3],
    /// Moment about the origin of the coordinates.
    pub moment: [f64; 3],
}

/// The reactions, support by support. What two supports hold together counts for the first of them.
pub(super) fn support_reactions(model: &Model, reactions: &[Vec<f64>]) -> Vec<SupportReaction> {
    let mut left = reactions.to_vec();
    let support = |support: &Support| {
        let mut sum = SupportReaction {
            name: support.name.clone(),
            on: support.on.iter().map(|on| model.surface_name(on)).collect(),
            force: [0.0; 3],
            moment: [0.0; 3],
        };
        for place in &support.on {
            let mesh = &model.bodies()[place.body].mesh;
            let mut own = vec![0.0; mesh.dof_count()];
            for node in model.nodes(place) {
                for component in 0..mesh.dimension() {
                    if support.components[component].is_some() {
                        let dof = mesh.dimension() * node + component;
                        own[dof] = std::mem::take(&mut left[place.body][dof]);
                    }
                }
            }
            let part = resultant(mesh, &own, [0.0; 3]);
            for k in 0..3 {
                sum.force[k] += part.force[k];
                sum.moment[k] += part.moment[k];
            }
        }
        sum
    };
    model.supports().iter().map(support).collect()
}
