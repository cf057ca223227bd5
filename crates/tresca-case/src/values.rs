//! What a value can be: bricks with a volume, materials that exist, numbers that are numbers.

use toml::Spanned;

use super::check::Check;
use super::entries::Components;
use super::error::{CaseError, FaultKind};
use super::keys::Material;
use crate::expression::VARIABLES;

/// Nodes that one body may have. Three unknowns per node: a hundred million nodes are beyond any
/// direct factorisation, so a larger number is a slip of the pen, better said before memory runs out.
pub const MAX_NODES: usize = 100_000_000;

impl Check<'_> {
    /// A box or rectangle; `word` is what reports call it.
    pub(super) fn block<const N: usize>(
        &self,
        word: &str,
        low: &Spanned<Components<f64, N>>,
        high: &Spanned<Components<f64, N>>,
        nodes: &Spanned<Components<usize, N>>,
    ) -> Result<(), CaseError> {
        let volume_word = if N == 2 { "area" } else { "volume" };
        self.finite_components("the corner `min`", low)?;
        self.finite_components("the corner `max`", high)?;
        self.nodes(nodes)?;
        let mut volume = 1.0;
        for (axis, letter) in VARIABLES.into_iter().enumerate().take(N) {
            let (low, high) = (&low.get_ref().0[axis], &high.get_ref().0[axis]);
            let (min, max) = (*low.get_ref(), *high.get_ref());
            let cells = (*nodes.get_ref().0[axis].get_ref() - 1) as f64;
            let extent = max - min;
            volume *= extent;
            // Neighbouring nodes must differ by more than rounding of their coordinates.
            let resolved = extent / cells > 4.0 * f64::EPSILON * min.abs().max(max.abs());
            if extent > 0.0 && extent.is_finite() && resolved {
                continue;
            }
            let (message, help) = if extent < 0.0 {
                (
                    format!("the {word} is turned inside out: `min` exceeds `max` along {letter}"),
                    "`min` and `max` are probably exchanged",
                )
            } else if extent == 0.0 {
                (
                    format!("the {word} has zero {volume_word}: no extent along {letter}"),
                    "a body is solid; give it an extent in every direction",
                )
            } else {
                (
                    format!("the nodes along {letter} cannot be told apart in double precision"),
                    "move the body closer to the origin, or choose another unit of length",
                )
            };
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    high.span(),
                    message,
                    format!("expected more than {min:?}, found {max:?}"),
                )
                .and_at(low.span(), "the other end")
                .with_help(help)
                .into());
        }
        if f64::is_normal(volume) {
            return Ok(());
        }
        let extents = if N == 2 { "two" } else { "three" };
        Err(self
            .fault(
                FaultKind::BadValue,
                high.span(),
                format!("the {volume_word} of the {word} is beyond the range of numbers"),
                format!("the product of the {extents} extents is {volume:?}"),
            )
            .with_help("choose another unit of length")
            .into())
    }

    fn nodes<const N: usize>(
        &self,
        nodes: &Spanned<Components<usize, N>>,
    ) -> Result<(), CaseError> {
        for (count, letter) in nodes.get_ref().0.iter().zip(VARIABLES) {
            if *count.get_ref() < 2 {
                return Err(self
                    .fault(
                        FaultKind::BadValue,
                        count.span(),
                        format!("too few nodes along {letter}"),
                        format!("expected 2 or more, found {}", count.get_ref()),
                    )
                    .with_help("nodes are counted with both ends: 2 nodes make one element")
                    .into());
            }
        }
        let product = nodes
            .get_ref()
            .values()
            .iter()
            .try_fold(1_usize, |product, &count| product.checked_mul(count));
        if product.is_some_and(|product| product <= MAX_NODES) {
            return Ok(());
        }
        let found = product.map_or("more than can be counted".to_owned(), |n| n.to_string());
        Err(self
            .fault(
                FaultKind::BadValue,
                nodes.span(),
                "too many nodes",
                format!("expected at most {MAX_NODES} in all, found {found}"),
            )
            .with_help(if N == 2 {
                "the two counts are multiplied: [41, 41] are 1681 nodes"
            } else {
                "the three counts are multiplied: [41, 41, 41] are 68921 nodes"
            })
            .into())
    }

    pub(super) fn material(&self, material: &Material) -> Result<(), CaseError> {
        let young = self.finite("Young's modulus", &material.young)?;
        if young <= 0.0 {
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    material.young.span(),
                    "Young's modulus must be positive",
                    format!("expected more than 0, found {young:?}"),
                )
                .with_help("it is the stiffness of the material, a force per area")
                .into());
        }
        if let Some(density) = &material.density {
            self.not_negative("the density", density, "it is the mass per volume")?;
        }
        let poisson = self.finite("Poisson's ratio", &material.poisson)?;
        if poisson > -1.0 && poisson < 0.5 {
            return Ok(());
        }
        let help = if poisson == 0.5 {
            "0.5 is an incompressible material, which needs another formulation; rubber is often \
             taken as 0.49"
        } else if poisson > 1.0 {
            "is this Young's modulus? most metals have 0.25 to 0.35"
        } else {
            "no stable isotropic material has it; most metals have 0.25 to 0.35"
        };
        Err(self
            .fault(
                FaultKind::BadValue,
                material.poisson.span(),
                "Poisson's ratio must lie between -1 and 0.5",
                format!("expected -1 < poisson < 0.5, found {poisson:?}"),
            )
            .with_help(help)
            .into())
    }

    pub(super) fn finite_components<const N: usize>(
        &self,
        what: &str,
        values: &Spanned<Components<f64, N>>,
    ) -> Result<(), CaseError> {
        for value in &values.get_ref().0 {
            self.finite(what, value)?;
        }
        Ok(())
    }

    /// `help` says what the number is.
    pub(super) fn not_negative(
        &self,
        what: &str,
        value: &Spanned<f64>,
        help: &str,
    ) -> Result<f64, CaseError> {
        let number = self.finite(what, value)?;
        if number >= 0.0 {
            return Ok(number);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                value.span(),
                format!("{what} must not be negative"),
                format!("expected 0 or more, found {number:?}"),
            )
            .with_help(help)
            .into())
    }

    pub(super) fn finite(&self, what: &str, value: &Spanned<f64>) -> Result<f64, CaseError> {
        let number = *value.get_ref();
        if number.is_finite() {
            return Ok(number);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                value.span(),
                format!("{what} is not a finite number"),
                format!("expected a finite number, found {number:?}"),
            )
            .with_help("TOML knows the words `nan` and `inf`; a case file takes numbers only")
            .into())
    }
}
