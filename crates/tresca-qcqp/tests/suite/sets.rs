//! What projections and slanting derivatives must fulfil, on random points.

use proptest::prelude::*;
use tresca_qcqp::ProductSet;
use tresca_qcqp::sets::{
    Block, BlockSet, BlockState, ConvexSet, Disc, HalfLine, Interval, Line, Origin,
};

fn any_set() -> impl Strategy<Value = BlockSet> {
    let bound = prop_oneof![Just(0.0), 1e-8..1e-6, 0.1..3.0, 1e6..1e9];
    prop_oneof![
        Just(BlockSet::Line(Line)),
        Just(BlockSet::HalfLine(HalfLine)),
        Just(BlockSet::Origin(Origin)),
        bound
            .clone()
            .prop_map(|bound| BlockSet::Interval(Interval { bound })),
        bound.prop_map(|bound| BlockSet::Disc(Disc { bound })),
    ]
}

/// A coordinate of any size, zero included.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), -1e-7..1e-7, -4.0..4.0, -1e10..1e10]
}

fn distance(x: &[f64], y: &[f64]) -> f64 {
    x.iter()
        .zip(y)
        .map(|(x, y)| (x - y).powi(2))
        .sum::<f64>()
        .sqrt()
}

fn size(x: &[f64]) -> f64 {
    distance(x, &[0.0; 2][..x.len()])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn projection_is_the_nearest_point(
        set in any_set(),
        y in [coordinate(), coordinate()],
        z in [coordinate(), coordinate()],
    ) {
        let d = set.dimension();
        let (y, z) = (&y[..d], &z[..d]);
        let project = |y: &[f64]| { let mut p = y.to_vec(); set.project(&mut p); p };
        let (p, q) = (project(y), project(z));
        let rounding = 1e-15 * (size(y) + size(z));
        prop_assert!(set.contains(&p));
        // Idempotent, up to the last digit of a point on a circle.
        prop_assert!(distance(&project(&p), &p) <= 4e-16 * size(&p));
        // Points of the set stay.
        if set.contains(y) { prop_assert!(distance(&p, y) <= 1e-15 * size(y)); }
        // Nonexpansive.
        prop_assert!(distance(&p, &q) <= distance(y, z) + rounding);
        // (y − P(y))ᵀ(x − P(y)) ≤ 0 for every x of the set, here q.
        let product: f64 = (0..d).map(|i| (y[i] - p[i]) * (q[i] - p[i])).sum();
        let scale = (size(y) + size(&p)) * (size(&q) + size(&p));
        prop_assert!(product <= 4e-15 * scale, "{product:e} against {scale:e}");
        // Free means that the projection does nothing, and a point set is never free.
        match set.classify(y) {
            BlockState::Free => prop_assert_eq!(&p[..], y),
            BlockState::Bound => prop_assert!(!matches!(set, BlockSet::Line(_))),
        }
        if set.bound() == Some(0.0) {
            prop_assert_eq!(set.classify(y), BlockState::Bound);
            prop_assert_eq!(&p[..], &[0.0; 2][..d]);
        }
    }

    #[test]
    fn slanting_derivative_is_the_derivative_away_from_kinks(
        set in any_set(),
        y in [-4.0..4.0, -4.0..4.0],
        h in [-1.0..1.0, -1.0..1.0],
    ) {
        let d = set.dimension();
        let bound = set.bound().unwrap_or(0.0);
        let kink = if d == 2 { (size(&y) - bound).abs() } else { (y[0].abs() - bound).abs() };
        prop_assume!(kink > 1e-2 && size(&y) > 1e-2);
        let step = 1e-5;
        let shifted = |sign: f64| {
            let mut p: Vec<f64> = (0..d).map(|i| y[i] + sign * step * h[i]).collect();
            set.project(&mut p);
            p
        };
        let (ahead, behind) = (shifted(1.0), shifted(-1.0));
        let difference: Vec<f64> = (0..d).map(|i| (ahead[i] - behind[i]) / (2.0 * step)).collect();
        let mut slope = h[..d].to_vec();
        set.slant(&y[..d], &mut slope);
        prop_assert!(distance(&slope, &difference) <= 1e-4, "{slope:?} is not {difference:?}");
    }

    #[test]
    fn slanting_derivative_lies_between_zero_and_one(
        set in any_set(),
        y in [coordinate(), coordinate()],
        h in [-1.0..1.0, -1.0..1.0],
        k in [-1.0..1.0, -1.0..1.0],
    ) {
        let d = set.dimension();
        let apply = |h: &[f64]| { let mut g = h[..d].to_vec(); set.slant(&y[..d], &mut g); g };
        let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let (gh, gk) = (apply(&h), apply(&k));
        prop_assert!((dot(&gh, &k) - dot(&h, &gk)).abs() <= 1e-14);
        let quadratic = dot(&gh, &h);
        prop_assert!(quadratic >= -1e-15);
        prop_assert!(quadratic <= dot(&h[..d], &h[..d]) * (1.0 + 1e-14));
        prop_assert!(gh.iter().all(|g| g.is_finite()));
    }

    #[test]
    fn not_a_number_is_never_hidden(set in any_set(), other in coordinate()) {
        let mut y = vec![other; set.dimension()];
        y[0] = f64::NAN;
        set.project(&mut y);
        prop_assert!(y[0].is_nan());
    }

    #[test]
    fn the_product_is_the_product_of_its_blocks(
        sets in prop::collection::vec(any_set(), 1..8),
        values in prop::collection::vec(coordinate(), 16),
    ) {
        let mut blocks = Vec::new();
        let mut start = 0;
        for set in sets {
            blocks.push(Block { start, set });
            start += set.dimension();
        }
        blocks.reverse();
        let product = ProductSet::new(start, blocks.clone()).unwrap();
        let y = &values[..start];
        let mut p = y.to_vec();
        product.project(&mut p);
        prop_assert!(product.contains(&p));
        let active = product.classify(y);
        let mut expected = vec![0.0; start];
        for (block, state) in blocks.iter().zip(active.states()) {
            let range = block.range();
            expected[range.clone()].copy_from_slice(&y[range.clone()]);
            block.set.project(&mut expected[range.clone()]);
            prop_assert_eq!(*state, block.set.classify(&y[range]));
        }
        prop_assert_eq!(p, expected);
        let counts = active.counts();
        // Neither a line nor a point has two sides.
        let sideless = |block: &&Block| matches!(block.set, BlockSet::Line(_) | BlockSet::Origin(_));
        let others = blocks.iter().filter(sideless).count();
        prop_assert_eq!(counts.open + counts.closed + counts.stick + counts.slip + others, blocks.len());
        prop_assert_eq!(active.changes(&active), 0);
    }
}
