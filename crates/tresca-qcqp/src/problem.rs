//! The dual problem.

use crate::coulomb::law::{CoulombBound, CoulombLaw};
use crate::equality::balance::{Balance, Equality};
use crate::error::{QcqpError, check_vector};
use crate::newton::operator_memory::OperatorMemory;
use crate::operator::dual_operator::DualOperator;
use crate::sets::product::ProductSet;

/// min ½ λᵀAλ − λᵀb over λ ∈ Λ, perhaps with an equality constraint, perhaps with bounds in Λ
/// that follow from λ (Coulomb's law).
///
/// In contact terms λ are the contact forces, A maps them to relative
/// displacements, b is the relative displacement (minus the gap) without them,
/// and r(λ) = Aλ − b is the open gap and the negative slip.
///
/// What a solve learns about A (the estimate of σmax, products to precondition with) is kept for
/// the next one, so that another b or other bounds cost no more than they must.
///
/// `'a` is how long the operator may live: it may work on memory that it does not own.
pub struct DualProblem<'a> {
    pub(crate) operator: Box<dyn DualOperator + 'a>,
    pub(crate) rhs: Vec<f64>,
    pub(crate) set: ProductSet,
    pub(crate) law: CoulombLaw,
    pub(crate) balance: Option<Balance>,
    pub(crate) memory: Option<OperatorMemory>,
    pub(crate) singular: bool,
}

impl<'a> DualProblem<'a> {
    /// Puts the parts together: `operator` A, `rhs` b, `set` Λ.
    ///
    /// # Errors
    /// When the sizes differ or b is not finite.
    pub fn new(
        operator: impl DualOperator + 'a,
        rhs: Vec<f64>,
        set: ProductSet,
    ) -> Result<Self, QcqpError> {
        let dim = operator.dim();
        check_vector("the right-hand side b", &rhs, dim)?;
        check_set(&set, dim)?;
        Ok(Self {
            operator: Box::new(operator),
            rhs,
            set,
            law: CoulombLaw::default(),
            balance: None,
            memory: None,
            singular: false,
        })
    }

    /// Adds the constraint Gλ = e. A must contain GᵀSG and b must contain GᵀSe, as they do when
    /// K is made regular by K + CCᵀ (then S = (RᵀCCᵀR)⁻¹): the multiplier α of the constraint,
    /// with r = Aλ − b − Gᵀα, is then the rigid motion. S matters for the work alone: best is about
    /// the compliance of the contact in these motions; thirty times as much does little harm, a
    /// thousand times as much makes A too ill-conditioned.
    ///
    /// # Errors
    /// When sizes differ, an entry is not finite, or S is not symmetric positive definite.
    pub fn with_equality(mut self, equality: &Equality) -> Result<Self, QcqpError> {
        self.balance = Some(Balance::new(equality, self.dim())?);
        Ok(self)
    }

    /// Lets bounds of Λ follow from normal forces. After a solve [`set`](Self::set) has the bounds
    /// of the solution.
    ///
    /// # Errors
    /// When a block or an unknown does not exist or does not fit, or a number is out of range.
    pub fn with_coulomb(mut self, bounds: Vec<CoulombBound>) -> Result<Self, QcqpError> {
        self.law = CoulombLaw::new(bounds, &self.set)?;
        Ok(self)
    }

    /// Another b.
    ///
    /// # Errors
    /// When its length differs or it is not finite.
    pub fn set_rhs(&mut self, rhs: Vec<f64>) -> Result<(), QcqpError> {
        check_vector("the right-hand side b", &rhs, self.dim())?;
        self.rhs = rhs;
        Ok(())
    }

    /// Another Λ.
    ///
    /// # Errors
    /// When its dimension differs, or a bound of Coulomb's law no longer finds its block.
    pub fn set_set(&mut self, set: ProductSet) -> Result<(), QcqpError> {
        check_set(&set, self.dim())?;
        self.law = CoulombLaw::new(self.law.bounds_of_blocks().to_vec(), &set)?;
        self.set = set;
        Ok(())
    }

    /// Other bounds that follow from normal forces.
    ///
    /// # Errors
    /// As [`with_coulomb`](Self::with_coulomb).
    pub fn set_coulomb(&mut self, bounds: Vec<CoulombBound>) -> Result<(), QcqpError> {
        self.law = CoulombLaw::new(bounds, &self.set)?;
        Ok(())
    }

    /// Another e. Without an equality constraint nothing happens.
    ///
    /// # Errors
    /// When its length differs or it is not finite.
    pub fn set_equality_rhs(&mut self, rhs: &[f64]) -> Result<(), QcqpError> {
        self.balance.as_mut().map_or(Ok(()), |b| b.set_load(rhs))
    }

    /// Says whether A is known to be singular, which a small explicit A shows by itself. Blocks of it are then
    /// factored a little off, so that of all solutions a short one is found, and methods without a guarantee are
    /// followed by proximal steps where they fail.
    pub fn set_singular(&mut self, singular: bool) {
        self.singular = singular;
    }

    /// Forgets what earlier solves have learnt about A, so that the next one counts as the first.
    pub fn forget(&mut self) {
        self.memory = None;
    }

    /// Number of unknowns.
    pub fn dim(&self) -> usize {
        self.rhs.len()
    }

    /// A.
    pub fn operator(&self) -> &(dyn DualOperator + 'a) {
        &*self.operator
    }

    /// A, to multiply with.
    pub fn operator_mut(&mut self) -> &mut (dyn DualOperator + 'a) {
        &mut *self.operator
    }

    /// b.
    pub fn rhs(&self) -> &[f64] {
        &self.rhs
    }

    /// Λ.
    pub fn set(&self) -> &ProductSet {
        &self.set
    }

    /// The bounds that follow from normal forces.
    pub fn coulomb(&self) -> &[CoulombBound] {
        self.law.bounds_of_blocks()
    }

    /// Number of rows of the equality constraint, 0 without one.
    pub fn equality_rows(&self) -> usize {
        self.balance.as_ref().map_or(0, |b| b.rows.len())
    }
}

fn check_set(set: &ProductSet, expected: usize) -> Result<(), QcqpError> {
    match set.dimension() {
        found if found == expected => Ok(()),
        found => Err(QcqpError::Dimension {
            what: "the feasible set",
            expected,
            found,
        }),
    }
}
