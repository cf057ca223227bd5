//! Random problems by the thousand, each answer judged by an independent oracle.
//!
//! - [`kinds`]: what is drawn, one line per kind; [`draw`] has the parts, [`random`] the numbers. A problem follows
//!   from its kind and its seed alone.
//! - [`problem`]: a problem as the oracles see it, and the form and units in which it is put to the solver.
//! - [`oracle`]: Clarabel in the displacements, elimination of ties, a conic programme for equilibrium, the
//!   conditions of Coulomb's law and block Gauss–Seidel.
//! - [`verdict`]: an answer beside the truth. [`table`]: all of them in one table. [`kept`]: the counts of before.

pub mod answer;
mod dense;
pub mod draw;
pub mod kept;
pub mod kinds;
mod median;
pub mod oracle;
pub mod problem;
pub mod random;
pub mod table;
pub mod verdict;

use rayon::prelude::*;

use answer::{Answer, End, answer};
use kinds::{KINDS, Kind};
use problem::Drawn;
use random::{Random, seed_of};
use verdict::{Judgement, judge};

/// A problem of a campaign.
#[derive(Debug, Clone, Copy)]
pub struct Ticket {
    /// Its kind.
    pub kind: &'static Kind,
    /// Its number among those of its kind.
    pub number: usize,
    /// From this and the kind it is drawn.
    pub seed: u64,
}

/// A problem that was solved and judged.
#[derive(Debug, Clone)]
pub struct Judged {
    /// Which.
    pub ticket: Ticket,
    /// How the solver's run ended.
    pub end: End,
    /// n_A.
    pub multiplications: usize,
    /// The worst figure of the certificate.
    pub certificate: f64,
    /// What it is worth.
    pub judgement: Judgement,
}

/// The kind of this name.
pub fn kind(name: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.name == name)
}

/// So many problems of these kinds in turn.
pub fn tickets(problems: usize, seed: u64, kinds: &[&'static Kind]) -> Vec<Ticket> {
    let ticket = |at: usize| {
        let (kind, number) = (kinds[at % kinds.len()], at / kinds.len());
        Ticket {
            kind,
            number,
            seed: seed_of(seed, kind.name, number),
        }
    };
    (0..problems).map(ticket).collect()
}

impl Ticket {
    /// The problem.
    pub fn draw(&self) -> Drawn {
        (self.kind.draw)(&mut Random::new(self.seed))
    }

    /// The solver's answer, and what it is worth.
    pub fn run(&self) -> (Drawn, Answer, Judged) {
        let drawn = self.draw();
        let answer = answer(&drawn);
        let judged = Judged {
            ticket: *self,
            end: answer.end.clone(),
            multiplications: answer.multiplications,
            certificate: answer.certificate,
            judgement: judge(&drawn, &answer),
        };
        (drawn, answer, judged)
    }
}

/// Problems side by side of which one waits for another.
const TOGETHER: usize = 256;

/// Solves and judges all of them, side by side; `hear` is told in their order.
pub fn run(tickets: &[Ticket], mut hear: impl FnMut(&Judged)) -> Vec<Judged> {
    let mut all = Vec::with_capacity(tickets.len());
    for some in tickets.chunks(TOGETHER) {
        let judged: Vec<Judged> = some.par_iter().map(|ticket| ticket.run().2).collect();
        judged.iter().for_each(&mut hear);
        all.extend(judged);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_follows_from_its_kind_and_seed() {
        let kinds: Vec<_> = KINDS.iter().collect();
        for ticket in tickets(2 * kinds.len(), 3, &kinds) {
            let (a, b) = (ticket.draw(), ticket.draw());
            assert_eq!(a.truth.load, b.truth.load);
            assert_eq!(a.truth.normal, b.truth.normal);
            let drawn = a;
            let m = drawn.truth.pairs();
            let name = ticket.kind.name;
            assert_eq!(drawn.truth.gap.len(), m, "{name}");
            assert_eq!(drawn.truth.laws.len(), m, "{name}");
            assert_eq!(
                drawn.truth.tangential.len(),
                drawn.truth.tangents * m,
                "{name}"
            );
            assert_eq!(drawn.truth.origin.len(), drawn.truth.tangents * m, "{name}");
            assert_eq!(drawn.units.rows.len(), m, "{name}");
            assert!(
                drawn.truth.dofs() <= 110,
                "{name}: {} dofs",
                drawn.truth.dofs()
            );
        }
    }

    #[test]
    fn names_of_kinds_differ() {
        for (i, kind) in KINDS.iter().enumerate() {
            assert!(KINDS[..i].iter().all(|other| other.name != kind.name));
            assert_eq!(
                super::kind(kind.name).map(|kind| kind.name),
                Some(kind.name)
            );
        }
    }
}
