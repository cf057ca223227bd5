//! Units for figures whose squares would over- or underflow.

/// Figures up to this, and down to its reciprocal, can be squared and added up.
const TAME: f64 = 1e60;

/// A power of two near a size that is not tame, else 1.
pub(crate) fn unit_of(size: f64) -> f64 {
    if size == 0.0 || !size.is_finite() || (1.0 / TAME..=TAME).contains(&size) {
        return 1.0;
    }
    // Even, so that there is a root, and between the normal numbers, so that there is a reciprocal.
    (2.0 * (0.5 * size.log2()).round().clamp(-510.0, 510.0)).exp2()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_figures_that_cannot_be_squared_have_units() {
        for tame in [0.0, 1.0, 1e-50, 1e50] {
            assert_eq!(unit_of(tame), 1.0);
        }
        for wild in [1e-200, 1e200, 5e-324, f64::MAX] {
            let unit = unit_of(wild);
            assert_eq!((0.5 * unit.log2()).fract(), 0.0);
            assert!(
                (wild / unit).log2().abs() < 60.0,
                "{wild:e} in units of {unit:e}"
            );
            assert!((1.0 / unit).is_normal());
        }
    }
}
