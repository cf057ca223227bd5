//! What every element must satisfy, in one call.

use super::mapping::orientation;
use super::reference::Element;
use super::table::{ShapeTable, interpolate, jacobian};
use crate::assembly::formulation::Formulation;
use crate::assembly::stiffness::stiffness;
use crate::dofs::DofMap;
use crate::material::Isotropic;
use crate::mesh::data::{CellBlock, Face, Mesh};
use crate::mesh::kind::CellKind;
use crate::mesh::space::Space;
use crate::quadrature::{Rule, gauss_cube, gauss_line, gauss_square, tetrahedron, triangle, wedge};
use std::collections::BTreeMap;

/// Runs the whole list on an element.
fn check(kind: CellKind) {
    let element = kind.element();
    let (n, d) = (element.nodes().len(), element.dimension());
    assert_eq!((kind.node_count(), kind.dimension()), (n, d));
    for xi in test_points(d) {
        partition_of_unity(element, xi);
        gradients_by_finite_differences(element, xi);
        linear_fields_are_reproduced(element, xi);
    }
    kronecker_property(element);
    rules_have_the_reference_measure(kind);
    corners_are_those_of_the_linear_kind(kind);
    faces_are_faces(kind);
    for map in [shear, perturb] {
        let points: Vec<[f64; 3]> = element.nodes().iter().map(|&xi| map(d, xi)).collect();
        rigid_motions_cause_no_strain(kind, &points);
        volume_is_exact(kind, &points);
        if d > 1 {
            faces_look_outwards(kind, points);
        }
    }
    mass_and_stiffness_are_exact_on_an_affine_cell(kind);
    if d > 1 {
        rigid_motions_alone_cost_no_energy(kind);
    }
}

macro_rules! conforms {
    ($($name:ident: $kind:ident),*) => {
        $(#[test]
        fn $name() {
            check(CellKind::$kind);
        })*
    };
}

conforms!(
    line2: Line2, line3: Line3, tri3: Tri3, tri6: Tri6, quad4: Quad4, quad8: Quad8, quad9: Quad9,
    tet4: Tet4, tet10: Tet10, wedge6: Wedge6, hex8: Hex8, hex20: Hex20, hex27: Hex27
);

/// Some points of no symmetry.
fn test_points(d: usize) -> Vec<[f64; 3]> {
    [
        [0.3, -0.7, 0.11],
        [-0.92, 0.05, 0.64],
        [0.0, 0.0, 0.0],
        [1.0, -1.0, 0.4],
    ]
    .map(|p| std::array::from_fn(|i| if i < d { p[i] } else { 0.0 }))
    .to_vec()
}

/// An affine map of positive determinant that keeps the element's dimension.
fn shear(d: usize, xi: [f64; 3]) -> [f64; 3] {
    let a = [[2.0, 0.6, -0.3], [0.1, 1.5, 0.4], [0.2, -0.5, 1.2]];
    std::array::from_fn(|i| {
        if i < d {
            0.3 * i as f64 + (0..d).map(|j| a[i][j] * xi[j]).sum::<f64>()
        } else {
            0.0
        }
    })
}

/// A mild nonlinear map.
fn perturb(d: usize, xi: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = xi;
    let bend = [
        0.13 * y * z + 0.1 * x * y + 0.04 * y * y,
        0.1 * x * y - 0.07 * z * x,
        0.09 * x * y * z - 0.08 * y + 0.05 * x * x,
    ];
    let sheared = shear(d, xi);
    std::array::from_fn(|i| if i < d { sheared[i] + bend[i] } else { 0.0 })
}

fn shape(element: &dyn Element, xi: [f64; 3]) -> Vec<f64> {
    let mut values = vec![f64::NAN; element.nodes().len()];
    element.shape(xi, &mut values);
    values
}

fn gradients(element: &dyn Element, xi: [f64; 3]) -> Vec<[f64; 3]> {
    let mut gradients = vec![[f64::NAN; 3]; element.nodes().len()];
    element.gradients(xi, &mut gradients);
    gradients
}

fn partition_of_unity(element: &dyn Element, xi: [f64; 3]) {
    assert!((shape(element, xi).iter().sum::<f64>() - 1.0).abs() < 1e-14);
    for j in 0..3 {
        let sum: f64 = gradients(element, xi).iter().map(|g| g[j]).sum();
        assert!(sum.abs() < 1e-14, "Σ∂φ/∂ξ_{j} = {sum:e}");
    }
}

fn kronecker_property(element: &dyn Element) {
    for (b, &xi) in element.nodes().iter().enumerate() {
        for (a, value) in shape(element, xi).into_iter().enumerate() {
            let expected = if a == b { 1.0 } else { 0.0 };
            assert!(
                (value - expected).abs() < 1e-15,
                "φ_{a} at node {b}: {value}"
            );
        }
    }
}

fn gradients_by_finite_differences(element: &dyn Element, xi: [f64; 3]) {
    let h = 1e-5;
    let exact = gradients(element, xi);
    for j in 0..3 {
        let (mut before, mut after) = (xi, xi);
        before[j] -= h;
        after[j] += h;
        let (before, after) = (shape(element, before), shape(element, after));
        for a in 0..exact.len() {
            // A direction that the element does not have must have no gradient.
            let difference = if j < element.dimension() {
                (after[a] - before[a]) / (2.0 * h)
            } else {
                0.0
            };
            assert!(
                (exact[a][j] - difference).abs() < 1e-9,
                "node {a}, direction {j}"
            );
        }
    }
}

fn linear_fields_are_reproduced(element: &dyn Element, xi: [f64; 3]) {
    let field = |x: [f64; 3]| 0.7 - 1.3 * x[0] + 2.1 * x[1] + 0.4 * x[2];
    let nodal = element.nodes().iter().map(|&x| field(x));
    let value: f64 = nodal.zip(shape(element, xi)).map(|(f, v)| f * v).sum();
    assert!((value - field(xi)).abs() < 1e-14);
}

fn rules_have_the_reference_measure(kind: CellKind) {
    let element = kind.element();
    let measure = match kind.linear() {
        CellKind::Line2 => 2.0,
        CellKind::Tri3 => 0.5,
        CellKind::Quad4 => 4.0,
        CellKind::Tet4 => 1.0 / 6.0,
        CellKind::Wedge6 => 1.0,
        _ => 8.0,
    };
    for rule in [element.rule(), element.mass_rule(), element.stress_points()] {
        assert_eq!(rule.points.len(), rule.weights.len());
        assert!((rule.weights.iter().sum::<f64>() - measure).abs() < 1e-14 * measure.max(1.0));
        assert!(rule.weights.iter().all(|&w| w > 0.0));
    }
}

/// The first nodes are the linear kind's, and the others lie amid some of them.
fn corners_are_those_of_the_linear_kind(kind: CellKind) {
    let (nodes, linear) = (kind.element().nodes(), kind.linear());
    assert_eq!(nodes[..kind.corner_count()], *linear.element().nodes());
    for &xi in &nodes[kind.corner_count()..] {
        let corners = shape(linear.element(), xi);
        let amid: Vec<f64> = corners.into_iter().filter(|&v| v != 0.0).collect();
        assert!(amid.len() > 1 && amid.iter().all(|&v| v == 1.0 / amid.len() as f64));
    }
}

/// Each face has as many nodes as its own element, and together they meet every node but one in the
/// middle of the cell.
fn faces_are_faces(kind: CellKind) {
    let mut met = vec![false; kind.node_count()];
    let linear = kind.linear();
    assert_eq!(kind.faces().len(), linear.faces().len());
    for (face, of_linear) in kind.faces().iter().zip(linear.faces()) {
        assert_eq!(face.nodes[..face.kind.corner_count()], *of_linear.nodes);
        assert_eq!(face.kind.dimension() + 1, kind.dimension());
        assert_eq!(face.nodes.len(), face.kind.node_count());
        assert_eq!(face.kind.order(), kind.order());
        // On the reference element the face's shape functions interpolate the cell's nodes: the
        // cell's shape functions restricted to the face are the face's.
        let corners: Vec<[f64; 3]> = face
            .nodes
            .iter()
            .map(|&a| kind.element().nodes()[a])
            .collect();
        for eta in test_points(face.kind.dimension()) {
            let on_face = shape(face.kind.element(), eta);
            let in_cell = shape(kind.element(), interpolate(&on_face, &corners));
            for (a, value) in in_cell.into_iter().enumerate() {
                let local = face.nodes.iter().position(|&node| node == a);
                let expected = local.map_or(0.0, |local| on_face[local]);
                assert!((value - expected).abs() < 1e-14);
            }
        }
        face.nodes.iter().for_each(|&a| met[a] = true);
    }
    let inside = usize::from(matches!(kind, CellKind::Quad9 | CellKind::Hex27));
    let unmet = met.iter().filter(|&&m| !m).count();
    assert!(kind.faces().is_empty() || unmet == inside);
}

/// Physical gradients by solving J^T g = ∇_ξ φ with Cramer's rule in d dimensions.
fn physical(kind: CellKind, points: &[[f64; 3]], xi: [f64; 3]) -> Vec<[f64; 3]> {
    let reference = gradients(kind.element(), xi);
    let mut columns = jacobian(&reference, points);
    for (j, column) in columns.iter_mut().enumerate().skip(kind.dimension()) {
        column[j] = 1.0;
    }
    let det = crate::matrix3::determinant(&columns);
    let rows = crate::matrix3::inverse_rows(&columns, det);
    reference
        .iter()
        .map(|g| std::array::from_fn(|i| (0..kind.dimension()).map(|j| g[j] * rows[j][i]).sum()))
        .collect()
}

fn rigid_motions_cause_no_strain(kind: CellKind, points: &[[f64; 3]]) {
    let d = kind.dimension();
    // u = t + W x with W antisymmetric, within the element's dimension.
    let w = [[0.0, -0.8, 0.3], [0.8, 0.0, -1.1], [-0.3, 1.1, 0.0]];
    let motion = |x: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|i| [0.2, -0.4, 1.0][i] + (0..d).map(|j| w[i][j] * x[j]).sum::<f64>())
    };
    for xi in test_points(d) {
        let g = physical(kind, points, xi);
        for i in 0..d {
            for j in 0..d {
                let strain: f64 = points
                    .iter()
                    .zip(&g)
                    .map(|(&x, g)| 0.5 * (motion(x)[i] * g[j] + motion(x)[j] * g[i]))
                    .sum();
                assert!(strain.abs() < 1e-14, "{kind}: ε_{i}{j} = {strain:e}");
            }
        }
    }
}

/// A rule of so many points that the test's integrands are integrated exactly.
fn fine_rule(kind: CellKind) -> Rule {
    match kind.linear() {
        CellKind::Line2 => gauss_line(8),
        CellKind::Tri3 => triangle(14),
        CellKind::Quad4 => gauss_square(8),
        CellKind::Tet4 => tetrahedron(14),
        CellKind::Wedge6 => wedge(14, 8),
        _ => gauss_cube(8),
    }
}

/// det J in the element's own dimension.
fn determinant(kind: CellKind, gradients: &[[f64; 3]], points: &[[f64; 3]]) -> f64 {
    match kind.dimension() {
        1 => jacobian(gradients, points)[0][0],
        d => orientation(d, gradients, points).0,
    }
}

fn volume_is_exact(kind: CellKind, points: &[[f64; 3]]) {
    let volume = |rule: &Rule| {
        let table = ShapeTable::new(kind, rule);
        (0..table.len())
            .map(|q| table.weights[q] * determinant(kind, table.gradients(q), points))
            .sum::<f64>()
    };
    let (full, fine) = (
        volume(&kind.element().mass_rule()),
        volume(&fine_rule(kind)),
    );
    assert!(
        full > 0.0 && (full - fine).abs() < 1e-13 * fine,
        "{kind}: {full} against {fine}"
    );
}

/// ∫ φ_a φ_b dΩ by the mass rule, and ∫ ∂_i φ_a ∂_j φ_b dΩ by the stiffness rule, against a fine one.
fn mass_and_stiffness_are_exact_on_an_affine_cell(kind: CellKind) {
    let (n, d) = (kind.node_count(), kind.dimension());
    let nodes = kind.element().nodes().iter();
    let points: Vec<[f64; 3]> = nodes.map(|&xi| shear(d, xi)).collect();
    // The matrices by rows: φφ first, then the pairs of reference gradients, which differ from the
    // physical ones by a constant matrix.
    let matrices = |rule: &Rule, stiffness: bool| {
        let table = ShapeTable::new(kind, rule);
        let mut sums = Vec::new();
        for (i, j) in (0..d).flat_map(|i| (0..d).map(move |j| (i, j))) {
            for (a, b) in (0..n).flat_map(|a| (0..n).map(move |b| (a, b))) {
                let of_point = |q: usize| {
                    let product = if stiffness {
                        table.gradients(q)[a][i] * table.gradients(q)[b][j]
                    } else {
                        table.values(q)[a] * table.values(q)[b]
                    };
                    table.weights[q] * determinant(kind, table.gradients(q), &points) * product
                };
                sums.push((0..table.len()).map(of_point).sum::<f64>());
            }
            if !stiffness {
                return sums;
            }
        }
        sums
    };
    for (rule, stiffness) in [
        (kind.element().rule(), true),
        (kind.element().mass_rule(), false),
    ] {
        let (found, fine) = (
            matrices(&rule, stiffness),
            matrices(&fine_rule(kind), stiffness),
        );
        let largest = fine.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        for (found, fine) in found.into_iter().zip(fine) {
            assert!(
                (found - fine).abs() < 1e-13 * largest,
                "{kind}: {found} {fine}"
            );
        }
    }
}

/// The stiffness of one free cell, straight or not, has the kernel of rigid motions: six zero
/// eigenvalues in space, three in the plane, one in an axisymmetric space.
fn rigid_motions_alone_cost_no_energy(kind: CellKind) {
    let spaces: &[(Space, usize)] = match kind.dimension() {
        2 => &[(Space::Plane, 3), (Space::Axisymmetric, 1)],
        _ => &[(Space::Solid, 6)],
    };
    for map in [shear, perturb] {
        for &(space, motions) in spaces {
            let nodes = kind.element().nodes().iter();
            // Off the axis of revolution.
            let off =
                |[x, y, z]: [f64; 3]| [x + if space == Space::Solid { 0.0 } else { 5.0 }, y, z];
            let points: Vec<_> = nodes.map(|&xi| off(map(kind.dimension(), xi))).collect();
            let dofs = DofMap::unsupported(points.len(), space.dimension());
            let mesh = one_cell(space, kind, points);
            let material = Isotropic::new(1.0, 0.3).unwrap();
            for formulation in Formulation::ALL {
                if formulation.check(&mesh, &material).is_err() {
                    continue;
                }
                let k = stiffness(&mesh, &material, formulation, &dofs).unwrap();
                let n = k.order();
                let mut matrix = faer::Mat::zeros(n, n);
                for j in 0..n {
                    for (i, &value) in k.lower().row_idx_of_col(j).zip(k.lower().val_of_col(j)) {
                        matrix[(i, j)] = value;
                    }
                }
                let values = matrix.self_adjoint_eigenvalues(faer::Side::Lower).unwrap();
                let zero = |x: &&f64| x.abs() < 1e-12 * values[n - 1];
                assert_eq!(
                    values.iter().filter(zero).count(),
                    motions,
                    "{kind} {space}"
                );
                assert!(
                    values[motions] > 1e-4 * values[n - 1],
                    "{kind} {space}: {values:?}"
                );
            }
        }
    }
}

fn one_cell(space: Space, kind: CellKind, points: Vec<[f64; 3]>) -> Mesh {
    let connectivity = (0..points.len()).collect();
    let block = CellBlock { kind, connectivity };
    Mesh::new(space, points, vec![block], BTreeMap::new()).unwrap()
}

/// ∫ x·n over each face is what the divergence theorem needs, and each face's area vector points
/// away from the cell's centre.
fn faces_look_outwards(kind: CellKind, points: Vec<[f64; 3]>) {
    let d = kind.dimension();
    let n = points.len();
    let center: [f64; 3] =
        std::array::from_fn(|i| points.iter().map(|p| p[i]).sum::<f64>() / n as f64);
    let space = if d == 2 { Space::Plane } else { Space::Solid };
    let mesh = one_cell(space, kind, points);
    let mut flux = 0.0;
    for local in 0..kind.faces().len() {
        let face = Face { cell: 0, local };
        let nodes = mesh.face_nodes(face);
        let area = mesh.area_vector(&[face]);
        let middle: [f64; 3] = std::array::from_fn(|i| {
            nodes.iter().map(|&a| mesh.points[a][i]).sum::<f64>() / nodes.len() as f64
        });
        let outwards: f64 = (0..3).map(|i| area[i] * (middle[i] - center[i])).sum();
        assert!(outwards > 0.0, "{kind}: face {local} looks inwards");
        for (node, vector) in crate::loads::nodal_area_vectors(&mesh, &[face])
            .into_iter()
            .enumerate()
        {
            flux += crate::vector3::dot(mesh.points[node], vector);
        }
    }
    // ∫ x·n dΓ = d |Ω|
    assert!(
        (flux - d as f64 * mesh.volume()).abs() < 1e-13 * flux,
        "{kind}: {flux}"
    );
}
