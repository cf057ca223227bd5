//! Meshes in a form that does not depend on the order of the file.

use std::collections::{BTreeMap, BTreeSet};

use tresca_fem::mesh::{CellKind, Mesh, Space};
use tresca_io::mesh::{BodyMesh, MeshFile, MeshFileError, Placement, parse, read};

/// A file beside this one.
pub fn data(name: &str) -> MeshFile {
    let path = format!(
        "{}/tests/suite/mesh/data/{name}",
        env!("CARGO_MANIFEST_DIR")
    );
    read(&path).unwrap_or_else(|error| panic!("{error}"))
}

pub fn body(file: &MeshFile, space: Space, part: Option<&str>) -> BodyMesh {
    let body = file.body(space, part, &Placement::default());
    body.unwrap_or_else(|error| panic!("{error}"))
}

pub fn solid(file: &MeshFile, part: Option<&str>) -> Mesh {
    body(file, Space::Solid, part).mesh
}

/// The error of a text that must be refused.
pub fn refused(name: &str, text: &str) -> MeshFileError {
    parse(name, text.as_bytes()).expect_err("must be refused")
}

/// A point as a key; two files that write numbers in decimals agree to 9 digits.
type Key = [i64; 3];

fn key(point: [f64; 3]) -> Key {
    point.map(|x| (x * 1e9).round() as i64)
}

/// A mesh by places: cells as kinds with the places of their nodes in order, face sets as sets of
/// sets of places, node sets as sets of places.
#[derive(Debug, PartialEq)]
pub struct ByPlace {
    cells: BTreeSet<(CellKind, Vec<Key>)>,
    face_sets: BTreeMap<String, BTreeSet<Vec<Key>>>,
    node_sets: BTreeMap<String, BTreeSet<Key>>,
}

pub fn by_place(mesh: &Mesh) -> ByPlace {
    let place = |&node: &usize| key(mesh.points[node]);
    let cells = mesh.iter_cells();
    ByPlace {
        cells: cells
            .map(|cell| (cell.kind, cell.nodes.iter().map(place).collect()))
            .collect(),
        face_sets: mesh
            .face_sets
            .iter()
            .map(|(name, faces)| {
                let nodes = faces.iter().map(|&face| mesh.face_nodes(face));
                let places = nodes.map(|nodes| nodes.iter().map(place).collect());
                (name.clone(), places.collect())
            })
            .collect(),
        node_sets: mesh
            .node_sets
            .iter()
            .map(|(name, nodes)| (name.clone(), nodes.iter().map(place).collect()))
            .collect(),
    }
}

/// ∫ n dΓ over a face set, rounded: areas here are multiples of a half.
pub fn area(mesh: &Mesh, set: &str) -> [f64; 3] {
    mesh.area_vector(&mesh.face_sets[set]).map(|x| {
        let rounded = (1e12 * x).round() * 1e-12;
        // No negative zeros.
        rounded + 0.0
    })
}
