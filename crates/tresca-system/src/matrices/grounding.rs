//! Which dofs hold a part of K that floats: the same support as `tresca_fem::rigid::Grounding`, chosen
//! without a mesh.

use tresca_fem::rigid::Grounding;
use tresca_la::vector::{axpy, dot, norm};

/// Rounds of choosing: each adds as many dofs as there are kernel vectors. More than one, so that the support
/// does not hang on single points, which the body around them gives way to.
const ROUNDS: usize = 4;

/// The chosen dofs see a kernel vector when the smallest root mean square of a combination over them is at
/// least this fraction of that over all dofs of the part.
const SEEN: f64 = 0.3;

/// A candidate that adds less than this (of the first one's length) to those before it adds nothing.
const NOTHING: f64 = 1e-6;

/// A part that floats, as seen from the body (a set of parts) that it belongs to.
pub(super) struct FloatingPart<'a> {
    /// Its dofs, numbered in the body, ascending.
    pub dofs: &'a [usize],
    /// √diag(K) at these dofs.
    pub scales: Vec<f64>,
    /// The scaled kernel R̂, orthonormal columns over these dofs.
    pub kernel: Vec<Vec<f64>>,
    /// Which of these dofs (by position) contact touches.
    pub touched: Vec<usize>,
}

/// The support of some parts of a body with `order` dofs.
///
/// In scaled coordinates C is an orthonormal basis of the kernel's rows at the chosen dofs: a support about
/// as stiff as the diagonal of K there. Any size is exact (see `Grounding`).
pub(super) fn ground(parts: &[FloatingPart<'_>], order: usize) -> Grounding {
    let count = parts.iter().map(|part| part.kernel.len()).sum();
    let mut grounding = Grounding {
        dofs: Vec::new(),
        c: Vec::with_capacity(count),
        s: vec![vec![0.0; count]; count],
        r: Vec::with_capacity(count),
    };
    // Columns of C by part, as (dof, value).
    let mut columns: Vec<Vec<(usize, f64)>> = Vec::with_capacity(count);
    for part in parts {
        let chosen = chosen(part);
        let first = columns.len();
        // R̂ at the chosen dofs = Q T; T⁻¹ is kept.
        let restricted = part
            .kernel
            .iter()
            .map(|r| chosen.iter().map(|&i| r[i]).collect())
            .collect();
        let (q, inverse) = orthonormal(restricted);
        for column in q {
            let entries = chosen.iter().zip(column);
            columns.push(
                entries
                    .map(|(&i, q)| (part.dofs[i], part.scales[i] * q))
                    .collect(),
            );
        }
        for k in 0..part.kernel.len() {
            for l in 0..part.kernel.len() {
                grounding.s[first + k][first + l] = dot(&inverse[k], &inverse[l]);
            }
        }
        for kernel in &part.kernel {
            let mut r = vec![0.0; order];
            for (i, &dof) in part.dofs.iter().enumerate() {
                r[dof] = kernel[i] / part.scales[i];
            }
            grounding.r.push(r);
        }
        grounding.dofs.extend(chosen.iter().map(|&i| part.dofs[i]));
    }
    grounding.dofs.sort_unstable();
    for column in columns {
        let mut c = vec![0.0; grounding.dofs.len()];
        for (dof, value) in column {
            if let Ok(at) = grounding.dofs.binary_search(&dof) {
                c[at] = value;
            }
        }
        grounding.c.push(c);
    }
    grounding
}

/// Dofs (by position in the part) that see the kernel: touched ones if these are enough.
fn chosen(part: &FloatingPart<'_>) -> Vec<usize> {
    let mut chosen = Vec::new();
    for _ in 0..ROUNDS {
        add_round(part, &part.touched, &mut chosen);
    }
    let all: Vec<usize> = (0..part.dofs.len()).collect();
    let enough = SEEN / (part.dofs.len() as f64).sqrt();
    while smallest(part, &chosen) < enough {
        let before = chosen.len();
        add_round(part, &all, &mut chosen);
        if chosen.len() == before {
            break;
        }
    }
    chosen.sort_unstable();
    chosen
}

/// One round of QR with row pivoting over the candidates that are not chosen yet.
fn add_round(part: &FloatingPart<'_>, candidates: &[usize], chosen: &mut Vec<usize>) {
    let mut rows: Vec<(usize, Vec<f64>)> = candidates
        .iter()
        .filter(|i| !chosen.contains(i))
        .map(|&i| (i, part.kernel.iter().map(|r| r[i]).collect()))
        .collect();
    let mut first = 0.0;
    for _ in 0..part.kernel.len() {
        // The first of the longest rows.
        let longest = rows.iter().enumerate().fold(None, |best, (at, (_, row))| {
            let length = norm(row);
            match best {
                Some((_, other)) if other >= length => best,
                _ => Some((at, length)),
            }
        });
        let Some((at, length)) = longest else { return };
        if first == 0.0 {
            first = length;
        }
        if length <= NOTHING * first || length == 0.0 {
            return;
        }
        let (dof, pivot) = rows.swap_remove(at);
        chosen.push(dof);
        for (_, row) in &mut rows {
            let along = dot(row, &pivot) / (length * length);
            axpy(-along, &pivot, row);
        }
    }
}

/// The smallest root mean square over the chosen dofs of a combination of the kernel with unit coefficients.
fn smallest(part: &FloatingPart<'_>, chosen: &[usize]) -> f64 {
    let count = part.kernel.len();
    if chosen.len() < count {
        return 0.0;
    }
    let gram = faer::Mat::from_fn(count, count, |k, l| {
        chosen
            .iter()
            .map(|&i| part.kernel[k][i] * part.kernel[l][i])
            .sum::<f64>()
    });
    let values = gram.self_adjoint_eigenvalues(faer::Side::Lower);
    let least = values
        .ok()
        .and_then(|values| values.first().copied())
        .unwrap_or(0.0);
    (least.max(0.0) / chosen.len() as f64).sqrt()
}

/// Q with orthonormal columns and T⁻¹ (upper triangular, by rows) of X = Q T.
fn orthonormal(mut x: Vec<Vec<f64>>) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let count = x.len();
    // Columns of T⁻¹: the same steps on the identity.
    let mut inverse: Vec<Vec<f64>> = (0..count)
        .map(|k| (0..count).map(|l| f64::from(u8::from(k == l))).collect())
        .collect();
    for k in 0..count {
        for _ in 0..2 {
            for l in 0..k {
                let along = dot(&x[l], &x[k]);
                let (head, tail) = x.split_at_mut(k);
                axpy(-along, &head[l], &mut tail[0]);
                let (head, tail) = inverse.split_at_mut(k);
                axpy(-along, &head[l], &mut tail[0]);
            }
        }
        let length = norm(&x[k]);
        if length > 0.0 {
            x[k].iter_mut().for_each(|v| *v /= length);
            inverse[k].iter_mut().for_each(|v| *v /= length);
        }
    }
    // From columns to rows.
    let rows = (0..count)
        .map(|k| (0..count).map(|l| inverse[l][k]).collect())
        .collect();
    (x, rows)
}
