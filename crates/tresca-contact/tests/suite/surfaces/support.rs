//! Bodies and checks that the tests share.

use std::collections::{BTreeMap, HashMap};

use faer::sparse::SparseRowMat;
use tresca_contact::{
    ContactData, CouplingMethod, FrictionLaw, Interface, ScalarField, Side, SmoothPatches, couple,
};
use tresca_fem::dofs::DofMap;
use tresca_fem::mesh::{BrickSpec, CellBlock, CellKind, Face, Mesh, brick};
use tresca_fem::supports::Supports;

pub const LAW: FrictionLaw = FrictionLaw::Tresca {
    bound: ScalarField::Constant(0.5),
};
pub const INTERFACE: Interface<'static> = Interface {
    friction: &LAW,
    gap: &ScalarField::Constant(0.0),
};

/// A body with the faces that may touch.
pub struct Body {
    pub mesh: Mesh,
    pub dofs: DofMap,
    pub faces: Vec<Face>,
    pub patches: Option<SmoothPatches>,
    pub taken: Vec<usize>,
}

impl Body {
    /// A body without supports; its contact faces are those with all nodes where `on` says so.
    pub fn new(mesh: Mesh, on: impl Fn([f64; 3]) -> bool) -> Self {
        let dofs = DofMap::unsupported(mesh.node_count(), mesh.dimension());
        let faces = boundary_where(&mesh, on);
        Self {
            mesh,
            dofs,
            faces,
            patches: None,
            taken: Vec::new(),
        }
    }

    /// Holds components of nodes.
    pub fn held(mut self, component: usize, at: impl Fn([f64; 3]) -> bool) -> Self {
        let mesh = &self.mesh;
        let mut supports = Supports::new(mesh.node_count(), mesh.dimension());
        for dof in self.dofs.prescribed() {
            let (node, c) = (dof / mesh.dimension(), dof % mesh.dimension());
            supports.prescribe(node, c, 0.0).unwrap();
        }
        for node in (0..mesh.node_count()).filter(|&node| at(mesh.points[node])) {
            supports.prescribe(node, component, 0.0).unwrap();
        }
        self.dofs = DofMap::new(&supports);
        self
    }

    pub fn side(&self) -> Side<'_> {
        Side {
            mesh: &self.mesh,
            faces: &self.faces,
            dofs: &self.dofs,
            patches: self.patches.as_ref(),
            taken: &self.taken,
        }
    }
}

pub fn boundary_where(mesh: &Mesh, on: impl Fn([f64; 3]) -> bool) -> Vec<Face> {
    let mut faces = mesh.boundary_faces();
    faces.retain(|&face| mesh.face_nodes(face).iter().all(|&n| on(mesh.points[n])));
    faces
}

pub fn mortar(slave: &Body, master: &Body) -> ContactData {
    let method = CouplingMethod::Mortar;
    couple(slave.side(), master.side(), INTERFACE, method, None).unwrap()
}

/// A box with `cells` hexahedra along each axis, or what they are divided into.
pub fn block(kind: CellKind, min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh {
    let nodes = cells.map(|n| n + 1);
    let mesh = brick(&BrickSpec { min, max, nodes }).unwrap();
    match kind {
        CellKind::Hex8 => mesh,
        CellKind::Hex20 | CellKind::Hex27 => elevated(&mesh, kind),
        CellKind::Wedge6 => divided(&mesh, kind, &[&[0, 2, 1, 4, 6, 5], &[0, 3, 2, 4, 7, 6]]),
        CellKind::Tet4 => divided(&mesh, kind, TETRAHEDRA),
        CellKind::Tet10 => elevated(&divided(&mesh, CellKind::Tet4, TETRAHEDRA), kind),
        other => panic!("{other} does not fill a box"),
    }
}

const TETRAHEDRA: &[&[usize]] = &[
    &[0, 1, 2, 6],
    &[0, 2, 3, 6],
    &[0, 3, 7, 6],
    &[0, 7, 4, 6],
    &[0, 4, 5, 6],
    &[0, 5, 1, 6],
];

fn divided(mesh: &Mesh, kind: CellKind, parts: &[&[usize]]) -> Mesh {
    let cells = mesh.iter_cells();
    let nodes = cells.flat_map(|cell| parts.iter().map(move |part| (cell, part)));
    let connectivity = nodes.flat_map(|(cell, part)| part.iter().map(move |&a| cell.nodes[a]));
    let block = CellBlock {
        kind,
        connectivity: connectivity.collect(),
    };
    Mesh::new(
        mesh.space,
        mesh.points.clone(),
        vec![block],
        BTreeMap::new(),
    )
    .unwrap()
}

/// The same cells with more nodes.
pub fn elevated(mesh: &Mesh, kind: CellKind) -> Mesh {
    let mut points = Vec::new();
    let mut known = HashMap::new();
    let mut connectivity = Vec::new();
    for cell in mesh.iter_cells() {
        for &xi in kind.element().nodes() {
            let mut values = vec![0.0; cell.nodes.len()];
            cell.kind.element().shape(xi, &mut values);
            let mut x = [0.0; 3];
            for (value, &node) in values.iter().zip(cell.nodes) {
                x = std::array::from_fn(|k| x[k] + value * mesh.points[node][k]);
            }
            let key = x.map(|x| (x * 1e7).round() as i64);
            let node = *known.entry(key).or_insert_with(|| {
                points.push(x);
                points.len() - 1
            });
            connectivity.push(node);
        }
    }
    let block = CellBlock { kind, connectivity };
    Mesh::new(mesh.space, points, vec![block], BTreeMap::new()).unwrap()
}

/// A rotation about the y axis, then one about the z axis.
pub fn turn([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (s, c) = 0.4_f64.sin_cos();
    let [x, y, z] = [c * x + s * z, y, c * z - s * x];
    let (s, c) = 0.7_f64.sin_cos();
    [c * x - s * y, s * x + c * y, z]
}

/// y ← y + B u.
pub fn add_product(matrix: &SparseRowMat<usize, f64>, u: &[f64], y: &mut [f64]) {
    let matrix = matrix.as_ref();
    for (row, y) in y.iter_mut().enumerate() {
        for (column, value) in matrix.col_idx_of_row(row).zip(matrix.val_of_row(row)) {
            *y += value * u[column];
        }
    }
}

/// Bᵀ λ.
pub fn transposed_product(matrix: &SparseRowMat<usize, f64>, lambda: &[f64]) -> Vec<f64> {
    let mut f = vec![0.0; matrix.ncols()];
    let matrix = matrix.as_ref();
    for (row, lambda) in lambda.iter().enumerate() {
        for (column, value) in matrix.col_idx_of_row(row).zip(matrix.val_of_row(row)) {
            f[column] += value * lambda;
        }
    }
    f
}

pub fn field(mesh: &Mesh, u: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<f64> {
    let d = mesh.dimension();
    let values = mesh.points.iter().flat_map(|&x| u(x).into_iter().take(d));
    values.collect()
}

/// B u of a displacement of each body, by point.
pub fn relative(
    data: &ContactData,
    slave: &Body,
    master: &Body,
    u: [&dyn Fn([f64; 3]) -> [f64; 3]; 2],
) -> Vec<f64> {
    let mut y = vec![0.0; data.slave_coupling.nrows()];
    add_product(&data.slave_coupling, &field(&slave.mesh, u[0]), &mut y);
    let coupling = data.master_coupling.as_ref().unwrap();
    add_product(coupling, &field(&master.mesh, u[1]), &mut y);
    y
}

/// The smallest pivot of the scaled B Bᵀ over the free dofs: positive where rows are independent.
/// Rows in which the supports let nothing move are left out.
pub fn smallest_pivot(data: &ContactData, slave: &Body, master: Option<&Body>) -> f64 {
    let m = data.pairs.len();
    let tangents = slave.mesh.dimension() - 1;
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for row in 0..data.slave_coupling.nrows() {
        let mobility = |pair: usize| data.pairs[pair].mobility;
        let moves = if row < m {
            mobility(row).normal
        } else {
            mobility((row - m) / tangents).tangents[(row - m) % tangents]
        };
        if !moves {
            continue;
        }
        let mut dense = Vec::new();
        let mut add = |matrix: &SparseRowMat<usize, f64>, body: &Body| {
            let mut part = vec![0.0; body.dofs.full_len()];
            let matrix = matrix.as_ref();
            for (column, value) in matrix.col_idx_of_row(row).zip(matrix.val_of_row(row)) {
                part[column] += value;
            }
            dense.extend(body.dofs.restrict(&part));
        };
        add(&data.slave_coupling, slave);
        if let (Some(matrix), Some(master)) = (&data.master_coupling, master) {
            add(matrix, master);
        }
        rows.push(dense);
    }
    // Gram–Schmidt, twice for accuracy.
    let mut smallest = f64::INFINITY;
    for i in 0..rows.len() {
        let (before, rest) = rows.split_at_mut(i);
        let row = &mut rest[0];
        let norm = |row: &[f64]| row.iter().map(|x| x * x).sum::<f64>().sqrt();
        let length = norm(row);
        for _ in 0..2 {
            for q in before.iter() {
                let along: f64 = q.iter().zip(row.iter()).map(|(a, b)| a * b).sum();
                row.iter_mut().zip(q).for_each(|(r, q)| *r -= along * q);
            }
        }
        let rest = norm(row);
        smallest = smallest.min(rest / length);
        row.iter_mut().for_each(|x| *x /= rest);
    }
    smallest
}
