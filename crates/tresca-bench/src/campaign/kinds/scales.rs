//! Other kinds in other units. Units are powers of two, so that the problem stays what it is to the last bit.

use super::{coulomb, degenerate, dual, floating, ordinary};
use crate::campaign::problem::{Drawn, Form};
use crate::campaign::random::Random;

/// 2⁴⁰ = 1.1e12.
const MOST: i32 = 40;

const OTHERS: [fn(&mut Random) -> Drawn; 11] = [
    ordinary::frictionless,
    ordinary::tresca,
    ordinary::orthotropic,
    ordinary::mixture,
    floating::tresca,
    floating::mixture,
    degenerate::repeated,
    degenerate::repeated_ties,
    dual::regular,
    coulomb::plane,
    coulomb::space,
];

fn exponent(random: &mut Random, most: i32) -> i32 {
    random.count(0, 2 * most as usize) as i32 - most
}

pub fn uniform(random: &mut Random) -> Drawn {
    let draw = random.pick(&OTHERS);
    let mut drawn = draw(random);
    drawn.units.stiffness = exponent(random, MOST);
    drawn.units.length = exponent(random, MOST);
    let rows = exponent(random, MOST);
    drawn.units.rows.fill([rows; 2]);
    drawn
}

pub fn of_rows(random: &mut Random) -> Drawn {
    let draw = random.pick(&OTHERS);
    let mut drawn = draw(random);
    // A and b have no rows of B whose length could be seen: there pairs of very different units are what they are.
    let most = match drawn.form {
        Form::Primal => random.pick(&[10, 20, MOST]),
        Form::Dual => 5,
    };
    for rows in &mut drawn.units.rows {
        *rows = [exponent(random, most); 2];
    }
    drawn
}
