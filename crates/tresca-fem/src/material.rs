//! Elastic materials.

use crate::error::FemError;
use crate::mesh::space::Space;

/// Isotropic linear elasticity: σ = λ tr(ε) I + 2μ ε.
///
/// On plane meshes this is plane strain (ε_zz = 0, σ_zz = ν(σ_xx + σ_yy)) unless
/// [`Isotropic::plane_stress`] asks for the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic {
    young: f64,
    poisson: f64,
    plane_stress: bool,
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
        Ok(Self {
            young,
            poisson,
            plane_stress: false,
        })
    }

    /// The same material under plane stress, σ_zz = 0: a thin sheet. For plane meshes only; λ is then
    /// replaced by 2λμ/(λ + 2μ) throughout, and ε_zz is not looked at.
    pub fn plane_stress(self) -> Self {
        Self {
            plane_stress: true,
            ..self
        }
    }

    /// Is this plane stress?
    pub fn is_plane_stress(&self) -> bool {
        self.plane_stress
    }

    /// Refuses plane stress on a mesh that is not plane. Assembly asks this itself.
    ///
    /// # Errors
    /// [`FemError::PlaneStress`].
    pub fn check_space(&self, space: Space) -> Result<(), FemError> {
        if self.plane_stress && space != Space::Plane {
            return Err(FemError::PlaneStress { space });
        }
        Ok(())
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

    /// The λ of σ = λ tr(ε) I + 2μ ε in the plane: Lamé's, or 2λμ/(λ + 2μ) = Eν/(1 − ν²) under plane
    /// stress, where tr(ε) = ε_xx + ε_yy.
    pub fn effective_lambda(&self) -> f64 {
        if self.plane_stress {
            self.young * self.poisson / (1.0 - self.poisson * self.poisson)
        } else {
            self.lambda()
        }
    }

    /// The shear modulus μ = E / (2(1 + ν)).
    pub fn mu(&self) -> f64 {
        self.young / (2.0 * (1.0 + self.poisson))
    }

    /// The matrix D of σ = D ε in the order xx, yy, zz, xy, yz, xz, with engineering shear strains.
    /// Under plane stress the row and the column of zz are zero.
    pub fn elasticity(&self) -> [[f64; 6]; 6] {
        let (lambda, mu) = (self.effective_lambda(), self.mu());
        let mut d = [[0.0; 6]; 6];
        for i in 0..3 {
            d[i][..3].fill(lambda);
            d[i][i] += 2.0 * mu;
            d[i + 3][i + 3] = mu;
        }
        if self.plane_stress {
            for i in 0..3 {
                d[i][2] = 0.0;
                d[2][i] = 0.0;
            }
        }
        d
    }

    /// Stress of a strain, both in the order xx, yy, zz, xy, yz, xz; shear strains γ = 2ε.
    /// Under plane stress ε_zz is not looked at, and σ_zz = 0.
    pub fn stress(&self, strain: [f64; 6]) -> [f64; 6] {
        let (lambda, mu) = (self.effective_lambda(), self.mu());
        let [xx, yy, zz, ..] = strain;
        let trace = xx + yy + if self.plane_stress { 0.0 } else { zz };
        let mut stress = std::array::from_fn(|k| {
            if k < 3 {
                lambda * trace + 2.0 * mu * strain[k]
            } else {
                mu * strain[k]
            }
        });
        if self.plane_stress {
            stress[2] = 0.0;
        }
        stress
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
    fn plane_stress_is_hookes_law_without_stress_across() {
        let (e, nu) = (70.0, 0.33);
        let material = Isotropic::new(e, nu).unwrap();
        let sheet = material.plane_stress();
        // ε_xx = (σ_xx − νσ_yy)/E, ε_yy = (σ_yy − νσ_xx)/E; whatever stands for ε_zz is not read.
        let (xx, yy, xy) = (1.3, -0.4, 0.7);
        let strain = [
            (xx - nu * yy) / e,
            (yy - nu * xx) / e,
            99.0,
            2.0 * (1.0 + nu) * xy / e,
            0.0,
            0.0,
        ];
        let d = sheet.elasticity();
        for (k, expected) in [xx, yy, 0.0, xy, 0.0, 0.0].into_iter().enumerate() {
            assert!((sheet.stress(strain)[k] - expected).abs() < 1e-14);
            let by_matrix: f64 = (0..6).map(|l| d[k][l] * strain[l]).sum();
            assert!((by_matrix - expected).abs() < 1e-14);
        }
        // The solid with the strain across that plane stress causes agrees.
        let mut across = strain;
        across[2] = -nu * (xx + yy) / e;
        let solid = material.stress(across);
        assert!((0..6).all(|k| (solid[k] - sheet.stress(strain)[k]).abs() < 1e-13));
        let (lambda, mu) = (material.lambda(), material.mu());
        let reduced = 2.0 * lambda * mu / (lambda + 2.0 * mu);
        assert!((sheet.effective_lambda() - reduced).abs() < 1e-13);

        sheet.check_space(Space::Plane).unwrap();
        for space in [Space::Solid, Space::Axisymmetric] {
            material.check_space(space).unwrap();
            assert_eq!(
                sheet.check_space(space),
                Err(FemError::PlaneStress { space })
            );
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
