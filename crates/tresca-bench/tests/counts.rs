//! The counts of small sizes beside those kept in `counts.toml`: work that grows, or shrinks, is seen.
//!
//! After a change that is meant to move them: `TRESCA_WRITE_COUNTS=1 cargo test -p tresca-bench --test counts`.

use std::path::Path;

use serde::{Deserialize, Serialize};
use tresca::{Method, Status};
use tresca_bench::coulomb::Comparison;
use tresca_bench::table1::{Counts, Plan};
use tresca_bench::trial::Trial;
use tresca_bench::two_bricks::{Units, two_bricks};

const SIZES: [usize; 2] = [9, 16];
const COEFFICIENTS: [f64; 2] = [0.1, 0.6];

#[derive(Debug, Serialize, Deserialize)]
struct Kept {
    table1: Vec<Bricks>,
    coulomb: Vec<Coulomb>,
}

/// `tresca bench table1` at one size.
#[derive(Debug, Serialize, Deserialize)]
struct Bricks {
    s: usize,
    dofs: usize,
    pairs: usize,
    /// Of the factors with the dofs of contact last.
    factor: Factor,
    /// Of the yardstick's.
    linear: Factor,
    solves: Vec<Solve>,
}

#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Factor {
    nonzeros: f64,
    flops: f64,
}

#[derive(Debug, Serialize, Deserialize)]
struct Solve {
    method: String,
    tolerance: f64,
    iterations: usize,
    multiplications: usize,
    /// Of these for σmax, not counted above.
    setup: usize,
}

/// `tresca bench coulomb` for one coefficient.
#[derive(Debug, Serialize, Deserialize)]
struct Coulomb {
    s: usize,
    coefficient: f64,
    frozen: [usize; 2],
    updates: usize,
    fixed_point: [usize; 2],
    in_loop: [usize; 2],
}

fn table1(s: usize) -> Bricks {
    let model = two_bricks(s, Units::METRE_MEGAPASCAL).unwrap();
    let plan = Plan::default();
    let mut trial = plan.trial(&model).unwrap();
    let rows: Vec<_> = plan.rows(s, &mut trial).map(Result::unwrap).collect();
    assert!(rows.iter().all(|row| row.status == Status::Converged));
    let (dofs, pairs) = (trial.description().dofs, trial.description().pairs);
    let (factor, linear) = factors(trial);
    Bricks {
        s,
        dofs,
        pairs,
        factor,
        linear,
        solves: rows
            .iter()
            .map(|row| Solve {
                method: row.method.to_string(),
                tolerance: row.tolerance,
                iterations: row.counts.iterations,
                multiplications: row.counts.multiplications,
                setup: row.setup,
            })
            .collect(),
    }
}

fn factors(trial: Trial<'_>) -> (Factor, Factor) {
    let cost = trial.cost().unwrap();
    let [own, linear] = [cost.factorization, cost.linear.factorization].map(|work| Factor {
        nonzeros: work.nonzeros,
        flops: work.flops,
    });
    (own, linear)
}

fn coulomb(s: usize, coefficient: f64) -> Coulomb {
    let comparison = Comparison::run(s, coefficient, 1e-6).unwrap();
    assert!(comparison.outcomes().iter().all(|run| run.converged()));
    let [frozen, fixed_point, in_loop] = comparison.outcomes().map(|outcome| {
        let counts = Counts::of(outcome);
        [counts.iterations, counts.multiplications]
    });
    Coulomb {
        s,
        coefficient,
        frozen,
        updates: comparison.updates(),
        fixed_point,
        in_loop,
    }
}

fn measured() -> Kept {
    let pairs = SIZES.iter().flat_map(|&s| COEFFICIENTS.map(|f| (s, f)));
    Kept {
        table1: SIZES.map(table1).into(),
        coulomb: pairs.map(|(s, f)| coulomb(s, f)).collect(),
    }
}

/// Rounding (other instruction sets, other levels of optimisation) decides whether a step more is needed; it moves
/// BiCGSTAB to full accuracy, and the loops of Coulomb's law, where every step starts from the one before.
#[track_caller]
fn close(what: &str, band: f64, found: usize, kept: usize) {
    let apart = found.abs_diff(kept);
    assert!(
        apart <= 1 || apart as f64 <= band * kept as f64,
        "{what}: {found}, and {kept} in counts.toml"
    );
}

#[test]
fn the_counts_are_those_that_are_kept() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("counts.toml");
    let found = measured();
    if std::env::var_os("TRESCA_WRITE_COUNTS").is_some() {
        let text = toml::to_string(&found).unwrap();
        std::fs::write(&path, format!("# Written by tests/counts.rs.\n\n{text}")).unwrap();
        return;
    }
    let kept: Kept = toml::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    assert_eq!(kept.table1.len(), found.table1.len());
    assert_eq!(kept.coulomb.len(), found.coulomb.len());
    for (kept, found) in kept.table1.iter().zip(&found.table1) {
        let s = kept.s;
        assert_eq!(s, found.s);
        assert_eq!((found.dofs, found.pairs), (kept.dofs, kept.pairs));
        // Sizes of factors come from METIS alone, which knows no rounding.
        assert_eq!(found.factor, kept.factor, "s = {s}");
        assert_eq!(found.linear, kept.linear, "s = {s}");
        assert_eq!(kept.solves.len(), found.solves.len());
        for (kept, found) in kept.solves.iter().zip(&found.solves) {
            assert_eq!(
                (&found.method, found.tolerance),
                (&kept.method, kept.tolerance)
            );
            let what = format!("s = {s}, {} {:e}", kept.method, kept.tolerance);
            let band = if kept.method == Method::Ssn.to_string() {
                0.15
            } else {
                0.05
            };
            close(&what, band, found.iterations, kept.iterations);
            close(&what, band, found.multiplications, kept.multiplications);
            close(&what, band, found.setup, kept.setup);
        }
    }
    for (kept, found) in kept.coulomb.iter().zip(&found.coulomb) {
        assert_eq!((found.s, found.coefficient), (kept.s, kept.coefficient));
        let what = format!("s = {}, F = {}", kept.s, kept.coefficient);
        close(&what, 0.0, found.updates, kept.updates);
        for (name, kept, found) in [
            ("frozen", kept.frozen, found.frozen),
            ("fixed point", kept.fixed_point, found.fixed_point),
            ("in the loop", kept.in_loop, found.in_loop),
        ] {
            let what = format!("{what}, {name}");
            close(&what, 0.25, found[0], kept[0]);
            close(&what, 0.25, found[1], kept[1]);
        }
    }
}
