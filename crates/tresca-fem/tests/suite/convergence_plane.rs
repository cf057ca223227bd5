//! Rates of convergence on plane and axisymmetric meshes: manufactured solutions, and Lamé's thick
//! cylinder.
//!
//! Errors are those of the displacement (L2, rate p + 1), the energy (square root of the strain energy
//! of the error, rate p) and the recovered stress (L2), with the measure of the space. The recovered
//! stress is of order p + 1 on quadrilaterals; on triangles at least of order p + ½ (see
//! [`stress::recover`]).

use crate::common::{kinds, perturbed_rectangle, solve};
use tresca_fem::assembly::Formulation;
use tresca_fem::loads::{body_force, pressure};
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{CellKind, Mesh, RectangleSpec, Space, rectangle};
use tresca_fem::quadrature::{gauss_square, triangle};
use tresca_fem::stress;
use tresca_fem::supports::Supports;

/// A displacement and its strain xx, yy, zz, γxy, γyz, γxz.
struct Exact<'a> {
    displacement: &'a dyn Fn([f64; 3]) -> [f64; 2],
    strain: &'a dyn Fn([f64; 3]) -> [f64; 6],
}

/// Errors of displacement, energy and recovered stress.
fn errors(mesh: &Mesh, material: &Isotropic, u: &[f64], exact: &Exact<'_>) -> [f64; 3] {
    let recovered = stress::recover(mesh, material, Formulation::Full, u, None);
    let mut sums = [0.0; 3];
    for cell in mesh.iter_cells() {
        let n = cell.nodes.len();
        let element = cell.kind.element();
        let rule = match cell.kind {
            CellKind::Tri3 | CellKind::Tri6 => triangle(8),
            _ => gauss_square(5),
        };
        let (mut shape, mut reference) = (vec![0.0; n], vec![[0.0; 3]; n]);
        for (&xi, weight) in rule.points.iter().zip(&rule.weights) {
            element.shape(xi, &mut shape);
            element.gradients(xi, &mut reference);
            let (mut p, mut value, mut tensor) = ([0.0; 3], [0.0; 2], [0.0; 6]);
            let mut j = [[0.0; 2]; 2];
            for (a, &node) in cell.nodes.iter().enumerate() {
                for i in 0..2 {
                    p[i] += shape[a] * mesh.points[node][i];
                    value[i] += shape[a] * u[2 * node + i];
                    for k in 0..2 {
                        j[k][i] += reference[a][k] * mesh.points[node][i];
                    }
                }
                for k in 0..6 {
                    tensor[k] += shape[a] * recovered[node][k];
                }
            }
            let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
            let mut measure = weight * det;
            let mut e = (exact.strain)(p).map(|x| -x);
            if mesh.space == Space::Axisymmetric {
                measure *= 2.0 * std::f64::consts::PI * p[0];
                e[2] += value[0] / p[0];
            }
            for (a, &node) in cell.nodes.iter().enumerate() {
                let [gx, gy, _] = reference[a];
                let dx = (j[1][1] * gx - j[0][1] * gy) / det;
                let dy = (-j[1][0] * gx + j[0][0] * gy) / det;
                e[0] += dx * u[2 * node];
                e[1] += dy * u[2 * node + 1];
                e[3] += dy * u[2 * node] + dx * u[2 * node + 1];
            }
            let s = material.stress(e);
            let (v, sigma) = ((exact.displacement)(p), material.stress((exact.strain)(p)));
            sums[0] += measure * (0..2).map(|i| (value[i] - v[i]).powi(2)).sum::<f64>();
            sums[1] += measure * (0..6).map(|k| 0.5 * s[k] * e[k]).sum::<f64>();
            sums[2] += measure * (0..6).map(|k| (tensor[k] - sigma[k]).powi(2)).sum::<f64>();
        }
    }
    sums.map(f64::sqrt)
}

/// Checks the rates of errors between meshes of 16 and of 32 cells along an edge (8 and 16 of
/// quadratic ones), and prints them.
fn check_rates(name: &str, cells: CellKind, of: impl Fn(usize) -> [f64; 3]) {
    let p = cells.order();
    let (coarse, fine) = (of(16 / p), of(32 / p));
    let rates: [f64; 3] = std::array::from_fn(|k| (coarse[k] / fine[k]).log2());
    println!(
        "{name:<28} displacement {:.2e} ({:.2})  energy {:.2e} ({:.2})  stress {:.2e} ({:.2})",
        fine[0], rates[0], fine[1], rates[1], fine[2], rates[2]
    );
    let p = p as f64;
    // On rings, where the solution depends on the radius alone, triangles gain.
    assert!(
        (-0.15..0.5).contains(&(rates[0] - p - 1.0)),
        "{name}: {rates:?}"
    );
    assert!((rates[1] - p).abs() < 0.1, "{name}: {rates:?}");
    let simplex = cells.linear() == CellKind::Tri3;
    let gain = if simplex { 0.5 } else { 0.85 };
    assert!(rates[2] > p + gain, "{name}: {rates:?}");
}

/// A smooth displacement in r = x and y. With u_x odd and u_y even in x it is smooth on the axis.
/// u_x = sin(2x) cos(y + 0.3), u_y = cos(1.5x) sin(2y + 0.2).
struct Smooth;

/// Value and derivatives ∂x, ∂y, ∂xx, ∂xy, ∂yy of one component.
type Jet = [f64; 6];

impl Smooth {
    fn jets([x, y, _]: [f64; 3]) -> [Jet; 2] {
        let (s, c) = (2.0 * x).sin_cos();
        let (sy, cy) = (y + 0.3).sin_cos();
        let u = [
            s * cy,
            2.0 * c * cy,
            -s * sy,
            -4.0 * s * cy,
            -2.0 * c * sy,
            -s * cy,
        ];
        let (s, c) = (1.5 * x).sin_cos();
        let (sy, cy) = (2.0 * y + 0.2).sin_cos();
        let v = [
            c * sy,
            -1.5 * s * sy,
            2.0 * c * cy,
            -2.25 * c * sy,
            -3.0 * s * cy,
            -4.0 * c * sy,
        ];
        [u, v]
    }

    fn displacement(p: [f64; 3]) -> [f64; 2] {
        Self::jets(p).map(|jet| jet[0])
    }

    fn strain(space: Space, p: [f64; 3]) -> [f64; 6] {
        let [u, v] = Self::jets(p);
        let hoop = if space == Space::Axisymmetric {
            u[0] / p[0]
        } else {
            0.0
        };
        [u[1], v[2], hoop, u[2] + v[1], 0.0, 0.0]
    }

    /// −div σ = −(λ + μ) ∇ div u − μ Δu (as vectors).
    fn force(space: Space, material: &Isotropic, p: [f64; 3]) -> [f64; 3] {
        let [u, v] = Self::jets(p);
        let mut gradient = [u[3] + v[4], u[4] + v[5]];
        let mut laplacian = [u[3] + u[5], v[3] + v[5]];
        if space == Space::Axisymmetric {
            let r = p[0];
            gradient[0] += u[1] / r - u[0] / (r * r);
            gradient[1] += u[2] / r;
            laplacian[0] += u[1] / r - u[0] / (r * r);
            laplacian[1] += v[1] / r;
        }
        let (lambda, mu) = (material.effective_lambda(), material.mu());
        let [x, y] = [0, 1].map(|i| -(lambda + mu) * gradient[i] - mu * laplacian[i]);
        [x, y, 0.0]
    }
}

fn models() -> [(&'static str, Space, Isotropic); 3] {
    let material = Isotropic::new(1.0, 0.3).unwrap();
    [
        ("plane strain", Space::Plane, material),
        ("plane stress", Space::Plane, material.plane_stress()),
        ("axisymmetric", Space::Axisymmetric, material),
    ]
}

#[test]
fn the_body_force_is_the_divergence_of_the_stress() {
    let p = [0.4, 0.7, 0.0];
    let h = 1e-5;
    for (name, space, material) in models() {
        let stress = |p| material.stress(Smooth::strain(space, p));
        let derivative = |axis: usize, component: usize| {
            let (mut before, mut after) = (p, p);
            before[axis] -= h;
            after[axis] += h;
            (stress(after)[component] - stress(before)[component]) / (2.0 * h)
        };
        let mut divergence = [
            derivative(0, 0) + derivative(1, 3),
            derivative(0, 3) + derivative(1, 1),
        ];
        if space == Space::Axisymmetric {
            let [rr, _, hoop, ry, ..] = stress(p);
            divergence[0] += (rr - hoop) / p[0];
            divergence[1] += ry / p[0];
        }
        let force = Smooth::force(space, &material, p);
        for i in 0..2 {
            assert!((divergence[i] + force[i]).abs() < 1e-8, "{name}");
        }
    }
}

#[test]
fn manufactured_solutions() {
    for (name, space, material) in models() {
        // The axis is part of the body of revolution.
        for (cells, amount) in kinds(2).flat_map(|cells| [(cells, 0.0), (cells, 0.1)]) {
            check_rates(&format!("{name}, {cells}, {amount}"), cells, |n| {
                let mesh = perturbed_rectangle(space, cells, [0.0, 0.0], [n + 1; 2], amount);
                let mut supports = Supports::new(mesh.node_count(), 2);
                for node in mesh.nodes_of_faces(&mesh.boundary_faces()) {
                    let values = Smooth::displacement(mesh.points[node]);
                    for (component, value) in values.into_iter().enumerate() {
                        supports.prescribe(node, component, value).unwrap();
                    }
                }
                let load = body_force(&mesh, |p| Smooth::force(space, &material, p));
                let u = solve(&mesh, &material, &supports, &load);
                let exact = Exact {
                    displacement: &Smooth::displacement,
                    strain: &|p| Smooth::strain(space, p),
                };
                errors(&mesh, &material, &u, &exact)
            });
        }
    }
}

/// Lamé's cylinder 1 ≤ r ≤ 2 under the inner pressure p: with c = p a²/(b² − a²) the radial
/// displacement is u = αr + β/r, β = (1 + ν) c b²/E, and α = (1 + ν)(1 − 2ν) c/E under plane strain,
/// (1 − ν) c/E under plane stress.
struct Lame {
    alpha: f64,
    beta: f64,
}

const YOUNG: f64 = 100.0;
const POISSON: f64 = 0.3;
const PRESSURE: f64 = 3.0;

impl Lame {
    fn new(plane_stress: bool) -> Self {
        let (a, b) = (1.0, 2.0);
        let c = PRESSURE * a * a / (b * b - a * a);
        let nu = POISSON;
        let factor = if plane_stress {
            1.0 - nu
        } else {
            (1.0 + nu) * (1.0 - 2.0 * nu)
        };
        Self {
            alpha: factor * c / YOUNG,
            beta: (1.0 + nu) * c * b * b / YOUNG,
        }
    }

    fn radial(&self, r: f64) -> f64 {
        self.alpha * r + self.beta / r
    }

    /// Strains along and across the radius.
    fn strains(&self, r: f64) -> [f64; 2] {
        let quotient = self.beta / (r * r);
        [self.alpha - quotient, self.alpha + quotient]
    }
}

#[test]
fn lames_stresses_are_those_of_the_textbook() {
    let material = Isotropic::new(YOUNG, POISSON).unwrap();
    for material in [material, material.plane_stress()] {
        for r in [1.0, 1.3, 2.0] {
            let [radial, hoop] = Lame::new(material.is_plane_stress()).strains(r);
            let s = material.stress([radial, hoop, 0.0, 0.0, 0.0, 0.0]);
            let c = PRESSURE / 3.0;
            let zz = if material.is_plane_stress() {
                0.0
            } else {
                2.0 * POISSON * c
            };
            let expected = [c * (1.0 - 4.0 / (r * r)), c * (1.0 + 4.0 / (r * r)), zz];
            assert!((0..3).all(|k| (s[k] - expected[k]).abs() < 1e-13));
        }
    }
}

#[test]
fn lames_cylinder_as_a_quarter_ring() {
    let material = Isotropic::new(YOUNG, POISSON).unwrap();
    for material in [material, material.plane_stress()] {
        for cells in kinds(2) {
            let lame = Lame::new(material.is_plane_stress());
            let exact = Exact {
                displacement: &|[x, y, _]| {
                    let r = x.hypot(y);
                    [x, y].map(|s| lame.radial(r) * s / r)
                },
                strain: &|[x, y, _]| {
                    let r = x.hypot(y);
                    let ([radial, hoop], c, s) = (lame.strains(r), x / r, y / r);
                    [
                        radial * c * c + hoop * s * s,
                        radial * s * s + hoop * c * c,
                        0.0,
                        2.0 * (radial - hoop) * s * c,
                        0.0,
                        0.0,
                    ]
                },
            };
            check_rates(&format!("ring of {cells}"), cells, |n| {
                let mesh = rectangle(&RectangleSpec {
                    space: Space::Plane,
                    min: [1.0, 0.0],
                    max: [2.0, std::f64::consts::FRAC_PI_2],
                    nodes: [n + 1, n + 1],
                    cells: cells.linear(),
                })
                .unwrap()
                .with_cells(cells)
                .unwrap()
                .mapped(|[r, angle, _]| [r * angle.cos(), r * angle.sin(), 0.0])
                .unwrap();
                mesh.check_cells().unwrap();
                let mut supports = Supports::new(mesh.node_count(), 2);
                supports.hold(&mesh.nodes_of_set("y-").unwrap(), 1).unwrap();
                supports.hold(&mesh.nodes_of_set("y+").unwrap(), 0).unwrap();
                let load = pressure(&mesh, mesh.faces_of_set("x-").unwrap(), PRESSURE);
                let u = solve(&mesh, &material, &supports, &load);
                errors(&mesh, &material, &u, &exact)
            });
        }
    }
}

#[test]
fn lames_cylinder_as_a_body_of_revolution() {
    let material = Isotropic::new(YOUNG, POISSON).unwrap();
    let lame = Lame::new(false);
    let exact = Exact {
        displacement: &|[r, _, _]| [lame.radial(r), 0.0],
        strain: &|[r, _, _]| {
            let [radial, hoop] = lame.strains(r);
            [radial, 0.0, hoop, 0.0, 0.0, 0.0]
        },
    };
    for cells in kinds(2) {
        check_rates(&format!("tube of {cells}"), cells, |n| {
            let mesh = rectangle(&RectangleSpec {
                space: Space::Axisymmetric,
                min: [1.0, 0.0],
                max: [2.0, 0.5],
                nodes: [n + 1, n / 2 + 1],
                cells: cells.linear(),
            })
            .unwrap()
            .with_cells(cells)
            .unwrap();
            let mut supports = Supports::new(mesh.node_count(), 2);
            for set in ["y-", "y+"] {
                supports.hold(&mesh.nodes_of_set(set).unwrap(), 1).unwrap();
            }
            let load = pressure(&mesh, mesh.faces_of_set("x-").unwrap(), PRESSURE);
            let u = solve(&mesh, &material, &supports, &load);
            errors(&mesh, &material, &u, &exact)
        });
    }
}
