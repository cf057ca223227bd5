//! Grids are read back by the `vtkio` crate, and hold what was written.

use std::collections::BTreeMap;
use std::path::Path;

use tresca_fem::mesh::{BrickSpec, CellBlock, CellKind, Mesh, Space, brick};
use tresca_io::WriteError;
use tresca_io::atomic::OutputSet;
use tresca_io::pvd::{self, PvdPart};
use tresca_io::results::{BodyFields, ContactFields, NodeContactFields};
use tresca_io::vtu::{CellShape, Cells, Fact, Field, Grid, Values};
use vtkio::model::{
    Attribute, CellType, DataSet, Piece, UnstructuredGridPiece, VertexNumbers, Vtk,
};

fn read(file: &[u8]) -> UnstructuredGridPiece {
    let DataSet::UnstructuredGrid { pieces, .. } = Vtk::parse_xml(file).unwrap().data else {
        panic!("no unstructured grid");
    };
    let [Piece::Inline(piece)] = <[_; 1]>::try_from(pieces).ok().unwrap() else {
        panic!("no inline piece");
    };
    *piece
}

fn connectivity(piece: &UnstructuredGridPiece) -> (Vec<u64>, Vec<u64>) {
    match &piece.cells.cell_verts {
        VertexNumbers::XML {
            connectivity,
            offsets,
        } => (connectivity.clone(), offsets.clone()),
        VertexNumbers::Legacy { .. } => panic!("not XML"),
    }
}

/// Number of components and values, as numbers, of a field.
fn field(fields: &[Attribute], name: &str) -> (usize, Vec<f64>) {
    let Some(Attribute::DataArray(array)) = fields.iter().find(|field| field.name() == name) else {
        panic!("no field `{name}`");
    };
    (
        array.num_comp(),
        array.data.clone().cast_into().expect("numbers"),
    )
}

fn small_mesh() -> Mesh {
    brick(&BrickSpec {
        min: [0.0, 0.0, 0.0],
        max: [2.0, 1.0, 1.0],
        nodes: [4, 3, 2],
    })
    .unwrap()
}

fn facts() -> Vec<(String, Fact)> {
    vec![
        ("version".into(), Fact::Text("1.2.3 --- \"a\" <b>".into())),
        ("status".into(), Fact::Text("converged -".into())),
        ("iterations".into(), Fact::Integers(vec![9])),
        ("tolerance".into(), Fact::Numbers(vec![1e-8])),
    ]
}

#[test]
fn a_body_comes_back() {
    let mesh = small_mesh();
    let n = mesh.points.len();
    let displacement: Vec<f64> = (0..3 * n).map(|i| (i as f64).sin() * 1e-3).collect();
    let stress: Vec<[f64; 6]> = (0..n)
        .map(|i| std::array::from_fn(|c| 10.0 * i as f64 + c as f64))
        .collect();
    let von_mises: Vec<f64> = (0..n).map(|i| 1.0 / (1.0 + i as f64)).collect();
    let mut file = Vec::new();
    BodyFields {
        mesh: &mesh,
        displacement: &displacement,
        stress: &stress,
        von_mises: &von_mises,
        reaction: None,
        surface: None,
        unresisted_motion: None,
        facts: facts(),
    }
    .write(&mut file)
    .unwrap();

    let piece = read(&file);
    let points: Vec<f64> = piece.points.clone().cast_into().unwrap();
    assert_eq!(points, mesh.points.as_flattened());
    let (nodes, offsets) = connectivity(&piece);
    let expected: Vec<u64> = mesh.cells[0]
        .connectivity
        .iter()
        .map(|&i| i as u64)
        .collect();
    assert_eq!(nodes, expected);
    assert_eq!(offsets, [8, 16, 24, 32, 40, 48]);
    assert_eq!(piece.cells.types, [CellType::Hexahedron; 6]);
    let fields = &piece.data.point;
    assert_eq!(fields.len(), 3);
    assert_eq!(field(fields, "displacement"), (3, displacement));
    assert_eq!(field(fields, "stress"), (6, stress.as_flattened().to_vec()));
    assert_eq!(field(fields, "von_mises_stress"), (1, von_mises));

    let text = String::from_utf8(file).unwrap();
    assert!(text.contains("<!-- version: 1.2.3 - - - &quot;a&quot; &lt;b&gt; -->"));
    assert!(text.contains("<!-- status: converged - -->"));
    let names: Vec<&str> = text
        .lines()
        .find(|line| line.contains("\"stress\""))
        .unwrap()
        .split("ComponentName")
        .skip(1)
        .map(|rest| rest.split('"').nth(1).unwrap())
        .collect();
    assert_eq!(names, ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]);
}

/// A quadrilateral in the plane: the displacement has two components per node.
#[test]
fn a_plane_body_comes_back_with_vectors_of_three_components() {
    let points = vec![
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [3.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
    ];
    let block = CellBlock {
        kind: CellKind::Quad4,
        connectivity: vec![0, 1, 2, 3],
    };
    let mesh = Mesh::new(Space::Plane, points, vec![block], BTreeMap::new()).unwrap();
    let displacement = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
    let stress = [[1.0, 2.0, 3.0, 4.0, 0.0, 0.0]; 4];
    let numbers = [20.0, 21.0, 22.0, 23.0];
    let vectors: [[f64; 3]; 4] = std::array::from_fn(|node| [node as f64, 0.5, 0.0]);
    let mut body = BodyFields {
        mesh: &mesh,
        displacement: &displacement,
        stress: &stress,
        von_mises: &[1.0; 4],
        reaction: Some(&vectors),
        surface: Some(NodeContactFields {
            force: &vectors,
            pressure: &numbers,
            traction: &vectors,
            gap: &numbers,
            status: &[0, 1, 2, 3],
        }),
        unresisted_motion: Some(&vectors),
        facts: facts(),
    };
    let mut file = Vec::new();
    body.write(&mut file).unwrap();
    let piece = read(&file);
    assert_eq!(piece.cells.types, [CellType::Quad]);
    let fields = &piece.data.point;
    let names: Vec<&str> = fields.iter().map(Attribute::name).collect();
    let expected = [
        "displacement",
        "stress",
        "von_mises_stress",
        "reaction",
        "contact_force",
        "contact_pressure",
        "contact_traction",
        "contact_gap",
        "contact_status",
        "unresisted_motion",
    ];
    assert_eq!(names, expected);
    let expected = [0.1, 0.2, 0.0, 0.3, 0.4, 0.0, 0.5, 0.6, 0.0, 0.7, 0.8, 0.0];
    assert_eq!(field(fields, "displacement"), (3, expected.to_vec()));
    for name in ["contact_pressure", "contact_gap"] {
        assert_eq!(field(fields, name), (1, numbers.to_vec()), "{name}");
    }
    for name in [
        "reaction",
        "contact_force",
        "contact_traction",
        "unresisted_motion",
    ] {
        let expected = vectors.as_flattened().to_vec();
        assert_eq!(field(fields, name), (3, expected), "{name}");
    }
    assert_eq!(
        field(fields, "contact_status"),
        (1, vec![0.0, 1.0, 2.0, 3.0])
    );

    body.displacement = &displacement[..7];
    let error = body.write(&mut Vec::new()).unwrap_err().to_string();
    assert_eq!(error, "`displacement` has 7 values, expected 12");
}

/// Arrays shorter and longer than a piece of the encoder, and of every length modulo 3.
#[test]
fn arrays_of_any_length_come_back() {
    for n in [
        0, 1, 2, 3, 4, 6143, 6144, 6145, 49_143, 49_144, 49_145, 60_000,
    ] {
        let points: Vec<[f64; 3]> = (0..n).map(|i| [i as f64, 0.5, -1.0]).collect();
        let states: Vec<u8> = (0..n).map(|i| (i % 3) as u8).collect();
        let numbers: Vec<i32> = (0..n).map(|i| i - 5).collect();
        let vertices: Vec<usize> = (0..n as usize).collect();
        let per_cell: Vec<f64> = (0..n).map(|i| f64::from(i) / 7.0).collect();
        let mut grid = Grid::new(&points);
        grid.cells.push(Cells {
            shape: CellShape::Vertex,
            connectivity: &vertices,
        });
        grid.point_fields
            .push(Field::new("state", Values::States(&states)));
        grid.point_fields
            .push(Field::new("number", Values::Integers(&numbers)));
        grid.cell_fields
            .push(Field::new("cell", Values::Scalars(&per_cell)));
        let mut file = Vec::new();
        grid.write(&mut file).unwrap();
        let piece = read(&file);
        let read: Vec<f64> = piece.points.clone().cast_into().unwrap();
        assert_eq!(read, points.as_flattened());
        let widened = |values: &[i32]| values.iter().map(|&v| f64::from(v)).collect::<Vec<_>>();
        let states: Vec<i32> = states.into_iter().map(i32::from).collect();
        assert_eq!(field(&piece.data.point, "state").1, widened(&states));
        assert_eq!(field(&piece.data.point, "number").1, widened(&numbers));
        assert_eq!(field(&piece.data.cell, "cell").1, per_cell);
    }
}

#[test]
fn blocks_of_different_shapes_follow_each_other() {
    let points = [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [2.0, 0.0, 0.0],
    ];
    let mut grid = Grid::new(&points);
    for (shape, connectivity) in [
        (CellShape::Quad, &[0, 1, 2, 3][..]),
        (CellShape::Triangle, &[1, 4, 2]),
        (CellShape::Line, &[0, 1, 1, 2]),
    ] {
        grid.cells.push(Cells {
            shape,
            connectivity,
        });
    }
    let mut file = Vec::new();
    grid.write(&mut file).unwrap();
    let piece = read(&file);
    assert_eq!(
        connectivity(&piece),
        (vec![0, 1, 2, 3, 1, 4, 2, 0, 1, 1, 2], vec![4, 7, 9, 11])
    );
    use CellType::{Line, Quad, Triangle};
    assert_eq!(piece.cells.types, [Quad, Triangle, Line, Line]);
}

struct Contact {
    points: Vec<[f64; 3]>,
    scalars: Vec<f64>,
    vectors: Vec<[f64; 3]>,
    pair: Vec<i32>,
    closed: Vec<bool>,
    sticking: Vec<bool>,
}

impl Contact {
    fn new() -> Self {
        Self {
            points: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            scalars: vec![0.0, 1.5, 2.5, -0.0],
            vectors: vec![[0.0, 0.0, 1.0]; 4],
            pair: vec![0, 0, 1, 1],
            closed: vec![false, true, true, false],
            sticking: vec![false, true, false, true],
        }
    }

    fn fields<'a>(&'a self, faces: Vec<Cells<'a>>) -> ContactFields<'a> {
        ContactFields {
            points: &self.points,
            faces,
            pair: &self.pair,
            normal: &self.vectors,
            normal_force: &self.scalars,
            contact_pressure: &self.scalars,
            tangential_force: &self.vectors,
            tangential_traction: &self.vectors,
            slip_bound: &self.scalars,
            gap: &self.scalars,
            slip: &self.vectors,
            closed: &self.closed,
            sticking: &self.sticking,
            slip_increment: &self.vectors,
            friction_law: &[1, 1, 3, 4],
            law_names: &["frictionless", "tresca", "orthotropic", "coulomb", "tied"],
            facts: facts(),
        }
    }
}

#[test]
fn contact_fields_come_back_with_and_without_faces() {
    let contact = Contact::new();
    let faces = vec![Cells {
        shape: CellShape::Quad,
        connectivity: &[0, 1, 2, 3],
    }];
    for (faces, types) in [
        (vec![], vec![CellType::Vertex; 4]),
        (faces, vec![CellType::Quad]),
    ] {
        let mut file = Vec::new();
        contact.fields(faces).write(&mut file).unwrap();
        let piece = read(&file);
        assert_eq!(piece.cells.types, types);
        let fields = &piece.data.point;
        assert_eq!(field(fields, "status"), (1, vec![0.0, 1.0, 2.0, 0.0]));
        assert_eq!(field(fields, "closed"), (1, vec![0.0, 1.0, 1.0, 0.0]));
        assert_eq!(field(fields, "sticking"), (1, vec![0.0, 1.0, 0.0, 1.0]));
        assert_eq!(field(fields, "pair"), (1, vec![0.0, 0.0, 1.0, 1.0]));
        assert_eq!(field(fields, "normal_force"), (1, contact.scalars.clone()));
        for name in [
            "normal",
            "tangential_force",
            "tangential_traction",
            "slip",
            "slip_increment",
        ] {
            let expected = contact.vectors.as_flattened().to_vec();
            assert_eq!(field(fields, name), (3, expected), "{name}");
        }
        for name in ["contact_pressure", "slip_bound", "gap"] {
            assert_eq!(field(fields, name).0, 1, "{name}");
        }
    }
}

#[test]
fn contact_fields_in_the_plane_have_lines_and_laws() {
    let contact = Contact::new();
    let fields = contact.fields(vec![Cells {
        shape: CellShape::Line,
        connectivity: &[0, 1, 1, 2],
    }]);
    let mut file = Vec::new();
    fields.write(&mut file).unwrap();
    let piece = read(&file);
    assert_eq!(piece.cells.types, [CellType::Line; 2]);
    let point = &piece.data.point;
    assert_eq!(field(point, "friction_law"), (1, vec![1.0, 1.0, 3.0, 4.0]));
    let text = String::from_utf8(file).unwrap();
    let meaning =
        "<!-- friction_law: 0 frictionless, 1 tresca, 2 orthotropic, 3 coulomb, 4 tied -->";
    assert!(text.contains(meaning), "{text}");
}

/// What `write` answers, and that it wrote nothing.
fn refusal(grid: &Grid<'_>) -> String {
    let mut file = Vec::new();
    let error: WriteError = grid.write(&mut file).unwrap_err();
    assert!(file.is_empty());
    error.to_string()
}

#[test]
fn what_makes_no_sense_is_refused_with_its_place() {
    let mesh = small_mesh();
    let n = mesh.points.len();
    let grid = Grid::of_mesh(&mesh);

    let mut displacement = vec![0.0; 3 * n];
    displacement[17] = f64::NAN;
    let mut bad = grid.clone();
    bad.point_fields = vec![Field::new(
        "displacement",
        Values::Interleaved(&displacement),
    )];
    assert_eq!(
        refusal(&bad),
        "`displacement` is not a finite number at node 5, component 2: NaN"
    );

    bad.point_fields = vec![Field::new(
        "von_mises_stress",
        Values::Scalars(&displacement),
    )];
    assert_eq!(
        refusal(&bad),
        "`von_mises_stress` has 72 values, expected 24"
    );

    bad.point_fields.clear();
    let per_cell = [0.0, 0.0, f64::NEG_INFINITY, 0.0, 0.0, 0.0];
    bad.cell_fields = vec![Field::new("energy", Values::Scalars(&per_cell))];
    assert_eq!(
        refusal(&bad),
        "`energy` is not a finite number at cell 2: -inf"
    );

    bad.cell_fields = vec![Field::new("energy", Values::Scalars(&[0.0; 6])); 2];
    assert_eq!(
        refusal(&bad),
        "the name `energy` cannot be used: two fields have it"
    );

    let mut bad = grid.clone();
    bad.facts = vec![("tolerance".into(), Fact::Numbers(vec![1.0, f64::INFINITY]))];
    assert_eq!(
        refusal(&bad),
        "`tolerance` is not a finite number at entry 1: inf"
    );

    let points = [[0.0; 3], [0.0, f64::NAN, 0.0]];
    assert_eq!(
        refusal(&Grid::new(&points)),
        "`Points` is not a finite number at node 1, component 1: NaN"
    );

    let mut bad = Grid::new(&points[..1]);
    bad.cells = vec![Cells {
        shape: CellShape::Line,
        connectivity: &[0, 0, 0, 1],
    }];
    assert_eq!(
        refusal(&bad),
        "cell 1 refers to point 1, but there are 1 points"
    );
    bad.cells = vec![Cells {
        shape: CellShape::Line,
        connectivity: &[0, 0, 0],
    }];
    assert_eq!(refusal(&bad), "`connectivity` has 3 values, expected 4");
}

/// A complete set of files, which `scripts/check_vtu.py` can read too.
#[test]
fn a_set_of_grids_is_written_with_its_collection() {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("grids");
    let mesh = small_mesh();
    let n = mesh.points.len();
    let (displacement, stress) = (vec![0.25; 3 * n], vec![[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]; n]);
    let von_mises: Vec<f64> = (0..n).map(|i| i as f64).collect();
    let body = BodyFields {
        mesh: &mesh,
        displacement: &displacement,
        stress: &stress,
        von_mises: &von_mises,
        reaction: None,
        surface: None,
        unresisted_motion: None,
        facts: facts(),
    };
    let contact = Contact::new();
    let part = |name, file| PvdPart {
        name,
        file,
        time: 0.0,
    };
    let parts = [
        part("upper & lower", "body.vtu"),
        part("contact", "contact.vtu"),
    ];
    let mut set = OutputSet::new(&directory).unwrap();
    set.stage("body.vtu", |out| body.write(out)).unwrap();
    set.stage("contact.vtu", |out| contact.fields(vec![]).write(out))
        .unwrap();
    set.stage("all.pvd", |out| pvd::write(out, &parts)).unwrap();
    set.commit().unwrap();

    let collection = std::fs::read_to_string(directory.join("all.pvd")).unwrap();
    assert_eq!(
        collection,
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n    \
         <DataSet timestep=\"0.0\" part=\"0\" name=\"upper &amp; lower\" file=\"body.vtu\"/>\n    \
         <DataSet timestep=\"0.0\" part=\"1\" name=\"contact\" file=\"contact.vtu\"/>\n  \
         </Collection>\n</VTKFile>\n"
    );
}
