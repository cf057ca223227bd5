//! Friction laws and their figures.

use serde::Deserialize;
use toml::de::{DeTable, DeValue};
use tresca_contact::{FrictionLaw, ScalarField};
use tresca_io::located::{SourceText, Span};
use tresca_io::names::listed;

use crate::error::{CaseError, FaultKind};
use crate::field::{FieldKeys, Kind};
use crate::numbers::Triple;
use crate::reader::Reader;
use crate::text::at::At;
use crate::text::shape::unsupported;

/// `friction`: the law and its figures. All figures of all laws stand here; which of them a law
/// takes is checked afterwards, so that the report can name the law.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ law = \"tresca\", bound = … }`"
)]
pub(crate) struct FrictionKeys {
    /// The law, one of [`FrictionLaw::NAMES`].
    pub law: At<String>,
    /// Slip bound (force per area), 0 or more: the tangential traction at which the pair slides.
    pub bound: Option<At<FieldKeys>>,
    /// Slip bounds along the two axes (force per area).
    pub bounds: Option<At<Vec<At<FieldKeys>>>>,
    /// Coefficient of friction, 0 or more.
    pub coefficient: Option<At<f64>>,
    /// Coefficients of friction along the two axes.
    pub coefficients: Option<At<Vec<At<f64>>>>,
    /// The first axis of friction, in the directions of the axes of space.
    pub axis: Option<At<Triple<f64>>>,
    /// Largest slip bound (force per area), whatever the normal force.
    pub limit: Option<At<FieldKeys>>,
}

/// The keys that each law of [`FrictionLaw::NAMES`] takes beside `law`.
const KEYS: [&[&str]; FrictionLaw::NAMES.len()] = [
    &[],
    &["bound"],
    &["bounds", "axis"],
    &["coefficient", "coefficients", "axis", "limit"],
    &[],
    &["bound"],
];

const BOUND_HELP: &str = "it is the tangential traction (force per area) at which the pair slides; \
                          0.0 is no friction";

impl Reader<'_> {
    pub(crate) fn friction(&self, keys: &At<FrictionKeys>) -> Result<FrictionLaw, CaseError> {
        let span = keys.span();
        self.keys_of_law(keys)?;
        match keys.law.as_str() {
            "frictionless" => Ok(FrictionLaw::Frictionless),
            "orthotropic" => self.orthotropic(keys, span),
            "coulomb" => self.coulomb(keys, span),
            "tied" => Ok(FrictionLaw::Tied),
            "bilateral" => Ok(FrictionLaw::Bilateral {
                bound: self.bound(keys.bound.as_ref())?,
            }),
            // Laws beside those of the list were refused by `known_laws`.
            _ => {
                let Some(bound) = self.bound(keys.bound.as_ref())? else {
                    return Err(self.missing_figure(
                        keys,
                        span,
                        "bound",
                        "`bound` is the tangential traction (force per area) at which the pair \
                         slides; 0.0 is no friction",
                    ));
                };
                Ok(FrictionLaw::Tresca { bound })
            }
        }
    }

    fn orthotropic(&self, keys: &FrictionKeys, span: Span) -> Result<FrictionLaw, CaseError> {
        self.only_in_space(keys, "orthotropic friction")?;
        let Some(bounds) = &keys.bounds else {
            return Err(self.missing_figure(
                keys,
                span,
                "bounds",
                "`bounds = [g1, g2]` are the slip bounds (force per area) along `axis` and across it",
            ));
        };
        let [first, second] = self.two("bounds", bounds)?;
        Ok(FrictionLaw::Orthotropic {
            bounds: [self.slip_bound(first)?, self.slip_bound(second)?],
            axis: self.axis(keys, span)?,
        })
    }

    fn coulomb(&self, keys: &FrictionKeys, span: Span) -> Result<FrictionLaw, CaseError> {
        let limit = keys
            .limit
            .as_ref()
            .map(|limit| {
                let help =
                    "it is the largest slip bound (force per area), whatever the normal force";
                self.field("the limit of the slip bound", Kind::Bound, limit, help)
            })
            .transpose()?;
        match (&keys.coefficient, &keys.coefficients) {
            (None, None) => Err(self.missing_figure(
                keys,
                span,
                "coefficient",
                "`coefficient` is the ratio of tangential to normal traction at which the pair slides",
            )),
            (Some(one), Some(two)) => Err(self
                .fault(
                    FaultKind::Duplicate,
                    two.span(),
                    "`coefficient` and `coefficients` exclude each other",
                    "one coefficient for each of two axes",
                )
                .and_at(one.span(), "one coefficient for all directions")
                .with_help("remove one of the two")),
            (Some(coefficient), None) => {
                if let Some(axis) = &keys.axis {
                    return Err(self
                        .fault(
                            FaultKind::UnknownKey,
                            axis.span(),
                            "one `coefficient` for all directions takes no `axis`",
                            "expected `coefficients` along with it",
                        )
                        .with_help("write `coefficients = [F1, F2]`, or remove `axis`")
                        );
                }
                Ok(FrictionLaw::Coulomb {
                    coefficients: [self.coefficient(coefficient)?; 2],
                    axis: None,
                    limit,
                })
            }
            (None, Some(coefficients)) => {
                self.only_in_space(keys, "friction with two `coefficients`")?;
                let [first, second] = self.two("coefficients", coefficients)?;
                Ok(FrictionLaw::Coulomb {
                    coefficients: [self.coefficient(first)?, self.coefficient(second)?],
                    axis: Some(self.axis(keys, span)?),
                    limit,
                })
            }
        }
    }

    fn bound(&self, keys: Option<&At<FieldKeys>>) -> Result<Option<ScalarField>, CaseError> {
        keys.map(|keys| self.slip_bound(keys)).transpose()
    }

    fn slip_bound(&self, keys: &At<FieldKeys>) -> Result<ScalarField, CaseError> {
        self.field("the slip bound", Kind::Bound, keys, BOUND_HELP)
    }

    fn coefficient(&self, value: &At<f64>) -> Result<f64, CaseError> {
        let help = "it is the ratio of tangential to normal traction at which the pair slides";
        self.not_negative("the coefficient of friction", value, help)
    }

    fn axis(&self, keys: &FrictionKeys, span: Span) -> Result<[f64; 3], CaseError> {
        let help = "`axis = [x, y, z]` is the direction of the first axis; its part in the tangential \
                    plane counts";
        let Some(axis) = &keys.axis else {
            return Err(self.missing_figure(keys, span, "axis", help));
        };
        self.finite_components("the axis", axis)?;
        let values = axis.values();
        if values == [0.0; 3] {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    axis.span(),
                    "the axis has no direction",
                    "expected a vector that is not zero",
                )
                .with_help(help));
        }
        Ok(values)
    }

    fn two<'k, T>(&self, key: &str, list: &'k At<Vec<T>>) -> Result<&'k [T; 2], CaseError> {
        let found = list.len();
        <&[T; 2]>::try_from(list.as_slice()).map_err(|_| {
            self.fault(
                FaultKind::WrongType,
                list.span(),
                "a list of the wrong length",
                format!("expected 2 entries, found {found}"),
            )
            .with_help(format!(
                "`{key}` has one entry for the axis and one for the direction across it"
            ))
        })
    }

    fn only_in_space(&self, keys: &FrictionKeys, what: &str) -> Result<(), CaseError> {
        if self.analysis.dimension() == 3 {
            return Ok(());
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                keys.law.span(),
                format!("{what} needs bodies in space"),
                format!(
                    "`analysis = \"{}\"` has one tangential direction",
                    self.analysis.word()
                ),
            )
            .with_help("use `tresca` with a `bound`, or `coulomb` with a `coefficient`"))
    }

    fn missing_figure(&self, keys: &FrictionKeys, span: Span, key: &str, help: &str) -> CaseError {
        let article = if key.ends_with('s') { "" } else { "a " };
        self.fault(
            FaultKind::MissingKey,
            span,
            format!(
                "the friction law `{}` needs {article}`{key}`",
                keys.law.value
            ),
            format!("expected `{key}` in this table"),
        )
        .with_help(help)
    }

    /// Refuses the keys of other laws.
    fn keys_of_law(&self, keys: &FrictionKeys) -> Result<(), CaseError> {
        let law = keys.law.as_str();
        let laws = || FrictionLaw::NAMES.into_iter().zip(KEYS);
        let taken = laws()
            .find(|(name, _)| *name == law)
            .map_or(&[][..], |(_, keys)| keys);
        let given = [
            ("bound", keys.bound.as_ref().map(At::span)),
            ("bounds", keys.bounds.as_ref().map(At::span)),
            ("coefficient", keys.coefficient.as_ref().map(At::span)),
            ("coefficients", keys.coefficients.as_ref().map(At::span)),
            ("axis", keys.axis.as_ref().map(At::span)),
            ("limit", keys.limit.as_ref().map(At::span)),
        ];
        for (key, span) in given {
            let Some(span) = span else { continue };
            if taken.contains(&key) {
                continue;
            }
            let owners: Vec<&str> = laws()
                .filter(|(_, keys)| keys.contains(&key))
                .map(|(name, _)| name)
                .collect();
            return Err(self
                .fault(
                    FaultKind::UnknownKey,
                    span,
                    format!("the friction law `{law}` takes no `{key}`"),
                    format!("`{key}` belongs to {}", listed(&owners)),
                )
                .and_at(keys.law.span(), "the law")
                .with_help(match taken {
                    [] => format!("`{law}` takes no further keys"),
                    _ => format!("`{law}` takes {}", listed(taken)),
                }));
        }
        Ok(())
    }
}

/// Friction laws that are not known. Without this the report on a law of another version would name
/// one of its keys instead of the law.
pub(crate) fn known_laws(source: &SourceText, root: &DeTable<'_>) -> Result<(), CaseError> {
    let contacts = root
        .get("contact")
        .and_then(|list| list.get_ref().as_array());
    let laws = contacts
        .into_iter()
        .flatten()
        .filter_map(|contact| contact.get_ref().get("friction")?.get_ref().get("law"));
    for law in laws {
        if let DeValue::String(name) = law.get_ref()
            && !FrictionLaw::NAMES.contains(&name.as_ref())
        {
            return Err(unsupported(
                source,
                law.span(),
                format!("the friction law `{name}` is not supported"),
                name,
                &FrictionLaw::NAMES,
            ));
        }
    }
    Ok(())
}
