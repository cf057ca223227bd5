//! Internal forces of a displacement: the action of the whole K, without the matrix.

use super::formulation::{Formulation, mean_dilatation, mean_gradients};
use super::stiffness::Elastic;
use super::strain::{elastic, nodal_force, strain, with_dilatation};
use crate::dofs::DofMap;
use crate::element::mapping::physical_gradients;
use crate::element::table::ShapeTable;
use crate::error::FemError;
use crate::initial_strain::InitialStrain;
use crate::material::Isotropic;
use crate::mesh::data::{CellBlock, Mesh};
use crate::mesh::geometry::gather_points;
use crate::mesh::space::Space;
use rayon::prelude::*;

/// ∫ Bᵀσ dΩ over *all* dofs, prescribed ones included, for a displacement `u` over the full dofs: K u without
/// an initial strain, K u less [`initial_strain_load`] with one.
///
/// At a prescribed dof, `(K u − f)` is the force that the support exerts on the body. uᵀ(K u)/2 is
/// the strain energy (without an initial strain).
///
/// # Errors
/// As [`super::stiffness`].
///
/// # Panics
/// When the length of `u` is not [`Mesh::dof_count`].
pub fn internal_forces(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    u: &[f64],
    initial: Option<&InitialStrain>,
) -> Result<Vec<f64>, FemError> {
    material.check_space(mesh.space)?;
    formulation.check(mesh, material)?;
    assert_eq!(u.len(), mesh.dof_count());
    let d = mesh.dimension();
    let mut forces = vec![0.0; u.len()];
    let mut first = 0;
    for block in &mesh.cells {
        // Cells in parallel, then added up in their order.
        let of_cells = forces_of_block(mesh, block, first, (material, formulation), u, initial)?;
        let width = block.kind.node_count();
        for (nodes, of_cell) in block.cells().zip(of_cells.chunks_exact(width)) {
            for (&node, force) in nodes.iter().zip(of_cell) {
                for i in 0..d {
                    forces[d * node + i] += force[i];
                }
            }
        }
        first += block.len();
    }
    Ok(forces)
}

/// Nodal forces of every cell of a block; the third component is zero in the plane.
fn forces_of_block(
    mesh: &Mesh,
    block: &CellBlock,
    first: usize,
    (material, formulation): Elastic<'_>,
    u: &[f64],
    initial: Option<&InitialStrain>,
) -> Result<Vec<[f64; 3]>, FemError> {
    let space = mesh.space;
    let table = ShapeTable::stiffness(block.kind);
    let n = table.nodes;
    let mut forces = vec![[0.0; 3]; block.connectivity.len()];
    let inverted = forces
        .par_chunks_exact_mut(n)
        .zip(block.connectivity.par_chunks_exact(n))
        .enumerate()
        .map_init(
            || [0; 3].map(|_| vec![[0.0; 3]; n]),
            |[points, gradients, mean], (local, (forces, nodes))| {
                gather_points(mesh, nodes, points);
                let b_bar = formulation == Formulation::BBar;
                let cell = first + local;
                let mut dilatation = 0.0;
                if b_bar {
                    mean_gradients(space, &table, points, gradients, mean).ok_or(cell)?;
                    dilatation = strain(space, nodes, mean, u)[..3].iter().sum();
                    if let Some(initial) = initial {
                        let of_point = |q| initial.at(cell, nodes, table.values(q));
                        dilatation -= mean_dilatation(space, &table, points, of_point);
                    }
                }
                for q in 0..table.len() {
                    let measure =
                        physical_gradients(space, &table, q, points, gradients).ok_or(cell)?;
                    let mut e = strain(space, nodes, gradients, u);
                    if let Some(initial) = initial {
                        e = elastic(e, initial.at(cell, nodes, table.values(q)));
                    }
                    if b_bar {
                        e = with_dilatation(e, dilatation);
                    }
                    let mut stress = material.stress(e).map(|s| s * measure * table.weights[q]);
                    if b_bar {
                        // The mean stress works on the mean dilatation of the virtual displacement.
                        let third = (stress[0] + stress[1] + stress[2]) / 3.0;
                        let mean_stress = [third, third, third, 0.0, 0.0, 0.0];
                        stress[..3].iter_mut().for_each(|s| *s -= third);
                        add_forces(space, mean_stress, mean, forces);
                    }
                    add_forces(space, stress, gradients, forces);
                }
                Ok(())
            },
        )
        .filter_map(Result::err)
        .min();
    match inverted {
        Some(cell) => Err(mesh.cell_fault(cell)),
        None => Ok(forces),
    }
}

/// Adds the nodal forces of a stress.
#[inline]
fn add_forces(space: Space, stress: [f64; 6], gradients: &[[f64; 3]], forces: &mut [[f64; 3]]) {
    for (force, &g) in forces.iter_mut().zip(gradients) {
        let part = nodal_force(space, stress, g);
        for i in 0..3 {
            force[i] += part[i];
        }
    }
}

/// ∫ Bᵀ D ε⁰ dΩ over the full dofs: the load that an initial strain is for the displacement, K u = f + this.
///
/// # Errors
/// As [`internal_forces`].
pub fn initial_strain_load(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    initial: &InitialStrain,
) -> Result<Vec<f64>, FemError> {
    let at_rest = vec![0.0; mesh.dof_count()];
    let mut load = internal_forces(mesh, material, formulation, &at_rest, Some(initial))?;
    load.iter_mut().for_each(|f| *f = -*f);
    Ok(load)
}

/// Right-hand side over the free dofs, Cᵀ(f − K u⁰), without equations f_f − K_fc u_c: the free part of the
/// load minus the forces that the prescribed displacements cause.
///
/// `load` and `prescribed` are full vectors; of `prescribed` (see
/// [`crate::supports::Supports::values`]) only the entries at prescribed dofs are read. When u⁰ is
/// zero this is the restriction of the load.
///
/// # Errors
/// As [`internal_forces`].
///
/// # Panics
/// When a length does not fit.
pub fn reduced_load(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    dofs: &DofMap,
    load: &[f64],
    prescribed: &[f64],
) -> Result<Vec<f64>, FemError> {
    let mut free = dofs.restrict(load);
    let mut u = dofs.offset(prescribed);
    if u.iter().any(|&x| x != 0.0) {
        u.truncate(mesh.dof_count());
        let mut forces = internal_forces(mesh, material, formulation, &u, None)?;
        forces.resize(dofs.full_len(), 0.0);
        for (f, force) in free.iter_mut().zip(dofs.restrict(&forces)) {
            *f -= force;
        }
    }
    Ok(free)
}
