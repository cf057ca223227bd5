//! The contact forces that can be attained: the set in which a load must find its equilibrium.

use crate::coulomb::law::CoulombLaw;
use crate::sets::block::{Block, BlockSet};
use crate::sets::convex_set::ConvexSet;
use crate::sets::product::ProductSet;

/// Bounds from here on mean that nothing slips.
const UNBOUNDED: f64 = 1e290;

/// Λ, or what takes its place while the slip bounds are not known: with Coulomb's law every
/// friction block and its normal force make the convex set ‖t‖ ≤ min(F n, limit).
pub(crate) struct AttainableForces {
    pieces: Vec<Piece>,
}

/// One factor of the set.
pub(super) enum Piece {
    /// A block of Λ.
    Block(Block),
    /// A normal force and the friction that it allows.
    Cone {
        normal: usize,
        friction: Block,
        coefficient: f64,
        limit: f64,
    },
}

impl AttainableForces {
    /// The friction cones of the law where there is one, else Λ with its bounds as they are.
    pub fn new(set: &ProductSet, law: Option<&CoulombLaw>) -> Self {
        law.map_or_else(|| Self::frozen(set), |law| Self::cones(set, law))
    }

    fn frozen(set: &ProductSet) -> Self {
        Self {
            pieces: set.blocks().iter().map(|&b| Piece::Block(b)).collect(),
        }
    }

    /// The friction cones of the law, where a half-line holds the normal force and no other cone
    /// has it; the rest is as in Λ. A friction block whose normal force is spoken for, or may
    /// pull, is left unbounded: the set may be too large, never too small.
    fn cones(set: &ProductSet, law: &CoulombLaw) -> Self {
        let blocks = set.blocks();
        let mut taken = vec![false; blocks.len()];
        let mut pieces = Vec::new();
        for bound in law.bounds_of_blocks() {
            let half_line = blocks
                .iter()
                .position(|b| b.start == bound.normal && matches!(b.set, BlockSet::HalfLine(_)))
                .filter(|&number| !taken[number]);
            taken[bound.block] = true;
            let mut friction = blocks[bound.block];
            if let Some(number) = half_line {
                taken[number] = true;
                pieces.push(Piece::Cone {
                    normal: bound.normal,
                    friction,
                    coefficient: bound.coefficient,
                    limit: bound.limit,
                });
            } else {
                friction.set = friction.set.with_bound(2.0 * UNBOUNDED);
                pieces.push(Piece::Block(friction));
            }
        }
        let rest = blocks.iter().zip(&taken).filter(|(_, taken)| !**taken);
        pieces.extend(rest.map(|(&block, _)| Piece::Block(block)));
        Self { pieces }
    }

    /// The same set with so much of every bound on friction.
    pub fn with_less_friction(&self, share: f64) -> Self {
        let shrunk = |piece: &Piece| match *piece {
            Piece::Block(mut block) => {
                if let Some(bound) = block.set.bound() {
                    block.set = block.set.with_bound(share * bound);
                }
                Piece::Block(block)
            }
            Piece::Cone {
                normal,
                friction,
                coefficient,
                limit,
            } => Piece::Cone {
                normal,
                friction,
                coefficient: share * coefficient,
                limit: share * limit,
            },
        };
        Self {
            pieces: self.pieces.iter().map(shrunk).collect(),
        }
    }

    /// Its factors.
    pub(super) fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// y ← the nearest point of the set.
    pub fn project(&self, y: &mut [f64]) {
        for piece in &self.pieces {
            match *piece {
                Piece::Block(block) => block.set.project(&mut y[block.range()]),
                Piece::Cone {
                    normal,
                    friction,
                    coefficient,
                    limit,
                } => {
                    let (n, t) = project_on_cone(
                        y[normal],
                        length(&y[friction.range()]),
                        coefficient,
                        limit,
                    );
                    y[normal] = n;
                    rescale(&mut y[friction.range()], t);
                }
            }
        }
    }

    /// h ← the derivative of the projection at y, applied to h.
    pub fn slant(&self, y: &[f64], h: &mut [f64]) {
        for piece in &self.pieces {
            match *piece {
                Piece::Block(block) => block.set.slant(&y[block.range()], &mut h[block.range()]),
                Piece::Cone {
                    normal,
                    friction,
                    coefficient,
                    limit,
                } => slant_on_cone(y, h, normal, friction, coefficient, limit),
            }
        }
    }

    /// sup wᵀλ over the set, where a force without limit that is driven with w > 0 counts
    /// `unlimited(w, length)`: the length is that of its column, given the lengths of all `columns`.
    pub fn support(&self, w: &[f64], columns: &[f64], unlimited: impl Fn(f64, f64) -> f64) -> f64 {
        let unlimited = |driven: f64, length: f64| {
            if driven > 0.0 {
                unlimited(driven, length)
            } else {
                0.0
            }
        };
        let of_piece = |piece: &Piece| match *piece {
            Piece::Block(block) => {
                let size = length(&w[block.range()]);
                let column = length(&columns[block.range()]);
                match block.set {
                    BlockSet::HalfLine(_) => unlimited(w[block.start], column),
                    BlockSet::Line(_) => unlimited(size, column),
                    BlockSet::Origin(_) => 0.0,
                    BlockSet::Interval(_) | BlockSet::Disc(_) => match block.set.bound() {
                        Some(bound) if bound < UNBOUNDED => bound * size,
                        _ => unlimited(size, column),
                    },
                }
            }
            Piece::Cone {
                normal,
                friction,
                coefficient,
                limit,
            } => {
                let alone = unlimited(w[normal], columns[normal]);
                // Per unit of friction: n = t/F, or n free to grow where the cap holds.
                let along = coefficient * length(&w[friction.range()]) + w[normal];
                let column = coefficient * length(&columns[friction.range()]) + columns[normal];
                if limit.is_infinite() {
                    unlimited(along, column)
                } else if coefficient == 0.0 {
                    alone
                } else {
                    limit * along.max(0.0) / coefficient + alone
                }
            }
        };
        self.pieces.iter().map(of_piece).sum()
    }
}

fn length(x: &[f64]) -> f64 {
    match *x {
        [x] => x.abs(),
        [x, y] => x.hypot(y),
        _ => 0.0,
    }
}

/// x scaled to length t.
fn rescale(x: &mut [f64], t: f64) {
    let now = length(x);
    if now > t {
        x.iter_mut().for_each(|x| *x *= t / now);
    }
}

/// The nearest (n, t) with 0 ≤ t ≤ min(F n, limit), for t ≥ 0.
fn project_on_cone(n: f64, t: f64, coefficient: f64, limit: f64) -> (f64, f64) {
    let (mut near_n, mut near_t) = (n, t);
    if t > coefficient * n {
        let s = f64::max(
            (n + coefficient * t) / (1.0 + coefficient * coefficient),
            0.0,
        );
        (near_n, near_t) = (s, coefficient * s);
    }
    if near_t > limit {
        // On the face t = limit; the edge where it meets the cone is at n = limit/F.
        (near_n, near_t) = (n.max(limit / coefficient), limit);
    }
    (near_n, near_t)
}

fn slant_on_cone(
    y: &[f64],
    h: &mut [f64],
    normal: usize,
    friction: Block,
    coefficient: f64,
    limit: f64,
) {
    let range = friction.range();
    let (n, t) = (y[normal], length(&y[range.clone()]));
    let (near_n, near_t) = project_on_cone(n, t, coefficient, limit);
    if near_n == n && near_t == t {
        return;
    }
    let unit: Vec<f64> = y[range.clone()]
        .iter()
        .map(|y| if t > 0.0 { y / t } else { 0.0 })
        .collect();
    let radial: f64 = unit.iter().zip(&h[range.clone()]).map(|(u, h)| u * h).sum();
    // How length and normal force of the projection change.
    let (change_n, change_t) = if near_n == 0.0 && near_t == 0.0 {
        (0.0, 0.0)
    } else if near_t == limit {
        (if near_n == n { h[normal] } else { 0.0 }, 0.0)
    } else {
        let along = (h[normal] + coefficient * radial) / (1.0 + coefficient * coefficient);
        (along, coefficient * along)
    };
    let turn = if t > 0.0 { near_t / t } else { 0.0 };
    h[normal] = change_n;
    for (u, h) in unit.iter().zip(&mut h[range]) {
        *h = change_t * u + turn * (*h - radial * u);
    }
}
