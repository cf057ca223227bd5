//! Quadrature rules of every degree that segments ask for, made once.

use tresca_fem::mesh::{CellKind, Space};
use tresca_fem::quadrature::{Rule, gauss_line, gauss_square, triangle};

use crate::geometry::face::{FaceElement, FaceShape};

/// Highest degree in use: two curved quad9.
const HIGHEST: usize = 12;

/// Rules on the line [−1, 1] and the triangle, by degree.
pub(crate) struct Rules {
    lines: Vec<Rule>,
    triangles: Vec<Rule>,
}

impl Rules {
    /// All of them.
    pub fn new() -> Self {
        let triangle = |degree| match degree {
            3..=5 => radon(),
            _ => triangle(degree),
        };
        Self {
            lines: (0..=HIGHEST).map(|n| gauss_line(n / 2 + 1)).collect(),
            triangles: (0..=HIGHEST).map(triangle).collect(),
        }
    }

    /// A single point, for those who only look.
    pub fn single(&self, space: Space) -> &Rule {
        match space {
            Space::Solid => &self.triangles[0],
            Space::Plane | Space::Axisymmetric => &self.lines[0],
        }
    }

    /// The rule for products of two shape functions of the slave face, or one of each face, on a
    /// segment of the two (a line in the plane, else a triangle).
    ///
    /// On affine faces all products are polynomials on the segment and the rule is exact. Where one of the
    /// faces is no affine image of its reference element (curved, or a flat quadrilateral that is no
    /// parallelogram) they are not; a rule of higher degree then leaves errors of its order.
    pub fn segment(&self, space: Space, slave: &FaceShape, master: &FaceShape) -> &Rule {
        let (s, m) = (slave.kind.degree(), master.kind.degree());
        // Measured on quadrilaterals distorted by a quarter, and by 5 %, of their size: 1e-10 of a constant
        // pressure.
        let beyond = |shape: &FaceShape| match shape.kind {
            _ if shape.affine() => 0,
            CellKind::Line3 | CellKind::Tri6 => 2,
            _ if shape.distortion < 0.05 => 2,
            _ => 4,
        };
        let beyond = beyond(slave).max(beyond(master));
        let radius = usize::from(space == Space::Axisymmetric);
        let degree = (s + s.max(m) + beyond + radius).min(HIGHEST);
        match space {
            Space::Solid => &self.triangles[degree],
            Space::Plane | Space::Axisymmetric => &self.lines[degree],
        }
    }
}

/// A rule on a whole face for products of its shape functions, with the radius of an axisymmetric
/// space.
pub(crate) fn face_rule(kind: CellKind) -> Rule {
    let order = kind.order();
    match (
        kind.dimension(),
        kind.facets().first().map_or(0, |f| f.len()),
    ) {
        (1, _) => gauss_line(order + 2),
        (_, 3) => triangle(2 * order + 2),
        _ => gauss_square(order + 2),
    }
}

/// Seven points, exact up to degree 5 (Radon 1948; Strang, Fix, formula 7).
fn radon() -> Rule {
    let root = 15f64.sqrt();
    let third = 1.0 / 3.0;
    let mut rule = Rule {
        points: vec![[third, third, 0.0]],
        weights: vec![9.0 / 80.0],
    };
    for (a, weight) in [
        ((6.0 - root) / 21.0, (155.0 - root) / 2400.0),
        ((6.0 + root) / 21.0, (155.0 + root) / 2400.0),
    ] {
        let b = 1.0 - 2.0 * a;
        rule.points.extend([[a, a, 0.0], [b, a, 0.0], [a, b, 0.0]]);
        rule.weights.extend([weight; 3]);
    }
    rule
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangle_rules_integrate_their_degree() {
        let factorial = |n: usize| (1..=n).map(|k| k as f64).product::<f64>();
        for (degree, rule) in Rules::new().triangles.iter().enumerate() {
            for i in 0..=degree {
                for j in 0..=degree - i {
                    // ∫ ξ^i η^j = i! j! / (i + j + 2)!
                    let exact = factorial(i) * factorial(j) / factorial(i + j + 2);
                    let value = rule.integrate(|[x, y, _]| x.powi(i as i32) * y.powi(j as i32));
                    assert!((value - exact).abs() < 1e-15, "degree {degree}: {i}, {j}");
                }
            }
        }
    }
}
