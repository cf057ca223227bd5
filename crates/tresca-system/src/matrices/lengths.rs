//! Rows of B, or of A, that differ in size by decades: forces get units in which they compare.

use super::matrix::Matrix;

/// Lengths within this factor of each other, and of 1 within [`TAME`], are left as they are: the caller's own units
/// are then good ones.
const ALIKE: f64 = 1e3;
const TAME: f64 = 1e30;

/// For each pair what its row of N, and its rows of T, are to be multiplied by, so that the rows have (for T: the
/// longer one has) length 1; `None` where lengths are alike.
pub(super) fn scales(lengths: &[f64], pairs: usize, tangents: usize) -> Option<Vec<[f64; 2]>> {
    let of_pair = |pair: usize| {
        let first = pairs + tangents * pair;
        let tangential = &lengths[first..first + tangents];
        [
            lengths[pair],
            tangential.iter().copied().fold(0.0, f64::max),
        ]
    };
    let sizes: Vec<[f64; 2]> = (0..pairs).map(of_pair).collect();
    let present = || sizes.iter().flatten().copied().filter(|&size| size > 0.0);
    let largest = present().fold(0.0, f64::max);
    let smallest = present().fold(f64::INFINITY, f64::min);
    if largest <= ALIKE * smallest && largest <= TAME && smallest >= 1.0 / TAME {
        return None;
    }
    let factor = |size: f64| if size > 0.0 { 1.0 / size } else { 1.0 };
    Some(sizes.iter().map(|sizes| sizes.map(factor)).collect())
}

/// The lengths of the rows of B.
pub(super) fn of_rows(b: &Matrix) -> Vec<f64> {
    let length = |i: usize| {
        // The largest first: squares of what is very large or small are no numbers.
        let size = b.row(i).fold(0.0, |a: f64, (_, x)| a.max(x.abs()));
        if size == 0.0 {
            return 0.0;
        }
        size * b
            .row(i)
            .map(|(_, x)| (x / size).powi(2))
            .sum::<f64>()
            .sqrt()
    };
    (0..b.rows()).map(length).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_are_alike_keep_their_units() {
        assert_eq!(scales(&[1.0, 2.0, 0.5, 30.0], 2, 1), None);
        assert_eq!(scales(&[0.0, 2.0], 2, 0), None);
        let scales = scales(&[1e12, 2.0, 1.0, 4.0], 2, 1).unwrap();
        assert_eq!(scales, [[1e-12, 1.0], [0.5, 0.25]]);
    }

    #[test]
    fn lengths_of_rows_of_any_size_are_found() {
        let b = Matrix::from_dense((2, 2), &[3e200, 4e200, 3e-200, 4e-200]).unwrap();
        for (found, expected) in of_rows(&b).iter().zip([5e200, 5e-200]) {
            assert!((found / expected - 1.0).abs() < 1e-15);
        }
    }
}
