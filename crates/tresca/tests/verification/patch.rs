//! The contact patch test: a constant pressure crosses an interface between meshes that know nothing of
//! each other, whatever their cells.

use tresca::material::Isotropic;
use tresca::mesh::{BrickSpec, CellKind, Mesh, RectangleSpec, Space, brick, rectangle};
use tresca::model::{ContactSpec, LoadKind};
use tresca::{
    CouplingMethod, FrictionLaw, Model, Outcome, Run, ScalarField, Settings, Silent, SurfaceRef,
};

use super::support::report;

const PRESSURE: f64 = 3.0;

/// A block with uneven inner nodes, so that nothing is symmetric by chance.
fn block(kind: CellKind, min: [f64; 3], max: [f64; 3], nodes: [usize; 3]) -> Mesh {
    let mesh = brick(&BrickSpec { min, max, nodes }).unwrap();
    let inside = |x: f64, k: usize| (x - min[k]) * (max[k] - x);
    let uneven = mesh.mapped(|[x, y, z]| {
        let bump = 0.15 * inside(x, 0) * inside(y, 1);
        [x + bump * (y - 0.3), y - 0.8 * bump * (x - 0.6), z]
    });
    // Quadratic cells with straight edges: of curved ones no rule integrates a constant stress exactly.
    uneven.unwrap().with_cells(kind).unwrap()
}

/// Two blocks, pressed together between rollers; `slope` inclines the interface.
fn blocks(upper: Cells, lower: Cells, slope: f64, law: FrictionLaw) -> Model {
    let face = |body, faces| SurfaceRef { body, faces };
    let steel = Isotropic::new(2.1e5, 0.3).unwrap();
    // Straight sides stay straight, the interface becomes a plane across the column.
    let tilt = |mesh: Mesh, far: f64| {
        mesh.mapped(|[x, y, z]| {
            let near = (z - far) / (1.0 - far);
            [x, y, z + near * slope * (x - 0.5 + 0.4 * y)]
        })
        .unwrap()
    };
    let mut model = Model::new("patch test");
    let top = block(upper.0, [0.0, 0.0, 1.0], [1.2, 1.0, 2.0], upper.1);
    let bottom = block(lower.0, [0.0, 0.0, 0.0], [1.2, 1.0, 1.0], lower.1);
    model.add_body("upper", tilt(top, 2.0), steel).unwrap();
    model.add_body("lower", tilt(bottom, 0.0), steel).unwrap();
    let roller = |axis: usize| std::array::from_fn(|k| (k == axis).then_some(0.0));
    for body in ["upper", "lower"] {
        model.support(None, &[face(body, "x-")], roller(0)).unwrap();
        model.support(None, &[face(body, "y-")], roller(1)).unwrap();
    }
    model
        .support(None, &[face("lower", "z-")], roller(2))
        .unwrap();
    let on = vec![model.resolve(face("upper", "z+")).unwrap()];
    let value = ScalarField::Constant(PRESSURE);
    model
        .add_load(None, LoadKind::Pressure { on, value })
        .unwrap();
    let contact = ContactSpec {
        coupling: CouplingMethod::Mortar,
        ..ContactSpec::new(face("upper", "z-"), face("lower", "z+"), law)
    };
    model.add_contact_as(contact).unwrap();
    model
}

fn solved(model: &Model) -> Outcome {
    let settings = Settings {
        tolerance: 1e-14,
        ..Settings::default()
    };
    match tresca::solve(model, &settings, &mut Silent).unwrap() {
        Run::Finished(outcome) => *outcome,
        Run::Stopped(_) => unreachable!("nobody stops this run"),
    }
}

/// The largest relative deviation of a pair's traction from that of the uniaxial state.
fn deviation(outcome: &Outcome, slope: f64) -> f64 {
    let steepness = slope * slope * (1.0 + 0.4 * 0.4);
    let deviations = outcome.last().pairs().map(|pair| {
        // On a roller the pair's normal is laid along what is free, the surface's is the same everywhere.
        let normal = pair.pair.frame.normal;
        // σ n of σ = −p e_z e_z, as the force of the slave on the master.
        let expected = [0.0, 0.0, -PRESSURE / (1.0 + steepness).sqrt()];
        let friction = pair.friction_traction();
        let off: [f64; 3] =
            std::array::from_fn(|k| pair.pressure() * normal[k] + friction[k] - expected[k]);
        off.iter().map(|x| x * x).sum::<f64>().sqrt() / PRESSURE
    });
    deviations.fold(0.0, f64::max)
}

/// Cells, and the nodes of the brick that they are made of.
type Cells = (CellKind, [usize; 3]);

const MIXTURES: [(Cells, Cells); 9] = [
    ((CellKind::Hex8, [4, 5, 3]), (CellKind::Hex8, [6, 4, 3])),
    ((CellKind::Tet4, [4, 4, 3]), (CellKind::Hex8, [5, 6, 3])),
    ((CellKind::Hex8, [6, 5, 3]), (CellKind::Tet4, [4, 4, 3])),
    ((CellKind::Tet4, [3, 4, 3]), (CellKind::Tet4, [5, 4, 3])),
    ((CellKind::Wedge6, [4, 3, 3]), (CellKind::Tet4, [5, 5, 3])),
    ((CellKind::Tet10, [3, 3, 2]), (CellKind::Hex8, [5, 4, 3])),
    ((CellKind::Hex20, [3, 3, 2]), (CellKind::Tet10, [4, 3, 2])),
    ((CellKind::Hex27, [3, 2, 2]), (CellKind::Hex20, [4, 3, 2])),
    ((CellKind::Tet10, [4, 3, 2]), (CellKind::Hex27, [3, 3, 2])),
];

#[test]
fn a_constant_pressure_crosses_a_flat_interface() {
    for (upper, lower) in MIXTURES {
        let outcome = solved(&blocks(upper, lower, 0.0, FrictionLaw::Frictionless));
        let error = deviation(&outcome, 0.0);
        report(&format!(
            "patch test, {} on {}: {error:.1e}",
            upper.0, lower.0
        ));
        assert!(error < 1e-10, "{} on {}: {error:e}", upper.0, lower.0);
    }
}

#[test]
fn a_constant_traction_crosses_an_inclined_interface() {
    for (upper, lower) in MIXTURES {
        let outcome = solved(&blocks(upper, lower, 0.2, FrictionLaw::tresca(1e3)));
        let error = deviation(&outcome, 0.2);
        report(&format!(
            "patch test, inclined, {} on {}: {error:.1e}",
            upper.0, lower.0
        ));
        // Sticking pairs have the worse condition: what rounding leaves is three times larger.
        assert!(error < 3e-10, "{} on {}: {error:e}", upper.0, lower.0);
    }
}

#[test]
fn a_constant_pressure_crosses_an_interface_in_the_plane() {
    use CellKind::{Quad4, Quad8, Quad9, Tri3, Tri6};
    for space in [Space::Plane, Space::Axisymmetric] {
        for (above, below) in [
            (Quad4, Quad4),
            (Tri3, Quad4),
            (Tri6, Quad8),
            (Quad8, Tri3),
            (Quad9, Tri6),
        ] {
            let part = |kind: CellKind, low: f64, nodes| {
                let spec = RectangleSpec {
                    space,
                    min: [0.0, low],
                    max: [1.5, low + 1.0],
                    nodes,
                    cells: Quad4,
                };
                rectangle(&spec).unwrap().with_cells(kind).unwrap()
            };
            let face = |body, faces| SurfaceRef { body, faces };
            let steel = Isotropic::new(2.1e5, 0.3).unwrap();
            let mut model = Model::new("patch test in the plane");
            model
                .add_body("upper", part(above, 1.0, [5, 3]), steel)
                .unwrap();
            model
                .add_body("lower", part(below, 0.0, [7, 4]), steel)
                .unwrap();
            for body in ["upper", "lower"] {
                let held = [Some(0.0), None, None];
                model.support(None, &[face(body, "x-")], held).unwrap();
            }
            let held = [None, Some(0.0), None];
            model.support(None, &[face("lower", "y-")], held).unwrap();
            let on = vec![model.resolve(face("upper", "y+")).unwrap()];
            let value = ScalarField::Constant(PRESSURE);
            model
                .add_load(None, LoadKind::Pressure { on, value })
                .unwrap();
            model
                .add_contact_as(ContactSpec {
                    coupling: CouplingMethod::Mortar,
                    ..ContactSpec::new(
                        face("upper", "y-"),
                        face("lower", "y+"),
                        FrictionLaw::Frictionless,
                    )
                })
                .unwrap();
            let outcome = solved(&model);
            let pairs = outcome.last().pairs();
            let error = pairs
                .map(|pair| (pair.pressure() / PRESSURE - 1.0).abs())
                .fold(0.0, f64::max);
            report(&format!(
                "patch test, {space:?}, {above} on {below}: {error:.1e}"
            ));
            assert!(error < 1e-10, "{space:?}, {above} on {below}: {error:e}");
        }
    }
}

/// Two contacts share the edge along which a face was cut: no row stands twice, and no area is lost.
#[test]
fn a_face_cut_in_two_carries_what_it_did_in_one_piece() {
    for method in [CouplingMethod::NodeByNode, CouplingMethod::Mortar] {
        let face = |body, faces| SurfaceRef { body, faces };
        let steel = Isotropic::new(2.1e5, 0.3).unwrap();
        let mut model = Model::new("a face cut in two");
        for (body, low) in [("upper", 1.0), ("lower", 0.0)] {
            let mut mesh = brick(&BrickSpec {
                min: [0.0, 0.0, low],
                max: [2.0, 1.0, low + 1.0],
                nodes: [5, 4, 3],
            })
            .unwrap();
            let whole = mesh.face_sets[if low > 0.0 { "z-" } else { "z+" }].clone();
            let (left, right): (Vec<_>, Vec<_>) = whole.into_iter().partition(|&face| {
                let nodes = mesh.face_nodes(face);
                nodes.iter().map(|&node| mesh.points[node][0]).sum::<f64>() < nodes.len() as f64
            });
            assert!(!left.is_empty() && !right.is_empty());
            mesh.face_sets.insert("left".into(), left);
            mesh.face_sets.insert("right".into(), right);
            model.add_body(body, mesh, steel).unwrap();
            model
                .support(None, &[face(body, "x-")], [Some(0.0), None, None])
                .unwrap();
            model
                .support(None, &[face(body, "y-")], [None, Some(0.0), None])
                .unwrap();
        }
        model
            .support(None, &[face("lower", "z-")], [None, None, Some(0.0)])
            .unwrap();
        let on = vec![model.resolve(face("upper", "z+")).unwrap()];
        let value = ScalarField::Constant(PRESSURE);
        model
            .add_load(None, LoadKind::Pressure { on, value })
            .unwrap();
        for side in ["left", "right"] {
            model
                .add_contact_as(ContactSpec {
                    coupling: method,
                    ..ContactSpec::new(
                        face("upper", side),
                        face("lower", side),
                        FrictionLaw::tresca(0.5),
                    )
                })
                .unwrap();
        }
        let outcome = solved(&model);
        let area: f64 = outcome.last().pairs().map(|pair| pair.pair.area).sum();
        assert!((area - 2.0).abs() < 1e-12, "{method:?}: area {area}");
        let error = deviation(&outcome, 0.0);
        report(&format!(
            "patch test, face cut in two, {method:?}: {error:.1e}"
        ));
        assert!(error < 1e-10, "{method:?}: {error:e}");
    }
}
