//! Initial strains: what a body would do if nothing hindered it.
//!
//! With an initial strain ε⁰ (thermal expansion α ΔT I, swelling, a misfit) the stress is
//!
//! <div>
//! $$
//! \sigma = D\,(\varepsilon - \varepsilon^0).
//! $$
//! </div>
//!
//! It enters in three places, all of which take the same [`InitialStrain`]: internal forces ∫ Bᵀσ dΩ
//! ([`crate::assembly::internal_forces`]), the load ∫ Bᵀ D ε⁰ dΩ that it is for the displacement
//! ([`crate::assembly::initial_strain_load`]), and stresses ([`crate::stress::recover`]). K does not know it.
//!
//! Its zz component counts under plane strain, where the thickness cannot change (σ_zz = ν(σ_xx + σ_yy) − E ε⁰_zz for
//! a thermal strain), and is the hoop component in an axisymmetric space; under plane stress it is not looked
//! at. With B-bar strains its volume change is the mean over the cell, like that of the displacement: otherwise a
//! temperature that varies in a cell would press on itself.

use crate::error::FemError;
use crate::mesh::data::Mesh;

/// An initial strain ε⁰, in the order xx, yy, zz, γxy, γyz, γxz.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialStrain(Values);

#[derive(Clone, Debug, PartialEq)]
enum Values {
    /// By cell.
    Cells(Vec<[f64; 6]>),
    /// By node, interpolated.
    Nodes(Vec<[f64; 6]>),
    /// α and ΔT by node, interpolated.
    Thermal(f64, Vec<f64>),
}

impl InitialStrain {
    /// Thermal expansion: coefficient α (per degree) and change of temperature ΔT at every node,
    /// interpolated as displacements are.
    ///
    /// Of cells of order p, a temperature of degree p − 1 is free of spurious stress within a cell; stresses
    /// are as accurate as otherwise at their points in any case.
    ///
    /// # Errors
    /// [`FemError::InitialStrain`] for another number of values than nodes, or values that are not finite.
    pub fn thermal(mesh: &Mesh, expansion: f64, change: Vec<f64>) -> Result<Self, FemError> {
        let finite = change.iter().filter(|t| (expansion * *t).is_finite());
        check("node", mesh.node_count(), change.len(), finite.count())?;
        Ok(Self(Values::Thermal(expansion, change)))
    }

    /// One strain per node, interpolated as displacements are.
    ///
    /// # Errors
    /// As [`InitialStrain::thermal`].
    pub fn at_nodes(mesh: &Mesh, strains: Vec<[f64; 6]>) -> Result<Self, FemError> {
        check("node", mesh.node_count(), strains.len(), finite(&strains))?;
        Ok(Self(Values::Nodes(strains)))
    }

    /// One strain per cell.
    ///
    /// # Errors
    /// [`FemError::InitialStrain`] for another number of values than cells, or values that are not finite.
    pub fn in_cells(mesh: &Mesh, strains: Vec<[f64; 6]>) -> Result<Self, FemError> {
        check("cell", mesh.cell_count(), strains.len(), finite(&strains))?;
        Ok(Self(Values::Cells(strains)))
    }

    /// ε⁰ at the point of a cell with the given values of the shape functions.
    pub(crate) fn at(&self, cell: usize, nodes: &[usize], shape: &[f64]) -> [f64; 6] {
        match &self.0 {
            Values::Cells(strains) => strains[cell],
            Values::Nodes(strains) => {
                let mut strain = [0.0; 6];
                for (&node, value) in nodes.iter().zip(shape) {
                    for k in 0..6 {
                        strain[k] += value * strains[node][k];
                    }
                }
                strain
            }
            Values::Thermal(expansion, change) => {
                let temperature: f64 = nodes
                    .iter()
                    .zip(shape)
                    .map(|(&node, value)| value * change[node])
                    .sum();
                let strain = expansion * temperature;
                [strain, strain, strain, 0.0, 0.0, 0.0]
            }
        }
    }
}

fn finite(strains: &[[f64; 6]]) -> usize {
    let finite = strains.iter().filter(|e| e.iter().all(|x| x.is_finite()));
    finite.count()
}

fn check(per: &'static str, expected: usize, given: usize, finite: usize) -> Result<(), FemError> {
    if given == expected && finite == expected {
        return Ok(());
    }
    Err(FemError::InitialStrain {
        per,
        expected,
        given,
        finite,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::brick::{BrickSpec, brick};

    #[test]
    fn values_that_do_not_fit_are_refused() {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [1.0; 3],
            nodes: [2, 2, 3],
        };
        let mesh = brick(&spec).unwrap();
        assert!(InitialStrain::thermal(&mesh, 1e-5, vec![1.0; 12]).is_ok());
        let error = InitialStrain::thermal(&mesh, 1e-5, vec![1.0; 2]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "an initial strain needs 12 values, one per node, all finite; found 2, of which 2 are finite"
        );
        assert!(InitialStrain::thermal(&mesh, f64::NAN, vec![1.0; 12]).is_err());
        assert!(InitialStrain::in_cells(&mesh, vec![[0.0; 6]; 2]).is_ok());
        let error = InitialStrain::in_cells(&mesh, vec![[0.0; 6], [f64::INFINITY; 6]]).unwrap_err();
        assert!(
            error
                .to_string()
                .ends_with("found 2, of which 1 are finite")
        );
        assert!(InitialStrain::at_nodes(&mesh, vec![[0.0; 6]; 11]).is_err());
    }
}
