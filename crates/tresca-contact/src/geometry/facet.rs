//! Flat facets of faces, and the planes on which surfaces meet.

use tresca_fem::vector3::{cross, dot, norm};

use super::face::FaceShape;
use super::polygon::{Point2, cross2};
use crate::error::ContactError;
use crate::frame::Frame;

/// A straight piece of a face: a line, a triangle or a (perhaps warped) quadrilateral between points
/// of the face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Facet {
    /// Which face it belongs to.
    pub face: usize,
    /// Its corners in the coordinates of the face element.
    parameters: &'static [[f64; 2]],
    points: [[f64; 3]; 4],
    /// Mean of the corners.
    pub center: [f64; 3],
    /// Unit outward normal, that of the mean plane for a warped quadrilateral.
    pub normal: [f64; 3],
    /// Largest distance of a corner from the centre.
    pub radius: f64,
    /// Its area on the plane through the centre.
    pub area: f64,
}

impl Facet {
    /// The facet with the given corners of a face.
    pub fn new(
        shape: &FaceShape,
        index: usize,
        parameters: &'static [[f64; 2]],
    ) -> Result<Self, ContactError> {
        let count = parameters.len();
        let mut points = [[0.0; 3]; 4];
        for (point, &[xi, eta]) in points.iter_mut().zip(parameters) {
            *point = shape.position(&shape.values([xi, eta, 0.0]));
        }
        let edge = |a: usize, b: usize| -> [f64; 3] {
            std::array::from_fn(|k| points[b][k] - points[a][k])
        };
        let vector = match count {
            2 => {
                let t = edge(0, 1);
                [t[1], -t[0], 0.0]
            }
            3 => cross(edge(0, 1), edge(0, 2)).map(|x| 0.5 * x),
            _ => cross(edge(0, 2), edge(1, 3)).map(|x| 0.5 * x),
        };
        let area = norm(vector);
        let center: [f64; 3] = std::array::from_fn(|k| {
            points[..count].iter().map(|p| p[k]).sum::<f64>() / count as f64
        });
        let distance = |p: &[f64; 3]| norm(std::array::from_fn(|k| p[k] - center[k]));
        let radius = points[..count].iter().map(distance).fold(0.0, f64::max);
        // A face without area has no normal, and nothing can be projected on it.
        let smallest = 1e-12 * radius.powi(count.min(3) as i32 - 1);
        let facet = Self {
            face: index,
            parameters,
            points,
            center,
            normal: vector.map(|x| x / area),
            radius,
            area,
        };
        if area.is_nan() || area <= smallest || !facet.is_convex() {
            return Err(ContactError::DegenerateFace { point: center });
        }
        Ok(facet)
    }

    /// Is the facet convex on its own plane, as clipping and the inverse of its map need it? Two corners
    /// in one place, as collapsed cells have them, do no harm.
    fn is_convex(&self) -> bool {
        let (corners, count) = self.on(&Plane::of(self));
        let corner = |i: usize| corners[i % count];
        count < 4
            || (0..count).all(|i| {
                let [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
                let turn = cross2([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
                turn >= -1e-9 * self.area
            })
    }

    /// The corners on a plane.
    pub fn on(&self, plane: &Plane) -> ([Point2; 4], usize) {
        let count = self.parameters.len();
        let mut corners = [[0.0; 2]; 4];
        for (corner, &point) in corners.iter_mut().zip(&self.points[..count]) {
            *corner = plane.project(point);
        }
        (corners, count)
    }

    /// Where a point of the plane lies on the facet: ξ in the face element, and the measure of ξ per
    /// measure of the plane there. `corners` are the facet's corners on the plane.
    ///
    /// The bilinear map of a quadrilateral is inverted by Newton's method, which converges
    /// from the centre for points of a convex quadrilateral; elsewhere the last iterate is kept
    /// within reach of the facet, so that shape functions stay bounded.
    pub fn locate(&self, corners: &[Point2; 4], point: Point2) -> ([f64; 3], f64) {
        let k = self.parameters;
        let from = |a: Point2, b: Point2| [b[0] - a[0], b[1] - a[1]];
        match k.len() {
            2 => {
                let s = (point[0] - corners[0][0]) / (corners[1][0] - corners[0][0]);
                let density = (k[1][0] - k[0][0]) / (corners[1][0] - corners[0][0]);
                ([k[0][0] + s * (k[1][0] - k[0][0]), 0.0, 0.0], density.abs())
            }
            3 => {
                let (a, b) = (from(corners[0], corners[1]), from(corners[0], corners[2]));
                let p = from(corners[0], point);
                let determinant = cross2(a, b);
                let (s, t) = (cross2(p, b) / determinant, cross2(a, p) / determinant);
                let (u, v) = (from(k[0], k[1]), from(k[0], k[2]));
                let xi = [0, 1].map(|i| k[0][i] + s * u[i] + t * v[i]);
                ([xi[0], xi[1], 0.0], (cross2(u, v) / determinant).abs())
            }
            _ => {
                let (s, t, determinant) = invert_bilinear(corners, point);
                let (u, v) = (from(k[0], k[1]), from(k[0], k[3]));
                let xi = [0, 1].map(|i| k[0][i] + s * u[i] + t * v[i]);
                ([xi[0], xi[1], 0.0], (cross2(u, v) / determinant).abs())
            }
        }
    }
}

/// s, t with c0 (1−s)(1−t) + c1 s(1−t) + c2 s t + c3 (1−s) t = p, and the determinant there.
fn invert_bilinear(c: &[Point2; 4], p: Point2) -> (f64, f64, f64) {
    let (mut s, mut t) = (0.5, 0.5);
    let mut determinant = 1.0;
    for _ in 0..30 {
        let weights = [(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t];
        let residual = [0, 1].map(|i| p[i] - (0..4).map(|a| weights[a] * c[a][i]).sum::<f64>());
        let along_s = [0, 1].map(|i| (1.0 - t) * (c[1][i] - c[0][i]) + t * (c[2][i] - c[3][i]));
        let along_t = [0, 1].map(|i| (1.0 - s) * (c[3][i] - c[0][i]) + s * (c[2][i] - c[1][i]));
        determinant = cross2(along_s, along_t);
        let (ds, dt) = (
            cross2(residual, along_t) / determinant,
            cross2(along_s, residual) / determinant,
        );
        if !(ds.is_finite() && dt.is_finite()) {
            break;
        }
        s = (s + ds).clamp(-0.5, 1.5);
        t = (t + dt).clamp(-0.5, 1.5);
        if ds.abs() + dt.abs() < 1e-14 {
            break;
        }
    }
    (s, t, determinant)
}

/// A plane (in the plane: a line) with coordinates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    origin: [f64; 3],
    /// Unit normal.
    pub normal: [f64; 3],
    axes: [[f64; 3]; 2],
}

impl Plane {
    /// The auxiliary plane of a facet: through its centre, with its normal.
    pub fn of(facet: &Facet) -> Self {
        let normal = facet.normal;
        let axes = match facet.parameters.len() {
            2 => [[-normal[1], normal[0], 0.0], [0.0; 3]],
            _ => Frame::from_normal(normal).tangents,
        };
        Self {
            origin: facet.center,
            normal,
            axes,
        }
    }

    /// Coordinates of the foot of a point.
    pub fn project(&self, point: [f64; 3]) -> Point2 {
        let offset = std::array::from_fn(|k| point[k] - self.origin[k]);
        self.axes.map(|axis| dot(axis, offset))
    }

    /// Coordinates of a direction in the plane.
    pub fn direction(&self, vector: [f64; 3]) -> Point2 {
        self.axes.map(|axis| dot(axis, vector))
    }
}
