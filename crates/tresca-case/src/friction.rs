//! Friction laws and their figures.

use toml::Spanned;

use super::check::Check;
use super::entries::FieldKeys;
use super::error::{CaseError, FaultKind};
use super::fields::{Field, Kind};
use super::keys::FrictionKeys;
use super::source::Span;
use tresca_io::names::listed;

/// What a contact pair does along its normal and in its tangential plane.
///
/// Slip bounds are forces per undeformed area, 0 or more where they are constant or from a file;
/// formulas are for the caller to check. λν is the normal traction, λτ the tangential one.
#[derive(Clone, Debug)]
pub enum Friction {
    /// No tangential traction.
    Frictionless,
    /// Tresca's law: the pair slides when its tangential traction reaches the bound, whatever the
    /// normal force.
    Tresca {
        /// The slip bound.
        bound: Spanned<Field>,
    },
    /// Tresca's law with a slip bound that depends on the direction:
    /// (λ₁/g₁)² + (λ₂/g₂)² ≤ 1. In space only.
    Orthotropic {
        /// The bounds g₁ and g₂ along the two axes.
        bounds: [Spanned<Field>; 2],
        /// Direction of the first axis in space, not zero; its part in the tangential plane counts,
        /// and the second axis is perpendicular to it.
        axis: Spanned<[f64; 3]>,
    },
    /// Coulomb's law: the slip bound is min(F λν, limit).
    Coulomb {
        /// The coefficient F, finite, 0 or more.
        coefficient: Spanned<f64>,
        /// Largest slip bound; none when absent.
        limit: Option<Spanned<Field>>,
    },
    /// Coulomb's law with coefficients that depend on the direction: the slip bounds along the two axes
    /// are F₁ and F₂ times min(λν, limit/max(F₁, F₂)): the limit is that of the larger bound. In space only.
    OrthotropicCoulomb {
        /// The coefficients F₁ and F₂, finite, 0 or more.
        coefficients: [Spanned<f64>; 2],
        /// As in [`Friction::Orthotropic`].
        axis: Spanned<[f64; 3]>,
        /// Largest slip bound; none when absent.
        limit: Option<Spanned<Field>>,
    },
    /// The two surfaces are glued: they neither open nor slide.
    Tied,
    /// The two surfaces do not open; they slide freely, or as with Tresca's law.
    Bilateral {
        /// The slip bound; free sliding when absent.
        bound: Option<Spanned<Field>>,
    },
}

/// The laws as case files call them. The position of a law is its number in result files.
pub const LAWS: [&str; 6] = [
    "frictionless",
    "tresca",
    "orthotropic",
    "coulomb",
    "tied",
    "bilateral",
];

/// The keys that each law takes beside `law`.
const KEYS: [&[&str]; LAWS.len()] = [
    &[],
    &["bound"],
    &["bounds", "axis"],
    &["coefficient", "coefficients", "axis", "limit"],
    &[],
    &["bound"],
];

impl Friction {
    /// The law as case files call it.
    pub fn law(&self) -> &'static str {
        LAWS[usize::from(self.number())]
    }

    /// The number of the law in result files: its position in [`LAWS`].
    pub fn number(&self) -> u8 {
        match self {
            Friction::Frictionless => 0,
            Friction::Tresca { .. } => 1,
            Friction::Orthotropic { .. } => 2,
            Friction::Coulomb { .. } | Friction::OrthotropicCoulomb { .. } => 3,
            Friction::Tied => 4,
            Friction::Bilateral { .. } => 5,
        }
    }
}

const BOUND_HELP: &str = "it is the tangential traction (force per area) at which the pair slides; \
                          0.0 is no friction";

impl Check<'_> {
    pub(super) fn friction(&self, keys: &Spanned<FrictionKeys>) -> Result<Friction, CaseError> {
        let span = keys.span();
        let keys = keys.get_ref();
        self.keys_of_law(keys)?;
        match keys.law.get_ref().as_str() {
            "frictionless" => Ok(Friction::Frictionless),
            "orthotropic" => self.orthotropic(keys, span),
            "coulomb" => self.coulomb(keys, span),
            "tied" => Ok(Friction::Tied),
            "bilateral" => Ok(Friction::Bilateral {
                bound: self.bound(keys.bound.as_ref())?,
            }),
            // Laws beside those of the list were refused by `precheck::friction_laws`.
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
                Ok(Friction::Tresca { bound })
            }
        }
    }

    fn orthotropic(&self, keys: &FrictionKeys, span: Span) -> Result<Friction, CaseError> {
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
        Ok(Friction::Orthotropic {
            bounds: [self.slip_bound(first)?, self.slip_bound(second)?],
            axis: self.axis(keys, span)?,
        })
    }

    fn coulomb(&self, keys: &FrictionKeys, span: Span) -> Result<Friction, CaseError> {
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
                .with_help("remove one of the two")
                .into()),
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
                        .into());
                }
                Ok(Friction::Coulomb {
                    coefficient: self.coefficient(coefficient)?,
                    limit,
                })
            }
            (None, Some(coefficients)) => {
                self.only_in_space(keys, "friction with two `coefficients`")?;
                let [first, second] = self.two("coefficients", coefficients)?;
                Ok(Friction::OrthotropicCoulomb {
                    coefficients: [self.coefficient(first)?, self.coefficient(second)?],
                    axis: self.axis(keys, span)?,
                    limit,
                })
            }
        }
    }

    fn bound(
        &self,
        keys: Option<&Spanned<FieldKeys>>,
    ) -> Result<Option<Spanned<Field>>, CaseError> {
        keys.map(|keys| self.slip_bound(keys)).transpose()
    }

    fn slip_bound(&self, keys: &Spanned<FieldKeys>) -> Result<Spanned<Field>, CaseError> {
        self.field("the slip bound", Kind::Bound, keys, BOUND_HELP)
    }

    fn coefficient(&self, value: &Spanned<f64>) -> Result<Spanned<f64>, CaseError> {
        let help = "it is the ratio of tangential to normal traction at which the pair slides";
        self.not_negative("the coefficient of friction", value, help)?;
        Ok(value.clone())
    }

    fn axis(&self, keys: &FrictionKeys, span: Span) -> Result<Spanned<[f64; 3]>, CaseError> {
        let help = "`axis = [x, y, z]` is the direction of the first axis; its part in the tangential \
                    plane counts";
        let Some(axis) = &keys.axis else {
            return Err(self.missing_figure(keys, span, "axis", help));
        };
        self.finite_components("the axis", axis)?;
        let values = axis.get_ref().values();
        if values == [0.0; 3] {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    axis.span(),
                    "the axis has no direction",
                    "expected a vector that is not zero",
                )
                .with_help(help)
                .into());
        }
        Ok(Spanned::new(axis.span(), values))
    }

    fn two<'k, T>(&self, key: &str, list: &'k Spanned<Vec<T>>) -> Result<&'k [T; 2], CaseError> {
        let found = list.get_ref().len();
        <&[T; 2]>::try_from(list.get_ref().as_slice()).map_err(|_| {
            self.fault(
                FaultKind::WrongType,
                list.span(),
                "a list of the wrong length",
                format!("expected 2 entries, found {found}"),
            )
            .with_help(format!(
                "`{key}` has one entry for the axis and one for the direction across it"
            ))
            .into()
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
            .with_help("use `tresca` with a `bound`, or `coulomb` with a `coefficient`")
            .into())
    }

    fn missing_figure(&self, keys: &FrictionKeys, span: Span, key: &str, help: &str) -> CaseError {
        let article = if key.ends_with('s') { "" } else { "a " };
        self.fault(
            FaultKind::MissingKey,
            span,
            format!(
                "the friction law `{}` needs {article}`{key}`",
                keys.law.get_ref()
            ),
            format!("expected `{key}` in this table"),
        )
        .with_help(help)
        .into()
    }

    /// Refuses the keys of other laws.
    fn keys_of_law(&self, keys: &FrictionKeys) -> Result<(), CaseError> {
        let law = keys.law.get_ref().as_str();
        let laws = || LAWS.into_iter().zip(KEYS);
        let taken = laws()
            .find(|(name, _)| *name == law)
            .map_or(&[][..], |(_, keys)| keys);
        let given = [
            ("bound", keys.bound.as_ref().map(Spanned::span)),
            ("bounds", keys.bounds.as_ref().map(Spanned::span)),
            ("coefficient", keys.coefficient.as_ref().map(Spanned::span)),
            (
                "coefficients",
                keys.coefficients.as_ref().map(Spanned::span),
            ),
            ("axis", keys.axis.as_ref().map(Spanned::span)),
            ("limit", keys.limit.as_ref().map(Spanned::span)),
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
                })
                .into());
        }
        Ok(())
    }
}
