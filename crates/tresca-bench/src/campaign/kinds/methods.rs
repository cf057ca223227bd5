//! Methods other than the default one.

use tresca::{Method, Settings};

use super::{degenerate, dual, floating, ordinary};
use crate::campaign::problem::Drawn;
use crate::campaign::random::Random;

const ORDINARY: [fn(&mut Random) -> Drawn; 5] = [
    ordinary::frictionless,
    ordinary::tresca,
    ordinary::orthotropic,
    ordinary::mixture,
    floating::tresca,
];
const DEGENERATE: [fn(&mut Random) -> Drawn; 6] = [
    degenerate::repeated,
    degenerate::repeated_ties,
    degenerate::dependent,
    degenerate::contradictory,
    degenerate::tie_loops,
    dual::singular,
];
const SAFE: [Method; 2] = [Method::Gimssn, Method::Apgd];
const NEWTON: [Method; 3] = [Method::Ssn, Method::Mssn, Method::Imssn];

/// Gradient methods take many short steps: they may make them.
const STEPS: usize = 100_000;

fn by(random: &mut Random, mut drawn: Drawn, methods: &[Method]) -> Drawn {
    let method = random.pick(methods);
    drawn.may_give_up = NEWTON.contains(&method);
    drawn.settings = Settings {
        method,
        max_iterations: if SAFE.contains(&method) { STEPS } else { 1000 },
        ..Settings::default()
    };
    drawn
}

pub fn safe(random: &mut Random) -> Drawn {
    let drawn = random.pick(&ORDINARY)(random);
    by(random, drawn, &SAFE)
}

pub fn newton(random: &mut Random) -> Drawn {
    let drawn = random.pick(&ORDINARY)(random);
    by(random, drawn, &NEWTON)
}

pub fn degenerate(random: &mut Random) -> Drawn {
    let drawn = random.pick(&DEGENERATE)(random);
    by(
        random,
        drawn,
        &[&SAFE[..], &NEWTON[..], &[Method::Grssn]].concat(),
    )
}
