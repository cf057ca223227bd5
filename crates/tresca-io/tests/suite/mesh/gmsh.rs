//! Files that Gmsh wrote: one mesh in every version and encoding, and as a deck.

use tresca_fem::mesh::{CellKind, Space};
use tresca_io::mesh::{MeshFile, MeshNote, parse};

use crate::mesh::support::{body, by_place, data, solid};

const VERSIONS: [&str; 4] = ["2.2-text", "2.2-binary", "4.1-text", "4.1-binary"];

fn all(name: &str) -> Vec<MeshFile> {
    VERSIONS
        .map(|version| data(&format!("{name}-{version}.msh")))
        .into()
}

fn kinds(mesh: &tresca_fem::mesh::Mesh) -> Vec<CellKind> {
    mesh.cells.iter().map(|block| block.kind).collect()
}

#[test]
fn every_version_and_encoding_gives_the_same_mesh() {
    for (name, space, part) in [
        ("solids", Space::Solid, None),
        ("solids", Space::Solid, Some("left")),
        ("solids", Space::Solid, Some("wedges")),
        ("hexes", Space::Solid, Some("block")),
        ("hexes20", Space::Solid, Some("block")),
        ("hexes27", Space::Solid, Some("70")),
        ("ball", Space::Solid, None),
        ("plates", Space::Plane, Some("all")),
        ("plates2", Space::Plane, Some("squares")),
    ] {
        let files = all(name);
        let meshes = files
            .iter()
            .map(|file| by_place(&body(file, space, part).mesh));
        let meshes: Vec<_> = meshes.collect();
        for (mesh, version) in meshes.iter().zip(VERSIONS).skip(1) {
            assert_eq!(mesh, &meshes[0], "{name} {version}");
        }
    }
    let formats = all("ball").into_iter().map(|file| file.format);
    assert_eq!(
        formats.collect::<Vec<_>>(),
        [
            "Gmsh MSH 2.2, text",
            "Gmsh MSH 2.2, binary",
            "Gmsh MSH 4.1, text",
            "Gmsh MSH 4.1, binary"
        ]
    );
}

/// Gmsh writes decks too; blanks in names become underscores there, and points are left out.
#[test]
fn decks_of_gmsh_give_the_same_cells_and_surfaces() {
    for (name, space, part) in [
        ("solids", Space::Solid, None),
        ("hexes", Space::Solid, Some("block")),
        ("hexes20", Space::Solid, Some("block")),
        ("ball", Space::Solid, Some("ball")),
        ("plates2", Space::Plane, Some("all")),
    ] {
        let mut msh = body(&data(&format!("{name}-4.1-text.msh")), space, part).mesh;
        let mut inp = body(&data(&format!("{name}.inp")), space, part).mesh;
        msh.node_sets.clear();
        inp.node_sets.clear();
        // The deck has a set for each entity beside those of the groups.
        inp.face_sets
            .retain(|name, _| !["Surface", "Line"].iter().any(|e| name.starts_with(e)));
        let renamed = msh.face_sets.into_iter();
        msh.face_sets = renamed
            .map(|(name, faces)| (name.replace(' ', "_"), faces))
            .collect();
        assert_eq!(by_place(&msh), by_place(&inp), "{name}");
    }
}

#[test]
fn volumes_areas_and_sets_are_those_of_the_geometry() {
    let file = data("solids-4.1-binary.msh");
    let left = solid(&file, Some("left"));
    assert!((left.volume() - 1.0).abs() < 1e-14);
    assert_eq!(kinds(&left), [CellKind::Tet4]);
    let names: Vec<&String> = left.face_sets.keys().collect();
    assert_eq!(names, ["between", "bottom plane", "ends"]);
    for (set, area) in [
        ("between", [1.0, 0.0, 0.0]),
        ("bottom plane", [0.0, 0.0, -1.0]),
        ("ends", [-1.0, 0.0, 0.0]),
    ] {
        let found = left.area_vector(&left.face_sets[set]);
        assert!(
            (0..3).all(|i| (found[i] - area[i]).abs() < 1e-14),
            "{set}: {found:?}"
        );
    }
    assert_eq!(left.node_sets["corner"].len(), 1);
    assert_eq!(left.points[left.node_sets["corner"][0]], [0.0; 3]);
    assert!(
        left.node_sets["edge"]
            .iter()
            .all(|&n| left.points[n][0] == 0.0)
    );
    // The common face belongs to both boxes, and lies inside of the two together.
    let right = solid(&file, Some("right"));
    assert_eq!(right.area_vector(&right.face_sets["between"])[0], -1.0);
    let both = body(&file, Space::Solid, None);
    assert!((both.mesh.volume() - 5.0).abs() < 1e-13);
    assert_eq!(kinds(&both.mesh), [CellKind::Tet4, CellKind::Wedge6]);
    assert_eq!(both.unusable.keys().collect::<Vec<_>>(), ["between"]);
    assert!(!both.mesh.face_sets.contains_key("between"));
    // Its nodes are nodes all the same.
    assert!(
        both.mesh.node_sets["between"]
            .iter()
            .all(|&n| both.mesh.points[n][0] == 1.0)
    );
    let wedges = solid(&file, Some("wedges"));
    assert!((wedges.volume() - 2.0).abs() < 1e-14);
    assert_eq!(
        wedges.face_sets.keys().collect::<Vec<_>>(),
        ["bottom plane"]
    );
}

#[test]
fn quadratic_hexahedra_and_tetrahedra_are_curved_where_the_geometry_is() {
    for (name, kind) in [("hexes20", CellKind::Hex20), ("hexes27", CellKind::Hex27)] {
        let mesh = solid(&data(&format!("{name}-4.1-text.msh")), Some("block"));
        assert_eq!(kinds(&mesh), [kind]);
        assert!((mesh.volume() - 2.0).abs() < 1e-14);
        let top = mesh.area_vector(&mesh.face_sets["top"]);
        assert!((top[2] - 2.0).abs() < 1e-14, "{top:?}");
        // Mid nodes lie where the corners say: at the trilinear image of their reference places.
        for cell in mesh.iter_cells() {
            for (&node, &xi) in cell.nodes.iter().zip(kind.element().nodes()) {
                let mut shape = [0.0; 8];
                CellKind::Hex8.element().shape(xi, &mut shape);
                for i in 0..3 {
                    let corners = shape.iter().zip(cell.nodes);
                    let expected: f64 = corners.map(|(s, &n)| s * mesh.points[n][i]).sum();
                    assert!((mesh.points[node][i] - expected).abs() < 1e-9, "{name}");
                }
            }
        }
    }
    let ball = solid(&data("ball-2.2-binary.msh"), Some("ball"));
    assert_eq!(kinds(&ball), [CellKind::Tet10]);
    for &node in &ball.nodes_of_set("round").unwrap() {
        let radius = ball.points[node].iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((radius - 1.0).abs() < 1e-6, "{radius}");
    }
    let exact = std::f64::consts::PI / 6.0;
    assert!(
        (ball.volume() / exact - 1.0).abs() < 0.02,
        "{}",
        ball.volume()
    );
    let floor = ball.area_vector(&ball.face_sets["floor"])[2];
    assert!((floor + std::f64::consts::PI / 4.0).abs() < 0.01, "{floor}");
}

#[test]
fn clockwise_surfaces_of_a_plane_mesh_are_turned_over() {
    for name in ["plates-4.1-text.msh", "plates2-2.2-binary.msh"] {
        let file = data(name);
        let both = body(&file, Space::Plane, Some("all"));
        let clockwise = solid_count(&file, "triangles");
        assert_eq!(both.notes, [MeshNote::Clockwise { cells: clockwise }]);
        assert!((both.mesh.volume() - 2.0).abs() < 1e-14);
        let area = both.mesh.area_vector(&both.mesh.face_sets["left"]);
        assert!((area[0] + 1.0).abs() < 1e-14, "{area:?}");
        assert_eq!(both.mesh.node_sets["tip"].len(), 1);
        let squares = body(&file, Space::Plane, Some("squares"));
        assert!(squares.notes.is_empty());
        assert_eq!(squares.mesh.face_sets.keys().collect::<Vec<_>>(), ["right"]);
    }
}

fn solid_count(file: &MeshFile, group: &str) -> usize {
    file.group(group, 2).unwrap().cells.len()
}

/// Version 2 repeats elements of several groups.
#[test]
fn elements_of_several_groups_are_read_once() {
    let counts = all("hexes")
        .iter()
        .map(|f| f.cells.of_dimension(3).count())
        .collect::<Vec<_>>();
    assert_eq!(counts, [8; 4]);
    for file in all("hexes") {
        assert_eq!(
            file.group("block", 3).unwrap().cells,
            file.group("70", 3).unwrap().cells
        );
    }
}

/// The bytes of every number turned round, which a machine of the other sort would write.
#[test]
fn both_byte_orders_are_read() {
    for (name, swapped) in [
        ("hexes20-4.1-binary.msh", swapped_4 as fn(&[u8]) -> Vec<u8>),
        ("hexes20-2.2-binary.msh", swapped_2),
    ] {
        let path = format!(
            "{}/tests/suite/mesh/data/{name}",
            env!("CARGO_MANIFEST_DIR")
        );
        let bytes = std::fs::read(&path).unwrap();
        let other = swapped(&bytes);
        assert_ne!(bytes, other);
        assert_eq!(parse(&path, &other).unwrap(), parse(&path, &bytes).unwrap());
    }
}

/// Copies a file, turning numbers round at the places that the caller knows.
struct Swap<'a> {
    from: &'a [u8],
    at: usize,
    to: Vec<u8>,
}

impl Swap<'_> {
    /// Up to and with a text.
    fn through(&mut self, text: &str) {
        let rest = &self.from[self.at..];
        let found = rest.windows(text.len()).position(|w| w == text.as_bytes());
        let end = self.at + found.expect(text) + text.len();
        self.to.extend(&self.from[self.at..end]);
        self.at = end;
    }

    fn swap(&mut self, width: usize) -> u64 {
        let bytes = &self.from[self.at..self.at + width];
        self.to.extend(bytes.iter().rev());
        self.at += width;
        bytes
            .iter()
            .rev()
            .fold(0, |n, &byte| 256 * n + u64::from(byte))
    }

    fn swap_all(&mut self, width: usize, count: u64) {
        for _ in 0..count {
            self.swap(width);
        }
    }

    fn finish(mut self) -> Vec<u8> {
        self.to.extend(&self.from[self.at..]);
        self.to
    }
}

fn swapped_4(bytes: &[u8]) -> Vec<u8> {
    let mut file = Swap {
        from: bytes,
        at: 0,
        to: Vec::new(),
    };
    file.through("4.1 1 8\n");
    file.swap(4);
    file.through("$Entities\n");
    let counts = [0; 4].map(|_| file.swap(8));
    for (dimension, count) in counts.into_iter().enumerate() {
        for _ in 0..count {
            file.swap(4);
            file.swap_all(8, if dimension == 0 { 3 } else { 6 });
            let groups = file.swap(8);
            file.swap_all(4, groups);
            if dimension > 0 {
                let bounding = file.swap(8);
                file.swap_all(4, bounding);
            }
        }
    }
    file.through("$Nodes\n");
    let blocks = file.swap(8);
    file.swap_all(8, 3);
    for _ in 0..blocks {
        file.swap_all(4, 3);
        let nodes = file.swap(8);
        file.swap_all(8, 4 * nodes);
    }
    file.through("$Elements\n");
    let blocks = file.swap(8);
    file.swap_all(8, 3);
    for _ in 0..blocks {
        file.swap_all(4, 2);
        let nodes = nodes_of_type(file.swap(4));
        let elements = file.swap(8);
        file.swap_all(8, elements * (1 + nodes));
    }
    file.finish()
}

fn swapped_2(bytes: &[u8]) -> Vec<u8> {
    let mut file = Swap {
        from: bytes,
        at: 0,
        to: Vec::new(),
    };
    let count = |file: &mut Swap<'_>, name: &str| -> u64 {
        file.through(name);
        let start = file.at;
        file.through("\n");
        let text = std::str::from_utf8(&bytes[start..file.at]).unwrap();
        text.trim().parse().unwrap()
    };
    file.through("2.2 1 8\n");
    file.swap(4);
    for _ in 0..count(&mut file, "$Nodes\n") {
        file.swap(4);
        file.swap_all(8, 3);
    }
    let elements = count(&mut file, "$Elements\n");
    let mut read = 0;
    while read < elements {
        let nodes = nodes_of_type(file.swap(4));
        let block = file.swap(4);
        let tags = file.swap(4);
        file.swap_all(4, block * (1 + tags + nodes));
        read += block;
    }
    file.finish()
}

fn nodes_of_type(number: u64) -> u64 {
    match number {
        15 => 1,
        8 => 3,
        16 => 8,
        17 => 20,
        other => panic!("{other}"),
    }
}

/// Sections for other programs, and nodes with their places on the curves and surfaces.
#[test]
fn what_a_mesh_does_not_need_is_skipped_and_listed() {
    let text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nof $no importance\n$EndComments\n\
                $Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 -9 0\n$EndEntities\n\
                $Nodes\n2 4 1 4\n2 1 1 2\n1\n2\n0 0 0 0.1 0.2\n1 0 0 0.3 0.4\n1 5 1 2\n3\n4\n1 1 0 0.5\n0 1 0 0.6\n$EndNodes\n\
                $Periodic\n1\n$EndPeriodic\n$Elements\n1 1 1 1\n2 1 3 1\n1 1 2 3 4\n$EndElements\n\
                $NodeData\n1\n$EndNodeData\n$NodeData\n2\n$EndNodeData\n";
    let file = parse("skipping.msh", text.as_bytes()).unwrap();
    assert_eq!(file.skipped, ["$Comments", "$Periodic", "$NodeData"]);
    assert_eq!(file.points[2], [1.0, 1.0, 0.0]);
    // The group has the entity reversed, and no name.
    assert_eq!(file.group("9", 2).unwrap().cells, [0]);
    assert_eq!(
        file.describe(),
        "Gmsh MSH 4.1, text: 4 points, 1 quad4; groups: `9`"
    );
    assert!((body(&file, Space::Plane, Some("9")).mesh.volume() - 1.0).abs() < 1e-15);
}

#[test]
fn a_mesh_in_partitions_is_refused() {
    let text =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PartitionedEntities\n2\n$EndPartitionedEntities\n";
    let error = parse("parts.msh", text.as_bytes()).unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("a mesh in partitions is not supported"),
        "{error}"
    );
}
