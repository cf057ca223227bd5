//! Scale, rotation and translation.

use serde::Deserialize;
use tresca_io::mesh::{Placement, Rotation};

use crate::error::{CaseError, FaultKind};
use crate::numbers::Triple;
use crate::reader::Reader;
use crate::text::at::At;

/// `rotate`: a rotation by the right-hand rule.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ axis = …, angle = … }`")]
pub(crate) struct RotateKeys {
    /// Direction of the axis. Default in the plane: that of z.
    pub axis: Option<At<Triple<f64>>>,
    /// Angle in degrees.
    pub angle: At<f64>,
    /// A point of the axis (length). Default: the origin.
    pub about: Option<At<Vec<At<f64>>>>,
}

impl Reader<'_> {
    /// Scale, rotation and translation.
    pub(crate) fn placement(
        &self,
        scale: Option<&At<f64>>,
        rotate: Option<&At<RotateKeys>>,
        translate: Option<&At<Vec<At<f64>>>>,
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

    fn rotation(&self, keys: &At<RotateKeys>) -> Result<Rotation, CaseError> {
        let span = keys.span();
        let axis = match &keys.axis {
            Some(axis) => {
                self.finite_components("the axis", axis)?;
                self.direction("the axis", axis.span(), axis.value.values())?
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
                    ));
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
}
