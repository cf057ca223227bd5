//! Ordering and factorisation of a brick with the face z = 0 last or not, and the kernels of its trailing block.

use std::error::Error;
use std::hint::black_box;

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput};
use tresca_fem::mesh::CellKind;
use tresca_la::{BodySolver, Ordering, PackedLower, Parallelism, SparseCholesky};

use crate::brick::Brick;

pub fn run(criterion: &mut Criterion) -> Result<(), Box<dyn Error>> {
    let nodes = crate::size(21, 3)?;
    let parallelism = Parallelism::Threads(rayon::current_num_threads());
    let brick = Brick::new(nodes, CellKind::Hex8)?;
    let matrix = brick.stiffness()?;
    let face: Vec<usize> = brick
        .mesh
        .nodes_of_set("z-")?
        .iter()
        .flat_map(|node| (0..3).map(move |axis| 3 * node + axis))
        .filter_map(|dof| brick.dofs.free_of_full(dof))
        .collect();

    let order = |face_last| {
        if face_last {
            Ordering::nested_dissection_with_trailing(&matrix, &face)
        } else {
            Ordering::nested_dissection(&matrix)
        }
    };
    let mut group = crate::group(criterion, "factor");
    for (name, face_last) in [("plain", false), ("face last", true)] {
        group.bench_function(
            BenchmarkId::new("order", format!("{name} {nodes}")),
            |bencher| {
                bencher.iter(|| order(face_last));
            },
        );
        let ordering = order(face_last)?;
        let flops = SparseCholesky::factor(&matrix, ordering.clone(), parallelism)?
            .work()
            .flops;
        // Elements per second are FLOP/s.
        group.throughput(Throughput::Elements(flops as u64));
        group.bench_function(
            BenchmarkId::new("factor", format!("{name} {nodes}")),
            |bencher| {
                bencher.iter_batched(
                    || ordering.clone(),
                    |ordering| SparseCholesky::factor(&matrix, ordering, parallelism),
                    BatchSize::PerIteration,
                );
            },
        );
    }
    group.finish();

    let factor = SparseCholesky::factor(&matrix, order(true)?, parallelism)?;
    let trailing = factor
        .trailing()
        .ok_or("the factor has no trailing block")?;
    let packed = PackedLower::from_lower(trailing.inverse(parallelism).as_ref());
    let bytes = trailing.factor().bytes() as u64;
    let x: Vec<f64> = (0..trailing.order()).map(|i| (i as f64).sin()).collect();
    let mut y = x.clone();
    let mut group = criterion.benchmark_group("kernels");
    group.bench_function(BenchmarkId::new("solve", nodes), |bencher| {
        let mut x = vec![1.0; factor.order()];
        bencher.iter(|| factor.solve_in_place(black_box(&mut x)));
    });
    group.throughput(Throughput::Bytes(2 * bytes));
    group.bench_function(BenchmarkId::new("trailing solve", nodes), |bencher| {
        bencher.iter(|| {
            y.copy_from_slice(&x);
            trailing.solve_in_place(black_box(&mut y));
        });
    });
    group.throughput(Throughput::Bytes(bytes));
    group.bench_function(BenchmarkId::new("symmetric product", nodes), |bencher| {
        bencher.iter(|| packed.symmetric_mul(&x, black_box(&mut y)));
    });
    group.finish();
    Ok(())
}
