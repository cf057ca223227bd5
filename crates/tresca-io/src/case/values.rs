//! What a value can be: bricks with a volume, materials that exist, numbers that are numbers.

use toml::Spanned;

use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::keys::{Brick, Material, Triple};

/// Nodes that one body may have. Three unknowns per node: a hundred million nodes are beyond any
/// direct factorisation, so a larger number is a slip of the pen, better said before memory runs out.
pub const MAX_NODES: usize = 100_000_000;

impl Check<'_> {
    pub(super) fn brick(&self, brick: &Brick) -> Result<(), CaseError> {
        self.finite_triple("the corner `min`", &brick.min)?;
        self.finite_triple("the corner `max`", &brick.max)?;
        self.nodes(&brick.nodes)?;
        let mut volume = 1.0;
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let (low, high) = (&brick.min.get_ref().0[axis], &brick.max.get_ref().0[axis]);
            let (min, max) = (*low.get_ref(), *high.get_ref());
            let cells = (*brick.nodes.get_ref().0[axis].get_ref() - 1) as f64;
            let extent = max - min;
            volume *= extent;
            // Neighbouring nodes must differ by more than rounding of their coordinates.
            let resolved = extent / cells > 4.0 * f64::EPSILON * min.abs().max(max.abs());
            if extent > 0.0 && extent.is_finite() && resolved {
                continue;
            }
            let (message, help) = if extent < 0.0 {
                (
                    format!("the brick is turned inside out: `min` exceeds `max` along {letter}"),
                    "`min` and `max` are probably exchanged",
                )
            } else if extent == 0.0 {
                (
                    format!("the brick has zero volume: no extent along {letter}"),
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
        Err(self
            .fault(
                FaultKind::BadValue,
                brick.max.span(),
                "the volume of the brick is beyond the range of numbers",
                format!("the product of the three extents is {volume:?}"),
            )
            .with_help("choose another unit of length")
            .into())
    }

    fn nodes(&self, nodes: &Spanned<Triple<usize>>) -> Result<(), CaseError> {
        for (count, letter) in nodes.get_ref().0.iter().zip(["x", "y", "z"]) {
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
            .with_help("the three counts are multiplied: [41, 41, 41] are 68921 nodes")
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

    pub(super) fn finite_triple(
        &self,
        what: &str,
        triple: &Spanned<Triple<f64>>,
    ) -> Result<(), CaseError> {
        for value in &triple.get_ref().0 {
            self.finite(what, value)?;
        }
        Ok(())
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
