//! Numbering of the free degrees of freedom.

use crate::supports::Supports;

/// Marks a full dof that is prescribed.
const PRESCRIBED: usize = usize::MAX;

/// The map between full dofs (`components * node + component`) and free dofs: the full ones that no
/// support prescribes, in the same order, counted from zero.
///
/// The map knows *which* dofs are prescribed, not their values, so that it outlives a load step.
#[derive(Clone, Debug, PartialEq)]
pub struct DofMap {
    components: usize,
    free_of_full: Vec<usize>,
    full_of_free: Vec<usize>,
}

impl DofMap {
    /// Numbers the dofs that the supports leave free.
    pub fn new(supports: &Supports) -> Self {
        let components = supports.components();
        let full = components * supports.node_count();
        let full_of_free: Vec<usize> = (0..full)
            .filter(|&dof| supports.at(dof).is_none())
            .collect();
        let mut free_of_full = vec![PRESCRIBED; full];
        for (free, &full) in full_of_free.iter().enumerate() {
            free_of_full[full] = free;
        }
        Self {
            components,
            free_of_full,
            full_of_free,
        }
    }

    /// Every dof is free: a body without supports.
    pub fn unsupported(nodes: usize, components: usize) -> Self {
        Self::new(&Supports::new(nodes, components))
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

    /// The free dof of a component of a node, `None` where it is prescribed.
    pub fn free(&self, node: usize, component: usize) -> Option<usize> {
        self.free_of_full(self.full(node, component))
    }

    /// The free dof of a full one, `None` where it is prescribed.
    pub fn free_of_full(&self, full: usize) -> Option<usize> {
        Some(self.free_of_full[full]).filter(|&free| free != PRESCRIBED)
    }

    /// The full dof of a free one.
    pub fn full_of_free(&self, free: usize) -> usize {
        self.full_of_free[free]
    }

    /// Full dofs that are prescribed, ascending.
    pub fn prescribed(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.full_len()).filter(|&dof| self.free_of_full[dof] == PRESCRIBED)
    }

    /// The free part of a full vector.
    ///
    /// # Panics
    /// When the length is not [`DofMap::full_len`].
    pub fn restrict(&self, full: &[f64]) -> Vec<f64> {
        assert_eq!(full.len(), self.full_len());
        self.full_of_free.iter().map(|&dof| full[dof]).collect()
    }

    /// The full vector with the given free part, zero at prescribed dofs.
    ///
    /// # Panics
    /// When the length is not [`DofMap::free_len`].
    pub fn expand(&self, free: &[f64]) -> Vec<f64> {
        let mut full = vec![0.0; self.full_len()];
        self.write_free(free, &mut full);
        full
    }

    /// Overwrites the free part of a full vector and leaves the prescribed part as it is, e.g. at
    /// [`Supports::values`].
    ///
    /// # Panics
    /// When the lengths are not [`DofMap::free_len`] and [`DofMap::full_len`].
    pub fn write_free(&self, free: &[f64], full: &mut [f64]) {
        assert_eq!(free.len(), self.free_len());
        assert_eq!(full.len(), self.full_len());
        for (&value, &dof) in free.iter().zip(&self.full_of_free) {
            full[dof] = value;
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
