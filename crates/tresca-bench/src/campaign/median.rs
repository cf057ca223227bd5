//! The median of counts.

/// The median; 0 of nothing. Ascending.
pub fn median(sorted: &[usize]) -> f64 {
    match sorted.len() {
        0 => 0.0,
        n => 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]) as f64,
    }
}
