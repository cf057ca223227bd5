//! Quadrature on the line, square and cube [−1, 1]^d (Gauss–Legendre), on the triangle
//! ξ, η ≥ 0, ξ + η ≤ 1, the tetrahedron ξ, η, ζ ≥ 0, ξ + η + ζ ≤ 1, and the wedge (triangle times
//! line). All weights are positive, all points inside.

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
/// to degree 1, three points inside for degree 2, six up to degree 4 (Strang, Fix: *An Analysis of the
/// Finite Element Method*, table 4.1), beyond that Gauss–Legendre points on the square collapsed to
/// the triangle.
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
        3 | 4 => {
            let root = (38.0 - 44.0 * 0.4f64.sqrt()).sqrt();
            let weight_root = (213_125.0 - 53_320.0 * 10f64.sqrt()).sqrt();
            let mut rule = Rule {
                points: Vec::with_capacity(6),
                weights: Vec::with_capacity(6),
            };
            for sign in [1.0, -1.0] {
                let a = (8.0 - 10f64.sqrt() + sign * root) / 18.0;
                let b = 1.0 - 2.0 * a;
                rule.points.extend([[a, a, 0.0], [b, a, 0.0], [a, b, 0.0]]);
                let weight = (620.0 + sign * weight_root) / 7440.0;
                rule.weights.extend([weight; 3]);
            }
            rule
        }
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

/// A rule on the tetrahedron that is exact for polynomials of the given total degree: the centroid up
/// to degree 1, four points for degree 2, fourteen up to degree 5 (Walkington, *Quadrature on simplices
/// of arbitrary dimension*, 2000), beyond that Gauss–Legendre points in the cube collapsed to the
/// tetrahedron.
pub fn tetrahedron(degree: usize) -> Rule {
    /// The four points (a, a, a, 1 − 3a) in barycentric coordinates.
    fn around_corners(a: f64) -> [[f64; 3]; 4] {
        let b = 1.0 - 3.0 * a;
        [[a, a, a], [b, a, a], [a, b, a], [a, a, b]]
    }
    match degree {
        0 | 1 => Rule {
            points: vec![[0.25; 3]],
            weights: vec![1.0 / 6.0],
        },
        2 => Rule {
            points: around_corners((5.0 - 5f64.sqrt()) / 20.0).to_vec(),
            weights: vec![1.0 / 24.0; 4],
        },
        3..=5 => {
            // The six points (c, c, d, d), c + d = ½.
            let c = 0.045_503_704_125_649_65;
            let d = 0.5 - c;
            let mut rule = Rule {
                points: vec![
                    [d, d, c],
                    [d, c, d],
                    [c, d, d],
                    [d, c, c],
                    [c, d, c],
                    [c, c, d],
                ],
                weights: vec![0.007_091_003_462_846_911; 6],
            };
            for (a, weight) in [
                (0.310_885_919_263_300_6, 0.018_781_320_953_002_643),
                (0.092_735_250_310_891_23, 0.012_248_840_519_393_659),
            ] {
                rule.points.extend(around_corners(a));
                rule.weights.extend([weight; 4]);
            }
            rule
        }
        // ξ = s (1 − t)(1 − r), η = t (1 − r), ζ = r with r, s, t in [0, 1]; the Jacobian
        // (1 − t)(1 − r)² raises the degree in r by two.
        _ => {
            let cube = gauss_cube((degree + 3).div_ceil(2));
            let (points, weights) = cube
                .points
                .iter()
                .zip(&cube.weights)
                .map(|(x, w)| {
                    let [s, t, r] = x.map(|x| 0.5 * (1.0 + x));
                    let (t1, r1) = (1.0 - t, 1.0 - r);
                    ([s * t1 * r1, t * r1, r], 0.125 * w * t1 * r1 * r1)
                })
                .unzip();
            Rule { points, weights }
        }
    }
}

/// A rule on the wedge: [`triangle`] of the given degree in ξ, η, times `n` Gauss–Legendre points in ζ,
/// triangle first.
pub fn wedge(degree: usize, n: usize) -> Rule {
    let triangle = triangle(degree);
    let (points, weights) = gauss_legendre(n)
        .into_iter()
        .flat_map(|(z, wz)| {
            let flat = triangle.points.iter().zip(&triangle.weights);
            flat.map(move |(&[x, y, _], w)| ([x, y, z], w * wz))
                .collect::<Vec<_>>()
        })
        .unzip();
    Rule { points, weights }
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
        assert!((triangle(4).integrate(|[x, _, _]| x.powi(5)) - 1.0 / 42.0).abs() > 1e-5);
        assert_eq!(triangle(4).points.len(), 6);
    }

    #[test]
    fn tetrahedron_rules_integrate_their_degree() {
        // ∫ ξ^i η^j ζ^k = i! j! k! / (i + j + k + 3)!
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        for degree in 0..=8 {
            let rule = tetrahedron(degree as usize);
            assert!(rule.weights.iter().all(|&w| w > 0.0));
            let inside = |p: &[f64; 3]| p.iter().all(|&x| x > 0.0) && p.iter().sum::<f64>() < 1.0;
            assert!(rule.points.iter().all(inside));
            for i in 0..=degree {
                for j in 0..=degree - i {
                    for k in 0..=degree - i - j {
                        let exact =
                            factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3);
                        let value = rule.integrate(|[x, y, z]| x.powi(i) * y.powi(j) * z.powi(k));
                        assert!(
                            (value - exact).abs() < 1e-15,
                            "degree {degree}: {i}, {j}, {k}"
                        );
                    }
                }
            }
        }
        assert_eq!(tetrahedron(2).points.len(), 4);
        assert_eq!(tetrahedron(5).points.len(), 14);
        assert!((tetrahedron(2).integrate(|[x, _, _]| x.powi(3)) - 1.0 / 120.0).abs() > 1e-5);
        let sixth = factorial(6) / factorial(9);
        assert!((tetrahedron(5).integrate(|[x, _, _]| x.powi(6)) - sixth).abs() > 1e-6);
    }

    #[test]
    fn wedge_rules_are_products() {
        let rule = wedge(4, 2);
        let value = rule.integrate(|[x, y, z]| x * x * y * y * (z * z + z.powi(3)));
        // 2! 2! / 6! · 2/3
        assert!((value - 4.0 / 720.0 * 2.0 / 3.0).abs() < 1e-16);
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
