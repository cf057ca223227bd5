//! What of a body the dual problem needs: K, its grounding, B. The same for bodies that were meshed here
//! and for matrices that were brought along.

use std::borrow::Cow;
use std::sync::Arc;

use crate::tame::unit_of;
use tresca_fem::rigid::Grounding;
use tresca_la::vector::{axpy, dot, norm};
use tresca_la::{
    BodySolver, FactorError, Ordering, OrderingError, Parallelism, SparseCholesky, SymmetricMatrix,
};
use tresca_qcqp::operator::Coupling;

/// A body over its free dofs.
#[derive(Debug, Clone)]
pub struct SystemBody {
    /// K, singular when the body floats.
    pub stiffness: SymmetricMatrix,
    /// C, R and S of a body that floats.
    pub grounding: Option<Grounding>,
    /// B over all unknowns of λ, weighted for the solver's unknowns (see [`Layout`](crate::layout::Layout)).
    pub coupling: Coupling,
    /// The dofs that come last in the factorisation, ascending: those that B or C touches.
    trailing: Vec<usize>,
}

/// Why a body has no factor.
#[derive(Debug)]
pub enum FactorFailure {
    /// It could not be ordered.
    Ordering(OrderingError),
    /// It could not be factored.
    Factor(FactorError),
}

impl SystemBody {
    /// A body; `grounding` if it floats.
    pub fn new(
        stiffness: SymmetricMatrix,
        grounding: Option<Grounding>,
        coupling: Coupling,
    ) -> Self {
        let mut trailing = coupling.touched();
        if let Some(grounding) = &grounding {
            trailing.extend_from_slice(&grounding.dofs);
            trailing.sort_unstable();
            trailing.dedup();
        }
        Self {
            stiffness,
            grounding,
            coupling,
            trailing,
        }
    }

    /// Measures the stiffness of bodies in a unit of its own where its figures could not be squared, and returns that
    /// unit, a power of two; 1 for everything that is met in practice.
    pub fn tame(bodies: &mut [Self]) -> f64 {
        let size = bodies.iter().flat_map(|body| body.stiffness.diagonal());
        let unit = unit_of(size.fold(0.0, f64::max));
        if unit != 1.0 {
            for body in bodies {
                body.stiffness.scale(1.0 / unit);
                if let Some(grounding) = &mut body.grounding {
                    grounding.scale(1.0 / unit);
                }
            }
        }
        unit
    }

    /// Number of free dofs.
    pub fn dofs(&self) -> usize {
        self.stiffness.order()
    }

    /// The dofs that come last in the factorisation, ascending: those that contact or the grounding touches.
    pub fn trailing(&self) -> &[usize] {
        &self.trailing
    }

    /// The rigid motions that contact has to hold.
    pub fn motions(&self) -> &[Vec<f64>] {
        self.grounding
            .as_ref()
            .map_or(&[], |grounding| &grounding.r)
    }

    /// K, or K + CCᵀ of a body that floats.
    pub fn regular_stiffness(&self) -> Cow<'_, SymmetricMatrix> {
        match &self.grounding {
            None => Cow::Borrowed(&self.stiffness),
            Some(grounding) => Cow::Owned(grounding.add_to(&self.stiffness)),
        }
    }

    /// Orders and factors; `contact_last` puts the dofs that contact touches last.
    ///
    /// # Errors
    /// When the matrix is not positive definite.
    pub fn factor(
        &self,
        contact_last: bool,
        parallelism: Parallelism,
    ) -> Result<Arc<dyn BodySolver>, FactorFailure> {
        let stiffness = self.regular_stiffness();
        let ordering = if contact_last {
            Ordering::nested_dissection_with_trailing(&stiffness, &self.trailing)
        } else {
            Ordering::nested_dissection(&stiffness)
        };
        let ordering = ordering.map_err(FactorFailure::Ordering)?;
        let factor = SparseCholesky::factor(&stiffness, ordering, parallelism);
        Ok(Arc::new(factor.map_err(FactorFailure::Factor)?))
    }
}

/// Zero displacements.
pub(crate) fn at_rest(bodies: &[SystemBody]) -> Vec<Vec<f64>> {
    bodies.iter().map(|body| vec![0.0; body.dofs()]).collect()
}

/// What is left of a sum beside the size of its terms that is rounding, and beside the size of all forces.
const ROUNDING: f64 = 1e-13;
const OF_ALL: f64 = 1e-15;

/// e = Rᵀf of all floating bodies. Loads on a body that are in equilibrium among themselves leave nothing, not
/// their rounding, which no contact force may be there to balance.
pub(crate) fn load_on_motions(bodies: &[SystemBody], loads: &[Vec<f64>]) -> Vec<f64> {
    bodies
        .iter()
        .zip(loads)
        .flat_map(|(body, f)| body.motions().iter().map(move |r| resultant(r, f)))
        .collect()
}

fn resultant(r: &[f64], f: &[f64]) -> f64 {
    let sum = dot(r, f);
    let size: f64 = r.iter().zip(f).map(|(r, f)| (r * f).abs()).sum();
    // A load along one axis has rounding along the others.
    if sum.abs() <= (ROUNDING * size).max(OF_ALL * norm(r) * norm(f)) {
        0.0
    } else {
        sum
    }
}

/// Adds R α to displacements; `alpha` holds the motions of all bodies in order.
pub(crate) fn add_motions(bodies: &[SystemBody], alpha: &[f64], displacements: &mut [Vec<f64>]) {
    let mut alpha = alpha.iter();
    for (body, u) in bodies.iter().zip(displacements) {
        for r in body.motions() {
            if let Some(&amount) = alpha.next() {
                axpy(amount, r, u);
            }
        }
    }
}
