//! Scale, rotation and translation, and the vectors and lengths that they and obstacles consist of.

use toml::Spanned;

use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::keys::RotateKeys;
use super::source::Span;
use tresca_io::mesh::{Placement, Rotation};

impl Check<'_> {
    /// Scale, rotation and translation.
    pub(super) fn placement(
        &self,
        scale: Option<&Spanned<f64>>,
        rotate: Option<&Spanned<RotateKeys>>,
        translate: Option<&Spanned<Vec<Spanned<f64>>>>,
    ) -> Result<Placement, CaseError> {
        let help = "it multiplies all coordinates, as in `scale = 1e-3` from millimetres to metres";
        let scale = scale.map(|scale| self.positive("the scale", scale, help));
        let rotation = rotate.map(|keys| self.rotation(keys));
        let translation = translate.map(|shift| self.vector("the translation", shift));
        Ok(Placement {
            scale: scale.transpose()?.unwrap_or(1.0),
            rotation: rotation.transpose()?,
            translation: translation.transpose()?.unwrap_or_default(),
        })
    }

    fn rotation(&self, keys: &Spanned<RotateKeys>) -> Result<Rotation, CaseError> {
        let (span, keys) = (keys.span(), keys.get_ref());
        let axis = match &keys.axis {
            Some(axis) => {
                self.finite_components("the axis", axis)?;
                self.direction("the axis", axis.span(), axis.get_ref().values())?
            }
            None if self.analysis.dimension() == 2 => [0.0, 0.0, 1.0],
            None => {
                return Err(self
                    .fault(
                        FaultKind::MissingKey,
                        span,
                        "missing key `axis`",
                        "expected `axis` in this table",
                    )
                    .with_help(
                        "`axis = [x, y, z]` is the direction of the axis of a rotation in space",
                    )
                    .into());
            }
        };
        let about = keys.about.as_ref();
        let about = about.map(|about| self.vector("the point of the axis", about));
        Ok(Rotation {
            axis,
            angle: self.finite("the angle", &keys.angle)?,
            about: about.transpose()?.unwrap_or_default(),
        })
    }

    /// A vector that points somewhere.
    pub(super) fn direction(
        &self,
        what: &str,
        span: Span,
        vector: [f64; 3],
    ) -> Result<[f64; 3], CaseError> {
        if vector != [0.0; 3] {
            return Ok(vector);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                span,
                format!("{what} has no direction"),
                "expected a vector that is not zero",
            )
            .with_help("its length does not matter")
            .into())
    }

    /// A number above 0.
    pub(super) fn positive(
        &self,
        what: &str,
        value: &Spanned<f64>,
        help: &str,
    ) -> Result<f64, CaseError> {
        let number = self.finite(what, value)?;
        if number > 0.0 {
            return Ok(number);
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                value.span(),
                format!("{what} must be positive"),
                format!("expected more than 0, found {number:?}"),
            )
            .with_help(help)
            .into())
    }
}
