//! What the tests of the crates share. A development dependency only; it knows no other crate.

/// The largest magnitude; 0 of nothing.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// The largest magnitude of a difference; NaN where one is.
///
/// # Panics
/// When the lengths differ.
#[track_caller]
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "vectors of two lengths");
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, |most, d| if d > most || d.is_nan() { d } else { most })
}

/// Every entry within `absolute`?
#[track_caller]
pub fn is_near(found: &[f64], expected: &[f64], absolute: f64) -> bool {
    distance(found, expected) <= absolute
}

/// Every entry within `absolute`.
///
/// # Panics
/// When it is not.
#[track_caller]
pub fn assert_near(found: &[f64], expected: &[f64], absolute: f64, what: &str) {
    let error = distance(found, expected);
    assert!(
        error <= absolute,
        "{what}: off by {error:.1e} > {absolute:.1e}; {}",
        both(found, expected)
    );
}

/// Every entry within `relative` of the largest one expected.
///
/// # Panics
/// When it is not.
#[track_caller]
pub fn assert_close(found: &[f64], expected: &[f64], relative: f64, what: &str) {
    let (error, scale) = (distance(found, expected), largest(expected));
    assert!(
        error <= relative * scale,
        "{what}: off by {error:.1e}, more than {relative:.1e} of the largest, {scale:.3e}; {}",
        both(found, expected)
    );
}

/// Two vectors in words, if they are short.
fn both(found: &[f64], expected: &[f64]) -> String {
    if found.len() > 12 {
        return format!("{} entries", found.len());
    }
    format!("{found:?}, expected {expected:?}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_near_is_judged_by_the_largest_error() {
        assert_eq!(largest(&[1.0, -3.0, 2.0]), 3.0);
        assert_eq!(distance(&[1.0, -3.0], &[1.5, -2.0]), 1.0);
        assert!(is_near(&[1.0], &[1.1], 0.2) && !is_near(&[1.0], &[1.3], 0.2));
        assert!(
            !is_near(&[f64::NAN], &[1.0], 1e300) && !is_near(&[1.0, f64::NAN, 1.0], &[1.0; 3], 1.0)
        );
        assert_close(&[1e9, 1.0], &[1e9, 0.0], 1e-8, "relative to the largest");
        assert_near(&[1.0], &[1.0 + 1e-12], 1e-11, "absolute");
    }

    #[test]
    #[should_panic(expected = "forces: off by 5.0e-1")]
    fn a_miss_says_what_and_how_far() {
        assert_close(&[1.0], &[1.5], 1e-3, "forces");
    }
}
