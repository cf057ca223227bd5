//! A problem as the oracles see it, in units in which everything is about 1, and as it is put to the solver.

use tresca::Settings;
use tresca::algebraic::PairLaw;

use super::dense::{self, Cholesky, Rows, block_diagonal, dot, product};

/// A contact problem, dense: min ½uᵀKu − fᵀu + Σ h(Tu − s) over N u ≤ d.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Tangents per pair.
    pub tangents: usize,
    /// K: its diagonal blocks.
    pub stiffness: Vec<Rows>,
    /// N.
    pub normal: Rows,
    /// T, `tangents` rows per pair.
    pub tangential: Rows,
    /// f.
    pub load: Vec<f64>,
    /// d.
    pub gap: Vec<f64>,
    /// s, the slip that counts as none.
    pub origin: Vec<f64>,
    /// One per pair.
    pub laws: Vec<PairLaw>,
}

impl Problem {
    /// m.
    pub fn pairs(&self) -> usize {
        self.normal.len()
    }

    /// n.
    pub fn dofs(&self) -> usize {
        self.load.len()
    }

    /// K.
    pub fn whole(&self) -> Rows {
        block_diagonal(&self.stiffness)
    }

    /// B = [N; T].
    pub fn contact(&self) -> Rows {
        self.normal
            .iter()
            .chain(&self.tangential)
            .cloned()
            .collect()
    }

    /// c = [d; s].
    pub fn shift(&self) -> Vec<f64> {
        [&self.gap[..], &self.origin].concat()
    }

    /// Does any pair follow Coulomb's law?
    pub fn is_coulomb(&self) -> bool {
        self.laws
            .iter()
            .any(|law| matches!(law, PairLaw::Coulomb { .. }))
    }

    /// ½uᵀKu − fᵀu + Σ h(Tu − s), whatever N u is; with Coulomb's law that part is left out.
    pub fn energy(&self, u: &[f64]) -> f64 {
        let elastic = 0.5 * dot(u, &product(&self.whole(), u)) - dot(&self.load, u);
        let slip = product(&self.tangential, u);
        let friction = (0..self.pairs()).map(|pair| {
            let bounds = bounds(&self.laws[pair], 0.0).unwrap_or([0.0; 2]);
            let own = (0..self.tangents).map(|t| {
                let row = self.tangents * pair + t;
                (bounds[t] * (slip[row] - self.origin[row])).powi(2)
            });
            own.sum::<f64>().sqrt()
        });
        elastic + friction.sum::<f64>()
    }

    /// A = B K⁻¹ Bᵀ, b = B K⁻¹ f − c, fᵀK⁻¹f: the dual form. `None` for bodies that float.
    pub fn dual(&self) -> Option<DualForm> {
        let factor = Cholesky::new(&self.whole())?;
        let half: Rows = self
            .contact()
            .iter()
            .map(|row| factor.forward(row))
            .collect();
        let load = factor.forward(&self.load);
        let shift = self.shift();
        Some(DualForm {
            matrix: half.iter().map(|row| product(&half, row)).collect(),
            rhs: half
                .iter()
                .zip(&shift)
                .map(|(row, c)| dot(row, &load) - c)
                .collect(),
            free_work: dot(&load, &load),
        })
    }
}

/// The two slip bounds of a law under a normal force; `None` where nothing slips.
pub fn bounds(law: &PairLaw, normal: f64) -> Option<[f64; 2]> {
    match *law {
        PairLaw::Tresca { bound } | PairLaw::Bilateral { bound } => Some([bound; 2]),
        PairLaw::Orthotropic { bounds } => Some(bounds),
        PairLaw::Coulomb {
            coefficients: [a, b],
            limit,
        } => {
            let most = a.max(b);
            let share = if most > 0.0 {
                normal.max(0.0).min(limit / most)
            } else {
                0.0
            };
            Some([a * share, b * share])
        }
        PairLaw::Tied => None,
        _ => Some([0.0; 2]),
    }
}

/// Does a pair of this law never open?
pub fn is_closed(law: &PairLaw) -> bool {
    matches!(law, PairLaw::Tied | PairLaw::Bilateral { .. })
}

/// min ½ λᵀAλ − λᵀb.
#[derive(Debug, Clone)]
pub struct DualForm {
    /// A.
    pub matrix: Rows,
    /// b.
    pub rhs: Vec<f64>,
    /// fᵀK⁻¹f: the primal energy is −q(λ) less half of it.
    pub free_work: f64,
}

impl DualForm {
    /// q(λ).
    pub fn objective(&self, lambda: &[f64]) -> f64 {
        0.5 * dot(lambda, &product(&self.matrix, lambda)) - dot(lambda, &self.rhs)
    }

    /// B u − c = b − Aλ.
    pub fn relative(&self, lambda: &[f64]) -> Vec<f64> {
        let mut relative = self.rhs.clone();
        dense::add(&mut relative, -1.0, &product(&self.matrix, lambda));
        relative
    }
}

/// In which form a problem is put to the solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// K, B, f, d.
    Primal,
    /// A and b.
    Dual,
}

/// Units, as powers of two, so that nothing is rounded.
#[derive(Debug, Clone, PartialEq)]
pub struct Units {
    /// Of K.
    pub stiffness: i32,
    /// Of u.
    pub length: i32,
    /// Of the normal row and of the tangential rows of each pair.
    pub rows: Vec<[i32; 2]>,
}

impl Units {
    /// Those of the problem itself.
    pub fn none(pairs: usize) -> Self {
        Self {
            stiffness: 0,
            length: 0,
            rows: vec![[0; 2]; pairs],
        }
    }

    /// What u is multiplied by.
    pub fn of_length(&self) -> f64 {
        2_f64.powi(self.length)
    }

    /// What K is multiplied by.
    pub fn of_stiffness(&self) -> f64 {
        2_f64.powi(self.stiffness)
    }

    /// What each row of B = [N; T] is multiplied by.
    pub fn of_rows(&self, tangents: usize) -> Vec<f64> {
        let normal = self.rows.iter().map(|row| row[0]);
        let tangential = self
            .rows
            .iter()
            .flat_map(|row| std::iter::repeat_n(row[1], tangents));
        normal.chain(tangential).map(|e| 2_f64.powi(e)).collect()
    }

    /// The problem in these units.
    pub fn of(&self, problem: &Problem) -> Problem {
        let (k, l) = (self.of_stiffness(), self.of_length());
        let (m, tangents) = (problem.pairs(), problem.tangents);
        let rows = self.of_rows(tangents);
        let (normal, tangential) = rows.split_at(m);
        let times = |s: f64, row: &Vec<f64>| row.iter().map(|x| s * x).collect::<Vec<f64>>();
        let law = |pair: usize| {
            let [n, t] = self.rows[pair].map(|e| 2_f64.powi(e));
            let force = k * l / t;
            match problem.laws[pair] {
                PairLaw::Tresca { bound } => PairLaw::Tresca {
                    bound: force * bound,
                },
                PairLaw::Bilateral { bound } => PairLaw::Bilateral {
                    bound: force * bound,
                },
                PairLaw::Orthotropic { bounds } => PairLaw::Orthotropic {
                    bounds: bounds.map(|g| force * g),
                },
                PairLaw::Coulomb {
                    coefficients,
                    limit,
                } => PairLaw::Coulomb {
                    coefficients: coefficients.map(|f| f * n / t),
                    limit: force * limit,
                },
                other => other,
            }
        };
        Problem {
            tangents,
            stiffness: problem
                .stiffness
                .iter()
                .map(|block| block.iter().map(|row| times(k, row)).collect())
                .collect(),
            normal: problem
                .normal
                .iter()
                .zip(normal)
                .map(|(row, s)| times(*s, row))
                .collect(),
            tangential: problem
                .tangential
                .iter()
                .zip(tangential)
                .map(|(row, s)| times(*s, row))
                .collect(),
            load: times(k * l, &problem.load),
            gap: problem
                .gap
                .iter()
                .zip(normal)
                .map(|(d, s)| d * s * l)
                .collect(),
            origin: problem
                .origin
                .iter()
                .zip(tangential)
                .map(|(d, s)| d * s * l)
                .collect(),
            laws: (0..m).map(law).collect(),
        }
    }
}

/// A problem, and how it is put to the solver.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// What the oracles are asked.
    pub truth: Problem,
    /// What the solver is asked, where that differs from the truth by rounding on purpose.
    pub noisy: Option<Problem>,
    /// In which form.
    pub form: Form,
    /// In which units.
    pub units: Units,
    /// With which settings.
    pub settings: Settings,
    /// The method has no guarantee to converge here: that it says so is no fault.
    pub may_give_up: bool,
    /// Rounding may leave the answer undetermined: that it is said to be inaccurate is no fault.
    pub ill_determined: bool,
}

impl Drawn {
    /// As it is, with default settings.
    pub fn plain(truth: Problem) -> Self {
        Self {
            units: Units::none(truth.pairs()),
            truth,
            noisy: None,
            form: Form::Primal,
            settings: Settings::default(),
            may_give_up: false,
            ill_determined: false,
        }
    }

    /// The same by A and b.
    #[must_use]
    pub fn dual(mut self) -> Self {
        self.form = Form::Dual;
        self
    }

    /// What the solver is asked, in the units of the truth.
    pub fn posed(&self) -> &Problem {
        self.noisy.as_ref().unwrap_or(&self.truth)
    }
}
