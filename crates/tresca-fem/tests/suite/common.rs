//! Meshes and a linear solve shared by the tests.

use faer::linalg::solvers::Solve;
use tresca_fem::assembly::{Formulation, reduced_load, stiffness};
use tresca_fem::dofs::DofMap;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, Face, Mesh, RectangleSpec, Space, brick, rectangle};
use tresca_fem::supports::Supports;
use tresca_la::SymmetricMatrix;
use tresca_la::vector::{axpy, dot, norm};

/// The kinds of cells that fill a space of the dimension.
pub fn kinds(dimension: usize) -> impl Iterator<Item = CellKind> {
    let all = CellKind::ALL.into_iter();
    all.filter(move |kind| kind.dimension() == dimension)
}

/// The unit cube with interior nodes moved by `amount` cell sizes, in a fixed irregular way.
pub fn perturbed_brick(nodes: [usize; 3], amount: f64) -> Mesh {
    let mut mesh = brick(&BrickSpec {
        min: [0.0; 3],
        max: [1.0; 3],
        nodes,
    })
    .unwrap();
    for (node, point) in mesh.points.iter_mut().enumerate() {
        if point.iter().all(|&x| x > 0.0 && x < 1.0) {
            for (i, x) in point.iter_mut().enumerate() {
                let phase = (12.9898 * node as f64 + 78.233 * i as f64).sin() * 43758.5453;
                *x += amount * (2.0 * (phase - phase.floor()) - 1.0) / (nodes[i] - 1) as f64;
            }
        }
    }
    mesh
}

/// A unit square from `min` on with interior corner nodes moved by `amount` cell sizes, in a fixed
/// irregular way.
pub fn perturbed_rectangle(
    space: Space,
    cells: CellKind,
    min: [f64; 2],
    nodes: [usize; 2],
    amount: f64,
) -> Mesh {
    let max = min.map(|x| x + 1.0);
    let mesh = rectangle(&RectangleSpec {
        space,
        min,
        max,
        nodes,
        cells: cells.linear(),
    })
    .unwrap();
    let mut node = 0;
    mesh.mapped(|point| {
        let mut moved = point;
        if (0..2).all(|i| point[i] > min[i] && point[i] < max[i]) {
            for i in 0..2 {
                let phase = (12.9898 * node as f64 + 78.233 * i as f64).sin() * 43758.5453;
                moved[i] += amount * (2.0 * (phase - phase.floor()) - 1.0) / (nodes[i] - 1) as f64;
            }
        }
        node += 1;
        moved
    })
    .unwrap()
    .with_cells(cells)
    .unwrap()
}

/// All entries of a symmetric matrix.
pub fn dense(k: &SymmetricMatrix) -> Vec<Vec<f64>> {
    let mut full = vec![vec![0.0; k.order()]; k.order()];
    for j in 0..k.order() {
        for (i, &value) in k.lower().row_idx_of_col(j).zip(k.lower().val_of_col(j)) {
            full[i][j] = value;
            full[j][i] = value;
        }
    }
    full
}

/// The displacement (full dofs) under a load and supports, by faer's sparse Cholesky.
pub fn solve(mesh: &Mesh, material: &Isotropic, supports: &Supports, load: &[f64]) -> Vec<f64> {
    solve_with(mesh, material, Formulation::Full, supports, load)
}

/// The same in a formulation of choice.
pub fn solve_with(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    supports: &Supports,
    load: &[f64],
) -> Vec<f64> {
    solve_by(mesh, material, formulation, supports, load, by_cholesky)
}

/// The same by conjugate gradients with the diagonal as preconditioner, to 1e-11: faster on the
/// finer meshes.
pub fn solve_by_cg(
    mesh: &Mesh,
    material: &Isotropic,
    supports: &Supports,
    load: &[f64],
) -> Vec<f64> {
    solve_by(mesh, material, Formulation::Full, supports, load, |k, f| {
        let diagonal = k.diagonal();
        let (mut x, mut r, mut kp) = (vec![0.0; f.len()], f.to_vec(), vec![0.0; f.len()]);
        let precondition = |r: &[f64]| {
            r.iter()
                .zip(&diagonal)
                .map(|(r, d)| r / d)
                .collect::<Vec<f64>>()
        };
        let mut z = precondition(&r);
        let mut p = z.clone();
        let mut rz = dot(&r, &z);
        for _ in 0..1000 {
            k.mul(&p, &mut kp);
            let alpha = rz / dot(&p, &kp);
            axpy(alpha, &p, &mut x);
            axpy(-alpha, &kp, &mut r);
            if norm(&r) <= 1e-11 * norm(f) {
                return x;
            }
            z = precondition(&r);
            let before = std::mem::replace(&mut rz, dot(&r, &z));
            p.iter_mut()
                .zip(&z)
                .for_each(|(p, z)| *p = z + rz / before * *p);
        }
        panic!("conjugate gradients did not converge");
    })
}

fn solve_by(
    mesh: &Mesh,
    material: &Isotropic,
    formulation: Formulation,
    supports: &Supports,
    load: &[f64],
    solver: impl Fn(&SymmetricMatrix, &[f64]) -> Vec<f64>,
) -> Vec<f64> {
    let dofs = DofMap::new(supports);
    let values = supports.values();
    solve_constrained(mesh, (material, formulation), &dofs, &values, load, solver)
}

/// The displacement (full dofs) of a body whose dofs are numbered; `prescribed` are the held displacements.
pub fn solve_constrained(
    mesh: &Mesh,
    (material, formulation): (&Isotropic, Formulation),
    dofs: &DofMap,
    prescribed: &[f64],
    load: &[f64],
    solver: impl Fn(&SymmetricMatrix, &[f64]) -> Vec<f64>,
) -> Vec<f64> {
    let k = stiffness(mesh, material, formulation, dofs).unwrap();
    let f = reduced_load(mesh, material, formulation, dofs, load, prescribed).unwrap();
    let mut u = prescribed.to_vec();
    dofs.write_free(&solver(&k, &f), &mut u);
    u
}

/// By faer's sparse Cholesky.
pub fn by_cholesky(k: &SymmetricMatrix, f: &[f64]) -> Vec<f64> {
    let factor = k.lower().sp_cholesky(faer::Side::Lower).unwrap();
    let x = factor.solve(faer::Col::from_fn(f.len(), |i| f[i]));
    (0..f.len()).map(|i| x[i]).collect()
}

/// Two meshes of one space as one, without a connection; the sets are those of both, the nodes of the second
/// come after those of the first.
pub fn side_by_side(first: &Mesh, second: &Mesh) -> Mesh {
    let mut mesh = first.clone();
    let (nodes, cells) = (first.node_count(), first.cell_count());
    mesh.points.extend_from_slice(&second.points);
    for block in &second.cells {
        let mut block = block.clone();
        block
            .connectivity
            .iter_mut()
            .for_each(|node| *node += nodes);
        mesh.cells.push(block);
    }
    for (name, faces) in &second.face_sets {
        let moved = faces.iter().map(|&face| Face {
            cell: face.cell + cells,
            ..face
        });
        mesh.face_sets
            .insert(format!("second {name}"), moved.collect());
    }
    mesh.validate().unwrap();
    mesh
}
