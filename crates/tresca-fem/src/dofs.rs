//! Numbering of the free degrees of freedom, and what the others make of them.

use crate::constraints::elimination::{Elimination, ResolvedRow};
use crate::constraints::equation::Equation;
use crate::error::FemError;
use crate::supports::Supports;
use std::sync::Arc;

/// Marks a full dof that is prescribed.
const PRESCRIBED: usize = usize::MAX;

/// Marks a full dof that an equation determines; free dofs are below.
const DEPENDENT: usize = usize::MAX - 1;

/// The map between full dofs (`components * node + component`) and free dofs: the full ones that no
/// support prescribes and no equation determines, in the same order, counted from zero.
///
/// With u⁰ the prescribed displacements (see [`DofMap::offset`]) and C of one row per full dof, u = C û + u⁰
/// (see [`crate::constraints`]). Without equations C is a selection.
///
/// The map knows *which* dofs are prescribed, not their values, so that it outlives a load step.
#[derive(Clone, Debug, PartialEq)]
pub struct DofMap {
    components: usize,
    free_of_full: Vec<usize>,
    full_of_free: Vec<usize>,
    equations: Option<Arc<Elimination>>,
}

impl DofMap {
    /// Numbers the dofs that the supports leave free.
    pub fn new(supports: &Supports) -> Self {
        Self::numbered(supports.components(), supports.len(), |dof| {
            supports.at(dof).map(|_| PRESCRIBED)
        })
    }

    /// Numbers the dofs that supports and equations leave free. Equations are counted from zero, in the
    /// order of the list; their order makes no difference beyond rounding.
    ///
    /// # Errors
    /// [`FemError::InvalidEquation`], [`FemError::DependentHeld`], [`FemError::DependentTwice`],
    /// [`FemError::EquationCircle`], [`FemError::RedundantEquation`], [`FemError::ContradictoryEquation`].
    pub fn constrained(supports: &Supports, equations: &[Equation]) -> Result<Self, FemError> {
        if equations.is_empty() {
            return Ok(Self::new(supports));
        }
        let elimination = Elimination::new(supports, equations)?;
        let numbered = Self::numbered(supports.components(), supports.len(), |dof| {
            let dependent = elimination.row(dof).map(|_| DEPENDENT);
            dependent.or(supports.at(dof).map(|_| PRESCRIBED))
        });
        Ok(Self {
            equations: Some(Arc::new(elimination)),
            ..numbered
        })
    }

    /// Every dof is free: a body without supports.
    pub fn unsupported(nodes: usize, components: usize) -> Self {
        Self::new(&Supports::new(nodes, components))
    }

    /// Numbers the dofs without a mark.
    fn numbered(components: usize, full: usize, mark: impl Fn(usize) -> Option<usize>) -> Self {
        let mut full_of_free = Vec::new();
        let free_of_full = (0..full)
            .map(|dof| {
                mark(dof).unwrap_or_else(|| {
                    full_of_free.push(dof);
                    full_of_free.len() - 1
                })
            })
            .collect();
        Self {
            components,
            free_of_full,
            full_of_free,
            equations: None,
        }
    }

    /// The map of the first `full` dofs without equations: what these determine is free.
    pub(crate) fn without_equations(&self, full: usize) -> Self {
        Self::numbered(self.components, full, |dof| {
            Some(PRESCRIBED).filter(|_| self.free_of_full[dof] == PRESCRIBED)
        })
    }

    /// Displacement components per node.
    pub fn components(&self) -> usize {
        self.components
    }

    /// Number of full dofs.
    pub fn full_len(&self) -> usize {
        self.free_of_full.len()
    }

    /// Number of free dofs: the order of the stiffness matrix.
    pub fn free_len(&self) -> usize {
        self.full_of_free.len()
    }

    /// The full dof of a component of a node.
    pub fn full(&self, node: usize, component: usize) -> usize {
        self.components * node + component
    }

    /// The free dof of a component of a node, `None` where it is prescribed or dependent.
    pub fn free(&self, node: usize, component: usize) -> Option<usize> {
        self.free_of_full(self.full(node, component))
    }

    /// The free dof of a full one, `None` where it is prescribed or dependent.
    pub fn free_of_full(&self, full: usize) -> Option<usize> {
        Some(self.free_of_full[full]).filter(|&free| free < DEPENDENT)
    }

    /// The full dof of a free one.
    pub fn full_of_free(&self, free: usize) -> usize {
        self.full_of_free[free]
    }

    /// Full dofs that are prescribed, ascending.
    pub fn prescribed(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.full_len()).filter(|&dof| self.free_of_full[dof] == PRESCRIBED)
    }

    /// Are there equations?
    pub fn has_equations(&self) -> bool {
        self.equations.is_some()
    }

    /// Full dofs that equations determine, in the order of the equations.
    pub fn dependent(&self) -> impl Iterator<Item = usize> + '_ {
        self.rows().iter().map(|row| row.dependent)
    }

    /// Can a component of a node move: is its row of C not zero?
    pub fn moves(&self, node: usize, component: usize) -> bool {
        self.row(self.full(node, component)).next().is_some()
    }

    /// The row of C of a full dof: free dofs, ascending, with their coefficients.
    pub fn row(&self, full: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let resolved = match &self.equations {
            Some(equations) => equations.row(full).map_or(&[][..], |row| &row.terms),
            None => &[],
        };
        let of_equation = resolved.iter();
        let of_equation = of_equation.filter_map(|&(dof, c)| Some((self.free_of_full(dof)?, c)));
        let own = self.free_of_full(full).map(|free| (free, 1.0));
        own.into_iter().chain(of_equation)
    }

    /// A sparse row over the full dofs (of B, say) times C, by ascending free dof, when that row is ascending.
    pub fn restrict_row(&self, row: impl Iterator<Item = (usize, f64)>) -> Vec<(usize, f64)> {
        let products = row.flat_map(|(full, a)| self.row(full).map(move |(free, c)| (free, c * a)));
        let mut products: Vec<(usize, f64)> = products.collect();
        if self.has_equations() {
            products.sort_by_key(|&(free, _)| free);
            products.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 += next.1;
                }
                same
            });
        }
        products
    }

    /// Cᵀ f: forces (all that does work on displacements) over the full dofs as they act on the free ones.
    ///
    /// # Panics
    /// When the length is not [`DofMap::full_len`].
    pub fn restrict(&self, full: &[f64]) -> Vec<f64> {
        let mut free = self.free_part(full);
        for row in self.rows() {
            let force = full[row.dependent];
            for &(dof, c) in &row.terms {
                if let Some(independent) = self.free_of_full(dof) {
                    free[independent] += c * force;
                }
            }
        }
        free
    }

    /// û: the entries of a full vector at the free dofs, of a displacement say.
    ///
    /// # Panics
    /// When the length is not [`DofMap::full_len`].
    pub fn free_part(&self, full: &[f64]) -> Vec<f64> {
        assert_eq!(full.len(), self.full_len());
        self.full_of_free.iter().map(|&dof| full[dof]).collect()
    }

    /// C û: the full displacement with the given free part, zero at prescribed dofs, when the right sides
    /// of equations are zero.
    ///
    /// # Panics
    /// When the length is not [`DofMap::free_len`].
    pub fn expand(&self, free: &[f64]) -> Vec<f64> {
        let mut full = vec![0.0; self.full_len()];
        self.write_free_part(free, &mut full);
        self.write_dependent(&mut full, 0.0);
        full
    }

    /// u = C û + u⁰ over a vector with the prescribed displacements, e.g. [`Supports::values`]: writes all
    /// but these.
    ///
    /// # Panics
    /// When the lengths are not [`DofMap::free_len`] and [`DofMap::full_len`].
    pub fn write_free(&self, free: &[f64], full: &mut [f64]) {
        self.write_free_part(free, full);
        self.write_dependent(full, 1.0);
    }

    /// u⁰: the full displacement of prescribed entries (others are not read) and free ones that are zero.
    ///
    /// # Panics
    /// When the length is not [`DofMap::full_len`].
    pub fn offset(&self, prescribed: &[f64]) -> Vec<f64> {
        let mut full = vec![0.0; self.full_len()];
        for dof in self.prescribed() {
            full[dof] = prescribed[dof];
        }
        self.write_dependent(&mut full, 1.0);
        full
    }

    /// The reactions of the supports out of K u − f, forces over the full dofs that equilibrium leaves to
    /// supports and equations: at prescribed dofs what equations do not bring there, zero elsewhere.
    ///
    /// # Panics
    /// When the length is not [`DofMap::full_len`].
    pub fn support_forces(&self, constraint_forces: &[f64]) -> Vec<f64> {
        assert_eq!(constraint_forces.len(), self.full_len());
        let mut reactions = vec![0.0; self.full_len()];
        for dof in self.prescribed() {
            reactions[dof] = constraint_forces[dof];
        }
        for row in self.rows() {
            for &(dof, c) in &row.terms {
                if self.free_of_full[dof] == PRESCRIBED {
                    reactions[dof] += c * constraint_forces[row.dependent];
                }
            }
        }
        reactions
    }

    /// The multipliers μ of the equations out of K u − f: equation Σ a_k u_k = b puts the force μ a_k on the
    /// body at dof k. In the order of the equations; empty without any.
    ///
    /// # Panics
    /// When the length is not [`DofMap::full_len`].
    pub fn multipliers(&self, constraint_forces: &[f64]) -> Vec<f64> {
        assert_eq!(constraint_forces.len(), self.full_len());
        let equations = self.equations.as_deref();
        equations.map_or_else(Vec::new, |equations| {
            equations.multipliers(constraint_forces)
        })
    }

    /// The resolved equations.
    pub(crate) fn rows(&self) -> &[ResolvedRow] {
        self.equations.as_deref().map_or(&[], Elimination::rows)
    }

    fn write_free_part(&self, free: &[f64], full: &mut [f64]) {
        assert_eq!(free.len(), self.free_len());
        assert_eq!(full.len(), self.full_len());
        for (&value, &dof) in free.iter().zip(&self.full_of_free) {
            full[dof] = value;
        }
    }

    /// Writes what the equations, their constants times `factor`, make of the other dofs.
    fn write_dependent(&self, full: &mut [f64], factor: f64) {
        for row in self.rows() {
            let sum: f64 = row.terms.iter().map(|&(dof, c)| c * full[dof]).sum();
            full[row.dependent] = factor * row.constant + sum;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_and_full_are_inverse_to_each_other() {
        let mut supports = Supports::new(4, 3);
        supports.clamp(&[2]).unwrap();
        supports.prescribe(0, 1, 0.25).unwrap();
        let dofs = DofMap::new(&supports);
        assert_eq!((dofs.full_len(), dofs.free_len()), (12, 8));
        assert_eq!(dofs.prescribed().collect::<Vec<_>>(), [1, 6, 7, 8]);
        assert_eq!(
            (dofs.free(0, 1), dofs.free(0, 2), dofs.free(3, 0)),
            (None, Some(1), Some(5))
        );
        for free in 0..8 {
            assert_eq!(dofs.free_of_full(dofs.full_of_free(free)), Some(free));
        }
        let values: Vec<f64> = (0..8).map(f64::from).collect();
        assert_eq!(dofs.restrict(&dofs.expand(&values)), values);
        let mut full = supports.values();
        dofs.write_free(&values, &mut full);
        assert_eq!(full[..3], [0.0, 0.25, 1.0]);
    }
}
