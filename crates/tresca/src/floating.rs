//! Bodies that supports do not hold completely: their rigid motions, and how their matrices are made regular.
//!
//! K of such a body is singular, its null space spanned by the rigid motions R. It is grounded, K + CCᵀ
//! with as many columns of C as motions: the inverse of that is a generalised inverse of K, and no
//! spring is left in the answer, because equilibrium, Gλ = e with G = RᵀBᵀ and e = Rᵀf, makes
//! the forces in C vanish (docs/theory.md, "Floating bodies").

use tresca_fem::dofs::DofMap;
use tresca_fem::rigid::{self, FreeMotion, Grounding};
use tresca_model::Body;
use tresca_qcqp::operator::Coupling;

use crate::error::SolveError;

/// What the supports leave free of a body, if anything: a basis of its rigid motions, and how they are kept
/// out of its factor.
///
/// # Errors
/// [`SolveError::Floating`] when no contact touches the part that is free.
pub(crate) fn floating(
    body: &Body,
    dofs: &DofMap,
    contact: &Coupling,
) -> Result<Option<(Vec<FreeMotion>, Grounding)>, SolveError> {
    let motions = rigid::remaining(&body.mesh, dofs);
    if motions.is_empty() {
        return Ok(None);
    }
    let mut nodes: Vec<usize> = contact
        .touched()
        .into_iter()
        .map(|dof| dof / body.mesh.dimension())
        .collect();
    nodes.dedup();
    let untouched = motions.iter().filter(|motion| {
        let u = motion.displacement(&body.mesh);
        let mut relative = vec![0.0; contact.rows()];
        contact.add_product(&u, &mut relative);
        relative.iter().all(|&x| x == 0.0)
            && !nodes
                .iter()
                .any(|&node| motion.nodes().binary_search(&node).is_ok())
    });
    let untouched: Vec<String> = untouched.map(ToString::to_string).collect();
    if !untouched.is_empty() {
        return Err(SolveError::Floating {
            body: body.name.clone(),
            motions: untouched,
        });
    }
    let grounding = Grounding::new(&body.mesh, &body.material, dofs, &motions, &nodes);
    Ok(Some((motions, grounding)))
}
