//! A sum over bodies, Σ B_i M_i⁻¹ B_iᵀ: what the engines that go body by body share.

use super::coupling::Coupling;
use rayon::prelude::*;

/// One body: what stands for M_i⁻¹, and B_i.
pub(super) struct Body<S> {
    pub solver: S,
    pub coupling: Coupling,
    displacement: Vec<f64>,
    product: Vec<f64>,
}

/// The bodies of the sum.
pub(super) struct Bodies<S>(Vec<Body<S>>);

impl<S: Send + Sync> Bodies<S> {
    /// From M_i⁻¹ and B_i of every body; `order` tells that of M_i.
    ///
    /// # Panics
    /// When the sizes do not fit, there is no body, or `groups` is no partition of the unknowns.
    pub fn new(
        parts: impl Iterator<Item = (S, Coupling)>,
        order: impl Fn(&S) -> usize,
        groups: &[Vec<usize>],
    ) -> Self {
        let body = |(solver, coupling): (S, Coupling)| {
            assert_eq!(
                order(&solver),
                coupling.dofs(),
                "B must have the dofs of the factor as columns"
            );
            Body {
                displacement: vec![0.0; coupling.dofs()],
                product: vec![0.0; coupling.rows()],
                solver,
                coupling,
            }
        };
        let bodies: Vec<Body<S>> = parts.map(body).collect();
        let mut rows: Vec<usize> = bodies.iter().map(|body| body.coupling.rows()).collect();
        rows.dedup();
        assert_eq!(
            rows.len(),
            1,
            "bodies, at least one, must have the same unknowns as rows of B"
        );
        assert_partition(groups, rows[0]);
        Self(bodies)
    }

    /// The bodies in their order.
    pub fn iter(&self) -> impl Iterator<Item = &Body<S>> {
        self.0.iter()
    }

    /// Body number `index`.
    pub fn get(&self, index: usize) -> &Body<S> {
        &self.0[index]
    }

    /// B_i of every body.
    pub fn couplings(&self) -> Vec<&Coupling> {
        self.iter().map(|body| &body.coupling).collect()
    }

    /// Number of rows that all B_i share.
    pub fn rows(&self) -> usize {
        self.0[0].coupling.rows()
    }

    /// y ← Σ B_i M_i⁻¹ B_iᵀ x: computed side by side, summed in their order, so that the threads do not show.
    pub fn multiply(&mut self, x: &[f64], y: &mut [f64], solve: impl Fn(&S, &mut [f64]) + Sync) {
        self.0.par_iter_mut().for_each(|body| {
            body.coupling.transposed_mul(x, &mut body.displacement);
            solve(&body.solver, &mut body.displacement);
            body.coupling.mul(&body.displacement, &mut body.product);
        });
        y.fill(0.0);
        for body in self.iter() {
            for (y, p) in y.iter_mut().zip(&body.product) {
                *y += p;
            }
        }
    }
}

/// Panics unless every one of `unknowns` unknowns is in exactly one group.
fn assert_partition(groups: &[Vec<usize>], unknowns: usize) {
    let mut seen = vec![false; unknowns];
    for &i in groups.iter().flatten() {
        assert!(
            !std::mem::replace(&mut seen[i], true),
            "unknown {i} is in two groups"
        );
    }
    assert!(seen.iter().all(|&s| s), "an unknown is in no group");
}
