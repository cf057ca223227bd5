//! Which displacement components are prescribed, and to what.

use crate::error::FemError;

/// Prescribed displacements of one body, component by component.
#[derive(Clone, Debug, PartialEq)]
pub struct Supports {
    components: usize,
    prescribed: Vec<Option<f64>>,
}

impl Supports {
    /// No supports yet, for a body of `nodes` nodes with `components` displacement components each
    /// (the mesh's dimension).
    pub fn new(nodes: usize, components: usize) -> Self {
        Self {
            components,
            prescribed: vec![None; nodes * components],
        }
    }

    /// Displacement components per node.
    pub fn components(&self) -> usize {
        self.components
    }

    /// Number of full dofs.
    pub fn len(&self) -> usize {
        self.prescribed.len()
    }

    /// Are there no dofs at all?
    pub fn is_empty(&self) -> bool {
        self.prescribed.is_empty()
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.prescribed.len() / self.components
    }

    /// Prescribes one component of one node. Prescribing the same value again is no conflict.
    ///
    /// # Errors
    /// [`FemError::InvalidSupport`], [`FemError::ConflictingSupport`].
    pub fn prescribe(&mut self, node: usize, component: usize, value: f64) -> Result<(), FemError> {
        let nodes = self.node_count();
        if node >= nodes || component >= self.components || !value.is_finite() {
            let components = self.components;
            return Err(FemError::InvalidSupport {
                node,
                component,
                value,
                nodes,
                components,
            });
        }
        match &mut self.prescribed[self.components * node + component] {
            Some(first) if *first != value => Err(FemError::ConflictingSupport {
                node,
                component,
                first: *first,
                second: value,
            }),
            entry => {
                *entry = Some(value);
                Ok(())
            }
        }
    }

    /// Holds one component of some nodes at zero: a symmetry plane, a roller.
    ///
    /// # Errors
    /// As [`Supports::prescribe`].
    pub fn hold(&mut self, nodes: &[usize], component: usize) -> Result<(), FemError> {
        nodes
            .iter()
            .try_for_each(|&node| self.prescribe(node, component, 0.0))
    }

    /// Holds all components of some nodes at zero.
    ///
    /// # Errors
    /// As [`Supports::prescribe`].
    pub fn clamp(&mut self, nodes: &[usize]) -> Result<(), FemError> {
        (0..self.components).try_for_each(|component| self.hold(nodes, component))
    }

    /// The prescribed value of a full dof, `None` where it is free.
    pub fn at(&self, dof: usize) -> Option<f64> {
        self.prescribed[dof]
    }

    /// The prescribed displacements as a vector over the full dofs, zero at free ones.
    pub fn values(&self) -> Vec<f64> {
        self.prescribed
            .iter()
            .map(|value| value.unwrap_or(0.0))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn supports_add_up_and_conflicts_are_named() {
        let mut supports = Supports::new(3, 3);
        supports.clamp(&[1]).unwrap();
        supports.hold(&[0, 1], 2).unwrap();
        supports.prescribe(2, 0, 0.5).unwrap();
        assert_eq!(
            supports.values(),
            [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0]
        );
        assert_eq!(
            (supports.at(2), supports.at(3), supports.at(0)),
            (Some(0.0), Some(0.0), None)
        );
        assert_eq!(
            supports.prescribe(1, 1, 1.0),
            Err(FemError::ConflictingSupport {
                node: 1,
                component: 1,
                first: 0.0,
                second: 1.0
            })
        );
        for (node, component, value) in [(3, 0, 0.0), (0, 3, 0.0), (0, 0, f64::NAN)] {
            let error = supports.prescribe(node, component, value).unwrap_err();
            assert!(matches!(error, FemError::InvalidSupport { .. }), "{error}");
        }
    }
}
