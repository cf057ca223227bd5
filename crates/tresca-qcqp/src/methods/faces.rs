//! What GRSSN does where the projection of its Newton point raises q: binding the blocks that left Λ, and
//! walking from face to face.

use super::run::Run;
use crate::active_set::ActiveSet;
use crate::point::Point;
use crate::sets::block::{Block, BlockSet};
use crate::sets::convex_set::BlockState;
use crate::sets::product::ProductSet;

/// Times that blocks which left Λ are bound and the system is solved again, in one step.
const MAX_PIVOTS: usize = 10;
/// Newton systems that are solved in one step on the walk from face to face.
const MAX_FACES: usize = 30;
/// Halvings of a Newton step before it is cut where it leaves Λ.
const MAX_HALVINGS: usize = 3;

/// The projection of the Newton point, if it does not raise q above q(x); else that of the Newton point of a
/// smaller space, which takes the blocks that left Λ as bound where they left. `None` when none of them will do.
pub(super) fn pivot(
    run: &mut Run,
    lambda: &Point,
    x: &Point,
    mut active: ActiveSet,
    newton: &Point,
    newton_from: &mut impl FnMut(&mut Run, &Point, &ActiveSet) -> Point,
) -> Option<Point> {
    let mut newton = newton.clone();
    let mut base = x.clone();
    for _ in 0..=MAX_PIVOTS {
        let trial = run.projected(&newton);
        if trial.objective_change_from(x) <= run.rounding(lambda, &trial) {
            return Some(trial);
        }
        let (smaller, bound) = without_those_that_left(&run.set, &active, &base, &newton, &trial)?;
        active = smaller;
        base = run.point_unless(bound, &base);
        newton = newton_from(run, &base, &active);
    }
    None
}

/// The active set without the free blocks that are outside of their sets at the Newton point, and the base point
/// with these blocks where the projection puts them. `None` when there is no such block.
fn without_those_that_left(
    set: &ProductSet,
    active: &ActiveSet,
    base: &Point,
    newton: &Point,
    projected: &Point,
) -> Option<(ActiveSet, Vec<f64>)> {
    let leaves = |block: &Block| {
        let range = block.range();
        newton.lambda[range.clone()] != projected.lambda[range]
    };
    let smaller = bound_where(set, active, leaves)?;
    let mut bound = base.lambda.clone();
    let states = active.states().iter().zip(smaller.states());
    for (block, (before, after)) in set.blocks().iter().zip(states) {
        if before != after {
            bound[block.range()].copy_from_slice(&projected.lambda[block.range()]);
        }
    }
    Some((smaller, bound))
}

/// The active set with those of its free blocks bound that `test` picks; `None` when it picks none.
fn bound_where(
    set: &ProductSet,
    active: &ActiveSet,
    test: impl Fn(&Block) -> bool,
) -> Option<ActiveSet> {
    let mut states = active.states().to_vec();
    for (block, state) in set.blocks().iter().zip(&mut states) {
        if *state == BlockState::Free && test(block) {
            *state = BlockState::Bound;
        }
    }
    (states != active.states()).then(|| ActiveSet::new(set.blocks(), states))
}

/// From x downhill: along the projected path to the Newton point as far as q falls, blocks that leave Λ on the
/// way are bound, then to the Newton point of the smaller space, until one is reached. Where no part of the path
/// lowers q, the step is cut at the first block that leaves. Returns the end with the length of its last step.
pub(super) fn walk(
    run: &mut Run,
    lambda: &Point,
    x: Point,
    mut active: ActiveSet,
    mut newton: Point,
    newton_from: &mut impl FnMut(&mut Run, &Point, &ActiveSet) -> Point,
) -> (Point, f64) {
    let mut base = x;
    let mut length = 0.0;
    for face in 0..MAX_FACES {
        if face > 0 {
            newton = newton_from(run, &base, &active);
            let trial = run.projected(&newton);
            if trial.objective_change_from(&base) <= run.rounding(lambda, &trial) {
                return (trial, 1.0);
            }
        }
        let smaller = match downhill(run, &base, &newton) {
            Some((trial, target, alpha)) => {
                let outside = |block: &Block| {
                    let range = block.range();
                    target.lambda[range.clone()] != trial.lambda[range]
                };
                let smaller = bound_where(&run.set, &active, outside);
                (base, length) = (trial, alpha);
                smaller
            }
            None => {
                let free = run.set.blocks().iter().zip(active.states());
                let free = free.filter(|(_, state)| **state == BlockState::Free);
                let shares =
                    free.map(|(block, _)| share_inside(block, &base.lambda, &newton.lambda));
                let alpha = shares.fold(1.0, f64::min);
                let first = |block: &Block| {
                    share_inside(block, &base.lambda, &newton.lambda) <= alpha * (1.0 + 1e-12)
                };
                let smaller = bound_where(&run.set, &active, first).filter(|_| alpha < 1.0);
                base = run.projected(&blend(&base, &newton, alpha));
                length = alpha;
                smaller
            }
        };
        match smaller {
            Some(smaller) => active = smaller,
            None => break,
        }
    }
    (base, length)
}

/// The first point of the projected path from `base` to `newton` at ½, ¼, … that lowers q, with the point that
/// was projected and how far along it is.
pub(super) fn downhill(run: &mut Run, base: &Point, newton: &Point) -> Option<(Point, Point, f64)> {
    let mut alpha = 0.5;
    for _ in 0..MAX_HALVINGS {
        let target = blend(base, newton, alpha);
        let trial = run.projected(&target);
        if trial.objective_change_from(base) < 0.0 {
            return Some((trial, target, alpha));
        }
        alpha *= 0.5;
    }
    None
}

/// How much of the way from a point of Λ to another the block stays inside, at most 1.
fn share_inside(block: &Block, from: &[f64], to: &[f64]) -> f64 {
    let i = block.start;
    let share = match block.set {
        BlockSet::Line(_) | BlockSet::Origin(_) => 1.0,
        BlockSet::HalfLine(_) if to[i] < 0.0 => from[i] / (from[i] - to[i]),
        BlockSet::HalfLine(_) => 1.0,
        BlockSet::Interval(interval) if to[i].abs() > interval.bound => {
            (interval.bound.copysign(to[i]) - from[i]) / (to[i] - from[i])
        }
        BlockSet::Interval(_) => 1.0,
        BlockSet::Disc(disc) if to[i].hypot(to[i + 1]) > disc.bound => {
            let d = [to[i] - from[i], to[i + 1] - from[i + 1]];
            let square = d[0] * d[0] + d[1] * d[1];
            let along = from[i] * d[0] + from[i + 1] * d[1];
            let room = disc.bound * disc.bound - from[i].powi(2) - from[i + 1].powi(2);
            ((along * along + square * room.max(0.0)).sqrt() - along) / square
        }
        BlockSet::Disc(_) => 1.0,
    };
    share.clamp(0.0, 1.0)
}

/// x + α (newton − x), gradient included.
fn blend(x: &Point, newton: &Point, alpha: f64) -> Point {
    let mix = |x: &[f64], newton: &[f64]| {
        x.iter()
            .zip(newton)
            .map(|(x, n)| x + alpha * (n - x))
            .collect::<Vec<_>>()
    };
    Point {
        lambda: mix(&x.lambda, &newton.lambda),
        gradient: mix(&x.gradient, &newton.gradient),
    }
}
