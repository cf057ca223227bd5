//! How supports, loads, obstacles and slip bounds vary from load step to load step.

use std::collections::BTreeMap;

use crate::amount::Amount;
use crate::identity::Quantity;

/// A state of a model. Friction acts on the slip from one step to the next.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// Instant in the time series; has no influence on the answer.
    pub time: f64,
    /// How reports call it.
    pub name: Option<String>,
    /// What differs from the model: whatever is not mentioned acts as the model gives it.
    pub amounts: BTreeMap<Quantity, Amount>,
}

impl Step {
    /// Everything as the model gives it.
    pub fn new(time: f64) -> Self {
        Self {
            time,
            name: None,
            amounts: BTreeMap::new(),
        }
    }

    /// With a name, by which reports call it.
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }

    /// With another amount of something.
    #[must_use]
    pub fn with(mut self, what: impl Into<Quantity>, amount: Amount) -> Self {
        self.amounts.insert(what.into(), amount);
        self
    }

    /// How much of something acts.
    pub fn amount(&self, what: impl Into<Quantity>) -> Amount {
        let amount = self.amounts.get(&what.into());
        amount.copied().unwrap_or(Amount::WHOLE)
    }
}
