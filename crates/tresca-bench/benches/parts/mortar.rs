//! Pairing and mortar coupling of two slabs that do not match, n × n and n′ × n′ faces with n′ = 9n/10:
//! hexahedra over hexahedra and over wedges, flat and curved.

use std::collections::BTreeMap;
use std::error::Error;

use criterion::{BenchmarkId, Criterion, Throughput};
use tresca_contact::{
    CouplingMethod, FrictionLaw, Interface, ScalarField, Side, couple, facing_surfaces,
};
use tresca_fem::FemError;
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{BrickSpec, CellBlock, CellKind, Mesh, brick};

pub fn run(criterion: &mut Criterion) -> Result<(), Box<dyn Error>> {
    let n = crate::size(100, 4)?;
    let other = (9 * n / 10).max(1);
    let mut group = crate::group(criterion, "mortar");
    group.throughput(Throughput::Elements((n * n) as u64));
    for (shape, height) in [("flat", 0.0), ("curved", 0.05)] {
        let bend = move |[x, y, z]: [f64; 3]| {
            let hill = height * (3.0 * x).sin() * (2.0 * y).cos();
            [x, y, z + hill]
        };
        let slave = slab(0.0, n)?.mapped(bend)?;
        let hexahedra = slab(-0.1, other)?.mapped(bend)?;
        let wedges = divided(&hexahedra)?;
        for (partner, master) in [("hex8", &hexahedra), ("wedge6", &wedges)] {
            let name = format!("{shape}, hex8 on {partner} {n}");
            let within = 0.5 / n as f64;
            group.bench_function(BenchmarkId::new("pairing", &name), |bencher| {
                bencher.iter(|| facing_surfaces(&slave, master, within));
            });
            let (slave_faces, master_faces) = facing_surfaces(&slave, master, within)?;
            let dofs = [&slave, master].map(|mesh| DofMap::unsupported(mesh.node_count(), 3));
            let side = |mesh, faces, dofs| Side {
                mesh,
                faces,
                dofs,
                patches: None,
                taken: &[],
            };
            let coupled = || {
                couple(
                    side(&slave, &slave_faces, &dofs[0]),
                    side(master, &master_faces, &dofs[1]),
                    Interface {
                        friction: &FrictionLaw::Frictionless,
                        gap: &ScalarField::Constant(0.0),
                    },
                    CouplingMethod::Mortar,
                    None,
                )
            };
            assert_eq!(coupled()?.pairs.len(), (n + 1) * (n + 1), "{name}");
            group.bench_function(BenchmarkId::new("coupling", &name), |bencher| {
                bencher.iter(coupled);
            });
        }
    }
    group.finish();
    Ok(())
}

fn slab(low: f64, cells: usize) -> Result<Mesh, FemError> {
    brick(&BrickSpec {
        min: [0.0, 0.0, low],
        max: [1.0, 1.0, low + 0.1],
        nodes: [cells + 1, cells + 1, 2],
    })
}

/// Each hexahedron as two wedges.
fn divided(mesh: &Mesh) -> Result<Mesh, FemError> {
    let parts = [[0, 2, 1, 4, 6, 5], [0, 3, 2, 4, 7, 6]];
    let cells = mesh.iter_cells();
    let cells = cells.flat_map(|cell| parts.map(|part| part.map(|a| cell.nodes[a])));
    let block = CellBlock {
        kind: CellKind::Wedge6,
        connectivity: cells.flatten().collect(),
    };
    Mesh::new(
        mesh.space,
        mesh.points.clone(),
        vec![block],
        BTreeMap::new(),
    )
}
