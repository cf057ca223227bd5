//! The largest eigenvalue of A, by a few Lanczos steps.

use crate::error::QcqpError;
use crate::operator::dual_operator::DualOperator;
use tresca_la::krylov::lanczos;
use tresca_la::vector::dot;

/// Enough on contact operators to have σmax within a few per cent.
const MAX_PRODUCTS: usize = 12;
/// Relative width of the enclosure that ends the steps early.
const TOLERANCE: f64 = 0.01;
/// Relative asymmetry, and relative negative curvature, beyond rounding.
const ALLOWED_DEFECT: f64 = 1e-8;

/// What the Lanczos steps found, and the products they paid for.
pub(crate) struct Spectrum {
    /// Upper estimate of σmax.
    pub sigma: f64,
    /// Orthonormal vectors v, v₁ pseudo-random.
    pub basis: Vec<Vec<f64>>,
    /// Their products A v.
    pub products: Vec<Vec<f64>>,
}

/// Estimates σmax from above and checks on the way, for free, that A is
/// symmetric, positive semidefinite, finite and not zero.
pub(crate) fn estimate(operator: &mut dyn DualOperator) -> Result<Spectrum, QcqpError> {
    let estimate = lanczos::largest_eigenvalue(operator, None, MAX_PRODUCTS, TOLERANCE);
    for product in &estimate.products {
        if let Some(index) = product.iter().position(|v| !v.is_finite()) {
            let value = product[index];
            return Err(QcqpError::OperatorNotFinite { index, value });
        }
    }
    let lanczos::Estimate {
        ref basis,
        ref products,
        ..
    } = estimate;
    let allowed = operator.accuracy().max(ALLOWED_DEFECT);
    let size = products
        .iter()
        .map(|w| dot(w, w).sqrt())
        .fold(0.0, f64::max);
    if size == 0.0 {
        return Err(QcqpError::ZeroOperator);
    }
    for (i, v) in basis.iter().enumerate() {
        let curvature = dot(v, &products[i]) / size;
        if curvature < -allowed {
            return Err(QcqpError::NotPositive { curvature });
        }
        for (w, product) in basis.iter().zip(products).take(i) {
            let asymmetry = (dot(v, product) - dot(w, &products[i])).abs() / size;
            if asymmetry > allowed {
                return Err(QcqpError::NotSymmetric { asymmetry });
            }
        }
    }
    Ok(Spectrum {
        sigma: estimate.upper_bound(),
        basis: estimate.basis,
        products: estimate.products,
    })
}
