//! How much of every support, load and slip bound acts at an instant.

/// What acts at an instant, entry by entry in the order of the lists of the
/// [`CaseFile`](super::CaseFile).
#[derive(Clone, Debug, PartialEq)]
pub struct Amounts {
    /// Displacements along x, y, z (length); `None` where the surfaces may move: the same components
    /// in all steps.
    pub supports: Vec<[Option<f64>; 3]>,
    /// Forces per area.
    pub tractions: Vec<Amount<[f64; 3]>>,
    /// Forces per area along the inward normal.
    pub pressures: Vec<Amount<f64>>,
    /// Forces per volume.
    pub body_forces: Vec<Amount<[f64; 3]>>,
    /// Accelerations.
    pub gravities: Vec<Amount<[f64; 3]>>,
    /// Displacements of the obstacles (length).
    pub motions: Vec<[f64; 3]>,
    /// Slip bounds of the contacts (force per area), 0 or more; always `Factor(1.0)` where the law has
    /// no bound of its own: frictionless, Coulomb, tied, bilateral without bound.
    pub bounds: Vec<Amount<f64>>,
}

/// How much of a quantity acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount<T> {
    /// The table's own value, multiplied by this.
    Factor(f64),
    /// This, over the whole surface or body, in the place of the table's own value.
    Value(T),
}

/// Quantities that can be multiplied and interpolated.
pub trait Quantity: Copy + PartialEq {
    /// Nothing.
    const ZERO: Self;

    /// factor × self.
    fn times(self, factor: f64) -> Self;

    /// (1 − t) self + t other.
    fn towards(self, other: Self, t: f64) -> Self;
}

impl Quantity for f64 {
    const ZERO: Self = 0.0;

    fn times(self, factor: f64) -> Self {
        factor * self
    }

    fn towards(self, other: Self, t: f64) -> Self {
        (1.0 - t) * self + t * other
    }
}

impl Quantity for [f64; 3] {
    const ZERO: Self = [0.0; 3];

    fn times(self, factor: f64) -> Self {
        self.map(|x| factor * x)
    }

    fn towards(self, other: Self, t: f64) -> Self {
        std::array::from_fn(|i| self[i].towards(other[i], t))
    }
}

impl<T: Quantity> Amount<T> {
    /// The amount, by the table's own value at a point.
    pub fn of(self, own: T) -> T {
        match self {
            Amount::Factor(factor) => own.times(factor),
            Amount::Value(value) => value,
        }
    }

    /// The amount, by the table's own value where that does not vary. Nothing is nothing of a
    /// varying value, too.
    fn resolved(self, own: Option<T>) -> Option<T> {
        match self {
            Amount::Factor(0.0) => Some(T::ZERO),
            Amount::Factor(factor) => own.map(|own| own.times(factor)),
            Amount::Value(value) => Some(value),
        }
    }

    /// A part t of the way from here to there; `None` between a factor of a varying value and a
    /// value.
    pub(super) fn towards(self, there: Self, t: f64, own: Option<T>) -> Option<Self> {
        if self == there || t == 1.0 {
            return Some(there);
        }
        match (self, there) {
            (Amount::Factor(a), Amount::Factor(b)) => Some(Amount::Factor(a.towards(b, t))),
            _ => {
                let (a, b) = (self.resolved(own)?, there.resolved(own)?);
                Some(Amount::Value(a.towards(b, t)))
            }
        }
    }
}
