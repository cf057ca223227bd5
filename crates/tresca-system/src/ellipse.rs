//! The ellipse of admissible friction forces, with semi-axes g1, g2 ≥ 0 along τ1, τ2.
//!
//! The certificate measures with it, from the forces and bounds themselves and not from the solver's
//! discs.

/// { x : (x1/g1)² + (x2/g2)² ≤ 1 }; a semi-axis of 0 leaves a segment, two leave the point 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse(pub [f64; 2]);

impl Ellipse {
    /// The larger semi-axis.
    pub fn largest(self) -> f64 {
        self.0[0].max(self.0[1])
    }

    /// max { x·s : x in the ellipse }: the work that friction dissipates along the slip s.
    pub fn support(self, slip: [f64; 2]) -> f64 {
        (self.0[0] * slip[0]).hypot(self.0[1] * slip[1])
    }

    /// How far a force is outside, as a force; 0 inside. Along an axis of length 0 all of it is.
    pub fn excess(self, force: [f64; 2]) -> f64 {
        let largest = self.largest();
        let (mut inside, mut beyond) = ([0.0; 2], 0.0_f64);
        for k in 0..2 {
            if self.0[k] > 0.0 {
                inside[k] = force[k] * (largest / self.0[k]);
            } else {
                beyond = beyond.max(force[k].abs());
            }
        }
        (inside[0].hypot(inside[1]) - largest).max(beyond).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn support_is_the_largest_work_over_the_boundary() {
        let ellipse = Ellipse([2.0, 0.5]);
        let slip = [0.3, -0.7];
        let on_boundary = |k: i32| {
            let angle = f64::from(k) * 1e-4;
            2.0 * angle.cos() * slip[0] + 0.5 * angle.sin() * slip[1]
        };
        let largest = (0..62_832).map(on_boundary).fold(0.0, f64::max);
        assert!((ellipse.support(slip) - largest).abs() < 1e-8);
        assert_eq!(Ellipse([0.0, 3.0]).support([5.0, -1.0]), 3.0);
    }

    #[test]
    fn excess_is_zero_inside_and_grows_outside() {
        let ellipse = Ellipse([2.0, 0.5]);
        assert_eq!(ellipse.excess([1.9, 0.0]), 0.0);
        assert!(ellipse.excess([1.9, 0.4]) > 0.1);
        assert!((ellipse.excess([2.1, 0.0]) - 0.1).abs() < 1e-15);
        assert_eq!(Ellipse([0.0, 1.0]).excess([0.25, 0.5]), 0.25);
        assert_eq!(Ellipse([0.0, 0.0]).excess([0.0, 0.0]), 0.0);
    }
}
