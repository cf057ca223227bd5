//! Polynomials through the stresses of a patch, by least squares.

use super::sample::StressSample;
use crate::matrix3::symmetric_eigen;
use crate::vector3::{dot, sub};

/// A direction of the fit is dropped when it would magnify errors of the samples more than this (as a
/// variance): the samples lie nearly in a plane that the node is far from, as in a plate of one layer
/// of linear cells. Two layers need about ½.
const LARGEST_LEVERAGE: f64 = 4.0;

/// A quadratic term counts as one of the linear ones on the samples when less than this of its
/// variance is its own; on complete patches it is more than 0.01.
const OWN_VARIANCE: f64 = 1e-6;

/// Products of two of three coordinates.
const PRODUCTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];

/// A fitted polynomial of first or second degree.
///
/// The samples are brought to their principal axes with unit variance along each, which makes the fit
/// independent of the cells' size and aspect. There the linear terms z_k are orthogonal to each other
/// and to the constant. The quadratic terms are made orthogonal to all of these before they are fitted,
/// so that they cannot take over what the linear ones explain: a patch of too few samples for a
/// quadratic fit still has the linear one.
pub(super) struct Fit {
    center: [f64; 3],
    mean: [f64; 6],
    /// Principal directions, divided by the deviation along them.
    axes: Vec<[f64; 3]>,
    /// The change of the stress with each z_k.
    slopes: Vec<[f64; 6]>,
    /// 1 / number of samples.
    share: f64,
    curvature: Option<Curvature>,
}

/// The quadratic part of a fit.
struct Curvature {
    /// The parts of each product z_k z_l along the linear terms.
    along: [[f64; 3]; 6],
    /// Principal combinations of the quadratic terms with their variances (times the number of
    /// samples), and the stress's coefficients.
    terms: Vec<([f64; 6], f64, [f64; 6])>,
}

impl Fit {
    /// Fits a polynomial of the given degree, 1 or 2.
    pub fn new<'a>(samples: impl Iterator<Item = &'a StressSample> + Clone, degree: usize) -> Self {
        let share = 1.0 / samples.clone().count() as f64;
        let (mut center, mut mean) = ([0.0; 3], [0.0; 6]);
        for sample in samples.clone() {
            for i in 0..3 {
                center[i] += sample.position[i] * share;
            }
            for k in 0..6 {
                mean[k] += sample.stress[k] * share;
            }
        }
        let mut covariance = [[0.0; 3]; 3];
        let mut moment = [[0.0; 3]; 6];
        for sample in samples.clone() {
            let r = sub(sample.position, center);
            for i in 0..3 {
                for j in 0..3 {
                    covariance[i][j] += r[i] * r[j];
                }
                for k in 0..6 {
                    moment[k][i] += r[i] * sample.stress[k];
                }
            }
        }
        let (eigenvalues, directions) = symmetric_eigen(covariance);
        let largest = eigenvalues.iter().fold(0.0_f64, |a, &b| a.max(b));
        let (mut axes, mut slopes) = (Vec::with_capacity(3), Vec::with_capacity(3));
        for (lambda, direction) in eigenvalues.into_iter().zip(directions) {
            if lambda > 1e-14 * largest {
                let scale = 1.0 / (lambda * share).sqrt();
                let axis = direction.map(|x| x * scale);
                slopes.push(moment.map(|m| dot(axis, m) * share));
                axes.push(axis);
            }
        }
        let mut fit = Self {
            center,
            mean,
            axes,
            slopes,
            share,
            curvature: None,
        };
        if degree == 2 {
            fit.curvature = Some(fit.curvature(samples));
        }
        fit
    }

    /// The coordinates z_k of a point; zero along dropped axes.
    fn coordinates(&self, x: [f64; 3]) -> [f64; 3] {
        let r = sub(x, self.center);
        let mut z = [0.0; 3];
        for (z, axis) in z.iter_mut().zip(&self.axes) {
            *z = dot(*axis, r);
        }
        z
    }

    fn curvature<'a>(&self, samples: impl Iterator<Item = &'a StressSample> + Clone) -> Curvature {
        let mut along = [[0.0; 3]; 6];
        for sample in samples.clone() {
            let z = self.coordinates(sample.position);
            for (along, (k, l)) in along.iter_mut().zip(PRODUCTS) {
                for j in 0..3 {
                    along[j] += z[k] * z[l] * z[j] * self.share;
                }
            }
        }
        let mut curvature = Curvature {
            along,
            terms: Vec::new(),
        };
        let mut covariance = [[0.0; 6]; 6];
        let mut moment = [[0.0; 6]; 6];
        for sample in samples {
            let own = curvature.own_parts(self.coordinates(sample.position), self.axes.len());
            for m in 0..6 {
                for n in 0..6 {
                    covariance[m][n] += own[m] * own[n];
                }
                for k in 0..6 {
                    moment[k][m] += own[m] * sample.stress[k];
                }
            }
        }
        let product = |a: &[f64; 6], b: &[f64; 6]| (0..6).map(|m| a[m] * b[m]).sum::<f64>();
        let (eigenvalues, combinations) = symmetric_eigen(covariance);
        for (lambda, combination) in eigenvalues.into_iter().zip(combinations) {
            if lambda * self.share > OWN_VARIANCE {
                let coefficients = moment.map(|m| product(&combination, &m) / lambda);
                curvature.terms.push((combination, lambda, coefficients));
            }
        }
        curvature
    }

    /// The polynomial's value at a point.
    pub fn at(&self, x: [f64; 3]) -> [f64; 6] {
        let z = self.coordinates(x);
        let mut value = self.mean;
        let mut add = |reach: f64, coefficients: &[f64; 6]| {
            for k in 0..6 {
                value[k] += reach * coefficients[k];
            }
        };
        for (&z, slope) in z.iter().zip(&self.slopes) {
            if z * z * self.share <= LARGEST_LEVERAGE {
                add(z, slope);
            }
        }
        if let Some(curvature) = &self.curvature {
            let own = curvature.own_parts(z, self.axes.len());
            for (combination, lambda, coefficients) in &curvature.terms {
                let reach: f64 = (0..6).map(|m| combination[m] * own[m]).sum();
                if reach * reach <= LARGEST_LEVERAGE * lambda {
                    add(reach, coefficients);
                }
            }
        }
        value
    }
}

impl Curvature {
    /// What is left of the products z_k z_l without their mean and linear parts; `axes` of the z_k are
    /// there.
    fn own_parts(&self, z: [f64; 3], axes: usize) -> [f64; 6] {
        let mut own = [0.0; 6];
        for ((own, along), (k, l)) in own.iter_mut().zip(&self.along).zip(PRODUCTS) {
            if k < axes && l < axes {
                let mean = if k == l { 1.0 } else { 0.0 };
                *own = z[k] * z[l] - mean - dot(*along, z);
            }
        }
        own
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(position: [f64; 3], curved: f64) -> StressSample {
        let [x, y, z] = position;
        let square = curved * (x * x - 0.5 * y * z + 0.3 * x * y + z * z);
        let stress = [1.0, 2.0 * x, y - z, x + y + z + square, 3.0 - z, square];
        StressSample {
            cell: 0,
            position,
            stress,
        }
    }

    /// Points of a grid, stretched and off the origin.
    fn grid(n: u32, stretch: f64, curved: f64) -> Vec<StressSample> {
        let points = (0..n.pow(3)).map(|k| [k % n, k / n % n, k / (n * n)].map(f64::from));
        points
            .map(|[x, y, z]| sample([7.0 + x, 0.8 * y + 0.1 * x, stretch * z], curved))
            .collect()
    }

    #[test]
    fn polynomials_of_the_degree_are_reproduced_outside_the_patch() {
        for (degree, curved) in [(1, 0.0), (2, 0.0), (2, 1.0)] {
            for stretch in [1.0, 1e-3, 1e3] {
                let samples = grid(3, stretch, curved);
                let x = [6.6, 2.0, 2.4 * stretch];
                let (value, exact) = (Fit::new(samples.iter(), degree).at(x), sample(x, curved));
                for k in 0..6 {
                    let error = (value[k] - exact.stress[k]).abs();
                    assert!(
                        error < 1e-11 * exact.stress[k].abs().max(10.0),
                        "{stretch}: {error}"
                    );
                }
            }
        }
    }

    /// Eight samples determine no quadratic polynomial; the linear part is exact all the same.
    #[test]
    fn too_few_samples_for_curvature_have_their_slopes() {
        let samples = grid(2, 1.0, 0.0);
        let x = [6.7, 1.0, -0.2];
        let value = Fit::new(samples.iter(), 2).at(x);
        for k in 0..6 {
            assert!((value[k] - sample(x, 0.0).stress[k]).abs() < 1e-13);
        }
    }

    #[test]
    fn a_flat_patch_fits_only_within_its_plane() {
        let mut samples: Vec<_> = (0..4)
            .map(|k| sample([f64::from(k & 1), f64::from(k >> 1), 0.0], 0.0))
            .collect();
        for tilt in [0.0, 1e-3] {
            samples[0].position[2] = tilt;
            for degree in [1, 2] {
                let value = Fit::new(samples.iter(), degree).at([0.5, 0.5, 0.5]);
                assert!(
                    (value[1] - 1.0).abs() < 1e-2 && value[5] == 0.0,
                    "{value:?}"
                );
            }
        }
        let single = Fit::new(samples[..1].iter(), 2).at([9.0; 3]);
        assert_eq!(single, samples[0].stress);
    }
}
