//! How much of a quantity acts.

/// What a load step makes of a quantity of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Amount {
    /// The model's own figure times this.
    Factor(f64),
    /// This number in the place of the model's own: of a pressure or a slip bound.
    Scalar(f64),
    /// This vector in the place of the model's own, global components: of everything else. Of a support the components
    /// that it prescribes count.
    Vector([f64; 3]),
}

/// What takes the place of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A number.
    Scalar,
    /// A vector.
    Vector,
}

impl Amount {
    /// The model's own figure.
    pub const WHOLE: Self = Amount::Factor(1.0);

    /// Nothing of it.
    pub const NOTHING: Self = Amount::Factor(0.0);

    /// What takes the place of the model's own figure; a factor has no shape.
    pub fn shape(self) -> Option<Shape> {
        match self {
            Amount::Factor(_) => None,
            Amount::Scalar(_) => Some(Shape::Scalar),
            Amount::Vector(_) => Some(Shape::Vector),
        }
    }

    /// Whether all its numbers are finite.
    pub fn is_finite(self) -> bool {
        match self {
            Amount::Factor(x) | Amount::Scalar(x) => x.is_finite(),
            Amount::Vector(x) => x.iter().all(|x| x.is_finite()),
        }
    }

    /// The number that acts, by the model's own. NaN for a vector, which [`Model::add_step`](crate::Model::add_step)
    /// refuses.
    pub fn of_scalar(self, own: f64) -> f64 {
        match self {
            Amount::Factor(factor) => factor * own,
            Amount::Scalar(value) => value,
            Amount::Vector(_) => f64::NAN,
        }
    }

    /// The vector that acts, by the model's own. NaN for a number, which
    /// [`Model::add_step`](crate::Model::add_step) refuses.
    pub fn of_vector(self, own: [f64; 3]) -> [f64; 3] {
        match self {
            Amount::Factor(factor) => own.map(|x| factor * x),
            Amount::Vector(value) => value,
            Amount::Scalar(_) => [f64::NAN; 3],
        }
    }

    fn times(self, factor: f64) -> Self {
        match self {
            Amount::Factor(x) => Amount::Factor(factor * x),
            Amount::Scalar(x) => Amount::Scalar(factor * x),
            Amount::Vector(x) => Amount::Vector(x.map(|x| factor * x)),
        }
    }

    /// The amount as a value, by the model's own where that does not vary. Nothing is nothing of a varying one, too:
    /// of the shape of `other`.
    fn as_value(self, own: Option<Amount>, other: Amount) -> Option<Self> {
        match self {
            Amount::Factor(factor) => match own {
                Some(own) => Some(own.times(factor)),
                None if factor == 0.0 && other.shape().is_some() => Some(other.times(0.0)),
                None => None,
            },
            value => Some(value),
        }
    }

    /// A part t of the way from here to there. `own` is the model's own value where it is the same everywhere; without,
    /// there is no way between a multiple of it and another value: `None`.
    pub fn towards(self, there: Self, t: f64, own: Option<Amount>) -> Option<Self> {
        let mean = |a: f64, b: f64| (1.0 - t) * a + t * b;
        if self == there || t == 1.0 {
            return Some(there);
        }
        let (a, b) = match (self, there) {
            (Amount::Factor(_), Amount::Factor(_)) => (self, there),
            _ => (self.as_value(own, there)?, there.as_value(own, self)?),
        };
        match (a, b) {
            (Amount::Factor(a), Amount::Factor(b)) => Some(Amount::Factor(mean(a, b))),
            (Amount::Scalar(a), Amount::Scalar(b)) => Some(Amount::Scalar(mean(a, b))),
            (Amount::Vector(a), Amount::Vector(b)) => {
                Some(Amount::Vector(std::array::from_fn(|i| mean(a[i], b[i]))))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Amount::{Factor, Scalar, Vector};

    #[test]
    fn an_amount_of_the_own_value() {
        assert_eq!(Factor(0.5).of_vector([2.0, 4.0, 6.0]), [1.0, 2.0, 3.0]);
        assert_eq!(Scalar(0.5).of_scalar(3.0), 0.5);
        assert!(Scalar(0.5).of_vector([1.0; 3])[0].is_nan());
    }

    #[test]
    fn factors_go_by_factors_and_values_by_values() {
        assert_eq!(
            Factor(1.0).towards(Factor(2.0), 0.5, None),
            Some(Factor(1.5))
        );
        let own = Some(Vector([0.0, 0.0, -1.0]));
        let there = Vector([0.0, 0.0, -3.0]);
        let half = Factor(0.5).towards(there, 0.5, own);
        assert_eq!(half, Some(Vector([0.0, 0.0, -1.75])));
        assert_eq!(Factor(0.5).towards(there, 0.5, None), None);
        assert_eq!(Factor(0.5).towards(there, 1.0, None), Some(there));
        // Nothing of a formula is nothing.
        assert_eq!(
            Factor(0.0).towards(Scalar(4.0), 0.5, None),
            Some(Scalar(2.0))
        );
    }
}
