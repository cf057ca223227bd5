//! A list of equations brought to the form u_D = C_D û + what is held.
//!
//! Elimination in the order of the list. Equation i is freed of the dependent dofs of the equations before it,
//!
//! r_i = a_i − Σ_{j<i} l_ij r_j,   that is  A = L R,
//!
//! and then determines its own dependent dof. What is left of it may still name dependent dofs of *later*
//! equations; these go when the rows are resolved, last to first. L and R are kept: the multipliers of the
//! equations are the solution of A_Dᵀμ = r_D = R_Dᵀ Lᵀ μ.

use super::equation::Equation;
use crate::error::FemError;
use crate::supports::Supports;
use std::collections::{BTreeMap, BTreeSet};

/// A coefficient below this part of what cancelled in it is zero.
const CANCELLED: f64 = 1e-12;

/// Marks a full dof that is not dependent.
const INDEPENDENT: usize = usize::MAX;

/// Resolved equations.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Elimination {
    /// Number of equation by full dof, `INDEPENDENT` for the others.
    equation_of: Vec<usize>,
    /// R and L, by equation.
    reduced: Vec<Reduced>,
    /// Resolved rows, by equation.
    rows: Vec<ResolvedRow>,
}

/// p u_D + Σ a_k u_k = b, free of the dependent dofs of earlier equations.
#[derive(Clone, Debug, PartialEq)]
struct Reduced {
    dependent: usize,
    pivot: f64,
    /// The other dofs, ascending.
    terms: Vec<(usize, f64)>,
    value: f64,
    /// l_ij by earlier equation j, ascending.
    lower: Vec<(usize, f64)>,
}

/// u_D = Σ c_k u_k + constant over dofs that are free or held.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ResolvedRow {
    /// The dependent dof.
    pub dependent: usize,
    /// c_k by full dof, ascending.
    pub terms: Vec<(usize, f64)>,
    /// What the right sides amount to.
    pub constant: f64,
}

/// A sum with the size of what went into it.
#[derive(Clone, Copy, Default)]
struct Sum {
    value: f64,
    size: f64,
}

impl Sum {
    fn add(&mut self, x: f64) {
        self.value += x;
        self.size += x.abs();
    }

    fn cancelled(self) -> bool {
        self.value.abs() <= CANCELLED * self.size
    }
}

impl Elimination {
    /// Resolves equations beside the dofs that supports hold.
    pub fn new(supports: &Supports, equations: &[Equation]) -> Result<Self, FemError> {
        let full = supports.components() * supports.node_count();
        let mut elimination = Self {
            equation_of: vec![INDEPENDENT; full],
            reduced: Vec::with_capacity(equations.len()),
            rows: Vec::new(),
        };
        for (index, equation) in equations.iter().enumerate() {
            let reduced = elimination.reduce(supports, index, equation)?;
            elimination.equation_of[reduced.dependent] = index;
            elimination.reduced.push(reduced);
        }
        elimination.resolve();
        Ok(elimination)
    }

    /// The resolved rows, by equation.
    pub fn rows(&self) -> &[ResolvedRow] {
        &self.rows
    }

    /// The resolved row of a dependent dof.
    pub fn row(&self, full: usize) -> Option<&ResolvedRow> {
        self.rows.get(self.equation_of[full])
    }

    /// Frees equation `index` of the dependent dofs of those before it.
    fn reduce(
        &self,
        supports: &Supports,
        index: usize,
        equation: &Equation,
    ) -> Result<Reduced, FemError> {
        let components = supports.components();
        let mut sums = self.gathered(supports, index, equation)?;
        let dependent = equation.terms[0].0;
        let mut value = Sum::default();
        value.add(equation.value);

        let mut lower = Vec::new();
        let earlier = |dof: &usize| Some(self.equation_of[*dof]).filter(|&j| j != INDEPENDENT);
        // The row of equation j names dependent dofs of equations after j only: ascending, each goes once.
        let mut pending: BTreeSet<usize> = sums.keys().filter_map(earlier).collect();
        while let Some(j) = pending.pop_first() {
            let row = &self.reduced[j];
            let factor = match sums.remove(&row.dependent) {
                Some(sum) if !sum.cancelled() => sum.value / row.pivot,
                _ => continue,
            };
            lower.push((j, factor));
            value.add(-factor * row.value);
            for &(dof, a) in &row.terms {
                sums.entry(dof).or_default().add(-factor * a);
                pending.extend(earlier(&dof));
            }
        }
        let full = dependent.full(components);
        let pivot = sums.remove(&full);
        sums.retain(|_, sum| !sum.cancelled());
        if pivot.is_none_or(Sum::cancelled) {
            return Err(self.unsolvable(supports, index, equation, &sums, value, &lower));
        }
        Ok(Reduced {
            dependent: full,
            pivot: pivot.unwrap_or_default().value,
            terms: sums
                .into_iter()
                .map(|(dof, sum)| (dof, sum.value))
                .collect(),
            value: value.value,
            lower,
        })
    }

    /// The checked coefficients by full dof.
    fn gathered(
        &self,
        supports: &Supports,
        index: usize,
        equation: &Equation,
    ) -> Result<BTreeMap<usize, Sum>, FemError> {
        let components = supports.components();
        let invalid = |what| {
            Err(FemError::InvalidEquation {
                equation: index,
                what,
            })
        };
        let Some(&(dependent, _)) = equation.terms.first() else {
            return invalid("it has no dofs");
        };
        let mut sums: BTreeMap<usize, Sum> = BTreeMap::new();
        for &(dof, a) in &equation.terms {
            if dof.node >= supports.node_count() || dof.component >= components {
                return invalid("it names a dof that the body does not have");
            }
            if !a.is_finite() {
                return invalid("a coefficient is no finite number");
            }
            sums.entry(dof.full(components)).or_default().add(a);
        }
        if !equation.value.is_finite() {
            return invalid("its right side is no finite number");
        }
        let full = dependent.full(components);
        if sums[&full].cancelled() {
            return invalid("the coefficient of its dependent dof, the first, is zero");
        }
        if supports.at(full).is_some() {
            return Err(FemError::DependentHeld {
                equation: index,
                dof: dependent,
            });
        }
        Ok(sums)
    }

    /// The equations that went into a row, and those that went into theirs, ascending.
    fn implied_by(&self, lower: &[(usize, f64)]) -> Vec<usize> {
        let mut all = BTreeSet::new();
        let mut open: Vec<usize> = lower.iter().map(|&(j, _)| j).collect();
        while let Some(j) = open.pop() {
            if all.insert(j) {
                open.extend(self.reduced[j].lower.iter().map(|&(i, _)| i));
            }
        }
        all.into_iter().collect()
    }

    /// Puts later equations into earlier ones.
    fn resolve(&mut self) {
        let mut rows: Vec<Option<ResolvedRow>> = vec![None; self.reduced.len()];
        for (index, reduced) in self.reduced.iter().enumerate().rev() {
            let mut sums: BTreeMap<usize, Sum> = BTreeMap::new();
            let mut constant = reduced.value / reduced.pivot;
            for &(dof, a) in &reduced.terms {
                let c = -a / reduced.pivot;
                match rows.get(self.equation_of[dof]) {
                    Some(Some(later)) => {
                        constant += c * later.constant;
                        for &(dof, of_later) in &later.terms {
                            sums.entry(dof).or_default().add(c * of_later);
                        }
                    }
                    _ => sums.entry(dof).or_default().add(c),
                }
            }
            sums.retain(|_, sum| !sum.cancelled());
            rows[index] = Some(ResolvedRow {
                dependent: reduced.dependent,
                terms: sums
                    .into_iter()
                    .map(|(dof, sum)| (dof, sum.value))
                    .collect(),
                constant,
            });
        }
        self.rows = rows.into_iter().flatten().collect();
    }

    /// μ with A_Dᵀμ = r_D, for the forces r over the full dofs.
    pub fn multipliers(&self, forces: &[f64]) -> Vec<f64> {
        let mut mu: Vec<f64> = self.reduced.iter().map(|r| forces[r.dependent]).collect();
        for (i, reduced) in self.reduced.iter().enumerate() {
            mu[i] /= reduced.pivot;
            for &(dof, a) in &reduced.terms {
                if self.equation_of[dof] != INDEPENDENT {
                    mu[self.equation_of[dof]] -= a * mu[i];
                }
            }
        }
        for (j, reduced) in self.reduced.iter().enumerate().rev() {
            for &(i, l) in &reduced.lower {
                mu[i] -= l * mu[j];
            }
        }
        mu
    }

    /// What is wrong with an equation whose dependent dof cancelled out; `left` is what did not.
    fn unsolvable(
        &self,
        supports: &Supports,
        index: usize,
        equation: &Equation,
        left: &BTreeMap<usize, Sum>,
        value: Sum,
        lower: &[(usize, f64)],
    ) -> FemError {
        let dofs = equation.terms.iter().map(|&(dof, _)| dof).collect();
        let others = self.implied_by(lower);
        if left.keys().any(|&dof| supports.at(dof).is_none()) {
            let first = self.equation_of[equation.terms[0].0.full(supports.components())];
            if first != INDEPENDENT {
                return FemError::DependentTwice {
                    equations: [first, index],
                    dof: equation.terms[0].0,
                };
            }
            return FemError::EquationCircle {
                equation: index,
                dofs,
                others,
            };
        }
        let mut excess = Sum {
            value: -value.value,
            size: value.size,
        };
        for (&dof, sum) in left {
            excess.add(sum.value * supports.at(dof).unwrap_or(0.0));
        }
        if excess.cancelled() {
            FemError::RedundantEquation {
                equation: index,
                dofs,
                others,
            }
        } else {
            FemError::ContradictoryEquation {
                equation: index,
                dofs,
                others,
                excess: excess.value,
            }
        }
    }
}
