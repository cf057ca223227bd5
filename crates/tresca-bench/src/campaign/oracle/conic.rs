//! Clarabel, posed in the displacements: min ½uᵀKu − fᵀu + Σ h(Tu − s) over N u ≤ d.

use super::program::Program;
use super::ties::{Affine, Ties, eliminate};
use crate::campaign::dense::{Rows, dot, largest, norm, product, transposed_product};
use crate::campaign::problem::{Problem, bounds, is_closed};

/// A row of N shorter than this part of itself on what the ties leave is decided by them.
const DECIDED: f64 = 1e-10;
/// An overlap that cannot be avoided, over the largest gap: below the first there is none, above the second
/// there is no displacement.
const FEASIBLE: f64 = 1e-8;
const INFEASIBLE: f64 = 1e-6;

/// Whether the constraints can be met at all.
pub enum Feasible {
    /// By these displacements, were it for the ties alone, under these rows.
    Yes(Reduced),
    /// No displacement meets them.
    No,
    /// By too little to say.
    Unclear(String),
}

/// The problem on what the ties leave.
pub struct Reduced {
    affine: Affine,
    /// Inequalities on v: rows, right-hand sides, pairs.
    rows: Vec<(Vec<f64>, f64, usize)>,
}

/// Z by columns: rows · Z.
fn on(basis: &Rows, row: &[f64]) -> Vec<f64> {
    product(basis, row)
}

/// Looks for a displacement that meets N u ≤ d and the ties.
pub fn feasible(problem: &Problem) -> Feasible {
    let mut ties = Vec::new();
    for (pair, law) in problem.laws.iter().enumerate() {
        if is_closed(law) {
            ties.push((problem.normal[pair].clone(), problem.gap[pair]));
        }
        if bounds(law, 0.0).is_none() {
            for t in 0..problem.tangents {
                let row = problem.tangents * pair + t;
                ties.push((problem.tangential[row].clone(), problem.origin[row]));
            }
        }
    }
    let affine = match eliminate(&ties, problem.dofs()) {
        Ties::Met(affine) => affine,
        Ties::Contradict => return Feasible::No,
        Ties::Unclear => {
            return Feasible::Unclear("ties that contradict each other a little".into());
        }
    };
    let scale = |pair: usize| {
        let length = norm(&problem.normal[pair]);
        if length > 0.0 {
            norm(&affine.origin) + problem.gap[pair].abs() / length
        } else {
            0.0
        }
    };
    let size = (0..problem.pairs()).map(scale).fold(0.0, f64::max);
    let mut rows = Vec::new();
    for (pair, law) in problem.laws.iter().enumerate() {
        if is_closed(law) {
            continue;
        }
        let normal = &problem.normal[pair];
        let left = problem.gap[pair] - dot(normal, &affine.origin);
        let row = on(&affine.basis, normal);
        let length = norm(normal);
        if norm(&row) > DECIDED * length {
            let length = norm(&row);
            rows.push((
                row.iter().map(|x| x / length).collect(),
                left / length,
                pair,
            ));
        } else if left < -INFEASIBLE * size * length {
            return Feasible::No;
        } else if left < -FEASIBLE * size * length {
            return Feasible::Unclear("an overlap that the ties leave".into());
        }
    }
    let reduced = Reduced { affine, rows };
    match reduced.overlap() {
        Err(why) => Feasible::Unclear(why),
        Ok(overlap) if overlap <= FEASIBLE => Feasible::Yes(reduced),
        Ok(overlap) if overlap >= INFEASIBLE => Feasible::No,
        Ok(overlap) => Feasible::Unclear(format!("an overlap of {overlap:.0e}")),
    }
}

impl Reduced {
    /// The smallest largest overlap, by a linear programme; over the largest right-hand side.
    fn overlap(&self) -> Result<f64, String> {
        let free = self.affine.basis.len();
        let values: Vec<f64> = self.rows.iter().map(|row| row.1).collect();
        let size = largest(&values);
        if values.iter().all(|&d| d >= 0.0) {
            return Ok(0.0);
        }
        let mut program = Program::new(free + 1);
        program.linear[free] = 1.0;
        program.at_most((vec![(free, -1.0)], 0.0));
        for (row, d, _) in &self.rows {
            let mut entries: Vec<_> = row.iter().copied().enumerate().collect();
            entries.push((free, -1.0));
            program.at_most((entries, d / size));
        }
        Ok(program.minimise()?.objective)
    }

    /// The displacements of least energy, and normal forces of pairs that may open.
    pub fn minimise(&self, problem: &Problem) -> Result<Vec<f64>, String> {
        let Affine { origin, basis } = &self.affine;
        let free = basis.len();
        if free == 0 {
            return Ok(origin.clone());
        }
        let (m, tangents) = (problem.pairs(), problem.tangents);
        let k = problem.whole();
        let images: Rows = basis.iter().map(|z| product(&k, z)).collect();
        let mut program = Program::new(free);
        let out_of_balance: Vec<f64> = product(&k, origin)
            .iter()
            .zip(&problem.load)
            .map(|(k, f)| k - f)
            .collect();
        program.linear = product(basis, &out_of_balance);
        for (i, z) in basis.iter().enumerate() {
            for (j, image) in images.iter().enumerate().skip(i) {
                program.quadratic.push((i, j, dot(z, image)));
            }
        }
        for (row, d, _) in &self.rows {
            program.at_most((row.iter().copied().enumerate().collect(), *d));
        }
        for pair in 0..m {
            let Some(bounds) = bounds(&problem.laws[pair], 0.0) else {
                continue;
            };
            // (t, g1 (T1u − s1), g2 (T2u − s2)) in the cone.
            let mut cone = Vec::new();
            for t in (0..tangents).filter(|&t| bounds[t] > 0.0) {
                let at = tangents * pair + t;
                let row = &problem.tangential[at];
                let left = dot(row, origin) - problem.origin[at];
                let entries = on(basis, row).into_iter().enumerate();
                cone.push((
                    entries.map(|(j, x)| (j, -bounds[t] * x)).collect(),
                    bounds[t] * left,
                ));
            }
            if !cone.is_empty() {
                program.linear.push(1.0);
                cone.insert(0, (vec![(program.linear.len() - 1, -1.0)], 0.0));
                program.in_cone(cone);
            }
        }
        let minimum = program.minimise()?;
        let mut u = transposed_product(basis, &minimum.x[..free], problem.dofs());
        u.iter_mut().zip(origin).for_each(|(u, o)| *u += o);
        Ok(u)
    }
}
