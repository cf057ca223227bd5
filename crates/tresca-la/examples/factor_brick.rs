//! Times the factorisation and the trailing-block kernels on a brick.
//!
//! `cargo run --release -p tresca-la --example factor_brick -- 31 [threads]`
//!
//! The matrix has the pattern of trilinear bricks, s × s × s nodes with three
//! dofs each, one face held: every node is tied to its 26 neighbours by springs.
#![allow(clippy::print_stdout)]

use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use std::hint::black_box;
use std::time::Instant;
use tresca_la::{Ordering, PackedLower, Parallelism, SparseCholesky, SymmetricMatrix};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let nodes: usize = arguments.next().map_or(Ok(21), |a| a.parse())?;
    let threads: usize = arguments.next().map_or(Ok(1), |a| a.parse())?;
    let parallelism = Parallelism::Threads(threads);
    let matrix = spring_brick(nodes);
    let face: Vec<usize> = (0..matrix.order())
        .filter(|dof| dof / 3 / (nodes - 1) / nodes == 0)
        .collect();
    println!(
        "s = {nodes}, {} dofs, {} on the face, {threads} thread(s)",
        matrix.order(),
        face.len()
    );

    let plain = timed("ordering, plain", || Ordering::nested_dissection(&matrix))?;
    drop(factor("plain", &matrix, plain, parallelism)?);
    let ordering = timed("ordering, face last", || {
        Ordering::nested_dissection_with_trailing(&matrix, &face)
    })?;
    let factor = factor("face last", &matrix, ordering, parallelism)?;
    let trailing = timed("extract trailing block", || factor.trailing());
    drop(factor);

    let x: Vec<f64> = (0..face.len()).map(|i| (i as f64).sin()).collect();
    let mut y = x.clone();
    let bytes = trailing.factor().bytes() as f64;
    rate("trailing solve", 2.0 * bytes, || {
        y.copy_from_slice(&x);
        trailing.solve_in_place(black_box(&mut y));
    });
    let inverse = timed("trailing inverse", || trailing.inverse(parallelism));
    let packed = PackedLower::from_lower(inverse.as_ref());
    rate("symmetric product", bytes, || {
        packed.symmetric_mul(&x, black_box(&mut y));
    });
    Ok(())
}

fn factor(
    name: &str,
    matrix: &SymmetricMatrix,
    ordering: Ordering,
    parallelism: Parallelism,
) -> Result<SparseCholesky, Box<dyn std::error::Error>> {
    let start = Instant::now();
    let factor = SparseCholesky::factor(matrix, ordering, parallelism)?;
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "factor, {name}: {seconds:.3} s, {:.1} GFLOP/s, {:.1} GFLOP, {:.1}e6 nonzeros, {:.1}e6 stored",
        factor.flops() / seconds * 1e-9,
        factor.flops() * 1e-9,
        factor.factor_nonzeros() as f64 * 1e-6,
        factor.bytes() as f64 / 8.0 * 1e-6,
    );
    let solution: Vec<f64> = (0..matrix.order()).map(|i| (i as f64).cos()).collect();
    let mut x = vec![0.0; matrix.order()];
    matrix.mul(&solution, &mut x);
    timed("solve", || factor.solve_in_place(&mut x));
    let error = x
        .iter()
        .zip(&solution)
        .fold(0.0_f64, |e, (a, b)| e.max((a - b).abs()));
    println!("    largest error {error:.1e}");
    Ok(factor)
}

fn timed<T>(name: &str, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    println!("{name}: {:.3} s", start.elapsed().as_secs_f64());
    result
}

/// Median over repetitions.
fn rate(name: &str, bytes: f64, mut work: impl FnMut()) {
    let mut seconds: Vec<f64> = (0..31)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    println!(
        "{name}: median {:.3} ms ({:.1} GB/s), best {:.3} ms ({:.1} GB/s)",
        seconds[15] * 1e3,
        bytes / seconds[15] * 1e-9,
        seconds[0] * 1e3,
        bytes / seconds[0] * 1e-9
    );
}

/// Nodes (x, y, z), x fastest, x = 0 held and left out: a spring of stiffness
/// 1/d² along each of the 26 directions d, softened across it.
fn spring_brick(s: usize) -> SymmetricMatrix {
    let free = |x: usize, y: usize, z: usize| (x - 1) + (s - 1) * (y + s * z);
    let (mut pointers, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for (z, y, x) in (0..s).flat_map(|z| (0..s).flat_map(move |y| (1..s).map(move |x| (z, y, x)))) {
        let mut neighbours = Vec::new();
        let mut own = [[0.0; 3]; 3];
        for (dz, dy, dx) in (0..27).map(|k| (k / 9, k / 3 % 3, k % 3)) {
            let shifted = [x + dx, y + dy, z + dz].map(|c| c.wrapping_sub(1));
            if (dx, dy, dz) == (1, 1, 1) || shifted.iter().any(|&c| c >= s) {
                continue;
            }
            let d = [dx, dy, dz].map(|c| c as f64 - 1.0);
            let length2: f64 = d.iter().map(|c| c * c).sum();
            let spring: [[f64; 3]; 3] = std::array::from_fn(|a| {
                std::array::from_fn(|b| {
                    (d[a] * d[b] / length2 + if a == b { 0.3 } else { 0.0 }) / length2
                })
            });
            for (own, row) in own.iter_mut().zip(&spring) {
                for (own, k) in own.iter_mut().zip(row) {
                    *own += k;
                }
            }
            if shifted[0] > 0 {
                neighbours.push((free(shifted[0], shifted[1], shifted[2]), spring));
            }
        }
        let node = free(x, y, z);
        neighbours.sort_by_key(|n| n.0);
        for b in 0..3 {
            for (a, row) in own.iter().enumerate().skip(b) {
                rows.push(3 * node + a);
                values.push(row[b]);
            }
            for (other, spring) in neighbours.iter().filter(|n| n.0 > node) {
                for (a, row) in spring.iter().enumerate() {
                    rows.push(3 * other + a);
                    values.push(-row[b]);
                }
            }
            pointers.push(rows.len());
        }
    }
    let n = pointers.len() - 1;
    let pattern = SymbolicSparseColMat::new_checked(n, n, pointers, None, rows);
    SymmetricMatrix::from_lower(SparseColMat::new(pattern, values))
}
