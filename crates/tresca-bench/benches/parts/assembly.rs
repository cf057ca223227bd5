//! Stiffness, internal forces, stress recovery; trilinear and triquadratic cells.

use std::error::Error;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput};
use tresca_fem::assembly::{self, Formulation};
use tresca_fem::mesh::CellKind;
use tresca_fem::stress;

use crate::brick::Brick;

pub fn run(criterion: &mut Criterion) -> Result<(), Box<dyn Error>> {
    let nodes = crate::size(21, 3)?;
    let mut group = crate::group(criterion, "assembly");
    for kind in [CellKind::Hex8, CellKind::Hex20] {
        let brick = Brick::new(nodes, kind)?;
        let u: Vec<f64> = (0..brick.dofs.full_len())
            .map(|i| (i as f64).sin())
            .collect();
        let (mesh, material) = (&brick.mesh, &brick.material);
        let name = format!("{kind} {nodes}");
        group.throughput(Throughput::Elements(mesh.cell_count() as u64));
        group.bench_function(BenchmarkId::new("stiffness", &name), |bencher| {
            bencher.iter(|| brick.stiffness());
        });
        group.bench_function(BenchmarkId::new("internal forces", &name), |bencher| {
            bencher.iter(|| {
                assembly::internal_forces(mesh, material, Formulation::Full, black_box(&u), None)
            });
        });
        group.bench_function(BenchmarkId::new("stress recovery", &name), |bencher| {
            bencher
                .iter(|| stress::recover(mesh, material, Formulation::Full, black_box(&u), None));
        });
    }
    group.finish();
    Ok(())
}
