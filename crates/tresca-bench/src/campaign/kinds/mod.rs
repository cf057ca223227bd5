//! The kinds of problems, one function and one line each.

mod coulomb;
mod degenerate;
mod dual;
mod floating;
mod methods;
mod ordinary;
mod scales;

use super::problem::Drawn;
use super::random::Random;

/// A kind of problems.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// What it is called.
    pub name: &'static str,
    /// What it consists of.
    pub about: &'static str,
    /// Draws one.
    pub draw: fn(&mut Random) -> Drawn,
}

macro_rules! kinds {
    ($($name:literal $draw:path, $about:literal;)*) => {
        /// All kinds.
        pub const KINDS: &[Kind] = &[$(Kind { name: $name, about: $about, draw: $draw }),*];
    };
}

kinds! {
    "frictionless" ordinary::frictionless, "none, one or two tangents, nothing resists sliding";
    "tresca" ordinary::tresca, "Tresca's law in the plane and in space";
    "orthotropic" ordinary::orthotropic, "two bounds, some of them 0";
    "mixture" ordinary::mixture, "all convex laws in one problem, ties and pairs that never open among them";
    "floating-frictionless" floating::frictionless, "bodies that float, with and without equilibrium";
    "floating-tresca" floating::tresca, "the same with Tresca's law";
    "floating-mixture" floating::mixture, "the same with all convex laws";
    "floating-chains" floating::chains, "masses on springs whose friction may not hold the load";
    "repeated" degenerate::repeated, "rows twice, with the same gap or another, pairs that may open";
    "repeated-ties" degenerate::repeated_ties, "ties and bilateral pairs twice or thrice, with the same gap";
    "noisy-ties" degenerate::noisy_ties, "the same, the gaps apart by rounding";
    "near-dependent" degenerate::near_dependent, "rows that differ by angles of 1e-5 and 1e-7";
    "near-dependent-ties" degenerate::near_dependent_ties, "the same with ties";
    "dependent" degenerate::dependent, "rows that are sums of others; more rows than dofs";
    "contradictory" degenerate::contradictory, "ties apart, overlapping obstacles, chains of contacts";
    "tie-loops" degenerate::tie_loops, "bodies tied in a ring";
    "dual" dual::regular, "A and b, A regular with a condition to 1e5";
    "dual-singular" dual::singular, "A singular, b in its range";
    "dual-unbounded" dual::unbounded, "A singular, b not in its range";
    "coulomb-plane" coulomb::plane, "W regular, 1 to 10 contacts, coefficients to 5";
    "coulomb-space" coulomb::space, "the same in space";
    "coulomb-singular" coulomb::singular, "W singular, rows repeated and dependent";
    "coulomb-mixture" coulomb::mixture, "Coulomb's law beside all others";
    "coulomb-floating" coulomb::floating, "bodies that float";
    "coulomb-rope" coulomb::rope, "a rope on a drum, below and above the load at which it slips";
    "scales" scales::uniform, "K, lengths and rows of B times 1e±12, of other kinds";
    "scales-of-rows" scales::of_rows, "each pair's rows of B in units of their own, apart by up to 1e±12";
    "nothing" degenerate::nothing, "no load, no gap, or nothing but one dof";
    "tiny" degenerate::tiny, "one or two dofs, rows of −1, 0 and 1";
    "safe-methods" methods::safe, "gimssn and apgd on ordinary problems";
    "newton-methods" methods::newton, "ssn, mssn and imssn on ordinary problems: they may give up";
    "methods-degenerate" methods::degenerate, "all methods on dependent rows and on singular A; ssn, mssn, imssn may give up";
}
