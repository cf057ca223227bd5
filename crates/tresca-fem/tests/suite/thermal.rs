//! Initial strains: free expansion, held bodies, bimetal, a tube that is warm inside.

use crate::common::{by_cholesky, kinds, perturbed_brick, perturbed_rectangle, solve_constrained};
use tresca_fem::assembly::{Formulation, initial_strain_load, internal_forces};
use tresca_fem::dofs::DofMap;
use tresca_fem::initial_strain::InitialStrain;
use tresca_fem::loads::resultant;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, RectangleSpec, Space, brick, rectangle};
use tresca_fem::stress;
use tresca_fem::supports::Supports;
use tresca_la::vector::norm;

const ALPHA: f64 = 1.2e-3;

fn formulations(kind: CellKind, material: &Isotropic) -> Vec<Formulation> {
    let linear = matches!(kind, CellKind::Hex8 | CellKind::Wedge6 | CellKind::Quad4);
    let b_bar = linear && !material.is_plane_stress();
    let all = [Some(Formulation::Full), b_bar.then_some(Formulation::BBar)];
    all.into_iter().flatten().collect()
}

/// u and the recovered stresses.
fn solve(
    mesh: &Mesh,
    (material, formulation): (&Isotropic, Formulation),
    supports: &Supports,
    initial: &InitialStrain,
) -> (Vec<f64>, Vec<[f64; 6]>) {
    let load = initial_strain_load(mesh, material, formulation, initial).unwrap();
    let (dofs, values) = (DofMap::new(supports), supports.values());
    let elastic = (material, formulation);
    let u = solve_constrained(mesh, elastic, &dofs, &values, &load, by_cholesky);
    // What is left at free dofs is rounding; K u is the internal forces and the load together.
    let forces = internal_forces(mesh, material, formulation, &u, Some(initial)).unwrap();
    let without = internal_forces(mesh, material, formulation, &u, None).unwrap();
    let scale = norm(&load).max(1e-300);
    for ((with, without), load) in forces.iter().zip(&without).zip(&load) {
        assert!((with - (without - load)).abs() < 1e-11 * scale);
    }
    assert!(norm(&dofs.restrict(&forces)) < 1e-10 * scale);
    let stresses = stress::recover(mesh, material, formulation, &u, Some(initial));
    for sample in stress::samples(mesh, material, formulation, &u, Some(initial)) {
        assert!(sample.stress.iter().all(|s| s.is_finite()));
    }
    (u, stresses)
}

/// Supports that take the rigid motions alone.
fn isostatic(mesh: &Mesh) -> Supports {
    let d = mesh.dimension();
    let at = |point: [f64; 2], z: f64| {
        let place = |p: &[f64; 3]| p[0] == point[0] && p[1] == point[1] && p[2] == z;
        mesh.points.iter().position(place).unwrap()
    };
    let x = mesh.bounding_box().min[0];
    let mut supports = Supports::new(mesh.node_count(), d);
    let origin = at([x, 0.0], 0.0);
    match mesh.space {
        Space::Axisymmetric => supports.prescribe(origin, 1, 0.0).unwrap(),
        Space::Plane => {
            supports.clamp(&[origin]).unwrap();
            supports.prescribe(at([x + 1.0, 0.0], 0.0), 1, 0.0).unwrap();
        }
        Space::Solid => {
            supports.clamp(&[origin]).unwrap();
            supports.hold(&[at([x + 1.0, 0.0], 0.0)], 1).unwrap();
            supports
                .hold(&[at([x + 1.0, 0.0], 0.0), at([x, 1.0], 0.0)], 2)
                .unwrap();
        }
    }
    supports
}

#[test]
fn free_expansion_is_free_of_stress() {
    let material = Isotropic::new(200.0, 0.3).unwrap();
    // A temperature that is linear along y bends the body and leaves it without stress, too; undistorted
    // quadratic cells can represent that.
    let mut bodies: Vec<(Mesh, Isotropic, f64)> = Vec::new();
    for kind in kinds(3).chain(kinds(2)) {
        let bent = (kind.order() == 2).then_some((0.0, 7.0));
        for (distortion, slope) in [Some((0.1, 0.0)), bent].into_iter().flatten() {
            if kind.dimension() == 3 {
                let mesh = perturbed_brick([3, 3, 4], distortion);
                bodies.push((mesh.with_cells(kind).unwrap(), material, slope));
                continue;
            }
            let of = |space, x| perturbed_rectangle(space, kind, [x, 0.0], [4, 3], distortion);
            bodies.push((of(Space::Plane, 0.0), material.plane_stress(), slope));
            bodies.push((of(Space::Axisymmetric, 1.0), material, slope));
        }
    }
    for (mesh, material, slope) in &bodies {
        let kind = mesh.cells[0].kind;
        let temperature = mesh.points.iter().map(|p| 30.0 + slope * p[1]);
        let initial = InitialStrain::thermal(mesh, ALPHA, temperature.collect()).unwrap();
        for formulation in formulations(kind, material) {
            let elastic = (material, formulation);
            let (u, stresses) = solve(mesh, elastic, &isostatic(mesh), &initial);
            let hindered = material.young() * ALPHA * 30.0;
            for s in stresses {
                let largest = s.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
                assert!(largest < 1e-11 * hindered, "{kind} {:?}: {s:?}", mesh.space);
            }
            // The point opposite to the one held.
            let left = mesh.bounding_box().min[0];
            let mut points = mesh.points.iter();
            let top = points.position(|p| *p == [left, 1.0, 0.0]).unwrap();
            let expected = ALPHA * (30.0 + 0.5 * slope);
            let found = u[mesh.dimension() * top + 1];
            assert!((found - expected).abs() < 1e-11, "{kind}: {found}");
        }
    }
}

/// By node, by cell and as a temperature: the same.
#[test]
fn the_ways_to_give_a_strain_agree() {
    let mesh = perturbed_brick([3, 3, 3], 0.1);
    let material = Isotropic::new(2.0, 0.25).unwrap();
    let strain = [0.03, 0.03, 0.03, 0.0, 0.0, 0.0];
    let all = [
        InitialStrain::thermal(&mesh, 1e-3, vec![30.0; mesh.node_count()]).unwrap(),
        InitialStrain::at_nodes(&mesh, vec![strain; mesh.node_count()]).unwrap(),
        InitialStrain::in_cells(&mesh, vec![strain; mesh.cell_count()]).unwrap(),
    ];
    let load = |initial: &InitialStrain| {
        initial_strain_load(&mesh, &material, Formulation::BBar, initial).unwrap()
    };
    let expected = load(&all[0]);
    for initial in &all[1..] {
        for (a, b) in load(initial).iter().zip(&expected) {
            assert!((a - b).abs() < 1e-14);
        }
    }
}

/// A bar between walls: σ = −E α ΔT, and the walls take it.
#[test]
fn a_bar_between_walls_is_pressed() {
    let (young, change) = (200.0, 50.0);
    let material = Isotropic::new(young, 0.3).unwrap();
    for kind in kinds(3) {
        let spec = BrickSpec {
            min: [0.0; 3],
            max: [3.0, 0.5, 0.5],
            nodes: [4, 3, 3],
        };
        let mesh = brick(&spec).unwrap().with_cells(kind).unwrap();
        let mut supports = Supports::new(mesh.node_count(), 3);
        for (set, component) in [("x-", 0), ("x+", 0), ("y-", 1), ("z-", 2)] {
            supports
                .hold(&mesh.nodes_of_set(set).unwrap(), component)
                .unwrap();
        }
        let temperature = vec![change; mesh.node_count()];
        let initial = InitialStrain::thermal(&mesh, ALPHA, temperature).unwrap();
        for formulation in formulations(kind, &material) {
            let elastic = (&material, formulation);
            let (u, stresses) = solve(&mesh, elastic, &supports, &initial);
            let expected = -young * ALPHA * change;
            for s in stresses {
                assert!(
                    (s[0] - expected).abs() < 1e-11 * expected.abs(),
                    "{kind}: {s:?}"
                );
                assert!(
                    s[1..].iter().all(|s| s.abs() < 1e-11 * expected.abs()),
                    "{kind}"
                );
            }
            let forces =
                internal_forces(&mesh, &material, formulation, &u, Some(&initial)).unwrap();
            let mut on_wall = vec![0.0; forces.len()];
            for node in mesh.nodes_of_set("x+").unwrap() {
                on_wall[3 * node] = forces[3 * node];
            }
            let force = resultant(&mesh, &on_wall, [0.0; 3]).force[0];
            assert!((force - expected * 0.25).abs() < 1e-11 * expected.abs());
        }
    }
}

/// Free in the plane, held across it: u = (1 + ν) α ΔT x, σ_zz = −E α ΔT.
#[test]
fn plane_strain_holds_the_thickness() {
    let (young, nu, change) = (200.0, 0.3, 20.0);
    let material = Isotropic::new(young, nu).unwrap();
    for kind in kinds(2) {
        let mesh = perturbed_rectangle(Space::Plane, kind, [0.0, 0.0], [4, 4], 0.1);
        let initial =
            InitialStrain::thermal(&mesh, ALPHA, vec![change; mesh.node_count()]).unwrap();
        for formulation in formulations(kind, &material) {
            let (u, stresses) = solve(&mesh, (&material, formulation), &isostatic(&mesh), &initial);
            for (node, p) in mesh.points.iter().enumerate() {
                for i in 0..2 {
                    let expected = (1.0 + nu) * ALPHA * change * p[i];
                    assert!((u[2 * node + i] - expected).abs() < 1e-13);
                }
            }
            let across = -young * ALPHA * change;
            for s in stresses {
                assert!(
                    (s[2] - across).abs() < 1e-11 * across.abs(),
                    "{kind}: {s:?}"
                );
                assert!(
                    [s[0], s[1], s[3]]
                        .iter()
                        .all(|s| s.abs() < 1e-11 * across.abs())
                );
            }
        }
    }
}

/// Timoshenko, *Analysis of bi-metal thermostats* (1925): the curvature of a strip of two layers that expand
/// differently, here of one modulus and of the thicknesses t₁ = m t₂.
#[test]
fn a_bimetal_strip_bends() {
    let material = Isotropic::new(70.0, 0.33).unwrap().plane_stress();
    let (length, height, change) = (12.0, 1.0, 40.0);
    let alphas = [ALPHA, 0.25 * ALPHA];
    for (rows_below, m) in [(2, 1.0), (1, 1.0 / 3.0)] {
        for kind in [CellKind::Quad8, CellKind::Quad9, CellKind::Tri6] {
            let spec = RectangleSpec {
                space: Space::Plane,
                min: [0.0; 2],
                max: [length, height],
                nodes: [25, 5],
                cells: CellKind::Quad4,
            };
            let mesh = rectangle(&spec).unwrap();
            let mesh = if kind == CellKind::Tri6 {
                let spec = RectangleSpec {
                    cells: CellKind::Tri3,
                    ..spec
                };
                rectangle(&spec).unwrap().with_cells(kind).unwrap()
            } else {
                mesh.with_cells(kind).unwrap()
            };
            let seam = 0.25 * height * f64::from(rows_below);
            let strains = mesh.iter_cells().map(|cell| {
                let centre: f64 = cell.nodes.iter().map(|&n| mesh.points[n][1]).sum();
                let below = centre / (cell.nodes.len() as f64) < seam;
                let strain = change * alphas[usize::from(!below)];
                [strain, strain, strain, 0.0, 0.0, 0.0]
            });
            let initial = InitialStrain::in_cells(&mesh, strains.collect()).unwrap();
            let mut supports = Supports::new(mesh.node_count(), 2);
            let at = |x: f64, y: f64| {
                let near = |p: &[f64; 3]| (p[0] - x).abs() + (p[1] - y).abs() < 1e-9;
                mesh.points.iter().position(near).unwrap()
            };
            supports.clamp(&[at(0.0, 0.0)]).unwrap();
            supports.prescribe(at(length, 0.0), 1, 0.0).unwrap();
            let (u, _) = solve(&mesh, (&material, Formulation::Full), &supports, &initial);
            // Second difference in the middle, far from the ends, of the bottom line.
            let v = |x: f64| u[2 * at(x, 0.0) + 1];
            let curvature = v(5.0) - 2.0 * v(6.0) + v(7.0);
            let squared = (1.0 + m) * (1.0 + m);
            let expected = 6.0 * (alphas[0] - alphas[1]) * change * squared
                / (height * (3.0 * squared + (1.0 + m) * (m * m + 1.0 / m)));
            let error = (curvature / expected - 1.0).abs();
            assert!(
                error < 1e-6,
                "{kind}, m = {m}: {curvature} against {expected}"
            );
        }
    }
}

/// A long tube, T = ΔT (r − a)/(b − a), held along its axis (Timoshenko, Goodier: *Theory of Elasticity*, § 151).
#[test]
fn a_tube_that_is_warm_outside() {
    let (young, nu, change, a, b) = (200.0, 0.3, 30.0, 1.0, 2.0);
    let material = Isotropic::new(young, nu).unwrap();
    let slope = change / (b - a);
    // ∫_a^r T r dr.
    let integral = |r: f64| slope * ((r.powi(3) - a * a * a) / 3.0 - a * (r * r - a * a) / 2.0);
    let factor = ALPHA * young / (1.0 - nu);
    let whole = integral(b) / (b * b - a * a);
    let mut errors = Vec::new();
    for n in [5, 9, 17] {
        let spec = RectangleSpec {
            space: Space::Axisymmetric,
            min: [a, 0.0],
            max: [b, 0.5],
            nodes: [n, 3],
            cells: CellKind::Quad4,
        };
        let mesh = rectangle(&spec)
            .unwrap()
            .with_cells(CellKind::Quad8)
            .unwrap();
        let temperature = mesh.points.iter().map(|p| slope * (p[0] - a)).collect();
        let initial = InitialStrain::thermal(&mesh, ALPHA, temperature).unwrap();
        let mut supports = Supports::new(mesh.node_count(), 2);
        supports
            .hold(&(0..mesh.node_count()).collect::<Vec<_>>(), 1)
            .unwrap();
        let (_, stresses) = solve(&mesh, (&material, Formulation::Full), &supports, &initial);
        let mut worst = 0.0_f64;
        for (s, p) in stresses.iter().zip(&mesh.points) {
            let (r, t) = (p[0], slope * (p[0] - a));
            let expected = [
                factor / (r * r) * ((r * r - a * a) * whole - integral(r)),
                factor * (2.0 * nu * whole - t),
                factor / (r * r) * ((r * r + a * a) * whole + integral(r) - t * r * r),
            ];
            for k in 0..3 {
                worst = worst.max((s[k] - expected[k]).abs() / (factor * change));
            }
        }
        errors.push(worst);
    }
    assert!(errors[2] < 2e-4, "{errors:?}");
    assert!(errors.windows(2).all(|e| e[0] > 5.0 * e[1]), "{errors:?}");
}

/// Held altogether, a cell with B-bar strains has one pressure, −3 κ α T̄, however T varies in it.
#[test]
fn b_bar_cells_see_the_mean_of_a_temperature() {
    let material = Isotropic::new(1.0, 0.499).unwrap();
    let mesh = perturbed_brick([2, 2, 3], 0.0);
    let temperature = |p: [f64; 3]| 5.0 + 3.0 * p[2] - p[0] * p[1];
    let values = mesh.points.iter().map(|&p| temperature(p)).collect();
    let initial = InitialStrain::thermal(&mesh, ALPHA, values).unwrap();
    let u = vec![0.0; mesh.dof_count()];
    let bulk = material.lambda() + 2.0 * material.mu() / 3.0;
    for sample in stress::samples(&mesh, &material, Formulation::BBar, &u, Some(&initial)) {
        let mean = if sample.cell == 0 {
            5.0 + 0.75
        } else {
            5.0 + 2.25
        } - 0.25;
        let expected = -3.0 * bulk * ALPHA * mean;
        let pressure = (sample.stress[0] + sample.stress[1] + sample.stress[2]) / 3.0;
        assert!((pressure - expected).abs() < 1e-12 * expected.abs());
    }
    // One pressure per cell pushes on the faces alone, each node of one by a quarter.
    let load = initial_strain_load(&mesh, &material, Formulation::BBar, &initial).unwrap();
    let up: Vec<f64> = mesh
        .nodes_of_set("z+")
        .unwrap()
        .iter()
        .map(|&n| load[3 * n + 2])
        .collect();
    let expected = 3.0 * bulk * ALPHA * 7.0 / 4.0;
    assert!(
        up.iter().all(|f| (f - expected).abs() < 1e-12 * expected),
        "{up:?}"
    );
}
