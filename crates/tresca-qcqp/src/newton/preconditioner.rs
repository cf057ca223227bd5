//! The preconditioner of the reduced Newton systems.
//!
//! ```text
//! M = Zᵀ(D + WG⁻¹Wᵀ)Z + C
//! ```
//!
//! with the operator's local model D, block diagonal, and the recycled products
//! W with their Gram matrix G: D serves what no product has shown yet. With
//! ZᵀDZ + C = LLᵀ, block by block, and U = L⁻¹ZᵀW the Woodbury formula reads
//!
//! ```text
//! M⁻¹ = L⁻ᵀ (I − U (G + UᵀU)⁻¹ Uᵀ) L⁻¹.
//! ```

use super::recycled_products::RecycledProducts;
use super::reduced_space::{BasisColumn, ReducedSpace, galerkin};
use crate::operator::local_model::{LocalBlock, LocalModel};
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::solvers::Llt;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, ColMut, ColRef, Mat, MatRef, Par, Side};
use rayon::prelude::*;
use tresca_la::vector::{axpy, dot};
use tresca_la::{LinearOperator, PackedLower};

/// M⁻¹.
pub(crate) struct Preconditioner<'a> {
    local: LocalFactor,
    low_rank: Option<LowRank<'a>>,
}

impl<'a> Preconditioner<'a> {
    /// M for the space of Z and C. `memory` is where U goes: megabytes that every Newton step would otherwise
    /// ask the system for.
    pub fn new(
        space: &ReducedSpace,
        model: &LocalModel,
        recycled: &mut RecycledProducts,
        memory: &'a mut Vec<f64>,
    ) -> Self {
        recycled.settle();
        let mut local = LocalFactor::new(space, model);
        let low_rank = LowRank::new(space, &mut local, recycled, memory);
        Self { local, low_rank }
    }
}

impl LinearOperator for Preconditioner<'_> {
    fn dim(&self) -> usize {
        self.local.dim
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        z.copy_from_slice(r);
        self.local.solve_lower_in_place(z);
        if let Some(low_rank) = &mut self.low_rank {
            low_rank.correct(z);
        }
        self.local.solve_upper_in_place(z);
    }
}

/// L⁻¹ with ZᵀDZ + C = LLᵀ, block by block.
struct LocalFactor {
    dim: usize,
    blocks: Vec<(Vec<usize>, Mat<f64>)>,
    diagonal: Vec<f64>,
    /// The part of a vector that belongs to one block.
    own: Vec<f64>,
}

impl LocalFactor {
    fn new(space: &ReducedSpace, model: &LocalModel) -> Self {
        let columns: Vec<BasisColumn> = space.columns().collect();
        let dim = columns.len();
        match model {
            LocalModel::Diagonal(d) => {
                let entry = |column: &BasisColumn| {
                    let ([i, j], [v, w]) = (column.rows, column.weights);
                    let square = d[i] * v * v + d[j] * w * w + column.curvature;
                    square.sqrt().recip()
                };
                Self {
                    dim,
                    blocks: Vec::new(),
                    diagonal: columns.iter().map(entry).collect(),
                    own: Vec::new(),
                }
            }
            LocalModel::Blocks(blocks) => Self {
                dim,
                blocks: factor_blocks(&columns, blocks),
                diagonal: Vec::new(),
                own: Vec::new(),
            },
        }
    }

    /// z ← L⁻¹ z.
    fn solve_lower_in_place(&mut self, z: &mut [f64]) {
        self.solve_in_place(z, |inverse, own, product| {
            product.fill(0.0);
            for (j, own) in own.iter().enumerate() {
                axpy(*own, column(inverse, j), &mut product[j..]);
            }
        });
    }

    /// z ← L⁻ᵀ z.
    fn solve_upper_in_place(&mut self, z: &mut [f64]) {
        self.solve_in_place(z, |inverse, own, product| {
            for (j, product) in product.iter_mut().enumerate() {
                *product = dot(column(inverse, j), &own[j..]);
            }
        });
    }

    fn solve_in_place(&mut self, z: &mut [f64], solve: impl Fn(&Mat<f64>, &[f64], &mut [f64])) {
        for (z, d) in z.iter_mut().zip(&self.diagonal) {
            *z *= d;
        }
        for (members, inverse) in &self.blocks {
            self.own.clear();
            self.own.extend(members.iter().map(|&k| z[k]));
            self.own.resize(2 * members.len(), 0.0);
            let (own, product) = self.own.split_at_mut(members.len());
            solve(inverse, own, product);
            for (&k, &product) in members.iter().zip(&*product) {
                z[k] = product;
            }
        }
    }
}

/// Column j of a lower triangle, from the diagonal down.
fn column(lower: &Mat<f64>, j: usize) -> &[f64] {
    lower
        .col(j)
        .try_as_col_major()
        .map_or(&[], |c| &c.as_slice()[j..])
}

/// L⁻¹ of every block that has columns of Z, with the numbers of these columns.
fn factor_blocks(columns: &[BasisColumn], blocks: &[LocalBlock]) -> Vec<(Vec<usize>, Mat<f64>)> {
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
        let own: Vec<BasisColumn> = members.iter().map(|&k| columns[k]).collect();
        // A pair that is split between two blocks counts with its share in the first.
        let entry = |i: usize, j: usize| match (place[i], place[j]) {
            ((a, row), (b, column)) if a == number && b == number => block.matrix[(row, column)],
            _ => 0.0,
        };
        let matrix = galerkin(&own, entry);
        let mut inverse = Mat::identity(own.len(), own.len());
        match Llt::new(matrix.as_ref(), Side::Lower) {
            Ok(factor) => {
                solve_lower_triangular_in_place(factor.L(), inverse.as_mut(), Par::Seq);
            }
            // Semidefinite to rounding: its diagonal alone.
            Err(_) => (0..own.len()).for_each(|i| inverse[(i, i)] = matrix[(i, i)].sqrt().recip()),
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

/// U = L⁻¹ZᵀW, and the factor of G + UᵀU.
struct LowRank<'a> {
    u: MatRef<'a, f64>,
    capacitance: PackedLower,
    share: Vec<f64>,
}

impl<'a> LowRank<'a> {
    /// `None` when nothing is kept yet (or the small matrix is not finite: D alone then serves).
    fn new(
        space: &ReducedSpace,
        local: &mut LocalFactor,
        recycled: &RecycledProducts,
        memory: &'a mut Vec<f64>,
    ) -> Option<Self> {
        let (rows, rank) = (space.dim(), recycled.len());
        if rank == 0 || rows == 0 {
            return None;
        }
        memory.resize(rows * rank, 0.0);
        for (column, product) in memory.chunks_exact_mut(rows).zip(recycled.products()) {
            space.restrict(product, column);
            local.solve_lower_in_place(column);
        }
        let u = MatRef::from_column_major_slice(memory, rows, rank);
        let mut capacitance = recycled.gram();
        triangular::matmul(
            capacitance.as_mut(),
            BlockStructure::TriangularLower,
            Accum::Add,
            u.transpose(),
            BlockStructure::Rectangular,
            u,
            BlockStructure::Rectangular,
            1.0,
            Par::Seq,
        );
        let capacitance = Llt::new(capacitance.as_ref(), Side::Lower).ok()?;
        Some(Self {
            u,
            capacitance: PackedLower::from_lower(capacitance.L()),
            share: vec![0.0; rank],
        })
    }

    /// z ← z − U (G + UᵀU)⁻¹ Uᵀ z.
    fn correct(&mut self, z: &mut [f64]) {
        let share = ColMut::from_slice_mut(&mut self.share);
        let u = self.u;
        let from = ColRef::from_slice(z);
        matmul(share, Accum::Replace, u.transpose(), from, 1.0, Par::Seq);
        self.capacitance.solve_lower_in_place(&mut self.share);
        self.capacitance.solve_upper_in_place(&mut self.share);
        let share = ColRef::from_slice(&self.share);
        let z = ColMut::from_slice_mut(z);
        matmul(z, Accum::Add, u, share, -1.0, Par::Seq);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sets::product::ProductSet;
    use faer::Col;
    use faer::linalg::solvers::Solve;

    const PAIRS: usize = 7;
    const DIM: usize = 3 * PAIRS;

    fn entry(seed: usize, i: usize, j: usize) -> f64 {
        (((i + 3) * (j + 5) * (seed + 7)) as f64).sin()
    }

    /// A fixed SPD matrix without structure.
    fn matrix(seed: usize) -> Mat<f64> {
        let root = Mat::from_fn(DIM, DIM, |i, j| entry(seed, i, j));
        &root * root.transpose() + Mat::<f64>::identity(DIM, DIM)
    }

    fn direction(k: usize) -> Col<f64> {
        Col::from_fn(DIM, |i| entry(k, i, 2 * k))
    }

    fn recycled(a: &Mat<f64>, count: usize) -> RecycledProducts {
        let mut recycled = RecycledProducts::new(6);
        for k in 0..count {
            let p = direction(k);
            let w = a * &p;
            let slice = |c: &Col<f64>| c.iter().copied().collect::<Vec<_>>();
            recycled.offer(&slice(&p), &slice(&w));
            // Some alone, some together.
            if k % 3 != 0 {
                recycled.settle();
            }
            // What is known already is not kept twice.
            recycled.offer(&slice(&p), &slice(&w));
        }
        recycled.settle();
        recycled
    }

    fn columns<'a>(vectors: impl Iterator<Item = &'a [f64]>) -> Mat<f64> {
        let vectors: Vec<_> = vectors.collect();
        Mat::from_fn(DIM, vectors.len(), |i, j| vectors[j][i])
    }

    /// WG⁻¹Wᵀ, the part of A that the recycled products have shown.
    fn seen(recycled: &RecycledProducts) -> Mat<f64> {
        let w = columns(recycled.products());
        let gram = Llt::new(recycled.gram().as_ref(), Side::Lower).unwrap();
        &w * gram.solve(w.transpose())
    }

    #[test]
    fn what_recycled_products_show_of_a_is_exact_on_their_span_and_never_above_it() {
        let a = matrix(1);
        let recycled = recycled(&a, 9);
        assert_eq!(recycled.len(), 6, "the capacity holds");
        let seen = seen(&recycled);
        for k in 0..6 {
            let p = direction(k);
            assert!((&a * &p - &seen * &p).norm_max() <= 1e-9 * a.norm_max());
        }
        let rest = &a - &seen;
        assert!(rest.self_adjoint_eigenvalues(Side::Lower).unwrap()[0] >= -1e-9 * a.norm_max());
    }

    /// M⁻¹ against the dense inverse of Zᵀ(D + WG⁻¹Wᵀ)Z + C, D as vector and as blocks.
    #[test]
    fn preconditioner_is_the_inverse_of_its_matrix() {
        let a = matrix(2);
        let bounds = [0.5, 0.0, 2.0, 1.0, 0.3, 1.5, 0.8];
        let set = ProductSet::contact_3d(&bounds).unwrap();
        let y: Vec<f64> = (0..DIM).map(|i| entry(4, i, 1)).collect();
        let active = set.classify(&y);
        let space = ReducedSpace::with_tangents(&set, &active, &y, |i, bound| i as f64 + bound);
        let groups =
            crate::operator::groups::unknowns_of_pairs(&[vec![0, 3, 4], vec![6], vec![1, 2, 5]], 3);
        let block = |unknowns: &Vec<usize>| LocalBlock {
            unknowns: unknowns.clone(),
            matrix: Mat::from_fn(unknowns.len(), unknowns.len(), |i, j| {
                a[(unknowns[i], unknowns[j])]
            }),
        };
        let models = [
            LocalModel::Diagonal((0..DIM).map(|i| a[(i, i)]).collect()),
            LocalModel::Blocks(groups.iter().map(block).collect()),
        ];
        for model in models {
            for count in [0, 4] {
                let (mut recycled, mut memory) = (recycled(&a, count), vec![f64::NAN; 5]);
                let mut full = seen(&recycled);
                match &model {
                    LocalModel::Diagonal(d) => (0..DIM).for_each(|i| full[(i, i)] += d[i]),
                    LocalModel::Blocks(blocks) => {
                        for block in blocks {
                            for (row, &i) in block.unknowns.iter().enumerate() {
                                for (column, &j) in block.unknowns.iter().enumerate() {
                                    full[(i, j)] += block.matrix[(row, column)];
                                }
                            }
                        }
                    }
                }
                let columns: Vec<BasisColumn> = space.columns().collect();
                let lower = galerkin(&columns, |i, j| full[(i, j)]);
                let mut preconditioner =
                    Preconditioner::new(&space, &model, &mut recycled, &mut memory);
                let r: Vec<f64> = (0..space.dim()).map(|i| entry(5, i, 3)).collect();
                let mut z = vec![f64::NAN; space.dim()];
                preconditioner.apply(&r, &mut z);
                for (i, r) in r.iter().enumerate() {
                    let product: f64 = (0..z.len())
                        .map(|j| lower[(i.max(j), i.min(j))] * z[j])
                        .sum();
                    assert!(
                        (product - r).abs() <= 1e-10,
                        "row {i}: {product} is not {r}"
                    );
                }
            }
        }
    }
}
