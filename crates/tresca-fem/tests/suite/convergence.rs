//! Rates of convergence on a manufactured solution.
//!
//! u_i(x) = a_i(x) b_i(y) c_i(z), smooth and no polynomial, on the unit cube; Dirichlet data on the
//! whole boundary; body force b = −div σ(u) = −(λ + μ) ∇(div u) − μ Δu.

use crate::common::{perturbed_brick, solve_by_cg};
use tresca_fem::assembly::Formulation;
use tresca_fem::loads::body_force;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{CellKind, Mesh};
use tresca_fem::quadrature::{gauss_cube, tetrahedron, wedge};
use tresca_fem::stress;
use tresca_fem::supports::Supports;

/// Value, first and second derivative of the factors a_i, b_i, c_i at a point, `[i][axis][order]`.
fn factors([x, y, z]: [f64; 3]) -> [[[f64; 3]; 3]; 3] {
    let sine = |w: f64, p: f64, t: f64| {
        let (s, c) = (w * t + p).sin_cos();
        [s, w * c, -w * w * s]
    };
    let exponential = |w: f64, t: f64| {
        let e = (w * t).exp();
        [e, w * e, w * w * e]
    };
    let hyperbola = |t: f64| {
        [
            1.0 / (1.0 + t),
            -(1.0 + t).powi(-2),
            2.0 * (1.0 + t).powi(-3),
        ]
    };
    [
        [sine(2.0, 0.1, x), sine(1.0, 1.5, y), exponential(0.5, z)],
        [sine(1.5, 1.2, x), sine(2.5, 0.3, y), hyperbola(z)],
        [exponential(-0.7, x), sine(2.0, 1.0, y), sine(3.0, 0.2, z)],
    ]
}

/// ∂^o u_i for the derivative orders o along x, y, z.
fn derivative(f: &[[[f64; 3]; 3]; 3], i: usize, order: [usize; 3]) -> f64 {
    (0..3).map(|axis| f[i][axis][order[axis]]).product()
}

fn order(axes: &[usize]) -> [usize; 3] {
    let mut order = [0; 3];
    axes.iter().for_each(|&axis| order[axis] += 1);
    order
}

fn displacement(p: [f64; 3]) -> [f64; 3] {
    let f = factors(p);
    std::array::from_fn(|i| derivative(&f, i, [0; 3]))
}

fn strain(p: [f64; 3]) -> [f64; 6] {
    let f = factors(p);
    let d = |i: usize, j: usize| derivative(&f, i, order(&[j]));
    [
        d(0, 0),
        d(1, 1),
        d(2, 2),
        d(0, 1) + d(1, 0),
        d(1, 2) + d(2, 1),
        d(0, 2) + d(2, 0),
    ]
}

fn force(material: &Isotropic, p: [f64; 3]) -> [f64; 3] {
    let f = factors(p);
    let (lambda, mu) = (material.lambda(), material.mu());
    std::array::from_fn(|i| {
        let gradient_of_divergence: f64 = (0..3).map(|j| derivative(&f, j, order(&[i, j]))).sum();
        let laplacian: f64 = (0..3).map(|j| derivative(&f, i, order(&[j, j]))).sum();
        -(lambda + mu) * gradient_of_divergence - mu * laplacian
    })
}

#[test]
fn the_body_force_is_the_divergence_of_the_stress() {
    let material = Isotropic::new(2.0, 0.3).unwrap();
    let p = [0.3, 0.8, 0.45];
    let h = 1e-5;
    let component = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];
    for i in 0..3 {
        let divergence: f64 = (0..3)
            .map(|j| {
                let at = |step: f64| {
                    let mut q = p;
                    q[j] += step;
                    material.stress(strain(q))[component[i][j]]
                };
                (at(h) - at(-h)) / (2.0 * h)
            })
            .sum();
        assert!((divergence + force(&material, p)[i]).abs() < 1e-8);
    }
}

/// Errors of displacement (L2), energy (square root of the strain energy of the error) and
/// recovered stress (L2, and largest at a node).
struct Errors {
    displacement: f64,
    energy: f64,
    stress: f64,
    largest_stress: f64,
}

fn errors(mesh: &Mesh, material: &Isotropic) -> Errors {
    let mut supports = Supports::new(mesh.node_count(), 3);
    for node in mesh.nodes_of_faces(&mesh.boundary_faces()) {
        for (component, value) in displacement(mesh.points[node]).into_iter().enumerate() {
            supports.prescribe(node, component, value).unwrap();
        }
    }
    let u = solve_by_cg(
        mesh,
        material,
        &supports,
        &body_force(mesh, |p| force(material, p)),
    );
    let recovered = stress::recover(mesh, material, Formulation::Full, &u, None);

    let mut sums = [0.0; 3];
    for cell in mesh.iter_cells() {
        let element = cell.kind.element();
        let rule = match cell.kind.linear() {
            CellKind::Tet4 => tetrahedron(6),
            CellKind::Wedge6 => wedge(6, 4),
            _ => gauss_cube(4),
        };
        let n = cell.nodes.len();
        let (mut shape, mut reference) = (vec![0.0; n], vec![[0.0; 3]; n]);
        for (&xi, weight) in rule.points.iter().zip(&rule.weights) {
            element.shape(xi, &mut shape);
            element.gradients(xi, &mut reference);
            let (mut p, mut value, mut tensor) = ([0.0; 3], [0.0; 3], [0.0; 6]);
            let mut jacobian = [[0.0; 3]; 3];
            for (a, &node) in cell.nodes.iter().enumerate() {
                for i in 0..3 {
                    p[i] += shape[a] * mesh.points[node][i];
                    value[i] += shape[a] * u[3 * node + i];
                    for k in 0..3 {
                        jacobian[i][k] += reference[a][k] * mesh.points[node][i];
                    }
                }
                for k in 0..6 {
                    tensor[k] += shape[a] * recovered[node][k];
                }
            }
            let (inverse, determinant) = inverse(&jacobian);
            let volume = weight * determinant;
            let mut e = strain(p).map(|x| -x);
            for (a, &node) in cell.nodes.iter().enumerate() {
                let g: [f64; 3] =
                    std::array::from_fn(|i| (0..3).map(|k| reference[a][k] * inverse[k][i]).sum());
                let v = &u[3 * node..3 * node + 3];
                for i in 0..3 {
                    e[i] += g[i] * v[i];
                }
                e[3] += g[1] * v[0] + g[0] * v[1];
                e[4] += g[2] * v[1] + g[1] * v[2];
                e[5] += g[2] * v[0] + g[0] * v[2];
            }
            let exact = material.stress(strain(p));
            let s = material.stress(e);
            sums[0] += volume
                * (0..3)
                    .map(|i| (value[i] - displacement(p)[i]).powi(2))
                    .sum::<f64>();
            sums[1] += volume * (0..6).map(|k| 0.5 * s[k] * e[k]).sum::<f64>();
            sums[2] += volume * (0..6).map(|k| (tensor[k] - exact[k]).powi(2)).sum::<f64>();
        }
    }
    let largest_stress = mesh
        .points
        .iter()
        .zip(&recovered)
        .flat_map(|(&p, nodal)| {
            let exact = material.stress(strain(p));
            (0..6).map(move |k| (nodal[k] - exact[k]).abs())
        })
        .fold(0.0, f64::max);
    let [displacement, energy, stress] = sums.map(f64::sqrt);
    Errors {
        displacement,
        energy,
        stress,
        largest_stress,
    }
}

/// Inverse and determinant by cofactors.
fn inverse(a: &[[f64; 3]; 3]) -> ([[f64; 3]; 3], f64) {
    let cofactor = |r: usize, c: usize| {
        let (r1, r2, c1, c2) = ((r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3);
        a[r1][c1] * a[r2][c2] - a[r1][c2] * a[r2][c1]
    };
    let determinant = (0..3).map(|c| a[0][c] * cofactor(0, c)).sum();
    (
        std::array::from_fn(|i| std::array::from_fn(|j| cofactor(j, i) / determinant)),
        determinant,
    )
}

/// A family of meshes of n cells along an edge.
#[derive(Clone, Copy, Debug)]
enum Family {
    Regular,
    /// Interior nodes moved, edges straight.
    Irregular,
    /// Bent by a smooth map, all nodes: curved edges of quadratic cells.
    Curved,
}

impl Family {
    fn mesh(self, kind: CellKind, n: usize) -> Mesh {
        let amount = if let Family::Irregular = self {
            0.12
        } else {
            0.0
        };
        let mesh = perturbed_brick([n + 1; 3], amount)
            .with_cells(kind)
            .unwrap();
        let mesh = match self {
            Family::Regular | Family::Irregular => mesh,
            Family::Curved => mesh
                .mapped(|[x, y, z]| {
                    [
                        x + 0.1 * (2.0 * y).sin() * (1.0 + z),
                        y + 0.15 * (x * x - x) * (0.5 + z),
                        z + 0.1 * (1.5 * x + y).cos(),
                    ]
                })
                .unwrap(),
        };
        mesh.check_cells().unwrap();
        mesh
    }
}

/// Prints the errors on meshes of `cells` along an edge, and returns the rates between the last two.
fn rates(kind: CellKind, family: Family, cells: &[usize]) -> [f64; 4] {
    let material = Isotropic::new(1.0, 0.3).unwrap();
    let mut before: Option<(usize, [f64; 4])> = None;
    let mut last = [f64::NAN; 4];
    for &n in cells {
        let e = errors(&family.mesh(kind, n), &material);
        let now = [e.displacement, e.energy, e.stress, e.largest_stress];
        if let Some((coarse, before)) = before {
            let refinement = (n as f64 / coarse as f64).ln();
            last = std::array::from_fn(|k| (before[k] / now[k]).ln() / refinement);
        }
        before = Some((n, now));
        println!(
            "{kind:<7} {:<9} n = {n:<2}  displacement {:.2e} ({:.2})  energy {:.2e} ({:.2})  \
             stress {:.2e} ({:.2})  at nodes {:.2e} ({:.2})",
            format!("{family:?}"),
            now[0],
            last[0],
            now[1],
            last[1],
            now[2],
            last[2],
            now[3],
            last[3]
        );
    }
    last
}

/// Displacement of order p + 1, energy of order p, recovered stress of more than order p + `gain`.
fn check(kind: CellKind, family: Family, cells: &[usize], tolerance: f64, gain: f64) {
    let rates = rates(kind, family, cells);
    let p = kind.order() as f64;
    let [displacement, energy, stress, _] = rates;
    assert!(
        displacement > p + 1.0 - tolerance,
        "{kind} {family:?}: {rates:?}"
    );
    assert!(
        (energy - p).abs() < tolerance,
        "{kind} {family:?}: {rates:?}"
    );
    assert!(stress > p + gain, "{kind} {family:?}: {rates:?}");
}

#[test]
fn rates_on_regular_meshes() {
    check(CellKind::Hex8, Family::Regular, &[4, 8, 16], 0.1, 0.8);
    for kind in [CellKind::Tet4, CellKind::Wedge6] {
        check(kind, Family::Regular, &[4, 8, 12], 0.15, 0.4);
    }
    for kind in [CellKind::Tet10, CellKind::Hex20, CellKind::Hex27] {
        check(kind, Family::Regular, &[2, 4, 6], 0.15, 0.4);
    }
}

#[test]
fn rates_on_irregular_meshes() {
    for kind in [CellKind::Hex8, CellKind::Tet4, CellKind::Wedge6] {
        check(kind, Family::Irregular, &[4, 8, 12], 0.2, 0.3);
    }
    for kind in [CellKind::Tet10, CellKind::Hex20, CellKind::Hex27] {
        check(kind, Family::Irregular, &[2, 4, 6], 0.25, 0.3);
    }
}

#[test]
fn rates_on_curved_meshes() {
    for kind in [CellKind::Tet10, CellKind::Hex20, CellKind::Hex27] {
        check(kind, Family::Curved, &[2, 4, 6], 0.25, 0.3);
    }
}
