//! How near do forces in a product of convex sets come to a load? Asked of an interior-point solver
//! (Clarabel).
//!
//! ```text
//! min s   over λ in the sets   subject to   ‖e − Gλ‖ ≤ s
//! ```
//!
//! always has an answer, whether there is an equilibrium or not. The multiplier of the last line is a v,
//! ‖v‖ ≤ 1, with eᵀv − sup λᵀGᵀv = s: where s > 0 it proves that no forces in the sets carry the load. The
//! distance is good to some eight digits, λ and v to fewer, and nothing is guaranteed: whoever asked has to
//! check the answer.

use super::attainable::{AttainableForces, Piece};
use crate::sets::block::BlockSet;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SupportedConeT,
    SupportedConeT::{NonnegativeConeT, SecondOrderConeT, ZeroConeT},
};
use tresca_la::vector::norm;

/// What is asked for; the solver ends before where it makes no progress, and says what it has.
const TOLERANCE: f64 = 1e-13;
const MAX_ITERATIONS: u32 = 200;
/// A bound of so many times the force that carries the load alone is left out.
const FAR: f64 = 1e6;

/// G by columns, of which only nonzero entries (row, value) are stored, and e.
#[derive(Clone, Copy)]
pub(super) struct Question<'a> {
    pub columns: &'a [Vec<(usize, f64)>],
    pub load: &'a [f64],
    pub reach: &'a AttainableForces,
}

/// The forces that come nearest, and the direction that remains.
pub(super) struct Nearest {
    /// λ, in the sets up to the solver's accuracy.
    pub lambda: Vec<f64>,
    /// v.
    pub motion: Vec<f64>,
}

/// The solver's answer; `None` when it has none that is finite, or there is no load.
pub(super) fn nearest(question: &Question) -> Option<Nearest> {
    let &Question {
        columns,
        load,
        reach,
    } = question;
    let size = norm(load);
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let (dim, rows) = (columns.len(), load.len());
    let scales = scales(columns, reach, size);
    let mut cones = Cones::of(reach, &scales, dim + 1);
    // (s, e − Gλ) in the second-order cone.
    let first = cones.rhs.len();
    cones.entries[dim].push((first, -1.0));
    cones.rhs.push(0.0);
    cones.rhs.extend(load.iter().map(|e| e / size));
    cones.kinds.push(SecondOrderConeT(rows + 1));
    for (i, column) in columns.iter().enumerate() {
        let scaled = column
            .iter()
            .map(|&(row, value)| (first + 1 + row, value * scales[i] / size));
        cones.entries[i].extend(scaled);
    }
    let mut cost = vec![0.0; dim + 1];
    cost[dim] = 1.0;
    let settings = DefaultSettings {
        verbose: false,
        max_iter: MAX_ITERATIONS,
        tol_gap_abs: TOLERANCE,
        tol_gap_rel: TOLERANCE,
        tol_feas: TOLERANCE,
        ..DefaultSettings::default()
    };
    let Cones {
        entries,
        rhs,
        kinds,
    } = cones;
    let matrix = compressed(rhs.len(), entries);
    let nothing = CscMatrix::zeros((dim + 1, dim + 1));
    let mut solver = DefaultSolver::new(&nothing, &cost, &matrix, &rhs, &kinds, settings).ok()?;
    solver.solve();
    let (x, z) = (&solver.solution.x, &solver.solution.z);
    let lambda: Vec<f64> = x.iter().zip(&scales).map(|(x, scale)| x * scale).collect();
    let motion: Vec<f64> = z.get(first + 1..)?.iter().map(|z| -z).collect();
    let finite = lambda.iter().chain(&motion).all(|value| value.is_finite());
    finite.then_some(Nearest { lambda, motion })
}

/// The unit of every force: what it takes to carry the load alone, or its bound where that is less. A disc
/// has one for both of its components.
fn scales(columns: &[Vec<(usize, f64)>], reach: &AttainableForces, size: f64) -> Vec<f64> {
    let alone = |range: std::ops::Range<usize>| {
        let squares = columns[range]
            .iter()
            .flatten()
            .map(|(_, value)| value * value);
        let length = squares.sum::<f64>().sqrt();
        if length > 0.0 { size / length } else { size }
    };
    let mut scales = vec![1.0; columns.len()];
    for piece in reach.pieces() {
        match *piece {
            Piece::Block(block) => {
                let mut scale = alone(block.range());
                if let Some(bound) = block.set.bound().filter(|&bound| bound > 0.0) {
                    scale = scale.min(bound);
                }
                scales[block.range()].fill(scale);
            }
            Piece::Cone {
                normal, friction, ..
            } => {
                scales[normal] = alone(normal..normal + 1);
                scales[friction.range()].fill(alone(friction.range()));
            }
        }
    }
    scales
}

/// h − Mx in a product of cones, M by columns.
struct Cones {
    entries: Vec<Vec<(usize, f64)>>,
    rhs: Vec<f64>,
    kinds: Vec<SupportedConeT<f64>>,
}

impl Cones {
    /// That the first of so many unknowns, times their scales, are in reach.
    fn of(reach: &AttainableForces, scales: &[f64], unknowns: usize) -> Self {
        let mut cones = Self {
            entries: vec![Vec::new(); unknowns],
            rhs: Vec::new(),
            kinds: Vec::new(),
        };
        for piece in reach.pieces() {
            match *piece {
                Piece::Block(block) => {
                    let first = block.start;
                    let bound = block.set.bound().map(|bound| bound / scales[first]);
                    match block.set {
                        BlockSet::Line(_) => {}
                        BlockSet::HalfLine(_) => cones.at_least(0.0, first),
                        BlockSet::Origin(_) => cones.none(block.range()),
                        BlockSet::Interval(_) | BlockSet::Disc(_) => match bound {
                            Some(0.0) => cones.none(block.range()),
                            Some(bound) if bound < FAR => cones.within(bound, None, block.range()),
                            _ => {}
                        },
                    }
                }
                Piece::Cone {
                    normal,
                    friction,
                    coefficient,
                    limit,
                } => {
                    let range = friction.range();
                    let unit = scales[friction.start];
                    cones.at_least(0.0, normal);
                    if coefficient == 0.0 || limit == 0.0 {
                        cones.none(range);
                        continue;
                    }
                    let steepness = coefficient * scales[normal] / unit;
                    cones.within(0.0, Some((normal, steepness)), range.clone());
                    if limit / unit < FAR {
                        cones.within(limit / unit, None, range);
                    }
                }
            }
        }
        cones
    }

    /// x ≥ least.
    fn at_least(&mut self, least: f64, unknown: usize) {
        self.entries[unknown].push((self.rhs.len(), -1.0));
        self.rhs.push(-least);
        self.kinds.push(NonnegativeConeT(1));
    }

    /// x = 0.
    fn none(&mut self, unknowns: std::ops::Range<usize>) {
        for unknown in unknowns {
            self.entries[unknown].push((self.rhs.len(), 1.0));
            self.rhs.push(0.0);
            self.kinds.push(ZeroConeT(1));
        }
    }

    /// ‖x‖ ≤ bound, or bound + coefficient · another unknown.
    fn within(&mut self, bound: f64, more: Option<(usize, f64)>, unknowns: std::ops::Range<usize>) {
        let row = |cones: &mut Self| {
            if let Some((unknown, coefficient)) = more {
                cones.entries[unknown].push((cones.rhs.len(), -coefficient));
            }
            cones.rhs.push(bound);
        };
        if unknowns.len() == 1 {
            for sign in [1.0, -1.0] {
                self.entries[unknowns.start].push((self.rhs.len(), sign));
                row(self);
            }
            self.kinds.push(NonnegativeConeT(2));
            return;
        }
        self.kinds.push(SecondOrderConeT(1 + unknowns.len()));
        row(self);
        for unknown in unknowns {
            self.entries[unknown].push((self.rhs.len(), -1.0));
            self.rhs.push(0.0);
        }
    }
}

fn compressed(rows: usize, columns: Vec<Vec<(usize, f64)>>) -> CscMatrix<f64> {
    let mut starts = vec![0];
    let (mut indices, mut values) = (Vec::new(), Vec::new());
    for mut column in columns {
        column.sort_unstable_by_key(|&(row, _)| row);
        for (row, value) in column {
            indices.push(row);
            values.push(value);
        }
        starts.push(indices.len());
    }
    CscMatrix::new(rows, starts.len() - 1, starts, indices, values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::law::{CoulombBound, CoulombLaw};
    use crate::sets::block::Block;
    use crate::sets::product::ProductSet;
    use crate::sets::{Disc, HalfLine, Interval, Line, Origin};
    use tresca_la::vector::dot;

    /// Every kind of block, with bounds of many sizes.
    fn set(size: f64) -> ProductSet {
        let mut start = 0;
        let sets = [
            BlockSet::HalfLine(HalfLine),
            BlockSet::Interval(Interval { bound: 0.5 * size }),
            BlockSet::HalfLine(HalfLine),
            BlockSet::Disc(Disc { bound: 0.1 * size }),
            BlockSet::Line(Line),
            BlockSet::Origin(Origin),
            BlockSet::Disc(Disc { bound: 0.0 }),
            BlockSet::Interval(Interval { bound: 1e3 * size }),
            BlockSet::Interval(Interval { bound: 1e300 }),
        ];
        let blocks = sets.map(|set| {
            let block = Block { start, set };
            start = block.range().end;
            block
        });
        ProductSet::new(start, blocks.to_vec()).unwrap()
    }

    fn identity(dim: usize) -> Vec<Vec<(usize, f64)>> {
        (0..dim).map(|i| vec![(i, 1.0)]).collect()
    }

    /// Numbers that look random, between −1 and 1.
    fn numbers(count: usize, seed: u64) -> Vec<f64> {
        let sine =
            |i: usize| (((seed * 97 + 13) as f64) * (i as f64 + 1.0) * 12.9898).sin() * 43758.5453;
        (0..count)
            .map(|i| 2.0 * (sine(i) - sine(i).floor()) - 1.0)
            .collect()
    }

    fn assert_nearest(set: &ProductSet, law: Option<&CoulombLaw>, size: f64) {
        let reach = AttainableForces::new(set, law);
        let dim = set.dimension();
        for seed in 0..40 {
            let load: Vec<f64> = numbers(dim, seed).iter().map(|x| x * size).collect();
            let mut nearest_point = load.clone();
            reach.project(&mut nearest_point);
            let remains: Vec<f64> = load
                .iter()
                .zip(&nearest_point)
                .map(|(e, x)| e - x)
                .collect();
            let distance = norm(&remains);
            let columns = identity(dim);
            let Nearest { lambda, motion } = nearest(&Question {
                columns: &columns,
                load: &load,
                reach: &reach,
            })
            .unwrap();
            for (found, right) in lambda.iter().zip(&nearest_point) {
                assert!(
                    (found - right).abs() <= 1e-4 * size,
                    "{seed}: {found:e} and {right:e}"
                );
            }
            for (found, right) in motion.iter().zip(&remains) {
                assert!(
                    (found - right / distance).abs() <= 1e-4,
                    "{seed}: {found:e}"
                );
            }
            let held = reach.support(&motion, &vec![1.0; dim], |driven, _| driven * size);
            let proved = dot(&load, &motion) - held;
            assert!(
                (proved - distance).abs() <= 1e-6 * size,
                "{seed}: {proved:e}, {distance:e}"
            );
        }
    }

    #[test]
    fn with_the_identity_the_answer_is_the_projection() {
        for size in [1e-9, 1.0, 1e9] {
            assert_nearest(&set(size), None, size);
            for limit in [f64::INFINITY, 0.05 * size] {
                let set = set(size);
                let bounds =
                    [(1, 0, 0.4), (3, 2, 1.3)].map(|(block, number, coefficient)| CoulombBound {
                        block,
                        normal: set.blocks()[number].start,
                        coefficient,
                        limit,
                    });
                let law = CoulombLaw::new(bounds.to_vec(), &set).unwrap();
                assert_nearest(&set, Some(&law), size);
            }
        }
    }

    #[test]
    fn what_can_be_carried_leaves_nothing() {
        // Two feet under a beam, of which the load is nearer to one: λ = (3/4, 1/4) times the load.
        let set = ProductSet::contact_2d(&[0.0, 0.0]).unwrap();
        let reach = AttainableForces::new(&set, None);
        let columns = [vec![(0, 1.0)], vec![(0, 1.0), (1, 4.0)], vec![], vec![]];
        let load = [8.0, 8.0];
        let question = Question {
            columns: &columns,
            load: &load,
            reach: &reach,
        };
        let Nearest { lambda, .. } = nearest(&question).unwrap();
        assert!((lambda[0] - 6.0).abs() <= 1e-7 && (lambda[1] - 2.0).abs() <= 1e-7);
        // Beyond the feet it tips, about the outer one.
        let beyond = [8.0, 40.0];
        let Nearest { motion, .. } = nearest(&Question {
            load: &beyond,
            ..question
        })
        .unwrap();
        assert!((motion[0] / motion[1] + 4.0).abs() <= 1e-6 && motion[1] > 0.0);
        assert!(
            nearest(&Question {
                load: &[0.0, 0.0],
                ..question
            })
            .is_none()
        );
    }
}
