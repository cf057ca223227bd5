//! Bodies in pieces: a bar split in two, hanging nodes, periodic cells, sectors of a ring.

use super::promises::check;
use crate::common::{by_cholesky, perturbed_brick, side_by_side, solve_constrained};
use std::f64::consts::PI;
use tresca_fem::assembly::{Formulation, internal_forces};
use tresca_fem::constraints::{Dof, Equation, cyclic, periodic, pretension};
use tresca_fem::dofs::DofMap;
use tresca_fem::loads;
use tresca_fem::material::Isotropic;
use tresca_fem::mesh::{BrickSpec, CellKind, Mesh, RectangleSpec, Space, brick, rectangle};
use tresca_fem::stress;
use tresca_fem::supports::Supports;
use tresca_la::vector::dot;
use tresca_testkit::largest;

/// u, and K u − f over the full dofs.
pub fn solve(
    mesh: &Mesh,
    material: &Isotropic,
    (supports, equations): (&Supports, &[Equation]),
    load: &[f64],
) -> (DofMap, Vec<f64>, Vec<f64>) {
    let dofs = DofMap::constrained(supports, equations).unwrap();
    let elastic = (material, Formulation::Full);
    let u = solve_constrained(mesh, elastic, &dofs, &supports.values(), load, by_cholesky);
    let of_mesh = &u[..mesh.dof_count()];
    let mut forces = internal_forces(mesh, material, Formulation::Full, of_mesh, None).unwrap();
    forces.resize(dofs.full_len(), 0.0);
    forces.iter_mut().zip(load).for_each(|(k, f)| *k -= f);
    (dofs, u, forces)
}

/// Equations that give `node` the mean of others, all components.
fn follows(d: usize, node: usize, on: &[(usize, f64)]) -> Vec<Equation> {
    let component = |i| {
        let on = on.iter().map(move |&(other, c)| (Dof::new(other, i), c));
        Equation::dependent(Dof::new(node, i), on)
    };
    (0..d).map(component).collect()
}

#[test]
fn a_bar_split_in_two_and_tied_is_the_whole_bar() {
    let whole = perturbed_brick([4, 4, 7], 0.1);
    let (per_layer, cut) = (16, 3);
    // The cells above the cut get their own copies of the nodes in it.
    let mut split = whole.clone();
    let first_copy = whole.node_count();
    let in_cut = per_layer * cut..per_layer * (cut + 1);
    split
        .points
        .extend_from_slice(&whole.points[in_cut.clone()]);
    for node in &mut split.cells[0].connectivity[9 * cut * 8..] {
        if in_cut.contains(node) {
            *node += first_copy - in_cut.start;
        }
    }
    split.validate().unwrap();
    assert_eq!(split.parts().len(), 2);

    let material = Isotropic::new(210.0, 0.3).unwrap();
    let traction = [0.3, -0.2, 0.5];
    let supports = |mesh: &Mesh| {
        let mut supports = Supports::new(mesh.node_count(), 3);
        supports.clamp(&mesh.nodes_of_set("z-").unwrap()).unwrap();
        // An imposed displacement beside the load.
        for node in mesh.nodes_of_set("x+").unwrap() {
            if mesh.points[node][2] < 0.4 {
                supports
                    .prescribe(
                        node,
                        0,
                        if mesh.points[node][2] == 0.0 {
                            0.0
                        } else {
                            1e-3
                        },
                    )
                    .unwrap();
            }
        }
        supports
    };
    let load = |mesh: &Mesh| loads::traction(mesh, mesh.faces_of_set("z+").unwrap(), traction);
    let (_, expected, of_whole) = solve(&whole, &material, (&supports(&whole), &[]), &load(&whole));
    for upper_follows in [true, false] {
        let pair = |node: usize| {
            let copy = node - in_cut.start + first_copy;
            if upper_follows {
                [copy, node]
            } else {
                [node, copy]
            }
        };
        let ties: Vec<Equation> = in_cut
            .clone()
            .flat_map(|node| {
                let [dependent, on] = pair(node);
                follows(3, dependent, &[(on, 1.0)])
            })
            .collect();
        let held = supports(&split);
        // Dofs in the cut that are held cannot be dependent.
        let held_here = |equation: &Equation| held.at(equation.terms[0].0.full(3)).is_some();
        assert!(!ties.iter().any(held_here));
        let f = load(&split);
        let (dofs, u, forces) = solve(&split, &material, (&held, &ties), &f);
        let scale = largest(&expected);
        for (a, b) in u.iter().zip(&expected) {
            assert!((a - b).abs() < 1e-12 * scale, "{a} against {b}");
        }
        for node in in_cut.clone() {
            let copy = node - in_cut.start + first_copy;
            assert_eq!(u[3 * copy..3 * copy + 3], u[3 * node..3 * node + 3]);
        }
        // The multipliers carry the whole load, and the moment comes with it: what the lower part feels.
        let mu = dofs.multipliers(&forces);
        for i in 0..3 {
            let sum: f64 = mu.iter().skip(i).step_by(3).sum();
            let expected = if upper_follows {
                -traction[i]
            } else {
                traction[i]
            };
            assert!((sum - expected).abs() < 1e-11, "{sum} against {expected}");
        }
        // Reactions of the supports are those of the whole bar.
        let reactions = dofs.support_forces(&forces);
        let whole_dofs = DofMap::new(&supports(&whole));
        let whole_reactions = whole_dofs.support_forces(&of_whole);
        for dof in whole_dofs.prescribed() {
            assert!((reactions[dof] - whole_reactions[dof]).abs() < 1e-11);
        }
        // Work of loads and supports is twice the strain energy.
        let energy = stress::strain_energy(&split, &material, Formulation::Full, &u).unwrap();
        let work = dot(&f, &u) + dot(&reactions, &u);
        assert!((work - 2.0 * energy).abs() < 1e-12 * energy);
    }
}

/// Two bricks that meet in x = 1, the second of finer cells; its nodes there hang in the faces of the first.
#[test]
fn hanging_nodes_pass_the_patch_test() {
    let part = |min: f64, nodes: usize| {
        let spec = BrickSpec {
            min: [min, 0.0, 0.0],
            max: [min + 1.0, 1.0, 1.0],
            nodes: [nodes; 3],
        };
        brick(&spec).unwrap()
    };
    let (coarse, fine) = (part(0.0, 2), part(1.0, 4));
    let mesh = side_by_side(&coarse, &fine);
    let at = |y: f64, z: f64| {
        let place = |node: &usize| mesh.points[*node] == [1.0, y, z];
        (0..8).find(place).unwrap()
    };
    let mut equations = Vec::new();
    for node in mesh.nodes_of_set("second x-").unwrap() {
        let [_, y, z] = mesh.points[node];
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
        let weight = |a: f64, x: f64| if a == 0.0 { 1.0 - x } else { x };
        let on: Vec<_> = corners
            .into_iter()
            .map(|(a, b)| (at(a, b), weight(a, y) * weight(b, z)))
            .collect();
        equations.extend(follows(3, node, &on));
    }
    // Nodes off the boundary, and all that hang, find the linear field by themselves.
    let field = |[x, y, z]: [f64; 3]| {
        [
            0.1 * x + 0.2 * z - 0.3,
            0.4 * y - 0.1 * x,
            0.3 * z + 0.2 * y,
        ]
    };
    let hangs = |node: usize| node >= 8 && mesh.points[node][0] == 1.0;
    let outside = |[x, y, z]: [f64; 3]| x == 0.0 || x == 2.0 || y % 1.0 == 0.0 || z % 1.0 == 0.0;
    let mut supports = Supports::new(mesh.node_count(), 3);
    for node in 0..mesh.node_count() {
        let coarse_seam = node < 8 && mesh.points[node] == [1.0, 1.0, 1.0];
        if outside(mesh.points[node]) && !hangs(node) && !coarse_seam {
            for (i, value) in field(mesh.points[node]).into_iter().enumerate() {
                supports.prescribe(node, i, value).unwrap();
            }
        }
    }
    let material = Isotropic::new(5.0, 0.25).unwrap();
    let load = vec![0.0; mesh.dof_count()];
    // The corner (1, 1, 1) is free of both sides: the loads of the surface there are missing, so hold it.
    for (i, value) in field([1.0; 3]).into_iter().enumerate() {
        supports.prescribe(at(1.0, 1.0), i, value).unwrap();
    }
    let (_, u, _) = solve(&mesh, &material, (&supports, &equations), &load);
    for (node, &point) in mesh.points.iter().enumerate() {
        for (i, expected) in field(point).into_iter().enumerate() {
            assert!((u[3 * node + i] - expected).abs() < 1e-13, "node {node}");
        }
    }
    check(&mesh, &Supports::new(mesh.node_count(), 3), &equations);
}

fn strip(width: f64, nodes: [usize; 2], cells: CellKind) -> Mesh {
    let spec = RectangleSpec {
        space: Space::Plane,
        min: [0.0; 2],
        max: [width, 1.0],
        nodes,
        cells: CellKind::Quad4,
    };
    rectangle(&spec).unwrap().with_cells(cells).unwrap()
}

/// The nodes of two sets that lie at one place after `map` of the second's points.
fn pairs(mesh: &Mesh, sets: [&str; 2], map: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<[usize; 2]> {
    let [first, second] = sets.map(|set| mesh.nodes_of_set(set).unwrap());
    let distance = |a: usize, b: usize| {
        let image = map(mesh.points[b]);
        (0..3)
            .map(|k| (mesh.points[a][k] - image[k]).abs())
            .fold(0.0, f64::max)
    };
    let partner = |&a: &usize| {
        let found = second.iter().find(|&&b| distance(a, b) < 1e-9);
        [a, *found.unwrap()]
    };
    first.iter().map(partner).collect()
}

/// A cell of a strip that repeats itself, under a load off its middle, is a longer piece of the strip under
/// repeated loads; and it does not matter where the strip is cut.
#[test]
fn a_periodic_cell_under_an_eccentric_load() {
    let material = Isotropic::new(7.0, 0.3).unwrap();
    let columns = 6;
    let run = |cells: usize, at: usize| {
        let mesh = strip(
            0.7 * cells as f64,
            [columns * cells + 1, 4],
            CellKind::Quad4,
        );
        let right_left = pairs(&mesh, ["x+", "x-"], |[x, y, z]| {
            [x + 0.7 * cells as f64, y, z]
        });
        let mut supports = Supports::new(mesh.node_count(), 2);
        let bottom = mesh.nodes_of_set("y-").unwrap();
        supports.clamp(&bottom[..bottom.len() - 1]).unwrap();
        // The right end of the bottom follows the left one.
        let equations = periodic(&mesh, &right_left, None).unwrap();
        let top = (columns * cells + 1) * 3;
        let mut load = vec![0.0; mesh.dof_count()];
        for cell in 0..cells {
            let node = top + columns * cell + at;
            (load[2 * node], load[2 * node + 1]) = (0.4, -1.0);
        }
        let (dofs, u, forces) = solve(&mesh, &material, (&supports, &equations), &load);
        // All of the load ends in the supports, of whatever parts equations brought there.
        let reactions = dofs.support_forces(&forces);
        let sum: f64 = reactions.iter().skip(1).step_by(2).sum();
        assert!((sum - cells as f64).abs() < 1e-12);
        move |j: usize, i: usize| {
            let node = (columns * cells + 1) * j + i;
            [u[2 * node], u[2 * node + 1]]
        }
    };
    let (one, three, shifted) = (run(1, 4), run(3, 4), run(1, 1));
    for j in 0..4 {
        for i in 0..=columns {
            let expected = one(j, i);
            for k in 0..2 {
                for cell in 0..3 {
                    assert!((three(j, i + columns * cell)[k] - expected[k]).abs() < 1e-13);
                }
                // Three columns to the left, around the seam.
                let there = shifted(j, (i + columns - 3) % columns)[k];
                assert!((there - expected[k]).abs() < 1e-13);
            }
        }
    }
}

/// The mean strain of a periodic cell as a dof: stretched by a force, and locked.
#[test]
fn a_periodic_cell_is_stretched_by_its_mean_strain() {
    let (young, nu) = (7.0, 0.3);
    let material = Isotropic::new(young, nu).unwrap();
    let mesh = strip(2.0, [5, 4], CellKind::Quad8);
    let amount = mesh.node_count();
    let right_left = pairs(&mesh, ["x+", "x-"], |[x, y, z]| [x + 2.0, y, z]);
    let stretch = [vec![Dof::new(amount, 0), Dof::new(amount, 1)]];
    let equations = periodic(&mesh, &right_left, Some(&stretch)).unwrap();
    let mut supports = Supports::new(mesh.node_count() + 1, 2);
    supports.clamp(&[0]).unwrap();
    supports.prescribe(amount, 1, 0.0).unwrap();
    // Σ of the tractions times the length of the cell: σ_xx |cell|.
    let mut load = vec![0.0; 2 * (amount + 1)];
    load[2 * amount] = 3.0 * 2.0;
    let (_, u, _) = solve(&mesh, &material, (&supports, &equations), &load);
    let expected = 3.0 * (1.0 - nu * nu) / young;
    assert!((u[2 * amount] - expected).abs() < 1e-13);
    let stresses = stress::recover(
        &mesh,
        &material,
        Formulation::Full,
        &u[..mesh.dof_count()],
        None,
    );
    for s in stresses {
        assert!((s[0] - 3.0).abs() < 1e-11 && s[1].abs() < 1e-11);
    }
    // Locked at that stretch, it takes that force, and the equations hand it on to the support.
    supports.prescribe(amount, 0, expected).unwrap();
    load[2 * amount] = 0.0;
    let (dofs, _, forces) = solve(&mesh, &material, (&supports, &equations), &load);
    assert!((dofs.support_forces(&forces)[2 * amount] - 6.0).abs() < 1e-11);
    check(&mesh, &supports, &equations);
}

/// A sector of a ring of inner radius 1 and outer radius 2, of `count` in the full circle.
fn sector(count: usize, nodes: [usize; 2], kind: CellKind) -> Mesh {
    let angle = 2.0 * PI / count as f64;
    let spec = RectangleSpec {
        space: Space::Plane,
        min: [1.0, 0.0],
        max: [2.0, angle],
        nodes,
        cells: CellKind::Quad4,
    };
    let flat = rectangle(&spec).unwrap().with_cells(kind).unwrap();
    flat.mapped(|[r, phi, _]| [r * phi.cos(), r * phi.sin(), 0.0])
        .unwrap()
}

fn turned([x, y, z]: [f64; 3], angle: f64) -> [f64; 3] {
    let (s, c) = angle.sin_cos();
    [c * x - s * y, s * x + c * y, z]
}

#[test]
fn a_cyclic_sector_is_the_full_ring() {
    const COUNT: usize = 8;
    let angle = 2.0 * PI / COUNT as f64;
    let material = Isotropic::new(100.0, 0.3).unwrap();
    let mesh = sector(COUNT, [4, 4], CellKind::Quad8);
    // The full ring: turned copies whose nodes on the seams are one.
    let mut ring = Mesh {
        points: Vec::new(),
        cells: vec![mesh.cells[0].clone()],
        ..mesh.clone()
    };
    ring.face_sets.clear();
    ring.cells[0].connectivity.clear();
    let mut number = vec![[0; COUNT]; mesh.node_count()];
    for copy in 0..COUNT {
        for (node, &point) in mesh.points.iter().enumerate() {
            let point = turned(point, angle * copy as f64);
            let near = |other: &[f64; 3]| (0..2).all(|k| (point[k] - other[k]).abs() < 1e-9);
            number[node][copy] = ring.points.iter().position(near).unwrap_or_else(|| {
                ring.points.push(point);
                ring.points.len() - 1
            });
        }
        let connectivity = mesh.cells[0].connectivity.iter();
        let moved = connectivity.map(|&node| number[node][copy]);
        ring.cells[0].connectivity.extend(moved);
    }
    ring.validate().unwrap();
    assert_eq!(ring.parts().len(), 1);

    // A pressure that changes along the sector, without a torque, and a turning held at one point.
    let inner = mesh.faces_of_set("x-").unwrap();
    let load = loads::pressure_field(&mesh, inner, |[x, y, _]| {
        1.0 + (COUNT as f64 * y.atan2(x)).cos()
    });
    let mut repeated = vec![0.0; ring.dof_count()];
    for (node, copies) in number.iter().enumerate() {
        for (copy, &there) in copies.iter().enumerate() {
            let force = turned(
                [load[2 * node], load[2 * node + 1], 0.0],
                angle * copy as f64,
            );
            repeated[2 * there] += force[0];
            repeated[2 * there + 1] += force[1];
        }
    }
    let on_outer_start = (0..mesh.node_count())
        .find(|&n| mesh.points[n] == [2.0, 0.0, 0.0])
        .unwrap();
    let mut held = Supports::new(mesh.node_count(), 2);
    held.prescribe(on_outer_start, 1, 0.0).unwrap();
    let faces = pairs(&mesh, ["y+", "y-"], |point| turned(point, angle));
    let ties = cyclic(&mesh, &faces, [[0.0; 3], [0.0, 0.0, 3.0]], angle).unwrap();
    let (_, u, _) = solve(&mesh, &material, (&held, &ties), &load);

    let mut held_ring = Supports::new(ring.node_count(), 2);
    for (copy, component) in [(0, 1), (2, 0), (4, 1)] {
        held_ring
            .prescribe(number[on_outer_start][copy], component, 0.0)
            .unwrap();
    }
    let (_, of_ring, _) = solve(&ring, &material, (&held_ring, &[]), &repeated);
    let scale = largest(&of_ring);
    for (node, copies) in number.iter().enumerate() {
        for (copy, &there) in copies.iter().enumerate() {
            let expected = turned([u[2 * node], u[2 * node + 1], 0.0], angle * copy as f64);
            for k in 0..2 {
                assert!((of_ring[2 * there + k] - expected[k]).abs() < 1e-11 * scale);
            }
        }
    }
    check(&mesh, &held, &ties);
    check(&mesh, &Supports::new(mesh.node_count(), 2), &ties);
}

/// Lamé: u_r = (1 + ν)/E · p a²/(b² − a²) · ((1 − 2ν) r + b²/r) under the pressure p inside (plane strain),
/// for a sector whose angle is no part of the circle that a mesh could close.
#[test]
fn a_cyclic_sector_under_pressure_is_lames_ring() {
    let (young, nu) = (100.0, 0.3);
    let material = Isotropic::new(young, nu).unwrap();
    let mut errors = Vec::new();
    for n in [3, 5, 9] {
        let mesh = sector(7, [n, n], CellKind::Quad8);
        let angle = 2.0 * PI / 7.0;
        let faces = pairs(&mesh, ["y+", "y-"], |point| turned(point, angle));
        let ties = cyclic(&mesh, &faces, [[0.0; 3], [0.0, 0.0, 1.0]], angle).unwrap();
        let mut held = Supports::new(mesh.node_count(), 2);
        held.prescribe(0, 1, 0.0).unwrap();
        let load = loads::pressure(&mesh, mesh.faces_of_set("x-").unwrap(), 2.0);
        let (_, u, _) = solve(&mesh, &material, (&held, &ties), &load);
        let mut worst = 0.0_f64;
        for (node, &[x, y, _]) in mesh.points.iter().enumerate() {
            let r = x.hypot(y);
            let radial = (1.0 + nu) / young * 2.0 / 3.0 * ((1.0 - 2.0 * nu) * r + 4.0 / r);
            let error = (u[2 * node] - radial * x / r).hypot(u[2 * node + 1] - radial * y / r);
            worst = worst.max(error / radial);
        }
        errors.push(worst);
    }
    assert!(errors[2] < 1e-5, "{errors:?}");
    assert!(
        errors[0] / errors[1] > 10.0 && errors[1] / errors[2] > 10.0,
        "{errors:?}"
    );
}

#[test]
fn a_node_on_the_axis_moves_along_it() {
    let mesh = perturbed_brick([3, 3, 3], 0.0);
    let axis = [1.0, 2.0, -3.0];
    let ties = cyclic(&mesh, &[[13, 13]], [mesh.points[13], axis], 0.7).unwrap();
    let dofs = check(&mesh, &Supports::new(mesh.node_count(), 3), &ties);
    let u = dofs.expand(&vec![1.0; dofs.free_len()]);
    let [a, b, c] = [u[39], u[40], u[41]];
    assert!((a * axis[1] - b * axis[0]).abs() < 1e-14 && (b * axis[2] - c * axis[1]).abs() < 1e-14);
    let error = cyclic(&mesh, &[[0, 13]], [[0.0; 3], axis], 0.7).unwrap_err();
    assert!(error.to_string().starts_with("node 0 lies "), "{error}");
    assert!(cyclic(&mesh, &[[0, 0]], [[0.0; 3], [0.0; 3]], 0.7).is_err());
    assert!(periodic(&mesh, &[[0, 13], [1, 12]], None).is_err());
}

/// A bolt between two walls, cut in the middle: shortened by p it pulls with E A p / L.
#[test]
fn a_bolt_is_pretensioned_by_length_and_by_force() {
    let (young, length) = (30.0, 4.0);
    // Without lateral contraction walls do not disturb.
    let material = Isotropic::new(young, 0.0).unwrap();
    let half = |min: f64| {
        let spec = BrickSpec {
            min: [0.0, 0.0, min],
            max: [0.5, 0.5, min + 2.0],
            nodes: [2, 2, 4],
        };
        brick(&spec).unwrap()
    };
    let mesh = side_by_side(&half(0.0), &half(2.0));
    let amount = Dof::new(mesh.node_count(), 0);
    let cut = pairs(&mesh, ["second z-", "z+"], |point| point);
    let equations = pretension(&mesh, &cut, [0.0, 0.0, 0.1], amount).unwrap();
    let mut supports = Supports::new(mesh.node_count() + 1, 3);
    for wall in ["z-", "second z+"] {
        supports.clamp(&mesh.nodes_of_set(wall).unwrap()).unwrap();
    }
    supports.hold(&[amount.node], 1).unwrap();
    supports.hold(&[amount.node], 2).unwrap();
    let at = amount.full(3);
    let force = 1.7;
    let mut load = vec![0.0; 3 * (mesh.node_count() + 1)];
    load[at] = force;
    let (_, u, _) = solve(&mesh, &material, (&supports, &equations), &load);
    let shortening = force * length / (young * 0.25);
    assert!((u[at] - shortening).abs() < 1e-13);
    let stresses = stress::recover(
        &mesh,
        &material,
        Formulation::Full,
        &u[..mesh.dof_count()],
        None,
    );
    assert!(stresses.iter().all(|s| (s[2] - force / 0.25).abs() < 1e-11));

    supports.prescribe(amount.node, 0, shortening).unwrap();
    let load = vec![0.0; load.len()];
    let (dofs, locked, forces) = solve(&mesh, &material, (&supports, &equations), &load);
    assert!((dofs.support_forces(&forces)[at] - force).abs() < 1e-12);
    assert!(u.iter().zip(&locked).all(|(a, b)| (a - b).abs() < 1e-13));
    check(&mesh, &supports, &equations);
}
