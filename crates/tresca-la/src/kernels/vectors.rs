//! The loops over vectors.

use super::isa::{Isa, Kind, LANES, for_each_isa, multiply_add};

for_each_isa! {
    /// xᵀy in eight interleaved partial sums, for vectors of the same length.
    dot = dot_loop(x: &[f64], y: &[f64]) -> f64,
    "avx512f,avx2,fma"
}

for_each_isa! {
    /// y ← y + a x, for vectors of the same length.
    axpy = axpy_loop(a: f64, x: &[f64], y: &mut [f64]),
    "avx512f,avx2,fma"
}

#[inline(always)]
fn dot_loop<const FMA: bool>(x: &[f64], y: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (xc, xr) = x.as_chunks::<LANES>();
    let (yc, yr) = y.as_chunks::<LANES>();
    for (a, b) in xc.iter().zip(yc) {
        for ((s, &a), &b) in sums.iter_mut().zip(a).zip(b) {
            *s = multiply_add::<FMA>(a, b, *s);
        }
    }
    let tail: f64 = xr.iter().zip(yr).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + tail
}

#[inline(always)]
fn axpy_loop<const FMA: bool>(a: f64, x: &[f64], y: &mut [f64]) {
    for (y, &x) in y.iter_mut().zip(x) {
        *y = multiply_add::<FMA>(a, x, *y);
    }
}
