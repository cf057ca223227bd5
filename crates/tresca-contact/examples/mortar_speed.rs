//! Times the mortar coupling of two surfaces that do not match.
//!
//! `cargo run --release -p tresca-contact --example mortar_speed -- 224`
//!
//! Two slabs of n × n and n′ × n′ faces, n′ = 9n/10, hexahedra over hexahedra and over wedges; the same with
//! curved surfaces.
#![allow(clippy::print_stdout)]

use std::collections::BTreeMap;
use std::time::Instant;

use tresca_contact::{
    CouplingMethod, FrictionLaw, Interface, ScalarField, Side, couple, facing_surfaces,
};
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{BrickSpec, CellBlock, CellKind, Mesh, brick};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let n: usize = std::env::args().nth(1).map_or(Ok(100), |a| a.parse())?;
    let other = (9 * n / 10).max(1);
    for (name, height) in [("flat", 0.0), ("curved", 0.05)] {
        let bend = move |[x, y, z]: [f64; 3]| {
            let hill = height * (3.0 * x).sin() * (2.0 * y).cos();
            [x, y, z + hill]
        };
        let slave = slab(0.0, n)?.mapped(bend)?;
        let hexahedra = slab(-0.1, other)?.mapped(bend)?;
        let wedges = divided(&hexahedra)?;
        for (partner, master) in [("hex8", &hexahedra), ("wedge6", &wedges)] {
            let start = Instant::now();
            let (slave_faces, master_faces) = facing_surfaces(&slave, master, 0.5 / n as f64)?;
            let facing = start.elapsed();
            let dofs = [&slave, master].map(|mesh| DofMap::unsupported(mesh.node_count(), 3));
            let side = |mesh, faces, dofs| Side {
                mesh,
                faces,
                dofs,
                patches: None,
                taken: &[],
            };
            let interface = Interface {
                friction: &FrictionLaw::Frictionless,
                gap: &ScalarField::Constant(0.0),
            };
            let start = Instant::now();
            let data = couple(
                side(&slave, &slave_faces, &dofs[0]),
                side(master, &master_faces, &dofs[1]),
                interface,
                CouplingMethod::Mortar,
                None,
            )?;
            println!(
                "{name}, hex8 on {partner}: {} faces over {}, {} pairs: pairing {:.2?}, coupling {:.2?}",
                slave_faces.len(),
                master_faces.len(),
                data.pairs.len(),
                facing,
                start.elapsed(),
            );
        }
    }
    Ok(())
}

fn slab(low: f64, cells: usize) -> Result<Mesh, tresca_fem::FemError> {
    brick(&BrickSpec {
        min: [0.0, 0.0, low],
        max: [1.0, 1.0, low + 0.1],
        nodes: [cells + 1, cells + 1, 2],
    })
}

/// Each hexahedron as two wedges.
fn divided(mesh: &Mesh) -> Result<Mesh, tresca_fem::FemError> {
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
