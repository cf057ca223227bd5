//! Cells of every kind, together in one file, with the types and the node orders of VTK.

use tresca_fem::mesh::CellKind;
use tresca_io::vtu::{Cells, Grid};
use vtkio::model::{CellType, DataSet, Piece, VertexNumbers, Vtk};

/// VTK's type of a kind, and of which corners each further node is the mean: the tables of VTK's
/// class references (vtkQuadraticTetra, vtkQuadraticHexahedron, vtkTriQuadraticHexahedron, …).
fn of_vtk(kind: CellKind) -> (CellType, &'static [&'static [usize]]) {
    const RING: [&[usize]; 4] = [&[0, 1], &[1, 2], &[2, 3], &[3, 0]];
    const HEXAHEDRON: [&[usize]; 19] = [
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
        &[0, 3, 7, 4],
        &[1, 2, 6, 5],
        &[0, 1, 5, 4],
        &[3, 2, 6, 7],
        &[0, 1, 2, 3],
        &[4, 5, 6, 7],
        &[0, 1, 2, 3, 4, 5, 6, 7],
    ];
    match kind {
        CellKind::Line2 => (CellType::Line, &[]),
        CellKind::Line3 => (CellType::QuadraticEdge, &[&[0, 1]]),
        CellKind::Tri3 => (CellType::Triangle, &[]),
        CellKind::Tri6 => (CellType::QuadraticTriangle, &[&[0, 1], &[1, 2], &[2, 0]]),
        CellKind::Quad4 => (CellType::Quad, &[]),
        CellKind::Quad8 => (CellType::QuadraticQuad, const { &RING }),
        CellKind::Quad9 => (
            CellType::BiquadraticQuad,
            &[&[0, 1], &[1, 2], &[2, 3], &[3, 0], &[0, 1, 2, 3]],
        ),
        CellKind::Tet4 => (CellType::Tetra, &[]),
        CellKind::Tet10 => (
            CellType::QuadraticTetra,
            &[&[0, 1], &[1, 2], &[2, 0], &[0, 3], &[1, 3], &[2, 3]],
        ),
        CellKind::Wedge6 => (CellType::Wedge, &[]),
        CellKind::Hex8 => (CellType::Hexahedron, &[]),
        CellKind::Hex20 => (CellType::QuadraticHexahedron, HEXAHEDRON.split_at(12).0),
        CellKind::Hex27 => (CellType::TriquadraticHexahedron, const { &HEXAHEDRON }),
    }
}

#[test]
fn a_mixed_grid_comes_back_in_the_order_of_vtk() {
    let mut points = Vec::new();
    let mut connectivity = Vec::new();
    for (i, kind) in CellKind::ALL.into_iter().enumerate() {
        let first = points.len();
        // Affine images of the reference elements, apart from each other.
        let image = |[x, y, z]: [f64; 3]| [5.0 * i as f64 + x + 0.1 * y, y + 0.2 * z, z + 0.3 * x];
        points.extend(kind.element().nodes().iter().copied().map(image));
        connectivity.push((first..points.len()).collect::<Vec<_>>());
    }
    let mut grid = Grid::new(&points);
    for (kind, connectivity) in CellKind::ALL.into_iter().zip(&connectivity) {
        let shape = kind.into();
        grid.cells.push(Cells {
            shape,
            connectivity,
        });
    }
    let mut file = Vec::new();
    grid.write(&mut file).unwrap();

    let DataSet::UnstructuredGrid { pieces, .. } = Vtk::parse_xml(&file[..]).unwrap().data else {
        panic!("no unstructured grid");
    };
    let [Piece::Inline(piece)] = <[_; 1]>::try_from(pieces).ok().unwrap() else {
        panic!("no inline piece");
    };
    let VertexNumbers::XML {
        connectivity,
        offsets,
    } = &piece.cells.cell_verts
    else {
        panic!("not XML");
    };
    let read: Vec<f64> = piece.points.cast_into().unwrap();
    let mut start = 0;
    for (i, kind) in CellKind::ALL.into_iter().enumerate() {
        let (cell_type, means) = of_vtk(kind);
        assert_eq!(piece.cells.types[i], cell_type, "{kind}");
        let end = offsets[i] as usize;
        let nodes: Vec<[f64; 3]> = connectivity[start..end]
            .iter()
            .map(|&node| std::array::from_fn(|axis| read[3 * node as usize + axis]))
            .collect();
        assert_eq!(nodes.len(), kind.corner_count() + means.len(), "{kind}");
        for (node, corners) in nodes[kind.corner_count()..].iter().zip(means) {
            for axis in 0..3 {
                let sum: f64 = corners.iter().map(|&a| nodes[a][axis]).sum();
                let mean = sum / corners.len() as f64;
                assert!((node[axis] - mean).abs() < 1e-13, "{kind}: {corners:?}");
            }
        }
        start = end;
    }
}
