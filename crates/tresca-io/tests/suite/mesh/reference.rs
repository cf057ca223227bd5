//! Reference elements, written in each format's own order of nodes as its documentation has it,
//! come out as our reference elements.
//!
//! The tables below are nodes by place, not permutations: they are copied from the pictures of the
//! two manuals, so that a wrong permutation in the reader cannot hide here.

use std::fmt::Write;

use tresca_fem::mesh::CellKind;
use tresca_io::mesh::{MeshFile, parse};

/// Corners of a cube, counter-clockwise at the bottom, then at the top.
const CUBE: [[f64; 3]; 8] = [
    [-1., -1., -1.],
    [1., -1., -1.],
    [1., 1., -1.],
    [-1., 1., -1.],
    [-1., -1., 1.],
    [1., -1., 1.],
    [1., 1., 1.],
    [-1., 1., 1.],
];

/// Corners of the unit tetrahedron; the first three are the unit triangle.
const SIMPLEX: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];

const SQUARE: [[f64; 3]; 4] = [[-1., -1., 0.], [1., -1., 0.], [1., 1., 0.], [-1., 1., 0.]];

const SEGMENT: [[f64; 3]; 2] = [[-1., 0., 0.], [1., 0., 0.]];

/// A prism over the unit triangle, from −1 to 1.
const PRISM: [[f64; 3]; 6] = [
    [0., 0., -1.],
    [1., 0., -1.],
    [0., 1., -1.],
    [0., 0., 1.],
    [1., 0., 1.],
    [0., 1., 1.],
];

/// Corners, then the means of the corners listed.
fn nodes(corners: &[[f64; 3]], means: &[&[usize]]) -> Vec<[f64; 3]> {
    let mut nodes = corners.to_vec();
    for of in means {
        nodes.push(std::array::from_fn(|i| {
            of.iter().map(|&a| corners[a][i]).sum::<f64>() / of.len() as f64
        }));
    }
    nodes
}

const ALL_8: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 7];

/// The chapter "Gmsh file formats", section "Node ordering": number of the type and nodes in order.
fn of_gmsh(kind: CellKind) -> (u32, Vec<[f64; 3]>) {
    let triangle = &SIMPLEX[..3];
    let hexahedron: [&[usize]; 19] = [
        &[0, 1],
        &[0, 3],
        &[0, 4],
        &[1, 2],
        &[1, 5],
        &[2, 3],
        &[2, 6],
        &[3, 7],
        &[4, 5],
        &[4, 7],
        &[5, 6],
        &[6, 7],
        &[0, 1, 2, 3],
        &[0, 1, 4, 5],
        &[0, 3, 4, 7],
        &[1, 2, 5, 6],
        &[2, 3, 6, 7],
        &[4, 5, 6, 7],
        ALL_8,
    ];
    match kind {
        CellKind::Line2 => (1, nodes(&SEGMENT, &[])),
        CellKind::Line3 => (8, nodes(&SEGMENT, &[&[0, 1]])),
        CellKind::Tri3 => (2, nodes(triangle, &[])),
        CellKind::Tri6 => (9, nodes(triangle, &[&[0, 1], &[1, 2], &[0, 2]])),
        CellKind::Quad4 => (3, nodes(&SQUARE, &[])),
        CellKind::Quad8 => (16, nodes(&SQUARE, &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]])),
        CellKind::Quad9 => (
            10,
            nodes(
                &SQUARE,
                &[&[0, 1], &[1, 2], &[2, 3], &[3, 0], &[0, 1, 2, 3]],
            ),
        ),
        CellKind::Tet4 => (4, nodes(&SIMPLEX, &[])),
        CellKind::Tet10 => (
            11,
            nodes(
                &SIMPLEX,
                &[&[0, 1], &[1, 2], &[0, 2], &[0, 3], &[2, 3], &[1, 3]],
            ),
        ),
        CellKind::Wedge6 => (6, nodes(&PRISM, &[])),
        CellKind::Hex8 => (5, nodes(&CUBE, &[])),
        CellKind::Hex20 => (17, nodes(&CUBE, &hexahedron[..12])),
        CellKind::Hex27 => (12, nodes(&CUBE, &hexahedron)),
    }
}

/// The Abaqus Elements Guide, "Node ordering and face numbering on elements"; CalculiX has the same.
fn of_abaqus(kind: CellKind) -> Option<(&'static str, Vec<[f64; 3]>)> {
    let triangle = &SIMPLEX[..3];
    Some(match kind {
        CellKind::Line2 => ("T3D2", nodes(&SEGMENT, &[])),
        // The middle node is the second one.
        CellKind::Line3 => ("T3D3", vec![SEGMENT[0], [0.; 3], SEGMENT[1]]),
        CellKind::Tri3 => ("CPS3", nodes(triangle, &[])),
        CellKind::Tri6 => ("CPE6", nodes(triangle, &[&[0, 1], &[1, 2], &[2, 0]])),
        CellKind::Quad4 => ("CAX4R", nodes(&SQUARE, &[])),
        CellKind::Quad8 => (
            "CPS8",
            nodes(&SQUARE, &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]]),
        ),
        CellKind::Quad9 => (
            "S9R5",
            nodes(
                &SQUARE,
                &[&[0, 1], &[1, 2], &[2, 3], &[3, 0], &[0, 1, 2, 3]],
            ),
        ),
        CellKind::Tet4 => ("C3D4", nodes(&SIMPLEX, &[])),
        CellKind::Tet10 => (
            "C3D10",
            nodes(
                &SIMPLEX,
                &[&[0, 1], &[1, 2], &[2, 0], &[0, 3], &[1, 3], &[2, 3]],
            ),
        ),
        CellKind::Wedge6 => ("C3D6", nodes(&PRISM, &[])),
        CellKind::Hex8 => ("C3D8I", nodes(&CUBE, &[])),
        CellKind::Hex20 => {
            let edges: [&[usize]; 12] = [
                &[0, 1],
                &[1, 2],
                &[2, 3],
                &[3, 0],
                &[4, 5],
                &[5, 6],
                &[6, 7],
                &[7, 4],
                &[0, 4],
                &[1, 5],
                &[2, 6],
                &[3, 7],
            ];
            ("C3D20R", nodes(&CUBE, &edges))
        }
        CellKind::Hex27 => return None,
    })
}

fn comes_out_as_reference(kind: CellKind, file: &MeshFile) {
    assert_eq!(file.cells.len(), 1, "{kind}");
    assert_eq!(file.cells.kind(0), kind);
    let found: Vec<[f64; 3]> = file
        .cells
        .nodes(0)
        .iter()
        .map(|&p| file.points[p])
        .collect();
    assert_eq!(found, kind.element().nodes(), "{kind} of {}", file.format);
}

#[test]
fn gmsh() {
    for kind in CellKind::ALL {
        let (number, nodes) = of_gmsh(kind);
        let count = nodes.len();
        // Numbers with gaps, that fall: nothing may depend on them.
        let numbers: Vec<usize> = (0..count).map(|i| 100 - 3 * i).collect();
        let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
        let list = words.join(" ");
        let (mut two, mut four) = (String::new(), String::new());
        writeln!(two, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{count}").unwrap();
        writeln!(
            four,
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {count} 1 100\n3 1 0 {count}"
        )
        .unwrap();
        writeln!(four, "{}", words.join("\n")).unwrap();
        for ([x, y, z], number) in nodes.iter().zip(&numbers) {
            writeln!(two, "{number} {x} {y} {z}").unwrap();
            writeln!(four, "{x} {y} {z}").unwrap();
        }
        writeln!(
            two,
            "$EndNodes\n$Elements\n1\n7 {number} 2 1 1 {list}\n$EndElements"
        )
        .unwrap();
        writeln!(
            four,
            "$EndNodes\n$Elements\n1 1 7 7\n3 1 {number} 1\n7 {list}\n$EndElements"
        )
        .unwrap();
        for text in [two, four] {
            comes_out_as_reference(kind, &parse("one.msh", text.as_bytes()).unwrap());
        }
    }
}

#[test]
fn abaqus() {
    for kind in CellKind::ALL {
        let Some((name, nodes)) = of_abaqus(kind) else {
            continue;
        };
        let mut text = String::from("*Node\n");
        for (i, [x, y, z]) in nodes.iter().enumerate() {
            writeln!(text, "{}, {x}, {y}, {z}", i + 10).unwrap();
        }
        // At most 16 entries on a line, as in real decks.
        let entries: Vec<String> = (0..nodes.len()).map(|i| (i + 10).to_string()).collect();
        let mut list = vec!["5".to_owned()];
        list.extend(entries);
        let lines: Vec<String> = list.chunks(16).map(|line| line.join(", ")).collect();
        writeln!(text, "*Element, type={name}\n{}", lines.join(",\n")).unwrap();
        comes_out_as_reference(kind, &parse("one.inp", text.as_bytes()).unwrap());
    }
}
