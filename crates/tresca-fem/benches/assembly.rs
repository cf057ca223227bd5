//! Times of assembly, internal forces and stress recovery on one brick of the two-brick benchmark.
//!
//! `cargo bench -p tresca-fem --bench assembly [-- NODES_PER_EDGE [KIND]]`, 41 corner nodes per edge and
//! hex8 by default; set `RAYON_NUM_THREADS` to choose the threads. Prints the best of five runs.
#![allow(clippy::print_stdout)]

use std::error::Error;
use std::time::Instant;
use tresca_fem::assembly::Formulation;
use tresca_fem::dofs::DofMap;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, brick};
use tresca_fem::supports::Supports;
use tresca_fem::{FemError, assembly, stress};

fn main() -> Result<(), Box<dyn Error>> {
    let (mut s, mut kind) = (41, CellKind::Hex8);
    // Cargo adds an argument of its own.
    for arg in std::env::args().skip(1).filter(|arg| arg != "--bench") {
        match arg.parse() {
            Ok(nodes) => s = nodes,
            Err(_) => kind = arg.parse()?,
        }
    }
    let spec = BrickSpec {
        min: [0.0; 3],
        max: [2.0, 1.0, 1.0],
        nodes: [s; 3],
    };
    let mesh = brick(&spec)?.with_cells(kind)?;
    let material = Isotropic::new(5e4, 0.35)?;
    let mut supports = Supports::new(mesh.node_count(), 3);
    supports.clamp(&mesh.nodes_of_set("x-")?)?;
    let dofs = DofMap::new(&supports);
    println!(
        "{} {kind} cells, {} dofs, {} threads",
        mesh.cell_count(),
        dofs.full_len(),
        rayon::current_num_threads()
    );

    let k = assembly::stiffness(&mesh, &material, Formulation::Full, &dofs)?;
    let bytes = k.lower().compute_nnz() * 16;
    println!(
        "matrix {} MiB, peak of the process {} MiB",
        bytes >> 20,
        peak_memory_kib().unwrap_or(0) >> 10
    );
    drop(k);

    let u: Vec<f64> = (0..dofs.full_len()).map(|i| (i as f64).sin()).collect();
    report("stiffness", || {
        assembly::stiffness(&mesh, &material, Formulation::Full, &dofs).map(drop)
    })?;
    report("internal forces", || {
        assembly::internal_forces(&mesh, &material, Formulation::Full, &u, None).map(drop)
    })?;
    report("stress recovery", || {
        std::hint::black_box(stress::recover(
            &mesh,
            &material,
            Formulation::Full,
            &u,
            None,
        ));
        Ok::<(), FemError>(())
    })?;
    report("mesh", || brick(&spec)?.with_cells(kind).map(drop))?;
    Ok(())
}

/// Prints the best time of five.
fn report<E>(name: &str, mut run: impl FnMut() -> Result<(), E>) -> Result<(), E> {
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        run()?;
        best = best.min(start.elapsed().as_secs_f64());
    }
    println!("{name:<16} {:8.1} ms", 1e3 * best);
    Ok(())
}

/// High-water mark of the resident set, where the system tells.
fn peak_memory_kib() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    status.lines().find_map(|line| {
        line.strip_prefix("VmHWM:")?
            .trim()
            .strip_suffix("kB")?
            .trim()
            .parse()
            .ok()
    })
}
