//! New amounts of what a step names.

use std::fmt;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use tresca_model::{Amount, ContactId, Quantity, Shape, SupportId};

use crate::error::{CaseError, FaultKind};
use crate::reader::Reader;
use crate::text::at::At;

/// A new value in a load step, as it stands in the text.
#[derive(Clone, Debug)]
pub(crate) enum AmountKeys {
    /// A pressure or a slip bound.
    Number(f64),
    /// Any other load, or the motion of an obstacle.
    List(Vec<At<f64>>),
    /// A prescribed displacement.
    Components(ComponentKeys),
}

/// `{ x = …, y = …, z = … }`: components of a displacement.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ x = …, y = …, z = … }`")]
pub(crate) struct ComponentKeys {
    /// Along x (length).
    pub x: Option<At<f64>>,
    /// Along y (length).
    pub y: Option<At<f64>>,
    /// Along z (length).
    pub z: Option<At<f64>>,
}

impl<'de> Deserialize<'de> for AmountKeys {
    /// Not derived, for the same reason as with [`crate::field::FieldKeys`].
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AmountVisitor)
    }
}

struct AmountVisitor;

impl<'de> Visitor<'de> for AmountVisitor {
    type Value = AmountKeys;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a list of numbers or a table `{ x = …, y = …, z = … }`")
    }

    fn visit_f64<E>(self, value: f64) -> Result<AmountKeys, E> {
        Ok(AmountKeys::Number(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<AmountKeys, A::Error> {
        Deserialize::deserialize(SeqAccessDeserializer::new(list)).map(AmountKeys::List)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<AmountKeys, A::Error> {
        Deserialize::deserialize(MapAccessDeserializer::new(map)).map(AmountKeys::Components)
    }
}

impl Reader<'_> {
    pub(super) fn factor(
        &self,
        name: &At<String>,
        factor: &At<f64>,
        made: &[Quantity],
    ) -> Result<Amount, CaseError> {
        self.finite("the factor", factor)?;
        match made.first() {
            Some(Quantity::Motion(id)) if self.model.obstacles()[id.0].motion.is_none() => {
                Err(self
                    .fault(
                        FaultKind::BadReference,
                        name.span(),
                        format!("the obstacle `{}` has no motion", name.value),
                        "a factor of nothing",
                    )
                    .and_at(self.origins.place(*id), "the obstacle")
                    .with_help("give it a key `motion`, or a value in this step"))
            }
            Some(Quantity::SlipBound(id)) => {
                self.has_bounds(name, *id)?;
                let help = "the slip bound is multiplied by it";
                self.not_negative("the factor of a slip bound", factor, help)
                    .map(Amount::Factor)
            }
            _ => Ok(Amount::Factor(factor.value)),
        }
    }

    /// `before`: how much of it acts so far.
    pub(super) fn amount(
        &self,
        name: &At<String>,
        value: &At<AmountKeys>,
        quantity: Quantity,
        before: Amount,
    ) -> Result<Amount, CaseError> {
        let what = match quantity {
            Quantity::Support(id) => return self.new_displacement(name, value, id, before),
            Quantity::SlipBound(id) => return self.new_bound(name, value, id),
            Quantity::Load(id) => self.model.loads()[id.0].kind.traits().value_word,
            _ => "the motion",
        };
        match (self.model.shape(quantity), &value.value) {
            (Some(Shape::Scalar), _) => {
                let number = self.new_number(name, value)?;
                self.finite(what, &number).map(Amount::Scalar)
            }
            (_, AmountKeys::List(list)) => {
                let list = At::new(value.span(), list.clone());
                self.vector(what, &list).map(Amount::Vector)
            }
            _ => Err(self.other_amount(name, value, "a list of numbers", "a vector")),
        }
    }

    fn new_bound(
        &self,
        name: &At<String>,
        value: &At<AmountKeys>,
        contact: ContactId,
    ) -> Result<Amount, CaseError> {
        self.has_bounds(name, contact)?;
        if self.model.contacts()[contact.0].shape().is_none() {
            return Err(self
                .fault(
                    FaultKind::WrongType,
                    value.span(),
                    format!("`{}` has two slip bounds", name.value),
                    "expected a factor for both",
                )
                .with_help(format!("write `factors = {{ {} = … }}`", name.value)));
        }
        let number = self.new_number(name, value)?;
        let help = "it takes the place of the slip bound";
        self.not_negative("the slip bound", &number, help)
            .map(Amount::Scalar)
    }

    fn has_bounds(&self, name: &At<String>, contact: ContactId) -> Result<(), CaseError> {
        let law = &self.model.contacts()[contact.0];
        if law.has_bounds() {
            return Ok(());
        }
        Err(self
            .fault(
                FaultKind::BadReference,
                name.span(),
                format!("the contact `{}` has no slip bound", name.value),
                format!("its law is `{}`", law.friction.name()),
            )
            .and_at(self.origins.place(contact), "the contact")
            .with_help(
                "a [[step]] changes the slip bounds of `tresca`, `orthotropic` and `bilateral`",
            ))
    }

    /// Components that are not given stay as they are.
    fn new_displacement(
        &self,
        name: &At<String>,
        value: &At<AmountKeys>,
        support: SupportId,
        before: Amount,
    ) -> Result<Amount, CaseError> {
        let AmountKeys::Components(keys) = &value.value else {
            let expected = "a table `{ x = …, y = … }`";
            return Err(self.other_amount(name, value, expected, "a support"));
        };
        let keys = [&keys.x, &keys.y, &keys.z].map(Clone::clone);
        let spans = keys.each_ref().map(|key| key.as_ref().map(At::span));
        let new = self.displacement(keys)?;
        let held = &self.model.supports()[support.0];
        for ((axis, span), held) in ["x", "y", "z"].iter().zip(spans).zip(held.components) {
            let (Some(span), None) = (span, held) else {
                continue;
            };
            return Err(self
                .fault(
                    FaultKind::BadReference,
                    span,
                    format!("the support `{}` does not hold {axis}", name.value),
                    "a component that is free in the other steps",
                )
                .and_at(self.origins.place(support), "the support")
                .with_help("what is held stays the same in all steps; only the values change"));
        }
        let old = before.of_vector(held.vector());
        Ok(Amount::Vector(std::array::from_fn(|k| {
            new[k].unwrap_or(old[k])
        })))
    }

    fn new_number(&self, name: &At<String>, value: &At<AmountKeys>) -> Result<At<f64>, CaseError> {
        match &value.value {
            AmountKeys::Number(number) => Ok(At::new(value.span(), *number)),
            _ => Err(self.other_amount(name, value, "a number", "a pressure or slip bound")),
        }
    }

    fn other_amount(
        &self,
        name: &At<String>,
        value: &At<AmountKeys>,
        expected: &str,
        kind: &str,
    ) -> CaseError {
        let found = match value.value {
            AmountKeys::Number(_) => "a number",
            AmountKeys::List(_) => "a list",
            AmountKeys::Components(_) => "a table",
        };
        self.fault(
            FaultKind::WrongType,
            value.span(),
            format!("expected {expected} for `{}`", name.value),
            format!("found {found}"),
        )
        .and_at(name.span(), kind)
    }
}
