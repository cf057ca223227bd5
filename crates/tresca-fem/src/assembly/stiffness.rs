//! The stiffness matrix.

use super::columns::{ColumnRange, ColumnValues};
use super::constrained::constrained;
use super::formulation::Formulation;
use super::kernel::Kernel;
use crate::dofs::DofMap;
use crate::error::FemError;
use crate::material::Isotropic;
use crate::mesh::data::{CellBlock, Mesh};
use crate::mesh::kind::CellKind;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use rayon::prelude::*;
use std::ops::Range;
use tresca_la::SymmetricMatrix;

/// Ranges per thread: enough to even out the load, few enough to integrate few cells twice.
const RANGES_PER_THREAD: usize = 4;

/// The stiffness matrix of a body over its free dofs, CᵀKC where there are equations: force per length, MN/m
/// for m and MPa; in the plane also per thickness; in an axisymmetric space that of the full circumference.
///
/// Symmetric, positive semidefinite; definite when the supports leave no rigid motion (see
/// [`crate::rigid::remaining`]). Runs on rayon's current thread pool.
///
/// # Errors
/// [`FemError::PlaneStress`]; those of [`Formulation::check`]; [`FemError::InvertedCell`], [`FemError::FoldedCell`] or
/// [`FemError::DegenerateCell`] for the lowest cell whose Jacobian is not positive at an integration
/// point.
///
/// # Panics
/// When the dof map belongs to another number of nodes.
pub fn stiffness(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    dofs: &DofMap,
) -> Result<SymmetricMatrix, FemError> {
    material.check_space(mesh.space)?;
    formulation.check(mesh, material)?;
    let full = mesh.dof_count();
    if dofs.has_equations() && dofs.full_len() >= full {
        let kept = dofs.without_equations(full);
        let stiffness = of_free_dofs(mesh, (material, formulation), &kept)?;
        return Ok(constrained(&stiffness, &kept, dofs));
    }
    assert_eq!(dofs.full_len(), full, "the dof map belongs to another mesh");
    of_free_dofs(mesh, (material, formulation), dofs)
}

/// K over the dofs that are free when there are no equations.
fn of_free_dofs(
    mesh: &Mesh,
    (material, formulation): Elastic<'_>,
    dofs: &DofMap,
) -> Result<SymmetricMatrix, FemError> {
    let incidence = mesh.incidence();
    let ranges: Vec<ColumnRange> =
        node_ranges(mesh.node_count(), |node| incidence.cells_at(node).len())
            .into_par_iter()
            .map(|nodes| ColumnRange::new(mesh, dofs, &incidence, nodes))
            .collect();

    let n = dofs.free_len();
    let mut starts = Vec::with_capacity(n + 1);
    starts.push(0);
    for length in ranges.iter().flat_map(|range| range.column_lengths(dofs)) {
        starts.push(starts[starts.len() - 1] + length);
    }
    let entries = starts[n];
    let (mut rows, mut values) = (vec![0_usize; entries], vec![0.0_f64; entries]);

    let mut jobs = Vec::with_capacity(ranges.len());
    let (mut rows_left, mut values_left, mut first_entry) = (&mut rows[..], &mut values[..], 0);
    for range in &ranges {
        let (rows, rest) = rows_left.split_at_mut(range.entries());
        let (values, rest_values) = values_left.split_at_mut(range.entries());
        (rows_left, values_left) = (rest, rest_values);
        jobs.push((
            rows,
            ColumnValues {
                range,
                dofs,
                starts: &starts,
                first_entry,
                values,
            },
        ));
        first_entry += range.entries();
    }
    let inverted = jobs
        .into_par_iter()
        .filter_map(|(rows, columns)| {
            columns.range.write_rows(dofs, rows);
            fill(mesh, (material, formulation), columns).err()
        })
        .min();
    if let Some(cell) = inverted {
        return Err(mesh.cell_fault(cell));
    }
    let pattern = SymbolicSparseColMat::new_checked(n, n, starts, None, rows);
    Ok(SymmetricMatrix::from_lower(SparseColMat::new(
        pattern, values,
    )))
}

/// What a cell's stiffness depends on beside the cell.
pub(super) type Elastic<'a> = (&'a Isotropic, Formulation);

/// Cuts the nodes into ranges of about equal work.
fn node_ranges(nodes: usize, work: impl Fn(usize) -> usize) -> Vec<Range<usize>> {
    let count = RANGES_PER_THREAD * rayon::current_num_threads();
    let total: usize = (0..nodes).map(&work).sum();
    let mut ranges = Vec::with_capacity(count);
    let (mut start, mut done) = (0, 0);
    for node in 0..nodes {
        done += work(node);
        if done * count >= total * (ranges.len() + 1) || node + 1 == nodes {
            ranges.push(start..node + 1);
            start = node + 1;
        }
    }
    ranges.retain(|range| !range.is_empty());
    ranges
}

/// Integrates the cells of a range and adds them to its columns; the error is a cell that cannot be
/// integrated.
fn fill(mesh: &Mesh, elastic: Elastic<'_>, mut columns: ColumnValues<'_>) -> Result<(), usize> {
    let mut first = 0;
    for block in &mesh.cells {
        match block.kind {
            CellKind::Tri3 => fill_block::<3, 2>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Tri6 => fill_block::<6, 2>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Quad4 => fill_block::<4, 2>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Quad8 => fill_block::<8, 2>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Quad9 => fill_block::<9, 2>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Tet4 => fill_block::<4, 3>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Tet10 => fill_block::<10, 3>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Wedge6 => fill_block::<6, 3>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Hex8 => fill_block::<8, 3>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Hex20 => fill_block::<20, 3>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Hex27 => fill_block::<27, 3>(mesh, block, first, elastic, &mut columns)?,
            CellKind::Line2 | CellKind::Line3 => {
                unreachable!("lines fill no body of a valid mesh")
            }
        }
        first += block.len();
    }
    Ok(())
}

/// The same for one block, whose cells are numbered from `first`.
// Each instance stands alone: inlined into one function they cost each other 5 % of the instructions.
#[inline(never)]
fn fill_block<const N: usize, const D: usize>(
    mesh: &Mesh,
    block: &CellBlock,
    first: usize,
    elastic: Elastic<'_>,
    columns: &mut ColumnValues<'_>,
) -> Result<(), usize> {
    let mut kernel = Kernel::<N, D>::new(mesh.space, block.kind, elastic);
    for &cell in columns.range.cells_within(first..first + block.len()) {
        let nodes: &[usize; N] = block.connectivity[(cell - first) * N..]
            .first_chunk()
            .expect("the connectivity of a valid mesh is whole");
        let points = nodes.map(|node| mesh.points[node]);
        kernel.integrate(&points).ok_or(cell)?;
        for (b, &node) in nodes.iter().enumerate() {
            if columns.range.contains(node) {
                columns.add(node, nodes, |a| kernel.block(a, b));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_cover_all_nodes_once() {
        for nodes in [1, 2, 7, 8, 1000] {
            let ranges = node_ranges(nodes, |node| 1 + node % 8);
            assert_eq!(ranges[0].start, 0);
            assert_eq!(ranges[ranges.len() - 1].end, nodes);
            assert!(ranges.windows(2).all(|w| w[0].end == w[1].start));
            assert!(ranges.iter().all(|range| !range.is_empty()));
        }
    }
}
