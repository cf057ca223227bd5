//! The solver's answer beside what the oracles say.

use tresca::Status;

use super::answer::{Answer, End};
use super::dense::{add, dot, largest, norm, product, transposed_product};
use super::oracle::{Conditions, Truth, sweep, truth};
use super::problem::{Drawn, Form, Problem, bounds, is_closed};

/// What an answer may be off by, relative to what is compared. The dual energy first: with equilibrium, what it
/// lacks is the energy of the error in u. The primal energy changes with the overlap that the tolerance leaves.
const ENERGY: f64 = 1e-6;
const PRIMAL_ENERGY: f64 = 1e-4;
const CONDITIONS: f64 = 1e-5;
/// Constraints on displacements, equilibrium, bounds of forces.
const ADMISSIBLE: f64 = 1e-5;
/// A figure of the certificate that says that something is wrong.
const ALARM: f64 = 1e-4;

/// What an answer is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The oracle agrees.
    Right,
    /// The oracle agrees, but the certificate cries.
    Alarm,
    /// The oracle disagrees.
    Wrong,
    /// The oracle disagrees, and the certificate is clean.
    WrongUnseen,
    /// The solver has no answer, and there is one.
    Undecided,
    /// The same, by a method without a guarantee.
    GaveUp,
    /// Neither solver nor oracle found a solution.
    Neither,
    /// The oracle cannot say.
    Unjudged,
}

impl Verdict {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Right => "right",
            Verdict::Alarm => "alarm",
            Verdict::Wrong => "WRONG",
            Verdict::WrongUnseen => "WRONG, certificate clean",
            Verdict::Undecided => "undecided",
            Verdict::GaveUp => "gave up",
            Verdict::Neither => "neither",
            Verdict::Unjudged => "oracle undecided",
        }
    }

    /// Is the answer wrong?
    pub fn is_wrong(self) -> bool {
        matches!(self, Verdict::Wrong | Verdict::WrongUnseen)
    }

    /// Does it have a line of its own?
    pub fn is_reported(self) -> bool {
        !matches!(self, Verdict::Right | Verdict::GaveUp)
    }
}

/// A verdict and its grounds.
#[derive(Debug, Clone)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// Of a converged answer: how far it is off, relative; of Coulomb's law the residual of the conditions.
    pub difference: Option<f64>,
    /// What the oracle said.
    pub oracle: String,
}

/// Judges an answer.
pub fn judge(drawn: &Drawn, answer: &Answer) -> Judgement {
    let truth = truth(&drawn.truth);
    let measured = match answer.end {
        End::Status(Status::Converged) => measure(drawn, answer, &truth),
        _ => None,
    };
    let mut swept = None;
    let solved = || *swept.insert(sweep(&drawn.truth).is_some());
    let verdict = verdict(&truth, answer, measured.as_ref(), drawn, solved);
    let mut oracle = truth.name();
    match swept {
        Some(true) => oracle += ", Gauss–Seidel has a solution",
        Some(false) => oracle += ", Gauss–Seidel has no solution",
        None => {}
    }
    if let Some(off) = &measured {
        oracle += &format!("; off by {off}");
    }
    Judgement {
        verdict,
        difference: measured.map(|off| off.difference),
        oracle,
    }
}

/// How far a converged answer is off.
#[derive(Debug, Clone, Copy)]
pub struct Off {
    /// Of the dual energies, or the residual of Coulomb's conditions.
    pub difference: f64,
    /// What is allowed of that.
    pub allowed: f64,
    /// Of the primal energies.
    pub primal: f64,
    /// Constraints on displacements that are not met, over the largest displacement or gap.
    pub constraints: f64,
    /// Ku + Bᵀλ − f, over the largest of the three.
    pub equilibrium: f64,
    /// Forces that their law does not allow, over the largest bound or force.
    pub forces: f64,
}

impl Off {
    fn is_small(&self) -> bool {
        self.difference <= self.allowed
            && self.primal <= PRIMAL_ENERGY
            && self.constraints <= ADMISSIBLE
            && self.equilibrium <= ADMISSIBLE
            && self.forces <= ADMISSIBLE
    }
}

impl std::fmt::Display for Off {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{:.0e} (primal energy {:.0e}, constraints {:.0e}, equilibrium {:.0e}, forces {:.0e})",
            self.difference, self.primal, self.constraints, self.equilibrium, self.forces
        )
    }
}

/// The verdict. `solved` tells whether Gauss–Seidel finds a solution, and is asked only where it matters.
pub fn verdict(
    truth: &Truth,
    answer: &Answer,
    off: Option<&Off>,
    drawn: &Drawn,
    solved: impl FnOnce() -> bool,
) -> Verdict {
    let status = match &answer.end {
        End::Panicked => return Verdict::Wrong,
        End::Refused(_) => None,
        End::Status(status) => Some(*status),
    };
    let wrong = |clean| {
        if clean {
            Verdict::WrongUnseen
        } else {
            Verdict::Wrong
        }
    };
    let clean = answer.certificate <= ALARM;
    match (status, truth) {
        (_, Truth::Unknown(_)) => Verdict::Unjudged,
        (Some(Status::Converged), Truth::None { .. }) => wrong(clean),
        (Some(Status::Converged), _) => match off {
            Some(off) if off.is_small() && clean => Verdict::Right,
            Some(off) if off.is_small() => Verdict::Alarm,
            _ => wrong(clean),
        },
        (
            Some(Status::Infeasible),
            Truth::None {
                infeasible: true, ..
            },
        )
        | (
            Some(Status::NoEquilibrium),
            Truth::None {
                unbalanced: true, ..
            },
        ) => Verdict::Right,
        (Some(Status::Infeasible | Status::NoEquilibrium), truth) => {
            // A proof that is none is wrong, whether a solution is known or not.
            if matches!(truth, Truth::Conditions) {
                solved();
            }
            Verdict::Wrong
        }
        (Some(Status::Inaccurate), _) if drawn.ill_determined => Verdict::Right,
        _ if drawn.may_give_up => Verdict::GaveUp,
        (_, Truth::Conditions) if !solved() => Verdict::Neither,
        _ => Verdict::Undecided,
    }
}

fn measure(drawn: &Drawn, answer: &Answer, truth: &Truth) -> Option<Off> {
    let problem = &drawn.truth;
    let lambda = &answer.forces;
    let (relative, primal) = match drawn.form {
        Form::Primal => {
            let u = &answer.displacement;
            let mut relative = product(&problem.contact(), u);
            add(&mut relative, -1.0, &problem.shift());
            (relative, Some(u))
        }
        Form::Dual => (problem.dual()?.relative(lambda), None),
    };
    let mut off = Off {
        difference: f64::NAN,
        allowed: ENERGY,
        primal: 0.0,
        constraints: 0.0,
        equilibrium: primal.map_or(0.0, |u| equilibrium(problem, u, lambda)),
        forces: inadmissible(problem, lambda),
    };
    match truth {
        Truth::Solution {
            energy,
            displacement,
        } => {
            let scale = energy_scale(problem, *energy, displacement);
            let apart = |found: f64| ((found - energy) / scale).abs();
            let dual = match primal {
                Some(u) => {
                    off.constraints = penetration(problem, u, &relative, displacement);
                    off.primal = apart(problem.energy(u));
                    lagrangian(problem, u, lambda, &relative)
                }
                None => {
                    let form = problem.dual()?;
                    -form.objective(lambda) - 0.5 * form.free_work
                }
            };
            off.difference = apart(dual);
        }
        Truth::Conditions => {
            off.allowed = CONDITIONS;
            off.difference = Conditions::new(problem)?.residual(lambda, &relative);
        }
        _ => {}
    }
    Some(off)
}

/// ½uᵀKu − fᵀu + λᵀ(Bu − c): the dual energy, where there is equilibrium; a little less of that moves it by its
/// square only.
fn lagrangian(problem: &Problem, u: &[f64], lambda: &[f64], relative: &[f64]) -> f64 {
    0.5 * dot(u, &product(&problem.whole(), u)) - dot(&problem.load, u) + dot(lambda, relative)
}

/// A force, a length and an energy that the data of a problem make; 1 where there are none.
fn sizes(problem: &Problem) -> [f64; 3] {
    let k = problem.whole();
    let stiff = (0..k.len()).map(|i| k[i][i]).fold(0.0, f64::max);
    let (load, gap) = (norm(&problem.load), norm(&problem.shift()));
    if load == 0.0 && gap == 0.0 {
        return [1.0; 3];
    }
    let (force, length) = (load.max(stiff * gap), gap.max(load / stiff));
    [force, length, force * length]
}

/// Part of these sizes that is little, but more than rounding.
const LITTLE: f64 = 1e-3;

/// Problems are about 1: what an oracle finds below this part of 1e-6 is its rounding.
const SMALLEST: f64 = 1e-4;

/// What energies of a problem are compared with: its energy, its parts, or what its data make of one.
fn energy_scale(problem: &Problem, energy: f64, u: &[f64]) -> f64 {
    let elastic = 0.5 * dot(u, &product(&problem.whole(), u));
    let parts = u.iter().zip(&problem.load).map(|(u, f)| (u * f).abs());
    let parts: f64 = parts.sum();
    let least = LITTLE * sizes(problem)[2];
    energy
        .abs()
        .max(elastic)
        .max(parts)
        .max(least)
        .max(SMALLEST)
}

fn equilibrium(problem: &Problem, u: &[f64], lambda: &[f64]) -> f64 {
    let internal = product(&problem.whole(), u);
    let contact = transposed_product(&problem.contact(), lambda, problem.dofs());
    let mut left = internal.clone();
    add(&mut left, 1.0, &contact);
    add(&mut left, -1.0, &problem.load);
    let scale = [&internal, &contact, &problem.load]
        .map(|x| norm(x))
        .into_iter()
        .fold(LITTLE * sizes(problem)[0], f64::max);
    norm(&left) / scale
}

/// Overlaps and ties that are not met, over the largest displacement along a row, or gap.
fn penetration(problem: &Problem, u: &[f64], relative: &[f64], right: &[f64]) -> f64 {
    let (m, tangents) = (problem.pairs(), problem.tangents);
    let (contact, shift) = (problem.contact(), problem.shift());
    let mut worst = 0.0_f64;
    let mut scale = largest(u).min(largest(right));
    scale = scale.max(LITTLE * sizes(problem)[1]);
    let mut take = |row: usize, apart: f64| {
        let length = norm(&contact[row]);
        if length > 0.0 {
            worst = worst.max(apart / length);
            scale = scale.max(shift[row].abs() / length);
        }
    };
    for (pair, law) in problem.laws.iter().enumerate() {
        let gap = relative[pair];
        take(
            pair,
            if is_closed(law) {
                gap.abs()
            } else {
                gap.max(0.0)
            },
        );
        if bounds(law, 0.0).is_none() {
            let rows = m + tangents * pair..m + tangents * (pair + 1);
            rows.for_each(|row| take(row, relative[row].abs()));
        }
    }
    worst / scale
}

fn inadmissible(problem: &Problem, lambda: &[f64]) -> f64 {
    let (m, tangents) = (problem.pairs(), problem.tangents);
    let (mut worst, mut scale) = (0.0_f64, largest(&lambda[..m]));
    for (pair, law) in problem.laws.iter().enumerate() {
        let normal = lambda[pair];
        if !is_closed(law) {
            worst = worst.max(-normal);
        }
        let Some(bounds) = bounds(law, normal) else {
            continue;
        };
        let force = &lambda[m + tangents * pair..m + tangents * (pair + 1)];
        // How far out of the ellipse, in parts of it.
        let parts = force.iter().zip(bounds).map(|(x, g)| {
            if g > 0.0 {
                (x / g).powi(2)
            } else if *x == 0.0 {
                0.0
            } else {
                f64::INFINITY
            }
        });
        let parts = parts.sum::<f64>().sqrt();
        let most = bounds[0].max(bounds[1]);
        scale = scale.max(most);
        if parts > 1.0 {
            worst = worst.max(if most > 0.0 {
                (parts - 1.0) * most
            } else {
                norm(force)
            });
        }
    }
    let worst = if lambda.iter().any(|x| x.is_nan()) {
        f64::NAN
    } else {
        worst
    };
    if scale > 0.0 { worst / scale } else { worst }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tresca::algebraic::PairLaw;

    /// A spring of stiffness 2 is pulled by 3 towards a wall at 1: u = 1, λ = 1, energy −2.
    fn wall() -> Drawn {
        Drawn::plain(Problem {
            tangents: 0,
            stiffness: vec![vec![vec![2.0]]],
            normal: vec![vec![1.0]],
            tangential: Vec::new(),
            load: vec![3.0],
            gap: vec![1.0],
            origin: Vec::new(),
            laws: vec![PairLaw::Frictionless],
        })
    }

    fn says(status: Status, u: f64, lambda: f64) -> Answer {
        Answer {
            end: End::Status(status),
            displacement: vec![u],
            forces: vec![lambda],
            multiplications: 1,
            certificate: 0.0,
            records: Vec::new(),
        }
    }

    #[test]
    fn a_right_answer_is_right_and_others_are_not() {
        let judged = |answer: &Answer| judge(&wall(), answer).verdict;
        assert_eq!(judged(&says(Status::Converged, 1.0, 1.0)), Verdict::Right);
        for (u, lambda) in [
            (1.01, 1.0),
            (1.5, 0.0),
            (1.0, -1.0),
            (0.0, 3.0),
            (1.0, 1.1),
            (f64::NAN, 1.0),
            (1.0, f64::NAN),
        ] {
            let verdict = judged(&says(Status::Converged, u, lambda));
            assert_eq!(verdict, Verdict::WrongUnseen, "u = {u}, λ = {lambda}");
        }
        let seen = Answer {
            certificate: 1.0,
            ..says(Status::Converged, 0.0, 0.0)
        };
        assert_eq!(judged(&seen), Verdict::Wrong);
        let alarm = Answer {
            certificate: 1.0,
            ..says(Status::Converged, 1.0, 1.0)
        };
        assert_eq!(judged(&alarm), Verdict::Alarm);
        for status in [Status::Infeasible, Status::NoEquilibrium] {
            assert_eq!(judged(&says(status, 1.0, 1.0)), Verdict::Wrong);
        }
        assert_eq!(
            judged(&says(Status::Stagnated, 1.0, 1.0)),
            Verdict::Undecided
        );
        let mut drawn = wall();
        drawn.may_give_up = true;
        let gave_up = judge(&drawn, &says(Status::Diverged, 0.0, 0.0)).verdict;
        assert_eq!(gave_up, Verdict::GaveUp);
        drawn.ill_determined = true;
        let said = judge(&drawn, &says(Status::Inaccurate, 0.0, 0.0)).verdict;
        assert_eq!(said, Verdict::Right);
        let panicked = Answer {
            end: End::Panicked,
            ..says(Status::Converged, 1.0, 1.0)
        };
        assert_eq!(judged(&panicked), Verdict::Wrong);
    }

    #[test]
    fn without_a_solution_the_reason_has_to_be_right() {
        let mut squeezed = wall();
        squeezed.truth.normal = vec![vec![1.0], vec![-1.0]];
        squeezed.truth.gap = vec![-0.5, -0.2];
        squeezed.truth.laws = vec![PairLaw::Frictionless; 2];
        let says = |status| Answer {
            forces: vec![1.0, 1.0],
            ..says(status, 0.0, 1.0)
        };
        let judged = |status| judge(&squeezed, &says(status)).verdict;
        assert_eq!(judged(Status::Infeasible), Verdict::Right);
        assert_eq!(judged(Status::NoEquilibrium), Verdict::Wrong);
        assert_eq!(judged(Status::Converged), Verdict::WrongUnseen);
        assert_eq!(judged(Status::Stagnated), Verdict::Undecided);
    }

    #[test]
    fn pulled_off_what_holds_it() {
        let mut free = wall();
        free.truth.stiffness = vec![vec![vec![1.0, -1.0], vec![-1.0, 1.0]]];
        free.truth.normal = vec![vec![1.0, 0.0]];
        free.truth.load = vec![-1.0, 0.0];
        let says = |status| Answer {
            displacement: vec![0.0; 2],
            ..says(status, 0.0, 0.0)
        };
        assert_eq!(
            judge(&free, &says(Status::NoEquilibrium)).verdict,
            Verdict::Right
        );
        assert_eq!(
            judge(&free, &says(Status::Infeasible)).verdict,
            Verdict::Wrong
        );
        free.truth.load = vec![0.0, 1.0];
        assert_eq!(
            judge(&free, &says(Status::NoEquilibrium)).verdict,
            Verdict::Wrong
        );
        let right = Answer {
            displacement: vec![1.0, 2.0],
            ..says(Status::Converged)
        };
        let right = Answer {
            forces: vec![1.0],
            ..right
        };
        assert_eq!(judge(&free, &right).verdict, Verdict::Right);
    }

    /// A mass on springs is pressed on a wall by 2, where friction 0.2 · 1.5 holds a part of 1.
    #[test]
    fn coulomb_by_its_conditions() {
        let mut mass = wall();
        mass.truth = Problem {
            tangents: 1,
            stiffness: vec![vec![vec![1.0, 0.0], vec![0.0, 2.0]]],
            normal: vec![vec![1.0, 0.0]],
            tangential: vec![vec![0.0, 1.0]],
            load: vec![2.0, 1.0],
            gap: vec![0.5],
            origin: vec![0.0],
            laws: vec![PairLaw::coulomb(0.2)],
        };
        let says = |u: [f64; 2], lambda: [f64; 2]| Answer {
            displacement: u.into(),
            forces: lambda.into(),
            ..says(Status::Converged, 0.0, 0.0)
        };
        let judged = |u, lambda| judge(&mass, &says(u, lambda)).verdict;
        assert_eq!(judged([0.5, 0.35], [1.5, 0.3]), Verdict::Right);
        // Stuck beyond the cone; slipping the wrong way; less friction than there is.
        assert_eq!(judged([0.5, 0.0], [1.5, 1.0]), Verdict::WrongUnseen);
        assert_eq!(judged([0.5, 0.65], [1.5, -0.3]), Verdict::WrongUnseen);
        assert_eq!(judged([0.5, 0.4], [1.5, 0.2]), Verdict::WrongUnseen);
        let lambda = sweep(&mass.truth).unwrap();
        assert!((lambda[0] - 1.5).abs() < 1e-8 && (lambda[1] - 0.3).abs() < 1e-8);
        let cycles = Answer {
            end: End::Status(Status::CoulombCycles),
            ..says([0.0; 2], [0.0; 2])
        };
        assert_eq!(judge(&mass, &cycles).verdict, Verdict::Undecided);
        let neither = verdict(&Truth::Conditions, &cycles, None, &wall(), || false);
        assert_eq!(neither, Verdict::Neither);
    }
}
