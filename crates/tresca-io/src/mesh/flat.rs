//! Points that lie in the plane but for rounding.

use tresca_fem::mesh::BoundingBox;

use super::error::{MeshFault, MeshFileError};
use super::file::MeshFile;

/// Distances below this part of a body's size are rounding: coordinates that should be 0 become 0.
const ROUNDING: f64 = 1e-12;

impl MeshFile {
    /// Brings placed points of the given nodes of the file into the plane z = 0. Returns the distance that
    /// counts as rounding.
    pub(super) fn flatten(
        &self,
        points: &mut [[f64; 3]],
        nodes: &[usize],
    ) -> Result<f64, MeshFileError> {
        let small = ROUNDING * BoundingBox::around(points.iter().copied()).diagonal();
        for (point, &node) in points.iter_mut().zip(nodes) {
            if point[2].abs() > small {
                return Err(MeshFault::OffPlane {
                    node: self.point_numbers[node],
                    z: point[2],
                }
                .at(self.path.clone()));
            }
            point[2] = 0.0;
        }
        Ok(small)
    }
}
