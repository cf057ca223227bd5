//! Every option of the solver, declared once.

mod options;

pub use options::OptionInfo;

use crate::error::QcqpError;
use options::{OptionValue, Range, settings, words};

words! {
    /// The methods.
    pub enum Method, "method" {
        /// Semismooth Newton, nonsymmetric inner systems solved by BiCGSTAB.
        Ssn = "ssn",
        /// Symmetrised SSN: the curvature term is dropped, inner systems solved by CG to full accuracy.
        Mssn = "mssn",
        /// Inexact MSSN: CG with adaptive precision.
        Imssn = "imssn",
        /// Globalised IMSSN: from a projected gradient point, CG stops before it would leave the feasible set.
        Gimssn = "gimssn",
        /// Globalised reduced SSN: the exact Newton system in symmetric form, by preconditioned CG.
        Grssn = "grssn",
        /// Accelerated projected gradient with restart, the baseline.
        Apgd = "apgd",
    }
}

words! {
    /// How A is applied.
    pub enum Engine, "engine" {
        /// Choose by the sizes.
        Auto = "auto",
        /// Two sweeps through the whole factor of K per multiplication.
        Factored = "factored",
        /// Two dense triangular solves with the trailing block per multiplication.
        Condensed = "condensed",
        /// A dense matrix A, formed once.
        Explicit = "explicit",
    }
}

words! {
    /// How Newton systems are solved.
    pub enum InnerSolver, "inner solver" {
        /// Directly when A is explicit and the system small, else iteratively.
        Auto = "auto",
        /// By a Krylov method.
        Iterative = "iterative",
        /// By factoring the active block when A is explicit; iteratively otherwise.
        Direct = "direct",
    }
}

words! {
    /// How the bounds of Coulomb's law are found.
    pub enum CoulombMethod, "Coulomb method" {
        /// In the loop with grssn and, should that fail, by fixed point; with other methods by fixed point.
        Auto = "auto",
        /// Problems with frozen bounds, one after another, until the bounds no longer change.
        FixedPoint = "fixed_point",
        /// The bounds follow the normal forces after every Newton step; grssn only.
        InLoop = "in_loop",
    }
}

settings! {
    /// The options of a solve, each with a default that works. Nothing here has
    /// a unit: lengths and forces scale out.
    pub struct Settings {
        /// Method that solves the dual problem.
        method: Method = Method::Grssn, Range::WORDS;
        /// Stop when the relative reduced gradient ‖r̃(λ)‖/‖r̃(0)‖ is at or below this.
        tolerance: f64 = 1e-8, Range::open(0.0, 1.0);
        /// Largest number of iterations, of all outer iterations together.
        max_iterations: usize = 1000, Range::at_least(0.0);
        /// ρ in y = λ − ρ r(λ), which decides the active set and is the step of gimssn, grssn and apgd; in
        /// units of 1/σmax. gimssn and grssn need a value below 2, apgd at most 1. With ssn, mssn and imssn
        /// larger values (5) save steps on many problems, but may cycle.
        rho: f64 = 1.0, Range::open(0.0, 1e6);
        /// imssn, gimssn: largest residual of the inner system, relative to the reduced gradient
        /// and, as that falls, falling with it.
        r_tol: f64 = 0.5, Range::open(0.0, 1.0);
        /// imssn, gimssn: least factor by which that residual falls from one iteration to the next.
        c_fact: f64 = 0.9, Range::open(0.0, 1.0);
        /// ssn, mssn, imssn, gimssn: finest residual of the inner system, relative to the reduced
        /// gradient that the tolerance asks for. ssn and mssn solve every system to it.
        inner_tolerance: f64 = 0.1, Range::open(0.0, 1.0);
        /// Largest number of inner iterations in one iteration.
        max_inner_iterations: usize = 2000, Range::at_least(1.0);
        /// How Newton systems are solved by mssn and grssn. Directly takes fewer multiplications by A,
        /// but for large contacts more time.
        inner_solver: InnerSolver = InnerSolver::Auto, Range::WORDS;
        /// grssn: largest residual of the inner system, relative to the current reduced gradient.
        forcing: f64 = 0.03, Range::open(0.0, 1.0);
        /// grssn: number of search directions whose products with A are kept to precondition later
        /// systems; 0 keeps none.
        recycled_directions: usize = 128, Range::closed(0.0, 4096.0);
        /// Coulomb friction: how the slip bounds, which depend on the normal forces, are found.
        coulomb: CoulombMethod = CoulombMethod::Auto, Range::WORDS;
        /// Coulomb friction: stop when the relative changes of the bounds, and of the forces from one
        /// outer iteration to the next, are at or below this.
        coulomb_tolerance: f64 = 1e-6, Range::open(0.0, 1.0);
        /// Largest number of outer iterations: updates of the bounds of Coulomb friction, and for
        /// each of them updates of the rigid motions of floating bodies.
        max_outer_iterations: usize = 50, Range::at_least(1.0);
        /// How A is applied.
        engine: Engine = Engine::Auto, Range::WORDS;
    }
}

impl Settings {
    /// Checks every option against its range, and the method against ρ and `coulomb`.
    ///
    /// # Errors
    /// [`QcqpError::Setting`], which names the option, its value and what is allowed.
    pub fn validate(&self) -> Result<(), QcqpError> {
        self.check_ranges()?;
        if self.coulomb == CoulombMethod::InLoop && self.method != Method::Grssn {
            return Err(QcqpError::Setting {
                name: "coulomb",
                value: self.coulomb.show(),
                allowed: "auto or fixed_point with methods other than grssn".to_owned(),
            });
        }
        let rho = self.rho;
        let allowed = match self.method {
            Method::Gimssn | Method::Grssn if rho >= 2.0 => {
                "below 2 for gimssn and grssn, which would not descend otherwise"
            }
            Method::Apgd if rho > 1.0 => "at most 1 for apgd, which would not descend otherwise",
            _ => return Ok(()),
        };
        Err(QcqpError::Setting {
            name: "rho",
            value: self.rho.show(),
            allowed: allowed.to_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_valid_and_listed_as_written() {
        Settings::default().validate().unwrap();
        let mut text = String::new();
        for option in Settings::options() {
            assert!(!option.doc.is_empty() && !option.allowed.is_empty());
            text += &format!("{} = {}\n", option.name, option.default);
        }
        // The list of options, written as a case file, is the default settings: no key is missing or misspelt.
        assert_eq!(
            toml::from_str::<Settings>(&text).unwrap(),
            Settings::default()
        );
        assert_eq!(toml::from_str::<Settings>("").unwrap(), Settings::default());
    }

    #[test]
    fn unknown_keys_and_words_are_refused() {
        let error = toml::from_str::<Settings>("tolerence = 1e-8")
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("tolerence") && error.contains("tolerance"),
            "{error}"
        );
        let error = toml::from_str::<Settings>("method = \"newton\"")
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("newton") && error.contains("grssn"),
            "{error}"
        );
        let error = "newton".parse::<Method>().unwrap_err().to_string();
        assert_eq!(
            error,
            "`newton` is no method: expected one of ssn, mssn, imssn, gimssn, grssn, apgd"
        );
        for &method in Method::ALL {
            assert_eq!(method.name().parse::<Method>().unwrap(), method);
            assert!(!method.doc().is_empty());
        }
    }

    #[test]
    fn values_out_of_range_are_named() {
        let refused = |settings: Settings| settings.validate().unwrap_err().to_string();
        assert_eq!(
            refused(Settings {
                tolerance: 0.0,
                ..Settings::default()
            }),
            "setting `tolerance` is 0.0, allowed is a number, 0 < value < 1"
        );
        assert!(
            refused(Settings {
                tolerance: f64::NAN,
                ..Settings::default()
            })
            .contains("NaN")
        );
        assert!(
            refused(Settings {
                max_inner_iterations: 0,
                ..Settings::default()
            })
            .contains("≥ 1")
        );
        let settings = Settings {
            rho: 2.0,
            method: Method::Gimssn,
            ..Settings::default()
        };
        assert!(refused(settings.clone()).contains("below 2"));
        Settings {
            method: Method::Mssn,
            ..settings
        }
        .validate()
        .unwrap();
    }
}
