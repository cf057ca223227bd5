//! Quadrature on the line, square and cube [−1, 1]^d (Gauss–Legendre) and on the triangle
//! ξ, η ≥ 0, ξ + η ≤ 1.

/// Points and weights of a quadrature rule on a reference element.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Reference coordinates; entries beyond the element's dimension are zero.
    pub points: Vec<[f64; 3]>,
    /// Weights, one per point; they add up to the reference element's measure.
    pub weights: Vec<f64>,
}

impl Rule {
    /// ∫ f over the reference element.
    pub fn integrate(&self, mut f: impl FnMut([f64; 3]) -> f64) -> f64 {
        self.points
            .iter()
            .zip(&self.weights)
            .map(|(&x, w)| w * f(x))
            .sum()
    }
}

/// The n points and weights on [−1, 1] that are exact for polynomials of degree 2n − 1,
/// points ascending.
///
/// # Panics
/// When n = 0.
pub fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    assert!(n > 0, "a quadrature rule has at least one point");
    // Newton's method on P_n from the classical estimate of its roots; the estimate is within the
    // basin of quadratic convergence for every n.
    let mut rule: Vec<(f64, f64)> = (0..n)
        .map(|i| {
            let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
            for _ in 0..100 {
                let (p, dp) = legendre(n, x);
                let step = p / dp;
                x -= step;
                if step.abs() < 1e-15 {
                    break;
                }
            }
            if 2 * i + 1 == n {
                x = 0.0;
            }
            let (_, dp) = legendre(n, x);
            (x, 2.0 / ((1.0 - x * x) * dp * dp))
        })
        .collect();
    rule.reverse();
    // Symmetric to the last bit, so that symmetric bodies give symmetric matrices.
    for i in 0..n / 2 {
        rule[n - 1 - i] = (-rule[i].0, rule[i].1);
    }
    rule
}

/// P_n(x) and its derivative, by the three-term recurrence.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut p, mut before) = (1.0, 0.0);
    for k in 0..n {
        let k = k as f64;
        (p, before) = (((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0), p);
    }
    (p, n as f64 * (before - x * p) / (1.0 - x * x))
}

/// n points on the line.
pub fn gauss_line(n: usize) -> Rule {
    let (points, weights) = gauss_legendre(n)
        .into_iter()
        .map(|(x, w)| ([x, 0.0, 0.0], w))
        .unzip();
    Rule { points, weights }
}

/// n × n points on the square, first coordinate fastest.
pub fn gauss_square(n: usize) -> Rule {
    let line = gauss_legendre(n);
    let (points, weights) = line
        .iter()
        .flat_map(|&(y, wy)| line.iter().map(move |&(x, wx)| ([x, y, 0.0], wx * wy)))
        .unzip();
    Rule { points, weights }
}

/// n × n × n points in the cube, first coordinate fastest.
pub fn gauss_cube(n: usize) -> Rule {
    let line = gauss_legendre(n);
    let square = gauss_square(n);
    let (points, weights) = line
        .iter()
        .flat_map(|&(z, wz)| {
            square
                .points
                .iter()
                .zip(&square.weights)
                .map(move |(&[x, y, _], w)| ([x, y, z], w * wz))
        })
        .unzip();
    Rule { points, weights }
}

/// A rule on the triangle that is exact for polynomials of the given total degree: the centroid up
/// to degree 1, three points inside for degree 2, beyond that Gauss–Legendre points on the square
/// collapsed to the triangle. All weights are positive, all points inside.
pub fn triangle(degree: usize) -> Rule {
    let third = 1.0 / 3.0;
    let sixth = 1.0 / 6.0;
    match degree {
        0 | 1 => Rule {
            points: vec![[third, third, 0.0]],
            weights: vec![0.5],
        },
        2 => Rule {
            points: vec![
                [sixth, sixth, 0.0],
                [2.0 * third, sixth, 0.0],
                [sixth, 2.0 * third, 0.0],
            ],
            weights: vec![sixth; 3],
        },
        // ξ = s (1 − t), η = t with s, t in [0, 1]; the Jacobian 1 − t raises the degree in t by one.
        _ => {
            let square = gauss_square(degree.div_ceil(2) + 1);
            let (points, weights) = square
                .points
                .iter()
                .zip(&square.weights)
                .map(|(&[s, t, _], w)| {
                    let (s, t) = (0.5 * (1.0 + s), 0.5 * (1.0 + t));
                    ([s * (1.0 - t), t, 0.0], 0.25 * w * (1.0 - t))
                })
                .unzip();
            Rule { points, weights }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ x^k over [−1, 1].
    fn moment(k: i32) -> f64 {
        if k % 2 == 1 {
            0.0
        } else {
            2.0 / (k as f64 + 1.0)
        }
    }

    #[test]
    fn exact_up_to_degree_2n_minus_1_and_not_beyond() {
        for n in 1..=8 {
            let rule = gauss_line(n);
            for k in 0..2 * n as i32 {
                let value = rule.integrate(|x| x[0].powi(k));
                assert!(
                    (value - moment(k)).abs() < 1e-14,
                    "n = {n}, degree {k}: {value}"
                );
            }
            let k = 2 * n as i32;
            assert!((rule.integrate(|x| x[0].powi(k)) - moment(k)).abs() > 1e-6);
        }
    }

    #[test]
    fn closed_forms_of_two_and_three_points() {
        let two = gauss_legendre(2);
        assert!((two[1].0 - 1.0 / 3f64.sqrt()).abs() < 2e-16 && (two[1].1 - 1.0).abs() < 1e-15);
        let three = gauss_legendre(3);
        assert!(
            (three[2].0 - 0.6f64.sqrt()).abs() < 2e-16 && (three[1].1 - 8.0 / 9.0).abs() < 1e-15
        );
    }

    #[test]
    fn triangle_rules_integrate_their_degree() {
        // ∫ ξ^i η^j = i! j! / (i + j + 2)!
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        for degree in 0..=9 {
            let rule = triangle(degree as usize);
            assert!(rule.weights.iter().all(|&w| w > 0.0));
            for i in 0..=degree {
                for j in 0..=degree - i {
                    let exact = factorial(i) * factorial(j) / factorial(i + j + 2);
                    let value = rule.integrate(|[x, y, _]| x.powi(i) * y.powi(j));
                    assert!((value - exact).abs() < 1e-15, "degree {degree}: {i}, {j}");
                }
            }
        }
        assert!((triangle(1).integrate(|[x, _, _]| x * x) - 1.0 / 12.0).abs() > 1e-2);
        assert!((triangle(2).integrate(|[x, _, _]| x.powi(3)) - 1.0 / 20.0).abs() > 1e-4);
    }

    #[test]
    fn tensor_rules_integrate_products() {
        let square = gauss_square(2).integrate(|[x, y, _]| x * x * y * y * (1.0 + x * y));
        assert!((square - 4.0 / 9.0).abs() < 1e-15);
        let cube =
            gauss_cube(2).integrate(|[x, y, z]| (1.0 + x) * y.powi(2) * (3.0 * z * z + z.powi(3)));
        assert!((cube - 8.0 / 3.0).abs() < 1e-14);
    }
}
