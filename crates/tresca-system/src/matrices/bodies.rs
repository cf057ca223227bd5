//! From the parts of K to bodies that can be factored.

use std::sync::Arc;
use std::time::Instant;

use faer::sparse::{SparseRowMat, SymbolicSparseRowMat};
use rayon::prelude::*;
use tresca_la::{BodySolver, Parallelism, SymmetricMatrix};
use tresca_qcqp::operator::Coupling;

use super::error::AlgebraicError;
use super::grounding::{FloatingPart, ground};
use super::kernel::{self, KernelFailure};
use super::matrix::Matrix;
use super::note::Note;
use super::parts::Stiffness;
use super::problem::Kernel;
use crate::body::{FactorFailure, SystemBody};
use crate::factors::{Factors, share_of_threads};

/// The dofs of K that are a body's own, the body, its solver, and what there is to say of it.
type FactoredPart = (Vec<usize>, SystemBody, Arc<dyn BodySolver>, Vec<Note>);

/// Parts up to this size are lumped into one body, and their kernels found by dense eigenvalues: supported
/// dofs that were left in K are parts of size 1, and there may be thousands.
const SMALL: usize = 200;

/// Parts of K that are factored together, and their factors.
pub(super) struct Bodies {
    /// Where the dofs of each body stand in the caller's numbering, ascending.
    pub dofs: BodyDofs,
    pub bodies: Vec<SystemBody>,
    pub factors: Factors,
}

/// The dofs of each body in the caller's numbering, ascending.
pub(super) struct BodyDofs(Vec<Vec<usize>>);

impl BodyDofs {
    /// n.
    pub fn count(&self) -> usize {
        self.0.iter().map(Vec::len).sum()
    }

    /// A vector over the caller's dofs, body by body.
    pub fn split(&self, values: &[f64]) -> Vec<Vec<f64>> {
        let own = |dofs: &Vec<usize>| dofs.iter().map(|&dof| values[dof]).collect();
        self.0.iter().map(own).collect()
    }

    /// The other way round.
    pub fn join(&self, parts: &[Vec<f64>]) -> Vec<f64> {
        let mut all = vec![0.0; self.count()];
        for (&dof, &value) in self.0.iter().flatten().zip(parts.iter().flatten()) {
            all[dof] = value;
        }
        all
    }
}

/// The dofs of a part that floats, numbered in its body, and its kernel (scaled, see `kernel`).
type PartKernel = (Vec<usize>, Vec<Vec<f64>>);

/// A body on the way to its factor.
struct Draft<'a> {
    dofs: Vec<usize>,
    /// Its parts, in the caller's numbering.
    parts: Vec<&'a [usize]>,
    stiffness: SymmetricMatrix,
    coupling: Coupling,
    /// Dofs that B touches, numbered in the body.
    touched: Vec<usize>,
}

/// Splits K into bodies, finds or checks their kernels, grounds and factors them, side by side.
pub(super) fn factor(
    stiffness: &Stiffness,
    b: &Matrix,
    weights: &[f64],
    kernel: &Kernel,
    contact_last: bool,
    notes: &mut Vec<Note>,
) -> Result<Bodies, AlgebraicError> {
    let begin = Instant::now();
    if let Kernel::Given(vectors) = kernel {
        for vector in vectors {
            super::check::vector(
                "a kernel vector",
                vector,
                stiffness.matrix.rows(),
                "dofs of K",
            )?;
        }
    }
    let drafts = drafts(stiffness, b, weights);
    let parallelism = share_of_threads(drafts.len());
    let done = drafts
        .into_par_iter()
        .map(|draft| draft.factor(kernel, contact_last, parallelism))
        .collect::<Result<Vec<_>, _>>()?;
    let (mut dofs, mut bodies, mut factors) = (Vec::new(), Vec::new(), Vec::new());
    for (own, body, factor, found) in done {
        notes.extend(found);
        dofs.push(own);
        bodies.push(body);
        factors.push(factor);
    }
    Ok(Bodies {
        dofs: BodyDofs(dofs),
        bodies,
        factors: Factors::of(factors, begin.elapsed().as_secs_f64()),
    })
}

fn drafts<'a>(stiffness: &'a Stiffness, b: &Matrix, weights: &[f64]) -> Vec<Draft<'a>> {
    let (small, large): (Vec<&[usize]>, Vec<&[usize]>) = stiffness
        .parts
        .iter()
        .map(Vec::as_slice)
        .partition(|part| part.len() <= SMALL);
    let mut groups: Vec<Vec<&[usize]>> = large.into_iter().map(|part| vec![part]).collect();
    if !small.is_empty() {
        groups.push(small);
    }
    let mut body_of = vec![(0, 0); stiffness.matrix.rows()];
    let dofs: Vec<Vec<usize>> = groups
        .iter()
        .enumerate()
        .map(|(body, parts)| {
            let mut dofs = parts.concat();
            dofs.sort_unstable();
            dofs.iter()
                .enumerate()
                .for_each(|(local, &dof)| body_of[dof] = (body, local));
            dofs
        })
        .collect();
    let couplings = couplings(b, weights, &body_of, &dofs);
    groups
        .into_iter()
        .zip(dofs)
        .zip(couplings)
        .map(|((parts, dofs), coupling)| Draft {
            stiffness: stiffness.restricted(&dofs),
            touched: coupling.touched(),
            parts,
            dofs,
            coupling,
        })
        .collect()
}

/// diag(weights) B, body by body; zeros are dropped.
fn couplings(
    b: &Matrix,
    weights: &[f64],
    body_of: &[(usize, usize)],
    dofs: &[Vec<usize>],
) -> Vec<Coupling> {
    let mut columns = vec![Vec::new(); dofs.len()];
    let mut values = vec![Vec::new(); dofs.len()];
    let mut starts = vec![vec![0]; dofs.len()];
    for (row, weight) in weights.iter().enumerate() {
        for (dof, value) in b.row(row).filter(|(_, value)| *value != 0.0) {
            let (body, local) = body_of[dof];
            columns[body].push(local);
            values[body].push(weight * value);
        }
        for (starts, columns) in starts.iter_mut().zip(&columns) {
            starts.push(columns.len());
        }
    }
    let parts = starts.into_iter().zip(columns).zip(values).zip(dofs);
    parts
        .map(|(((starts, columns), values), dofs)| {
            let symbolic =
                SymbolicSparseRowMat::new_checked(b.rows(), dofs.len(), starts, None, columns);
            Coupling::new(SparseRowMat::new(symbolic, values))
        })
        .collect()
}

impl<'a> Draft<'a> {
    /// The first dof, for messages.
    fn first(&self) -> usize {
        self.dofs[0]
    }

    /// Whether this is one part that is too large for dense eigenvalues.
    fn is_large(&self) -> bool {
        self.parts.len() == 1 && self.dofs.len() > SMALL
    }

    fn factor(
        self,
        kernel: &Kernel,
        contact_last: bool,
        parallelism: Parallelism,
    ) -> Result<FactoredPart, AlgebraicError> {
        let given = matches!(kernel, Kernel::Given(_));
        let first = self.first();
        let large = self.is_large();
        // Of a large part it is not known yet whether it is singular: its own factor tells.
        let kernels = match kernel {
            Kernel::Given(vectors) => self.given(vectors)?,
            Kernel::Find if large => Vec::new(),
            Kernel::Find => self.of_small_parts()?,
        };
        let floats = !kernels.is_empty();
        let mut notes = if given {
            Vec::new()
        } else {
            self.notes(&kernels)
        };
        let (dofs, body) = self.grounded(&kernels)?;
        let attempt = body.factor(contact_last, parallelism);
        let regular = |solver: &dyn BodySolver| {
            // Of small parts it is known by their eigenvalues.
            !(large || given) || !kernel::is_singular(&body.regular_stiffness(), solver)
        };
        match attempt {
            Ok(factor) if regular(&*factor) => return Ok((dofs, body, factor, notes)),
            Err(FactorFailure::Ordering(source)) => {
                return Err(AlgebraicError::Ordering { dof: first, source });
            }
            Err(FactorFailure::Factor(source))
                if !matches!(source, tresca_la::FactorError::NotPositiveDefinite { .. }) =>
            {
                return Err(AlgebraicError::Factorization { dof: first, source });
            }
            _ if given => return Err(AlgebraicError::KernelIncomplete { dof: first }),
            Err(FactorFailure::Factor(source)) if floats || !large => {
                return Err(AlgebraicError::Factorization { dof: first, source });
            }
            _ => {}
        }
        let part = Draft {
            parts: Vec::new(),
            touched: body.coupling.touched(),
            dofs,
            stiffness: body.stiffness,
            coupling: body.coupling,
        };
        let found = kernel::of_large(&part.stiffness, parallelism)
            .map_err(|failure| part.failure(failure, &part.dofs))?;
        if found.is_empty() {
            return Err(AlgebraicError::NotPositive {
                dof: first,
                reason: "no Cholesky factor, and no kernel that could be the reason,",
            });
        }
        let all: Vec<usize> = (0..part.dofs.len()).collect();
        let kernels = vec![(all, found)];
        notes = part.notes(&kernels);
        let (dofs, body) = part.grounded(&kernels)?;
        match body.factor(contact_last, parallelism) {
            Ok(factor) => Ok((dofs, body, factor, notes)),
            Err(FactorFailure::Ordering(source)) => {
                Err(AlgebraicError::Ordering { dof: first, source })
            }
            Err(FactorFailure::Factor(source)) => {
                Err(AlgebraicError::Factorization { dof: first, source })
            }
        }
    }

    /// The dofs of a part, numbered in the body.
    fn local(&self, part: &[usize]) -> Vec<usize> {
        part.iter()
            .filter_map(|dof| self.dofs.binary_search(dof).ok())
            .collect()
    }

    /// The kernels of all parts, by eigenvalues: (dofs in the body, scaled vectors).
    fn of_small_parts(&self) -> Result<Vec<PartKernel>, AlgebraicError> {
        let mut kernels = Vec::new();
        for part in &self.parts {
            let local = self.local(part);
            let found = kernel::of_small(&principal(&self.stiffness, &local))
                .map_err(|failure| self.failure(failure, part))?;
            if !found.is_empty() {
                kernels.push((local, found));
            }
        }
        Ok(kernels)
    }

    /// What given vectors are on every part.
    fn given(&self, vectors: &[Vec<f64>]) -> Result<Vec<PartKernel>, AlgebraicError> {
        let mut kernels = Vec::new();
        for part in &self.parts {
            let local = self.local(part);
            let own: Vec<Vec<f64>> = vectors
                .iter()
                .map(|r| part.iter().map(|&dof| r[dof]).collect())
                .collect();
            let k;
            let k = if self.parts.len() == 1 {
                &self.stiffness
            } else {
                k = principal(&self.stiffness, &local);
                &k
            };
            let kernel = kernel::checked(k, &own)
                .map_err(|(vector, residual)| AlgebraicError::Kernel { vector, residual })?;
            if part.len() <= SMALL {
                let all = kernel::of_small(k).map_err(|failure| self.failure(failure, part))?;
                if all.len() > kernel.len() {
                    return Err(AlgebraicError::KernelIncomplete { dof: part[0] });
                }
            }
            if !kernel.is_empty() {
                kernels.push((local, kernel));
            }
        }
        Ok(kernels)
    }

    fn failure(&self, failure: KernelFailure, part: &[usize]) -> AlgebraicError {
        match failure {
            KernelFailure::Indefinite(local) => AlgebraicError::NotPositive {
                dof: part[local],
                reason: "a negative eigenvalue, largest",
            },
            KernelFailure::TooLarge => AlgebraicError::KernelTooLarge {
                dof: part[0],
                limit: kernel::MOST,
            },
        }
    }

    fn notes(&self, kernels: &[PartKernel]) -> Vec<Note> {
        let note = |(local, kernel): &PartKernel| Note::KernelFound {
            dof: self.dofs[local[0]],
            dofs: local.len(),
            vectors: kernel.len(),
        };
        kernels.iter().map(note).collect()
    }

    /// Its dofs, and the body with its floating parts grounded.
    fn grounded(self, kernels: &[PartKernel]) -> Result<(Vec<usize>, SystemBody), AlgebraicError> {
        let scales = kernel::scales(&self.stiffness);
        let mut floating = Vec::new();
        for (local, kernel) in kernels {
            let is_touched = |(_, dof): &(usize, &usize)| self.touched.binary_search(dof).is_ok();
            let touched: Vec<usize> = local
                .iter()
                .enumerate()
                .filter(is_touched)
                .map(|(i, _)| i)
                .collect();
            if touched.is_empty() {
                return Err(AlgebraicError::Floating {
                    dof: self.dofs[local[0]],
                    dofs: local.len(),
                    motions: kernel.len(),
                });
            }
            floating.push(FloatingPart {
                dofs: local,
                scales: local.iter().map(|&dof| scales[dof]).collect(),
                kernel: kernel.clone(),
                touched,
            });
        }
        let grounding = (!floating.is_empty()).then(|| ground(&floating, self.dofs.len()));
        let body = SystemBody::new(self.stiffness, grounding, self.coupling);
        Ok((self.dofs, body))
    }
}

/// K on some dofs (ascending).
fn principal(k: &SymmetricMatrix, dofs: &[usize]) -> SymmetricMatrix {
    let mut starts = vec![0];
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for &dof in dofs {
        let column = k.lower().row_idx_of_col(dof).zip(k.lower().val_of_col(dof));
        for (row, &value) in column.filter_map(|(i, k)| Some((dofs.binary_search(&i).ok()?, k))) {
            rows.push(row);
            values.push(value);
        }
        starts.push(rows.len());
    }
    let order = dofs.len();
    let pattern = faer::sparse::SymbolicSparseColMat::new_checked(order, order, starts, None, rows);
    SymmetricMatrix::from_lower(faer::sparse::SparseColMat::new(pattern, values))
}
