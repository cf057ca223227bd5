//! From what pairs may do to the convex sets of the dual problem.
//!
//! λ = \[λν (m); λτ ((d−1) m)\]. An ellipse of friction becomes a disc by λτ = diag(w1, w2) μτ, the larger
//! weight being 1 (docs/theory.md, "Orthotropic friction"): the solver's unknown is μ, everyone else's is λ.
//! A direction in which supports let a pair not move carries no force.

use tresca_contact::{Mobility, Opening, Sliding};
use tresca_qcqp::sets::{Block, BlockSet, BlockState, Disc, HalfLine, Interval, Line, Origin};
use tresca_qcqp::{ActiveSet, CoulombBound, ProductSet, QcqpError};

/// How the tangential unknowns of a pair are constrained.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    /// One disc for both (or, where the two bounds have a ratio, for both after weighting).
    Disc,
    /// Each for itself: in the plane, on symmetry planes, and where one of two bounds is zero.
    Separate,
}

/// The blocks of one pair.
#[derive(Debug, Clone, Copy, PartialEq)]
struct PairBlocks {
    opening: Opening,
    mobility: Mobility,
    shape: Shape,
    /// Number of its first tangential block.
    first_tangential: usize,
}

/// Where every pair stands in λ and in Λ. The same for all load steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    tangents: usize,
    pairs: Vec<PairBlocks>,
    weights: Vec<f64>,
    /// What the rows of N, and both rows of T of a pair, are multiplied by; part of the weights.
    scales: Vec<[f64; 2]>,
}

impl Layout {
    /// The layout for pairs in `dimension` dimensions (1: there are no tangents), each with how it opens,
    /// moves and slides.
    pub fn new(
        dimension: usize,
        pairs: impl Iterator<Item = (Opening, Mobility, Sliding)>,
    ) -> Self {
        let tangents = dimension - 1;
        let mut blocks = Vec::new();
        let mut tangential_weights = Vec::new();
        let mut tangential_blocks = 0;
        for (opening, mobility, sliding) in pairs {
            let axes = semi_axes(&sliding);
            let shape = match axes {
                _ if tangents < 2 || mobility.tangents != [true; 2] => Shape::Separate,
                None => Shape::Separate,
                Some([a, b]) if (a == 0.0) != (b == 0.0) => Shape::Separate,
                Some(_) => Shape::Disc,
            };
            let weights = match (shape, axes) {
                (Shape::Disc, Some([a, b])) if a != b => [a / a.max(b), b / a.max(b)],
                _ => [1.0; 2],
            };
            tangential_weights.extend_from_slice(&weights[..tangents]);
            blocks.push(PairBlocks {
                opening,
                mobility,
                shape,
                first_tangential: tangential_blocks,
            });
            tangential_blocks += match shape {
                Shape::Disc => 1,
                Shape::Separate => tangents,
            };
        }
        // The normal blocks stand before them.
        let normals = blocks.len();
        for pair in &mut blocks {
            pair.first_tangential += normals;
        }
        let mut weights = vec![1.0; normals];
        weights.extend(tangential_weights);
        Self {
            tangents,
            scales: vec![[1.0; 2]; normals],
            pairs: blocks,
            weights,
        }
    }

    /// The same with other units for the forces of every pair: the row of N, and the rows of T, times these
    /// factors. Rows of very different length are brought to one.
    pub fn with_scales(mut self, scales: Vec<[f64; 2]>) -> Self {
        let m = self.pairs.len();
        for (i, [normal, tangential]) in scales.iter().enumerate() {
            self.weights[i] *= normal;
            let first = m + self.tangents * i;
            self.weights[first..first + self.tangents]
                .iter_mut()
                .for_each(|w| *w *= tangential);
        }
        self.scales = scales;
        self
    }

    /// Number by which relative displacements of a pair, along the normal and along the tangents, are displacements:
    /// 1 unless the rows of B have very different lengths.
    pub(crate) fn scale(&self, pair: usize) -> [f64; 2] {
        self.scales[pair]
    }

    /// The largest of some gaps, as a displacement.
    pub(crate) fn largest_gap(&self, gaps: &[f64]) -> f64 {
        let scaled = gaps
            .iter()
            .zip(&self.scales)
            .map(|(d, [s, _])| (s * d).abs());
        scaled.fold(0.0, f64::max)
    }

    /// Whether pairs stand where they stand in the other.
    pub fn same_blocks(&self, other: &Self) -> bool {
        let own = self.weights.iter().zip(&other.weights);
        let proportions = |layout: &Self, i: usize| {
            let pair = i.saturating_sub(layout.pairs.len()) / layout.tangents.max(1);
            layout.weights[i] / layout.scales[pair][1]
        };
        let m = self.pairs.len();
        self.pairs == other.pairs
            && own.len() == other.weights.len()
            && (m..self.weights.len())
                .all(|i| (proportions(self, i) - proportions(other, i)).abs() <= 1e-14)
    }

    /// m.
    pub fn pair_count(&self) -> usize {
        self.pairs.len()
    }

    /// Number of unknowns, d m.
    pub fn unknowns(&self) -> usize {
        self.weights.len()
    }

    /// The weights w of λ = diag(w) μ.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// λ ↦ μ or back: `apply` is * or /.
    fn weighted(&self, values: &[f64], apply: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let pairs = values.iter().zip(&self.weights);
        pairs.map(|(&x, &w)| apply(x, w)).collect()
    }

    /// λ = diag(w) μ.
    pub fn forces(&self, mu: &[f64]) -> Vec<f64> {
        self.weighted(mu, |x, w| x * w)
    }

    /// μ of λ = diag(w) μ.
    pub fn unknowns_of(&self, forces: &[f64]) -> Vec<f64> {
        self.weighted(forces, |x, w| x / w)
    }

    /// diag(w) x of a relative displacement x = B u: what μ is dual to.
    pub fn dual(&self, relative: &[f64]) -> Vec<f64> {
        self.weighted(relative, |x, w| x * w)
    }

    /// The tangential unknowns of a pair as two components, zero where there is no such tangent.
    pub fn tangential(&self, values: &[f64], pair: usize) -> [f64; 2] {
        let first = self.pairs.len() + self.tangents * pair;
        std::array::from_fn(|t| {
            if t < self.tangents {
                values[first + t]
            } else {
                0.0
            }
        })
    }

    /// Number of tangents of a pair: 1 in the plane, 2 in space, 0 without any.
    pub fn tangents(&self) -> usize {
        self.tangents
    }

    /// Whether a pair can move along its normal at all.
    pub fn moves_normally(&self, pair: usize) -> bool {
        self.pairs[pair].mobility.normal
    }

    /// The unknowns along which supports let a pair not move: no force acts there.
    pub(crate) fn immobile(&self) -> impl Iterator<Item = usize> {
        let m = self.pairs.len();
        self.pairs.iter().enumerate().flat_map(move |(i, pair)| {
            let normal = (!pair.mobility.normal).then_some(i);
            let held = (0..self.tangents).filter(|&t| !pair.mobility.tangents[t]);
            let tangents = held.map(move |t| m + self.tangents * i + t);
            normal.into_iter().chain(tangents)
        })
    }

    /// Whether the law keeps a pair from opening.
    pub fn never_opens(&self, pair: usize) -> bool {
        self.pairs[pair].opening == Opening::Never
    }

    /// The tangential unknowns (numbers in λ) that incremental friction speaks of: not those that are
    /// glued.
    pub fn frictional<'a>(&'a self, slidings: &'a [Sliding]) -> impl Iterator<Item = usize> + 'a {
        let m = self.pairs.len();
        let bounded = (0..m).filter(|&i| slidings[i] != Sliding::Never);
        bounded.flat_map(move |i| (0..self.tangents).map(move |t| m + self.tangents * i + t))
    }

    /// Λ for the given laws, pair by pair. Coulomb bounds start at 0.
    ///
    /// # Errors
    /// When a bound is no number ≥ 0.
    pub fn set(&self, slidings: &[Sliding]) -> Result<ProductSet, QcqpError> {
        let m = self.pairs.len();
        let normals = self.pairs.iter().enumerate().map(|(start, pair)| Block {
            start,
            set: match pair.opening {
                _ if !pair.mobility.normal => ORIGIN,
                Opening::Unilateral => BlockSet::HalfLine(HalfLine),
                Opening::Never => BlockSet::Line(Line),
            },
        });
        let tangentials =
            self.pairs
                .iter()
                .zip(slidings)
                .enumerate()
                .flat_map(|(i, (pair, sliding))| {
                    let first = m + self.tangents * i;
                    let [_, tangential] = self.scales[i];
                    let bounds = sliding.scaled(1.0 / tangential).bounds(0.0);
                    match (pair.shape, bounds) {
                        (Shape::Disc, Some([a, b])) => vec![Block {
                            start: first,
                            set: BlockSet::Disc(Disc { bound: a.max(b) }),
                        }],
                        _ => (0..self.tangents)
                            .map(|t| Block {
                                start: first + t,
                                set: match bounds {
                                    _ if !pair.mobility.tangents[t] => ORIGIN,
                                    None => BlockSet::Line(Line),
                                    Some(bounds) => {
                                        BlockSet::Interval(Interval { bound: bounds[t] })
                                    }
                                },
                            })
                            .collect(),
                    }
                });
        ProductSet::new(self.unknowns(), normals.chain(tangentials).collect())
    }

    /// The blocks whose bound follows the normal force.
    pub fn coulomb(&self, slidings: &[Sliding]) -> Vec<CoulombBound> {
        let mut bounds = Vec::new();
        for (normal, (pair, sliding)) in self.pairs.iter().zip(slidings).enumerate() {
            let Sliding::Coulomb {
                coefficients,
                limit,
            } = *sliding
            else {
                continue;
            };
            let largest = coefficients[0].max(coefficients[1]);
            let [own, tangential] = self.scales[normal];
            let (along, limit) = (own / tangential, limit / tangential);
            let mut push = |block: usize, coefficient: f64| {
                let share = if largest > 0.0 {
                    coefficient / largest
                } else {
                    1.0
                };
                // 0 · ∞ is no number: without a limit every axis is without one.
                let limit = if limit.is_finite() {
                    share * limit
                } else {
                    limit
                };
                bounds.push(CoulombBound {
                    block,
                    normal,
                    coefficient: along * coefficient,
                    limit,
                });
            };
            match pair.shape {
                Shape::Disc => push(pair.first_tangential, largest),
                Shape::Separate => {
                    for t in (0..self.tangents).filter(|&t| pair.mobility.tangents[t]) {
                        push(pair.first_tangential + t, coefficients[t]);
                    }
                }
            }
        }
        bounds
    }

    /// Whether a pair carries a normal force, and whether it sticks, by the states of its blocks.
    pub fn state(&self, active: &ActiveSet, pair: usize) -> (bool, bool) {
        let states = active.states();
        let own = &self.pairs[pair];
        let stick = match own.shape {
            Shape::Disc => states[own.first_tangential] == BlockState::Free,
            // Without tangents there is nothing that holds.
            Shape::Separate if self.tangents == 0 => false,
            Shape::Separate => (0..self.tangents)
                .filter(|&t| own.mobility.tangents[t])
                .all(|t| states[own.first_tangential + t] == BlockState::Free),
        };
        (states[pair] == BlockState::Free, stick)
    }
}

/// An unknown that is always zero.
const ORIGIN: BlockSet = BlockSet::Origin(Origin);

/// The proportions of the ellipse, `None` where nothing slides.
fn semi_axes(sliding: &Sliding) -> Option<[f64; 2]> {
    match *sliding {
        Sliding::Never => None,
        Sliding::Bounded(bounds) => Some(bounds),
        Sliding::Coulomb { coefficients, .. } => Some(coefficients),
    }
}
