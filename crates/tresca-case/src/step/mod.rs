//! The history of loading: a list of steps, cut into increments, with the amount of every support,
//! load, motion and slip bound at the end of each.

mod amount;

use std::collections::BTreeMap;

use serde::Deserialize;
use tresca_io::names::{listed, nearest};
use tresca_model::{Amount, Model, Quantity, Step, Subject};

use crate::error::{CaseError, FaultKind};
use crate::origins::NamedTable;
use crate::reader::Reader;
use crate::text::at::At;
use amount::AmountKeys;
use tresca_io::located::Span;

/// Increments that all steps of a case may have together: more is a slip of the pen.
pub const MAX_INCREMENTS: usize = 100_000;

/// `[[step]]`: a step of the history of loading.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[step]]")]
pub(crate) struct StepKeys {
    /// What reports call it.
    pub name: Option<At<String>>,
    /// The instant of its end. Default: one more than that of the step before.
    pub time: Option<At<f64>>,
    /// Number of parts that the change is cut into. Default: 1.
    pub increments: Option<At<usize>>,
    /// By name of a support, load, obstacle or contact: what its own value is multiplied by.
    #[serde(default)]
    pub factors: BTreeMap<At<String>, At<f64>>,
    /// By name of a support, load, obstacle or contact: what takes the place of its own value.
    #[serde(default)]
    pub values: BTreeMap<At<String>, At<AmountKeys>>,
}
/// How much of everything acts.
type State = BTreeMap<Quantity, Amount>;

impl Reader<'_> {
    pub(crate) fn steps(&mut self, list: Vec<At<StepKeys>>) -> Result<(), CaseError> {
        // Obstacles come last in the documentation, but contacts need them.
        let names = &mut self.origins.names;
        names.sort_by_key(|table| matches!(table.made.first(), Some(Quantity::Motion(_))));
        self.different_names()?;
        let quantities: Vec<Quantity> = self.model.quantities().collect();
        let (mut time, mut before) = (0.0, at_rest(&quantities));
        // What the first step does not mention acts fully at its end, as without steps.
        let mut after: State = quantities.iter().map(|&q| (q, Amount::WHOLE)).collect();
        for keys in list {
            let span = keys.span();
            let keys = keys.value;
            let name = self.checked_name(keys.name)?.map(|name| name.value);
            let end = self.time(keys.time.as_ref(), time)?;
            let increments = self.increments(keys.increments.as_ref())?;
            for (name, factor) in &keys.factors {
                let made = &self.named(name)?.made;
                let factor = self.factor(name, factor, made)?;
                after.extend(made.iter().map(|&quantity| (quantity, factor)));
            }
            for (name, value) in &keys.values {
                if let Some((other, _)) = keys.factors.get_key_value(name) {
                    return Err(self
                        .fault(
                            FaultKind::Duplicate,
                            name.span(),
                            format!(
                                "`{}` has both a factor and a value in this step",
                                name.value
                            ),
                            "the value",
                        )
                        .and_at(other.span(), "the factor")
                        .with_help("remove one of the two"));
                }
                for &quantity in &self.named(name)?.made {
                    let amount = self.amount(name, value, quantity, after[&quantity])?;
                    after.insert(quantity, amount);
                }
            }
            for increment in 1..=increments {
                let t = increment as f64 / increments as f64;
                let between = between(&self.model, &before, &after, t);
                let amounts = between.map_err(|stuck| {
                    let mut given = keys.factors.keys().chain(keys.values.keys());
                    let by = given.find(|name| {
                        self.named(name)
                            .is_ok_and(|table| table.made.contains(&stuck))
                    });
                    self.no_way_between(by.map_or(span.clone(), At::span))
                })?;
                let mut step = Step::new((1.0 - t) * time + t * end);
                step.name = name.as_ref().map(|name| match increments {
                    1 => name.clone(),
                    _ => format!("{name}, increment {increment} of {increments}"),
                });
                step.amounts = amounts;
                let subject = Subject::Step(self.model.steps().len());
                self.origins.places.insert(subject, span.clone());
                let added = self.model.add_step(step).map(drop);
                added.map_err(|error| self.refused(&span, error))?;
            }
            (time, before) = (end, after.clone());
        }
        Ok(())
    }

    /// Names are unique over all lists, for steps do not say which list they mean.
    fn different_names(&self) -> Result<(), CaseError> {
        let names: Vec<&At<String>> = self.origins.names.iter().map(|table| &table.name).collect();
        for (i, name) in names.iter().enumerate() {
            if let Some(first) = names[..i].iter().find(|other| *other == name) {
                // The lists are in the order of the documentation, not of the file.
                let (first, second) = match first.span().start < name.span().start {
                    true => (first.span(), name.span()),
                    false => (name.span(), first.span()),
                };
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        second,
                        format!("the name `{}` is given twice", name.value),
                        "the second time",
                    )
                    .and_at(first, "the first time")
                    .with_help(
                        "supports, loads, obstacles and contacts have different names, so that a [[step]] \
                         can tell them apart",
                    )
                    );
            }
        }
        Ok(())
    }

    fn time(&self, time: Option<&At<f64>>, before: f64) -> Result<f64, CaseError> {
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
            .with_help("`time` is the instant of the end of a step; the first step starts at 0"))
    }

    fn increments(&self, increments: Option<&At<usize>>) -> Result<usize, CaseError> {
        let Some(increments) = increments else {
            return Ok(1);
        };
        let count = increments.value;
        let others = self.model.steps().len();
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
            )))
    }

    fn named(&self, name: &At<String>) -> Result<&NamedTable, CaseError> {
        let tables = &self.origins.names;
        if let Some(table) = tables.iter().find(|table| table.name == *name) {
            return Ok(table);
        }
        let all: Vec<&str> = tables.iter().map(|table| table.name.as_str()).collect();
        Err(self
            .fault(
                FaultKind::BadReference,
                name.span(),
                format!(
                    "no support, load, obstacle or contact is called `{}`",
                    name.value
                ),
                match nearest(name, all.iter().copied()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => {
                        "expected the `name` of a support, load, obstacle or contact".to_owned()
                    }
                },
            )
            .with_help(match all.as_slice() {
                [] => "none of them has a name in this file: give it a key `name`".to_owned(),
                _ => format!("the names of this case are {}", listed(&all)),
            }))
    }

    fn no_way_between(&self, place: Span) -> CaseError {
        self.fault(
            FaultKind::BadValue,
            place,
            "there is no way from the step before to this one in increments",
            "from a multiple of something that varies to a constant, or back",
        )
        .with_help("use factors in both steps, or a single increment")
    }
}

/// The state before the first step: bodies at rest under no load, surfaces as rough as ever.
fn at_rest(quantities: &[Quantity]) -> State {
    let amount = |quantity: &Quantity| match quantity {
        Quantity::SlipBound(_) => Amount::WHOLE,
        _ => Amount::NOTHING,
    };
    quantities.iter().map(|q| (*q, amount(q))).collect()
}

/// A part t of the way between two states; the error is what has no way, see [`Amount::towards`].
fn between(model: &Model, from: &State, to: &State, t: f64) -> Result<State, Quantity> {
    let mean = |(&quantity, &there): (&Quantity, &Amount)| {
        let own = model.constant(quantity);
        match from[&quantity].towards(there, t, own) {
            Some(amount) => Ok((quantity, amount)),
            None => Err(quantity),
        }
    };
    let all = to.iter().map(mean);
    // A step says what differs from the model.
    all.filter(|result| !matches!(result, Ok((_, amount)) if *amount == Amount::WHOLE))
        .collect()
}
