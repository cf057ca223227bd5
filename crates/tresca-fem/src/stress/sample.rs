//! Stresses at the points of cells, and quantities made of them.

use crate::assembly::formulation::{Formulation, mean_dilatation, mean_gradients};
use crate::assembly::internal::internal_forces;
use crate::assembly::strain::{elastic, strain, with_dilatation};
use crate::element::mapping::physical_gradients;
use crate::element::table::{ShapeTable, interpolate};
use crate::initial_strain::InitialStrain;
use crate::material::Isotropic;
use crate::mesh::data::Mesh;
use crate::mesh::geometry::gather_points;

/// The stress at a point of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StressSample {
    /// The cell that the point lies in.
    pub cell: usize,
    /// The point.
    pub position: [f64; 3],
    /// The stress of the discrete displacement there.
    pub stress: [f64; 6],
}

/// The stress at every cell's stress points (see [`crate::element::Element::stress_points`]), cell
/// after cell: the most accurate values that the discrete displacement has to offer. `initial` is the initial
/// strain, if there is one.
///
/// # Panics
/// When the length of `u` is not [`Mesh::dof_count`].
pub fn samples(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    u: &[f64],
    initial: Option<&InitialStrain>,
) -> Vec<StressSample> {
    assert_eq!(u.len(), mesh.dof_count());
    let mut samples = Vec::with_capacity(mesh.cell_count());
    let mut cell = 0;
    for block in &mesh.cells {
        let table = ShapeTable::new(block.kind, &block.kind.element().stress_points());
        let full = ShapeTable::stiffness(block.kind);
        let [mut points, mut gradients, mut mean] = [0; 3].map(|_| vec![[0.0; 3]; table.nodes]);
        for nodes in block.cells() {
            gather_points(mesh, nodes, &mut points);
            let mean_of_cell = match formulation {
                Formulation::Full => None,
                Formulation::BBar => {
                    let found =
                        mean_gradients(mesh.space, &full, &points, &mut gradients, &mut mean);
                    found.map(|()| {
                        let of_u: f64 = strain(mesh.space, nodes, &mean, u)[..3].iter().sum();
                        initial.map_or(of_u, |initial| {
                            let at = |q| initial.at(cell, nodes, full.values(q));
                            of_u - mean_dilatation(mesh.space, &full, &points, at)
                        })
                    })
                }
            };
            for q in 0..table.len() {
                // A collapsed cell has no strain; assembly has refused it before anyone asks.
                let stress =
                    match physical_gradients(mesh.space, &table, q, &points, &mut gradients) {
                        Some(_) => {
                            let mut e = strain(mesh.space, nodes, &gradients, u);
                            if let Some(initial) = initial {
                                e = elastic(e, initial.at(cell, nodes, table.values(q)));
                            }
                            material.stress(mean_of_cell.map_or(e, |mean| with_dilatation(e, mean)))
                        }
                        None => [f64::NAN; 6],
                    };
                samples.push(StressSample {
                    cell,
                    position: interpolate(table.values(q), &points),
                    stress,
                });
            }
            cell += 1;
        }
    }
    samples
}

/// The equivalent stress of von Mises, √(3/2 s:s) with s the deviator.
pub fn von_mises(stress: [f64; 6]) -> f64 {
    let size = stress.iter().fold(0.0, |a: f64, s| a.max(s.abs()));
    if size == 0.0 || !size.is_finite() {
        return size;
    }
    // In units of the largest component, whose square always fits; a power of two, so that no digit changes.
    let unit = size.log2().floor().exp2();
    let [xx, yy, zz, xy, yz, xz] = stress.map(|s| s / unit);
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    let shear = xy * xy + yz * yz + xz * xz;
    unit * (0.5 * normal + 3.0 * shear).sqrt()
}

/// Strain energy ½ ∫ σ : ε dΩ, without an initial strain, of a displacement over the full dofs, by each cell's stiffness rule (per
/// thickness in the plane, of the full circumference in an axisymmetric space).
///
/// # Errors
/// As [`crate::assembly::internal_forces`].
pub fn strain_energy(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    u: &[f64],
) -> Result<f64, crate::FemError> {
    let forces = internal_forces(mesh, material, formulation, u, None)?;
    Ok(0.5 * tresca_la::vector::dot(u, &forces))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn von_mises_of_textbook_states() {
        assert_eq!(von_mises([3.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 3.0);
        assert_eq!(von_mises([7.0, 7.0, 7.0, 0.0, 0.0, 0.0]), 0.0);
        assert!((von_mises([0.0, 0.0, 0.0, 2.0, 0.0, 0.0]) - 2.0 * 3f64.sqrt()).abs() < 1e-15);
        // Equal principal stresses, one state turned by 45° about z: (4, 0) ↔ (2, 2; shear 2).
        let turned = von_mises([2.0, 2.0, 1.0, 2.0, 0.0, 0.0]);
        assert!((turned - von_mises([4.0, 0.0, 1.0, 0.0, 0.0, 0.0])).abs() < 1e-14);
    }
}
