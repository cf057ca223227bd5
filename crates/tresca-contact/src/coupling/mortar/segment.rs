//! Integration points on the part of a slave facet that a master facet covers.
//!
//! Both are projected on the auxiliary plane of the slave facet and cut (Puso, Laursen 2004). From a point
//! of the plane one goes back to the slave face by the facet's parametrisation, which makes
//! the facets of a curved face a partition of it, and from there along the auxiliary normal to the
//! master face itself. Weights are those of the slave face as it is, not of its projection.

use tresca_fem::mesh::Space;
use tresca_fem::quadrature::Rule;

use tresca_fem::vector3::{dot, norm};

use super::rules::Rules;
use crate::geometry::face::{FaceShape, MAX_NODES};
use crate::geometry::facet::{Facet, Plane};
use crate::geometry::polygon::{Point2, Polygon, cross2};

/// Pieces smaller than this share of the slave facet are rounding.
const SLIVER: f64 = 1e-12;

/// Points closer to an edge than this share of the facet's radius are on it.
const ON_EDGE: f64 = 1e-12;

/// A point at which both surfaces are evaluated.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SegmentPoint {
    /// φ of the slave face.
    pub slave: [f64; MAX_NODES],
    /// φ of the master face.
    pub master: [f64; MAX_NODES],
    /// Share of the slave's area, circumference included.
    pub weight: f64,
    /// From the slave to the master.
    pub offset: [f64; 3],
    /// The offset along the auxiliary normal: the gap, as the facet sees it.
    pub distance: f64,
}

/// A slave facet on its auxiliary plane.
pub(crate) struct Segments<'a> {
    space: Space,
    rules: &'a Rules,
    slave: &'a FaceShape,
    facet: &'a Facet,
    plane: Plane,
    corners: [Point2; 4],
    window: Polygon,
}

impl<'a> Segments<'a> {
    /// Projects a facet of the slave face on its own plane.
    pub fn new(space: Space, rules: &'a Rules, slave: &'a FaceShape, facet: &'a Facet) -> Self {
        let plane = Plane::of(facet);
        let (corners, count) = facet.on(&plane);
        Self {
            space,
            rules,
            slave,
            facet,
            plane,
            corners,
            window: Polygon::counter_clockwise(&corners[..count]),
        }
    }

    /// Writes the integration points on the common part with a facet of the master face.
    pub fn points(&self, master: &FaceShape, facet: &Facet, points: &mut Vec<SegmentPoint>) {
        let rule = self.rules.segment(self.space, self.slave, master);
        self.points_of(rule, master, facet, points);
    }

    /// The distance along the normal in the middle of that piece of the common part where it is least in size,
    /// negative behind the slave; `None` without a common part.
    pub fn distance(
        &self,
        master: &FaceShape,
        facet: &Facet,
        work: &mut Vec<SegmentPoint>,
    ) -> Option<f64> {
        self.points_of(self.rules.single(self.space), master, facet, work);
        let distances = work.iter().map(|point| point.distance);
        distances.min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    fn points_of(
        &self,
        rule: &Rule,
        master: &FaceShape,
        facet: &Facet,
        points: &mut Vec<SegmentPoint>,
    ) {
        points.clear();
        let (corners, count) = facet.on(&self.plane);
        let at = |p, weight| self.point(p, weight, master, facet, &corners);
        let reference = rule.points.iter().zip(&rule.weights);
        if count == 2 {
            let ends = |corners: &[Point2; 4]| {
                let [a, b] = [corners[0][0], corners[1][0]];
                [a.min(b), a.max(b)]
            };
            let (own, other) = (ends(&self.corners), ends(&corners));
            let (low, high) = (own[0].max(other[0]), own[1].min(other[1]));
            let half = 0.5 * (high - low);
            if half > 0.5 * SLIVER * self.facet.area {
                points.extend(
                    reference.map(|(xi, w)| at([low + half * (1.0 + xi[0]), 0.0], w * half)),
                );
            }
            return;
        }
        let piece = Polygon::counter_clockwise(&corners[..count])
            .clipped(&self.window, ON_EDGE * self.facet.radius);
        if piece.area() <= SLIVER * self.facet.area {
            return;
        }
        for [a, b, c] in piece.triangles() {
            let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
            let determinant = cross2(u, v);
            points.extend(reference.clone().map(|(&[s, t, _], w)| {
                let p = [0, 1].map(|k| a[k] + s * u[k] + t * v[k]);
                at(p, w * determinant)
            }));
        }
    }

    /// The point of both faces behind a point of the plane.
    fn point(
        &self,
        p: Point2,
        weight: f64,
        master: &FaceShape,
        facet: &Facet,
        corners: &[Point2; 4],
    ) -> SegmentPoint {
        let (xi, density) = self.facet.locate(&self.corners, p);
        let slave_values = self.slave.values(xi);
        let x = self.slave.position(&slave_values);
        // On an affine face both measures are that of the plane.
        let stretch = if self.slave.affine() {
            1.0
        } else {
            density * norm(self.slave.area_vector(xi))
        };
        let foot = self.plane.project(x);
        let (start, _) = facet.locate(corners, foot);
        let xi = if master.kind.order() == 1 {
            start
        } else {
            self.project(master, foot, start)
        };
        let master_values = master.values(xi);
        let y = master.position(&master_values);
        let offset = std::array::from_fn(|k| y[k] - x[k]);
        SegmentPoint {
            slave: slave_values,
            master: master_values,
            weight: weight * stretch * self.space.circumference(x),
            offset,
            distance: dot(self.plane.normal, offset),
        }
    }

    /// ξ of the point of a curved face over a point of the plane, by Newton's method from the
    /// point of its facet; that point itself where the method leaves its neighbourhood.
    fn project(&self, shape: &FaceShape, foot: Point2, start: [f64; 3]) -> [f64; 3] {
        let mut xi = start;
        for _ in 0..20 {
            let place = self.plane.project(shape.position(&shape.values(xi)));
            let residual = [foot[0] - place[0], foot[1] - place[1]];
            let [u, v] = shape.tangents(xi).map(|t| self.plane.direction(t));
            let step = if shape.kind.dimension() == 1 {
                [residual[0] / u[0], 0.0]
            } else {
                let determinant = cross2(u, v);
                [
                    cross2(residual, v) / determinant,
                    cross2(u, residual) / determinant,
                ]
            };
            xi = [xi[0] + step[0], xi[1] + step[1], 0.0];
            let away = (xi[0] - start[0]).abs() + (xi[1] - start[1]).abs();
            if away.is_nan() || away > 1.0 {
                return start;
            }
            if step[0].abs() + step[1].abs() < 1e-13 {
                break;
            }
        }
        xi
    }
}
