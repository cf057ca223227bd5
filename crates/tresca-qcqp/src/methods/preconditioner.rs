//! The preconditioner of the reduced Newton systems.
//!
//! ```text
//! M = Zᵀ(D + WWᵀ)Z + C
//! ```
//!
//! with the operator's local model D, block diagonal, and the recycled products
//! W: D serves what no product has shown yet. M⁻¹ by the Woodbury formula.

use super::recycle::RecycledProducts;
use crate::operator::{LocalBlock, LocalModel};
use crate::reduced::{Column, ReducedSpace, galerkin};
use faer::linalg::matmul::matmul;
use faer::linalg::solvers::{Llt, Solve};
use faer::{Accum, Col, ColMut, ColRef, Mat, Par, Side};
use rayon::prelude::*;
use tresca_la::LinearOperator;

/// M⁻¹.
pub(super) struct Preconditioner {
    local: LocalInverse,
    low_rank: Option<LowRank>,
}

impl Preconditioner {
    /// M for the space of Z and C.
    pub fn new(space: &ReducedSpace, model: &LocalModel, recycled: &RecycledProducts) -> Self {
        let local = LocalInverse::new(space, model);
        let low_rank = LowRank::new(space, &local, recycled);
        Self { local, low_rank }
    }
}

impl LinearOperator for Preconditioner {
    fn dim(&self) -> usize {
        self.local.dim
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        z.copy_from_slice(r);
        self.local.solve_in_place(z);
        if let Some(low_rank) = &mut self.low_rank {
            low_rank.correct(z);
        }
    }
}

/// (ZᵀDZ + C)⁻¹, block by block.
struct LocalInverse {
    dim: usize,
    blocks: Vec<(Vec<usize>, Mat<f64>)>,
    diagonal: Vec<f64>,
}

impl LocalInverse {
    fn new(space: &ReducedSpace, model: &LocalModel) -> Self {
        let columns: Vec<Column> = space.columns().collect();
        let dim = columns.len();
        match model {
            LocalModel::Diagonal(d) => {
                let entry = |column: &Column| {
                    let ([i, j], [v, w]) = (column.rows, column.weights);
                    (d[i] * v * v + d[j] * w * w + column.curvature).recip()
                };
                Self {
                    dim,
                    blocks: Vec::new(),
                    diagonal: columns.iter().map(entry).collect(),
                }
            }
            LocalModel::Blocks(blocks) => Self {
                dim,
                blocks: invert_blocks(&columns, blocks),
                diagonal: Vec::new(),
            },
        }
    }

    fn solve_in_place(&self, z: &mut [f64]) {
        for (z, d) in z.iter_mut().zip(&self.diagonal) {
            *z *= d;
        }
        let mut own = Vec::new();
        for (members, inverse) in &self.blocks {
            own.clear();
            own.extend(members.iter().map(|&k| z[k]));
            for (row, &k) in members.iter().enumerate() {
                z[k] = own
                    .iter()
                    .zip(inverse.col(row).iter())
                    .map(|(o, i)| o * i)
                    .sum();
            }
        }
    }
}

/// The inverse of every block that has columns of Z, with the numbers of these columns.
fn invert_blocks(columns: &[Column], blocks: &[LocalBlock]) -> Vec<(Vec<usize>, Mat<f64>)> {
    let unknowns = 1 + blocks
        .iter()
        .flat_map(|b| &b.unknowns)
        .copied()
        .max()
        .unwrap_or(0);
    let mut place = vec![(0, 0); unknowns];
    for (number, block) in blocks.iter().enumerate() {
        for (row, &i) in block.unknowns.iter().enumerate() {
            place[i] = (number, row);
        }
    }
    let mut members = vec![Vec::new(); blocks.len()];
    for (k, column) in columns.iter().enumerate() {
        members[place[column.rows[0]].0].push(k);
    }
    let inverse = |(members, block): (Vec<usize>, &LocalBlock)| {
        let number = place[block.unknowns[0]].0;
        let own: Vec<Column> = members.iter().map(|&k| columns[k]).collect();
        // A pair that is split between two blocks counts with its share in the first.
        let entry = |i: usize, j: usize| match (place[i], place[j]) {
            ((a, row), (b, column)) if a == number && b == number => block.matrix[(row, column)],
            _ => 0.0,
        };
        let matrix = galerkin(&own, entry);
        let mut inverse = Mat::identity(own.len(), own.len());
        match Llt::new(matrix.as_ref(), Side::Lower) {
            Ok(factor) => factor.solve_in_place(inverse.as_mut()),
            // Semidefinite to rounding: its diagonal alone.
            Err(_) => (0..own.len()).for_each(|i| inverse[(i, i)] = matrix[(i, i)].recip()),
        }
        (members, inverse)
    };
    let occupied = members
        .into_iter()
        .zip(blocks)
        .filter(|(members, _)| !members.is_empty());
    occupied
        .collect::<Vec<_>>()
        .into_par_iter()
        .map(inverse)
        .collect()
}

/// V = ZᵀW, D⁻¹V with D for ZᵀDZ + C, and the factor of I + VᵀD⁻¹V.
struct LowRank {
    v: Mat<f64>,
    scaled: Mat<f64>,
    capacitance: Llt<f64>,
    share: Col<f64>,
}

impl LowRank {
    /// `None` when nothing is kept yet (or the small matrix is not finite: D alone then serves).
    fn new(
        space: &ReducedSpace,
        local: &LocalInverse,
        recycled: &RecycledProducts,
    ) -> Option<Self> {
        let (rows, rank) = (space.dim(), recycled.len());
        if rank == 0 || rows == 0 {
            return None;
        }
        let (mut v, mut scaled) = (Mat::zeros(rows, rank), Mat::zeros(rows, rank));
        let mut column = vec![0.0; rows];
        for (j, product) in recycled.products().enumerate() {
            space.restrict(product, &mut column);
            v.col_mut(j).copy_from(ColRef::from_slice(&column));
            local.solve_in_place(&mut column);
            scaled.col_mut(j).copy_from(ColRef::from_slice(&column));
        }
        let mut capacitance = Mat::identity(rank, rank);
        matmul(
            capacitance.as_mut(),
            Accum::Add,
            v.transpose(),
            scaled.as_ref(),
            1.0,
            Par::Seq,
        );
        let capacitance = Llt::new(capacitance.as_ref(), Side::Lower).ok()?;
        Some(Self {
            v,
            scaled,
            capacitance,
            share: Col::zeros(rank),
        })
    }

    /// z ← z − D⁻¹V (I + VᵀD⁻¹V)⁻¹ Vᵀ z, for z = D⁻¹ r.
    fn correct(&mut self, z: &mut [f64]) {
        let share = self.share.as_mut();
        matmul(
            share,
            Accum::Replace,
            self.v.transpose(),
            ColRef::from_slice(z),
            1.0,
            Par::Seq,
        );
        self.capacitance.solve_in_place(self.share.as_mut());
        let z = ColMut::from_slice_mut(z);
        matmul(
            z,
            Accum::Add,
            self.scaled.as_ref(),
            self.share.as_ref(),
            -1.0,
            Par::Seq,
        );
    }
}
