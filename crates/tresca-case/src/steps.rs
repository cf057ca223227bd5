//! The history of loading: a list of steps, cut into increments, with the amount of every support,
//! load and slip bound at the end of each.

use toml::Spanned;

use super::amounts::{Amount, Amounts, Quantity};
use super::check::Check;
use super::contact::Contact;
use super::entries::ValueKeys;
use super::error::{CaseError, FaultKind};
use super::friction::Friction;
use super::keys::StepKeys;
use super::loading::{Item, Loading};
use super::loads::Support;
use super::source::Span;
use tresca_io::names::{listed, nearest};

/// Increments that all steps of a case may have together: more is a slip of the pen.
pub const MAX_INCREMENTS: usize = 100_000;

/// One increment of the history of loading: a state of the loads for which equilibrium is sought.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Name of the step in the file.
    pub name: Option<String>,
    /// Number of the step in the file, from 0.
    pub number: usize,
    /// Number of the increment in its step, from 1.
    pub increment: usize,
    /// Number of increments of its step.
    pub increments: usize,
    /// The instant of its end; larger than that of the increment before, and than 0.
    pub time: f64,
    /// What acts at that instant.
    pub amounts: Amounts,
}

impl Check<'_> {
    pub(super) fn steps(
        &self,
        list: Vec<Spanned<StepKeys>>,
        loading: &Loading<'_>,
    ) -> Result<Vec<Step>, CaseError> {
        let names = loading.names();
        self.different(&names)?;
        if list.is_empty() {
            return Ok(vec![Step {
                name: None,
                number: 0,
                increment: 1,
                increments: 1,
                time: 1.0,
                amounts: loading.full(),
            }]);
        }
        let mut steps = Vec::new();
        let (mut time, mut before) = (0.0, loading.rest());
        for (number, keys) in list.into_iter().enumerate() {
            let span = keys.span();
            let keys = keys.into_inner();
            let name = self.item_name(keys.name)?.map(Spanned::into_inner);
            let end = self.time(keys.time.as_ref(), time)?;
            let increments = self.increments(keys.increments.as_ref(), steps.len())?;
            // What the first step does not mention acts fully at its end, as without steps.
            let mut after = match number {
                0 => loading.full(),
                _ => before.clone(),
            };
            for (name, factor) in &keys.factors {
                let item = self.named(name, &names)?;
                self.set_factor(item, name, factor, loading, &mut after)?;
            }
            for (name, value) in &keys.values {
                if let Some((other, _)) = keys.factors.get_key_value(name) {
                    return Err(self
                        .fault(
                            FaultKind::Duplicate,
                            name.span(),
                            format!(
                                "`{}` has both a factor and a value in this step",
                                name.get_ref()
                            ),
                            "the value",
                        )
                        .and_at(other.span(), "the factor")
                        .with_help("remove one of the two")
                        .into());
                }
                let item = self.named(name, &names)?;
                self.set_value(item, name, value, loading, &mut after)?;
            }
            for increment in 1..=increments {
                let t = increment as f64 / increments as f64;
                let Some(amounts) = loading.between(&before, &after, t) else {
                    let given = keys.factors.keys().chain(keys.values.keys());
                    let stuck = given.filter(|name| {
                        self.named(name, &names)
                            .is_ok_and(|item| loading.is_stuck(item, &before, &after))
                    });
                    let place = stuck.map(Spanned::span).next().unwrap_or(span);
                    return Err(self.no_way_between(place));
                };
                steps.push(Step {
                    name: name.clone(),
                    number,
                    increment,
                    increments,
                    time: time.towards(end, t),
                    amounts,
                });
            }
            (time, before) = (end, after);
        }
        Ok(steps)
    }

    /// Names are unique over all lists, for steps do not say which list they mean.
    fn different(&self, names: &[(&Spanned<String>, Item)]) -> Result<(), CaseError> {
        for (i, (name, _)) in names.iter().enumerate() {
            if let Some((first, _)) = names[..i].iter().find(|(other, _)| other == name) {
                // The lists are in the order of the documentation, not of the file.
                let (first, second) = match first.span().start < name.span().start {
                    true => (first.span(), name.span()),
                    false => (name.span(), first.span()),
                };
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        second,
                        format!("the name `{}` is given twice", name.get_ref()),
                        "the second time",
                    )
                    .and_at(first, "the first time")
                    .with_help(
                        "supports, loads, obstacles and contacts have different names, so that a [[step]] \
                         can tell them apart",
                    )
                    .into());
            }
        }
        Ok(())
    }

    fn time(&self, time: Option<&Spanned<f64>>, before: f64) -> Result<f64, CaseError> {
        let Some(time) = time else {
            return Ok(before + 1.0);
        };
        let end = self.finite("the time", time)?;
        if end > before {
            return Ok(end);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                time.span(),
                "the time does not increase",
                format!("expected more than {before:?}, found {end:?}"),
            )
            .with_help("`time` is the instant of the end of a step; the first step starts at 0")
            .into())
    }

    /// `others`: the increments of the steps before.
    fn increments(
        &self,
        increments: Option<&Spanned<usize>>,
        others: usize,
    ) -> Result<usize, CaseError> {
        let Some(increments) = increments else {
            return Ok(1);
        };
        let count = *increments.get_ref();
        let largest = MAX_INCREMENTS.saturating_sub(others);
        if (1..=largest).contains(&count) {
            return Ok(count);
        }
        let label = match count {
            0 => "expected 1 or more, found 0".to_owned(),
            _ => format!("expected at most {largest}, found {count}"),
        };
        Err(self
            .fault(
                FaultKind::BadValue,
                increments.span(),
                "a step cannot have this number of increments",
                label,
            )
            .with_help(format!(
                "a case has at most {MAX_INCREMENTS} increments, in each of which the contact \
                 problem is solved"
            ))
            .into())
    }

    fn named(
        &self,
        name: &Spanned<String>,
        names: &[(&Spanned<String>, Item)],
    ) -> Result<Item, CaseError> {
        if let Some((_, item)) = names.iter().find(|(known, _)| *known == name) {
            return Ok(*item);
        }
        let all: Vec<&str> = names
            .iter()
            .map(|(name, _)| name.get_ref().as_str())
            .collect();
        Err(self
            .fault(
                FaultKind::BadReference,
                name.span(),
                format!(
                    "no support, load, obstacle or contact is called `{}`",
                    name.get_ref()
                ),
                match nearest(name.get_ref(), all.iter().copied()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => {
                        "expected the `name` of a support, load, obstacle or contact".to_owned()
                    }
                },
            )
            .with_help(match all.as_slice() {
                [] => "none of them has a name in this file: give it a key `name`".to_owned(),
                _ => format!("the names of this case are {}", listed(&all)),
            })
            .into())
    }

    fn set_factor(
        &self,
        item: Item,
        name: &Spanned<String>,
        factor: &Spanned<f64>,
        loading: &Loading<'_>,
        amounts: &mut Amounts,
    ) -> Result<(), CaseError> {
        let number = self.finite("the factor", factor)?;
        match item {
            Item::Support(i) => {
                amounts.supports[i] = loading.supports[i]
                    .displacement
                    .map(|u| u.map(|u| u.times(number)));
            }
            Item::Traction(i) => amounts.tractions[i] = Amount::Factor(number),
            Item::Pressure(i) => amounts.pressures[i] = Amount::Factor(number),
            Item::BodyForce(i) => amounts.body_forces[i] = Amount::Factor(number),
            Item::Gravity(i) => amounts.gravities[i] = Amount::Factor(number),
            Item::Obstacle(i) => {
                let obstacle = &loading.obstacles[i];
                let Some(motion) = obstacle.motion else {
                    return Err(self
                        .fault(
                            FaultKind::BadReference,
                            name.span(),
                            format!("the obstacle `{}` has no motion", name.get_ref()),
                            "a factor of nothing",
                        )
                        .and_at(obstacle.span.clone(), "the obstacle")
                        .with_help("give it a key `motion`, or a value in this step")
                        .into());
                };
                amounts.motions[i] = motion.times(number);
            }
            Item::Contact(i) => {
                self.has_bound(name, &loading.contacts[i])?;
                let help = "the slip bound is multiplied by it";
                self.not_negative("the factor of a slip bound", factor, help)?;
                amounts.bounds[i] = Amount::Factor(number);
            }
        }
        Ok(())
    }

    fn set_value(
        &self,
        item: Item,
        name: &Spanned<String>,
        value: &Spanned<ValueKeys>,
        loading: &Loading<'_>,
        amounts: &mut Amounts,
    ) -> Result<(), CaseError> {
        match item {
            Item::Support(i) => {
                let new = self.new_displacement(name, value, &loading.supports[i])?;
                for (component, new) in amounts.supports[i].iter_mut().zip(new) {
                    *component = new.or(*component);
                }
            }
            Item::Traction(i) => {
                amounts.tractions[i] =
                    Amount::Value(self.new_vector("the traction", name, value)?);
            }
            Item::Pressure(i) => {
                let number = self.new_number(name, value)?;
                amounts.pressures[i] = Amount::Value(self.finite("the pressure", &number)?);
            }
            Item::BodyForce(i) => {
                let vector = self.new_vector("the body force", name, value)?;
                amounts.body_forces[i] = Amount::Value(vector);
            }
            Item::Gravity(i) => {
                let vector = self.new_vector("the acceleration", name, value)?;
                amounts.gravities[i] = Amount::Value(vector);
            }
            Item::Obstacle(i) => {
                amounts.motions[i] = self.new_vector("the motion", name, value)?;
            }
            Item::Contact(i) => {
                let contact = &loading.contacts[i];
                self.has_bound(name, contact)?;
                if matches!(contact.friction, Friction::Orthotropic { .. }) {
                    return Err(self
                        .fault(
                            FaultKind::WrongType,
                            value.span(),
                            format!("`{}` has two slip bounds", name.get_ref()),
                            "expected a factor for both",
                        )
                        .with_help(format!("write `factors = {{ {} = … }}`", name.get_ref()))
                        .into());
                }
                let number = self.new_number(name, value)?;
                let help = "it takes the place of the slip bound";
                let bound = self.not_negative("the slip bound", &number, help)?;
                amounts.bounds[i] = Amount::Value(bound);
            }
        }
        Ok(())
    }

    fn has_bound(&self, name: &Spanned<String>, contact: &Contact) -> Result<(), CaseError> {
        match &contact.friction {
            Friction::Tresca { .. }
            | Friction::Orthotropic { .. }
            | Friction::Bilateral { bound: Some(_) } => Ok(()),
            other => Err(self
                .fault(
                    FaultKind::BadReference,
                    name.span(),
                    format!("the contact `{}` has no slip bound", name.get_ref()),
                    format!("its law is `{}`", other.law()),
                )
                .and_at(contact.span.clone(), "the contact")
                .with_help(
                    "a [[step]] changes the slip bounds of `tresca`, `orthotropic` and `bilateral`",
                )
                .into()),
        }
    }

    fn new_displacement(
        &self,
        name: &Spanned<String>,
        value: &Spanned<ValueKeys>,
        support: &Support,
    ) -> Result<[Option<f64>; 3], CaseError> {
        let ValueKeys::Components(keys) = value.get_ref() else {
            return Err(self.other_value(name, value, "a table `{ x = …, y = … }`", "a support"));
        };
        let keys = [&keys.x, &keys.y, &keys.z].map(Clone::clone);
        let spans = keys.each_ref().map(|key| key.as_ref().map(Spanned::span));
        let new = self.displacement(keys)?;
        for ((axis, span), held) in ["x", "y", "z"].iter().zip(spans).zip(support.displacement) {
            let (Some(span), None) = (span, held) else {
                continue;
            };
            return Err(self
                .fault(
                    FaultKind::BadReference,
                    span,
                    format!("the support `{}` does not hold {axis}", name.get_ref()),
                    "a component that is free in the other steps",
                )
                .and_at(support.span.clone(), "the support")
                .with_help("what is held stays the same in all steps; only the values change")
                .into());
        }
        Ok(new)
    }

    fn new_vector(
        &self,
        what: &str,
        name: &Spanned<String>,
        value: &Spanned<ValueKeys>,
    ) -> Result<[f64; 3], CaseError> {
        match value.get_ref() {
            ValueKeys::List(list) => self.vector(what, &Spanned::new(value.span(), list.clone())),
            _ => Err(self.other_value(name, value, "a list of numbers", "a vector")),
        }
    }

    fn new_number(
        &self,
        name: &Spanned<String>,
        value: &Spanned<ValueKeys>,
    ) -> Result<Spanned<f64>, CaseError> {
        match value.get_ref() {
            ValueKeys::Number(number) => Ok(Spanned::new(value.span(), *number)),
            _ => Err(self.other_value(name, value, "a number", "a pressure or slip bound")),
        }
    }

    fn other_value(
        &self,
        name: &Spanned<String>,
        value: &Spanned<ValueKeys>,
        expected: &str,
        kind: &str,
    ) -> CaseError {
        let found = match value.get_ref() {
            ValueKeys::Number(_) => "a number",
            ValueKeys::List(_) => "a list",
            ValueKeys::Components(_) => "a table",
        };
        self.fault(
            FaultKind::WrongType,
            value.span(),
            format!("expected {expected} for `{}`", name.get_ref()),
            format!("found {found}"),
        )
        .and_at(name.span(), kind)
        .into()
    }

    fn no_way_between(&self, place: Span) -> CaseError {
        self.fault(
            FaultKind::BadValue,
            place,
            "there is no way from the step before to this one in increments",
            "from a multiple of something that varies to a constant, or back",
        )
        .with_help("use factors in both steps, or a single increment")
        .into()
    }
}
