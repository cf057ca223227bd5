//! Vectors and matrices of order three, for use inside element loops.

/// a × b.
pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// aᵀb.
pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// ‖a‖₂.
pub(crate) fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// a − b.
pub(crate) fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// det of the matrix with the columns `c`.
pub(crate) fn determinant(c: &[[f64; 3]; 3]) -> f64 {
    dot(c[0], cross(c[1], c[2]))
}

/// Rows of the inverse of the matrix with the columns `c`, given its determinant.
pub(crate) fn inverse_rows(c: &[[f64; 3]; 3], determinant: f64) -> [[f64; 3]; 3] {
    let scaled = |v: [f64; 3]| v.map(|x| x / determinant);
    [
        scaled(cross(c[1], c[2])),
        scaled(cross(c[2], c[0])),
        scaled(cross(c[0], c[1])),
    ]
}
