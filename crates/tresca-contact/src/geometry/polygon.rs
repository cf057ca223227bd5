//! Intersection of polygons.

/// Coordinates on a plane.
pub(crate) type Point2 = [f64; 2];

/// Room for what four clips leave of a quadrilateral, convex or not.
const CAPACITY: usize = 16;

/// z component of a × b.
pub(crate) fn cross2(a: Point2, b: Point2) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// A polygon, counter-clockwise.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Polygon {
    points: [Point2; CAPACITY],
    len: usize,
}

impl Polygon {
    /// The polygon with the given corners, turned counter-clockwise.
    pub fn counter_clockwise(corners: &[Point2]) -> Self {
        let mut polygon = Self {
            points: [[0.0; 2]; CAPACITY],
            len: 0,
        };
        corners.iter().for_each(|&corner| polygon.push(corner));
        if polygon.area() < 0.0 {
            polygon.points[..polygon.len].reverse();
        }
        polygon
    }

    /// The corners.
    pub fn points(&self) -> &[Point2] {
        &self.points[..self.len]
    }

    /// Area, positive counter-clockwise.
    pub fn area(&self) -> f64 {
        self.triangles().map(triangle_area).sum()
    }

    /// The fan of triangles from the first corner. Of a polygon that is not convex some may have
    /// negative area; integrals over the fan still add up to that over the polygon.
    pub fn triangles(&self) -> impl Iterator<Item = [Point2; 3]> + '_ {
        let points = self.points();
        (2..points.len()).map(move |i| [points[0], points[i - 1], points[i]])
    }

    /// What lies inside of a convex polygon `window` (Sutherland, Hodgman 1974).
    ///
    /// A corner closer than `tolerance` to the line of an edge counts as inside: edges that coincide up
    /// to rounding then leave no slivers and lose no area.
    pub fn clipped(&self, window: &Polygon, tolerance: f64) -> Polygon {
        let mut result = *self;
        let corners = window.points();
        for (i, &a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            let edge = [b[0] - a[0], b[1] - a[1]];
            let length = edge[0].hypot(edge[1]);
            if length <= tolerance {
                continue;
            }
            let inward = |p: Point2| {
                let distance = cross2(edge, [p[0] - a[0], p[1] - a[1]]) / length;
                if distance.abs() < tolerance {
                    0.0
                } else {
                    distance
                }
            };
            result = result.half(inward);
        }
        result
    }

    /// The part where the (linear) distance is not negative.
    fn half(&self, distance: impl Fn(Point2) -> f64) -> Polygon {
        let mut result = Polygon {
            points: [[0.0; 2]; CAPACITY],
            len: 0,
        };
        let points = self.points();
        for (i, &p) in points.iter().enumerate() {
            let q = points[(i + 1) % points.len()];
            let (dp, dq) = (distance(p), distance(q));
            if dp >= 0.0 {
                result.push(p);
            }
            if dp * dq < 0.0 {
                let t = dp / (dp - dq);
                result.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
            }
        }
        result
    }

    fn push(&mut self, point: Point2) {
        if self.len < CAPACITY {
            self.points[self.len] = point;
            self.len += 1;
        }
    }
}

/// Area of a triangle, positive counter-clockwise.
pub(crate) fn triangle_area([a, b, c]: [Point2; 3]) -> f64 {
    0.5 * cross2([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polygon(corners: &[Point2]) -> Polygon {
        Polygon::counter_clockwise(corners)
    }

    /// A convex quadrilateral: corners of an ellipse at four angles, one in each quadrant, turned and
    /// moved.
    fn convex() -> impl Strategy<Value = Polygon> {
        let quarter = || 0.05..0.95;
        let angles = [quarter(), quarter(), quarter(), quarter()];
        (angles, 0.2..3.0, 0.2..3.0, 0.0..6.3, -1.0..1.0, -1.0..1.0).prop_map(
            |(angles, a, b, turn, x, y): ([f64; 4], f64, f64, f64, f64, f64)| {
                let (sin, cos) = turn.sin_cos();
                let mut corners = [[0.0; 2]; 4];
                for (i, corner) in corners.iter_mut().enumerate() {
                    let angle = (i as f64 + angles[i]) * std::f64::consts::FRAC_PI_2;
                    let (u, v) = (a * angle.cos(), b * angle.sin());
                    *corner = [x + cos * u - sin * v, y + sin * u + cos * v];
                }
                polygon(&corners)
            },
        )
    }

    const TOLERANCE: f64 = 1e-12;

    fn overlap(a: &Polygon, b: &Polygon) -> f64 {
        a.clipped(b, TOLERANCE).area()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]

        #[test]
        fn intersection_is_commutative_and_no_larger_than_its_parts(a in convex(), b in convex()) {
            let (ab, ba) = (overlap(&a, &b), overlap(&b, &a));
            prop_assert!((ab - ba).abs() < 1e-11, "{ab} against {ba}");
            prop_assert!(ab > -1e-12 && ab < a.area().min(b.area()) + 1e-11);
            prop_assert!((overlap(&a, &a) - a.area()).abs() < 1e-11);
        }

        /// A window cut in two along any line through two of its edges.
        #[test]
        fn intersection_adds_up_over_a_partition(
            a in convex(), b in convex(), s in 0.01..0.99, t in 0.01..0.99, opposite in any::<bool>(),
        ) {
            let c = b.points();
            let at = |i: usize, s: f64| -> Point2 {
                [0, 1].map(|k| (1.0 - s) * c[i % 4][k] + s * c[(i + 1) % 4][k])
            };
            let parts = if opposite {
                let (p, q) = (at(0, s), at(2, t));
                [polygon(&[c[0], p, q, c[3]]), polygon(&[p, c[1], c[2], q])]
            } else {
                let (p, q) = (at(0, s), at(1, t));
                [polygon(&[p, c[1], q]), polygon(&[c[0], p, q, c[2], c[3]])]
            };
            let sum = overlap(&a, &parts[0]) + overlap(&a, &parts[1]);
            prop_assert!((sum - overlap(&a, &b)).abs() < 1e-11);
            // The other way round the parts are what is clipped.
            let sum = overlap(&parts[0], &a) + overlap(&parts[1], &a);
            prop_assert!((sum - overlap(&a, &b)).abs() < 1e-11);
        }
    }

    #[test]
    fn closed_forms() {
        let square =
            |x: f64, y: f64, a: f64| polygon(&[[x, y], [x + a, y], [x + a, y + a], [x, y + a]]);
        let unit = square(0.0, 0.0, 1.0);
        assert_eq!(overlap(&unit, &square(0.25, 0.5, 1.0)), 0.375);
        assert_eq!(overlap(&unit, &square(1.0, 0.0, 1.0)), 0.0);
        assert_eq!(overlap(&unit, &square(2.0, 0.0, 1.0)), 0.0);
        // An octagon: a square in a square turned by 45°, area 8 (√2 − 1) of inradius 1.
        let root = 2f64.sqrt();
        let turned = polygon(&[[root, 0.0], [0.0, root], [-root, 0.0], [0.0, -root]]);
        let octagon = square(-1.0, -1.0, 2.0).clipped(&turned, TOLERANCE);
        assert_eq!(octagon.points().len(), 8);
        assert!((octagon.area() - 8.0 * (root - 1.0)).abs() < 1e-14);
        // Clockwise input is turned over; an arrow that is not convex keeps its area.
        let arrow = polygon(&[[0.0, 0.0], [0.5, 0.25], [1.0, 0.0], [0.5, 1.0]]);
        assert!((arrow.area() - 0.375).abs() < 1e-15);
        assert!((overlap(&arrow, &unit) - 0.375).abs() < 1e-15);
        // Left of x = ½ the arrow is half of itself.
        let left = polygon(&[[0.0, 0.0], [0.5, 0.0], [0.5, 1.0], [0.0, 1.0]]);
        assert!((overlap(&arrow, &left) - 0.1875).abs() < 1e-15);
    }

    /// Edges that coincide up to rounding lose nothing.
    #[test]
    fn coincident_edges_keep_the_area() {
        let square = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        for epsilon in [1e-16, 1e-14, 1e-13] {
            let moved = polygon(&[
                [epsilon, -epsilon],
                [1.0 + epsilon, epsilon],
                [1.0 - epsilon, 1.0 + epsilon],
                [-epsilon, 1.0],
            ]);
            assert!((overlap(&square, &moved) - 1.0).abs() < 1e-11);
            assert!((overlap(&moved, &square) - 1.0).abs() < 1e-11);
        }
    }
}
