//! Elastic materials.

use crate::FemError;

/// Isotropic linear elasticity: σ = λ tr(ε) I + 2μ ε.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic {
    young: f64,
    poisson: f64,
}

impl Isotropic {
    /// From Young's modulus E > 0 (a stress) and Poisson's ratio −1 < ν < ½: the range in which the
    /// strain energy is positive.
    ///
    /// # Errors
    /// [`FemError::Young`], [`FemError::Poisson`].
    pub fn new(young: f64, poisson: f64) -> Result<Self, FemError> {
        if !(young.is_finite() && young > 0.0) {
            return Err(FemError::Young { found: young });
        }
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(FemError::Poisson { found: poisson });
        }
        Ok(Self { young, poisson })
    }

    /// Young's modulus E.
    pub fn young(&self) -> f64 {
        self.young
    }

    /// Poisson's ratio ν.
    pub fn poisson(&self) -> f64 {
        self.poisson
    }

    /// Lamé's first parameter λ = Eν / ((1 + ν)(1 − 2ν)).
    pub fn lambda(&self) -> f64 {
        self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))
    }

    /// The shear modulus μ = E / (2(1 + ν)).
    pub fn mu(&self) -> f64 {
        self.young / (2.0 * (1.0 + self.poisson))
    }

    /// The matrix D of σ = D ε in the order xx, yy, zz, xy, yz, xz, with engineering shear strains.
    pub fn elasticity(&self) -> [[f64; 6]; 6] {
        let (lambda, mu) = (self.lambda(), self.mu());
        let mut d = [[0.0; 6]; 6];
        for i in 0..3 {
            d[i][..3].fill(lambda);
            d[i][i] += 2.0 * mu;
            d[i + 3][i + 3] = mu;
        }
        d
    }

    /// Stress of a strain, both in the order xx, yy, zz, xy, yz, xz; shear strains γ = 2ε.
    pub fn stress(&self, strain: [f64; 6]) -> [f64; 6] {
        let (lambda, mu) = (self.lambda(), self.mu());
        let pressure = lambda * (strain[0] + strain[1] + strain[2]);
        std::array::from_fn(|k| {
            if k < 3 {
                pressure + 2.0 * mu * strain[k]
            } else {
                mu * strain[k]
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hookes_law_in_its_engineering_form() {
        // ε_xx = (σ_xx − ν(σ_yy + σ_zz))/E, γ_xy = 2(1 + ν) σ_xy / E
        let (e, nu) = (210.0, 0.3);
        let material = Isotropic::new(e, nu).unwrap();
        let s = [1.0, -2.0, 0.5, 0.7, -0.1, 3.0];
        let strain: [f64; 6] = std::array::from_fn(|k| {
            if k < 3 {
                ((1.0 + nu) * s[k] - nu * (s[0] + s[1] + s[2])) / e
            } else {
                2.0 * (1.0 + nu) * s[k] / e
            }
        });
        let back = material.stress(strain);
        let d = material.elasticity();
        for k in 0..6 {
            assert!((back[k] - s[k]).abs() < 1e-13);
            let by_matrix: f64 = (0..6).map(|l| d[k][l] * strain[l]).sum();
            assert!((by_matrix - s[k]).abs() < 1e-13);
        }
    }

    #[test]
    fn unphysical_constants_are_refused() {
        for young in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(
                Isotropic::new(young, 0.3),
                Err(FemError::Young { .. })
            ));
        }
        for poisson in [0.5, -1.0, 0.7, f64::NAN, f64::NEG_INFINITY] {
            assert!(matches!(
                Isotropic::new(1.0, poisson),
                Err(FemError::Poisson { .. })
            ));
        }
        assert!(Isotropic::new(1.0, -0.5).is_ok());
    }
}
