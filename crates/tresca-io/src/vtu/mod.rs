//! VTK's XML files of unstructured grids (`.vtu`), as ParaView, VTK and `meshio` read them.
//!
//! ```
//! use tresca_io::vtu::{CellShape, Cells, Field, Grid, Values};
//!
//! let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! let mut grid = Grid::new(&points);
//! grid.cells.push(Cells { shape: CellShape::Quad, connectivity: &[0, 1, 2, 3] });
//! grid.point_fields.push(Field::new("gap", Values::Scalars(&[0.0, 0.1, 0.1, 0.0])));
//!
//! let mut file = Vec::new();
//! grid.write(&mut file)?;
//! # Ok::<(), tresca_io::WriteError>(())
//! ```
//!
//! The arrays stand behind the XML as base64 ("appended"): the file stays valid XML, which the raw
//! form is not, and readers find every array without parsing the others. No compression: it would
//! cost more time than the disk saves.
//!
//! The writer is our own because of what users see: names of components, field data and exact
//! offsets. The `vtkio` crate has none of the three; it reads our files back in the tests.

mod encode;

use std::io::Write;

use tresca_fem::mesh::{CellKind, Mesh};

use crate::error::WriteError;
use crate::xml::escape;
use encode::{Appended, Data};

/// Shapes of cells. The nodes of a cell stand in VTK's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellShape {
    /// A point.
    Vertex,
    /// Two nodes.
    Line,
    /// Three nodes.
    Triangle,
    /// Four nodes.
    Quad,
    /// Four nodes.
    Tetra,
    /// Eight nodes.
    Hexahedron,
    /// Six nodes.
    Wedge,
    /// Three nodes.
    QuadraticLine,
    /// Six nodes.
    QuadraticTriangle,
    /// Eight nodes.
    QuadraticQuad,
    /// Ten nodes.
    QuadraticTetra,
    /// Twenty nodes.
    QuadraticHexahedron,
    /// Nine nodes.
    BiquadraticQuad,
    /// Twenty-seven nodes.
    TriquadraticHexahedron,
}

impl CellShape {
    /// VTK's number of the shape.
    pub fn vtk_type(self) -> u8 {
        match self {
            CellShape::Vertex => 1,
            CellShape::Line => 3,
            CellShape::Triangle => 5,
            CellShape::Quad => 9,
            CellShape::Tetra => 10,
            CellShape::Hexahedron => 12,
            CellShape::Wedge => 13,
            CellShape::QuadraticLine => 21,
            CellShape::QuadraticTriangle => 22,
            CellShape::QuadraticQuad => 23,
            CellShape::QuadraticTetra => 24,
            CellShape::QuadraticHexahedron => 25,
            CellShape::BiquadraticQuad => 28,
            CellShape::TriquadraticHexahedron => 29,
        }
    }

    /// Nodes per cell.
    pub fn node_count(self) -> usize {
        match self {
            CellShape::Vertex => 1,
            CellShape::Line => 2,
            CellShape::Triangle | CellShape::QuadraticLine => 3,
            CellShape::Quad | CellShape::Tetra => 4,
            CellShape::Wedge | CellShape::QuadraticTriangle => 6,
            CellShape::Hexahedron | CellShape::QuadraticQuad => 8,
            CellShape::BiquadraticQuad => 9,
            CellShape::QuadraticTetra => 10,
            CellShape::QuadraticHexahedron => 20,
            CellShape::TriquadraticHexahedron => 27,
        }
    }
}

impl From<CellKind> for CellShape {
    fn from(kind: CellKind) -> Self {
        match kind {
            CellKind::Line2 => CellShape::Line,
            CellKind::Line3 => CellShape::QuadraticLine,
            CellKind::Tri3 => CellShape::Triangle,
            CellKind::Tri6 => CellShape::QuadraticTriangle,
            CellKind::Quad4 => CellShape::Quad,
            CellKind::Quad8 => CellShape::QuadraticQuad,
            CellKind::Quad9 => CellShape::BiquadraticQuad,
            CellKind::Tet4 => CellShape::Tetra,
            CellKind::Tet10 => CellShape::QuadraticTetra,
            CellKind::Wedge6 => CellShape::Wedge,
            CellKind::Hex8 => CellShape::Hexahedron,
            CellKind::Hex20 => CellShape::QuadraticHexahedron,
            CellKind::Hex27 => CellShape::TriquadraticHexahedron,
        }
    }
}

/// Cells of one shape.
#[derive(Clone, Copy, Debug)]
pub struct Cells<'a> {
    /// The shape of each of them.
    pub shape: CellShape,
    /// Points of the cells, [`CellShape::node_count`] for each, cell after cell.
    pub connectivity: &'a [usize],
}

/// A named field with one value per point or per cell.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    name: &'a str,
    values: Values<'a>,
}

impl<'a> Field<'a> {
    /// A field; names are unique among the fields of the points and among those of the cells.
    pub fn new(name: &'a str, values: Values<'a>) -> Self {
        Self { name, values }
    }
}

/// The values of a field.
#[derive(Clone, Copy, Debug)]
pub enum Values<'a> {
    /// Numbers.
    Scalars(&'a [f64]),
    /// Vectors, components X, Y, Z.
    Vectors(&'a [[f64; 3]]),
    /// Vectors, component after component: a displacement by degrees of freedom.
    Interleaved(&'a [f64]),
    /// Symmetric tensors, components XX, YY, ZZ, XY, YZ, XZ.
    Tensors(&'a [[f64; 6]]),
    /// Small numbers for states.
    States(&'a [u8]),
    /// Whole numbers.
    Integers(&'a [i32]),
}

impl<'a> Values<'a> {
    fn components(self) -> &'static [&'static str] {
        match self {
            Values::Scalars(_) | Values::States(_) | Values::Integers(_) => &[""],
            Values::Vectors(_) | Values::Interleaved(_) => &["X", "Y", "Z"],
            Values::Tensors(_) => &["XX", "YY", "ZZ", "XY", "YZ", "XZ"],
        }
    }

    fn data(self) -> Data<'a> {
        match self {
            Values::Scalars(values) | Values::Interleaved(values) => Data::F64(values),
            Values::Vectors(values) => Data::F64(values.as_flattened()),
            Values::Tensors(values) => Data::F64(values.as_flattened()),
            Values::States(values) => Data::U8(values.into()),
            Values::Integers(values) => Data::I32(values),
        }
    }
}

/// A fact about the whole grid, such as the version of the program or a setting.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// Shown by ParaView as field data.
    Numbers(Vec<f64>),
    /// Shown by ParaView as field data.
    Integers(Vec<i64>),
    /// Stands as a comment at the head of the file, for people: VTK's arrays of texts are an error
    /// to `meshio`, and a file that opens counts for more.
    Text(String),
}

/// An unstructured grid with its fields. Borrows everything large.
#[derive(Clone, Debug)]
pub struct Grid<'a> {
    /// Coordinates.
    pub points: &'a [[f64; 3]],
    /// Blocks of cells; cells are counted through all blocks.
    pub cells: Vec<Cells<'a>>,
    /// Fields with one value per point.
    pub point_fields: Vec<Field<'a>>,
    /// Fields with one value per cell.
    pub cell_fields: Vec<Field<'a>>,
    /// Facts about the whole, by name.
    pub facts: Vec<(String, Fact)>,
}

impl<'a> Grid<'a> {
    /// Points alone.
    pub fn new(points: &'a [[f64; 3]]) -> Self {
        Self {
            points,
            cells: Vec::new(),
            point_fields: Vec::new(),
            cell_fields: Vec::new(),
            facts: Vec::new(),
        }
    }

    /// Points and cells of a mesh.
    pub fn of_mesh(mesh: &'a Mesh) -> Self {
        let mut grid = Self::new(&mesh.points);
        grid.cells = mesh
            .cells
            .iter()
            .map(|block| Cells {
                shape: block.kind.into(),
                connectivity: &block.connectivity,
            })
            .collect();
        grid
    }

    /// Number of cells in all blocks.
    pub fn cell_count(&self) -> usize {
        self.cells
            .iter()
            .map(|cells| cells.connectivity.len() / cells.shape.node_count())
            .sum()
    }

    /// Writes the file.
    ///
    /// # Errors
    /// [`WriteError::NotFinite`], [`WriteError::Length`], [`WriteError::Connectivity`] and
    /// [`WriteError::Name`] when the grid makes no sense, before anything is written; those of the
    /// stream.
    pub fn write(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        self.check()?;
        let mut appended = Appended::default();
        writeln!(out, "<?xml version=\"1.0\"?>")?;
        for (name, fact) in &self.facts {
            if let Fact::Text(text) = fact {
                writeln!(out, "<!-- {}: {} -->", comment(name), comment(text))?;
            }
        }
        writeln!(
            out,
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">"
        )?;
        writeln!(out, "  <UnstructuredGrid>")?;
        self.declare_facts(out, &mut appended)?;
        writeln!(
            out,
            "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
            self.points.len(),
            self.cell_count()
        )?;
        declare_fields(out, &mut appended, "PointData", &self.point_fields)?;
        declare_fields(out, &mut appended, "CellData", &self.cell_fields)?;
        let points = Field::new("Points", Values::Vectors(self.points));
        declare_fields(out, &mut appended, "Points", &[points])?;
        self.declare_cells(out, &mut appended)?;
        writeln!(out, "    </Piece>")?;
        writeln!(out, "  </UnstructuredGrid>")?;
        appended.write(out)?;
        writeln!(out, "</VTKFile>")?;
        Ok(())
    }

    fn declare_facts<'s>(
        &'s self,
        out: &mut dyn Write,
        appended: &mut Appended<'s>,
    ) -> Result<(), WriteError> {
        writeln!(out, "    <FieldData>")?;
        for (name, fact) in &self.facts {
            let (data, count) = match fact {
                Fact::Numbers(values) => (Data::F64(values), values.len()),
                Fact::Integers(values) => (Data::I64(values.into()), values.len()),
                Fact::Text(_) => continue,
            };
            let attributes = format!(" NumberOfTuples=\"{count}\"");
            appended.declare(out, name, &attributes, data)?;
        }
        writeln!(out, "    </FieldData>")?;
        Ok(())
    }

    fn declare_cells<'s>(
        &'s self,
        out: &mut dyn Write,
        appended: &mut Appended<'s>,
    ) -> Result<(), WriteError> {
        let blocks = || self.cells.iter().map(|c| (c, c.shape.node_count()));
        let connectivity: Vec<i64> = self
            .cells
            .iter()
            .flat_map(|cells| cells.connectivity)
            .map(|&point| point as i64)
            .collect();
        let offsets: Vec<i64> = blocks()
            .flat_map(|(cells, nodes)| std::iter::repeat_n(nodes, cells.connectivity.len() / nodes))
            .scan(0, |end, nodes| {
                *end += nodes as i64;
                Some(*end)
            })
            .collect();
        let types: Vec<u8> = blocks()
            .flat_map(|(cells, nodes)| {
                std::iter::repeat_n(cells.shape.vtk_type(), cells.connectivity.len() / nodes)
            })
            .collect();
        writeln!(out, "      <Cells>")?;
        appended.declare(out, "connectivity", "", Data::I64(connectivity.into()))?;
        appended.declare(out, "offsets", "", Data::I64(offsets.into()))?;
        appended.declare(out, "types", "", Data::U8(types.into()))?;
        writeln!(out, "      </Cells>")?;
        Ok(())
    }

    fn check(&self) -> Result<(), WriteError> {
        let points = self.points.len();
        check_finite("Points", "node", self.points.as_flattened(), 3)?;
        let mut first = 0;
        for cells in &self.cells {
            let nodes = cells.shape.node_count();
            if !cells.connectivity.len().is_multiple_of(nodes) {
                return Err(WriteError::Length {
                    field: "connectivity".to_owned(),
                    expected: cells.connectivity.len().next_multiple_of(nodes),
                    found: cells.connectivity.len(),
                });
            }
            if let Some(i) = cells.connectivity.iter().position(|&p| p >= points) {
                return Err(WriteError::Connectivity {
                    cell: first + i / nodes,
                    point: cells.connectivity[i],
                    points,
                });
            }
            first += cells.connectivity.len() / nodes;
        }
        check_fields(&self.point_fields, "node", points)?;
        check_fields(&self.cell_fields, "cell", self.cell_count())?;
        for (name, fact) in &self.facts {
            if let Fact::Numbers(values) = fact {
                check_finite(name, "entry", values, 1)?;
            }
        }
        Ok(())
    }
}

/// `place` is what the fields have values on.
fn check_fields(fields: &[Field<'_>], place: &str, count: usize) -> Result<(), WriteError> {
    for (i, field) in fields.iter().enumerate() {
        if fields[..i].iter().any(|other| other.name == field.name) {
            return Err(WriteError::Name {
                name: field.name.to_owned(),
                reason: "two fields have it",
            });
        }
        let components = field.values.components().len();
        let data = field.values.data();
        if data.len() != components * count {
            return Err(WriteError::Length {
                field: field.name.to_owned(),
                expected: components * count,
                found: data.len(),
            });
        }
        if let Data::F64(values) = data {
            check_finite(field.name, place, values, components)?;
        }
    }
    Ok(())
}

fn check_finite(
    field: &str,
    place: &str,
    values: &[f64],
    components: usize,
) -> Result<(), WriteError> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(i) => Err(WriteError::NotFinite {
            field: field.to_owned(),
            place: match components {
                1 => format!("{place} {i}"),
                n => format!("{place} {}, component {}", i / n, i % n),
            },
            value: values[i],
        }),
    }
}

fn declare_fields<'a>(
    out: &mut dyn Write,
    appended: &mut Appended<'a>,
    section: &str,
    fields: &[Field<'a>],
) -> Result<(), WriteError> {
    writeln!(out, "      <{section}>")?;
    for field in fields {
        let components = field.values.components();
        let mut attributes = String::new();
        if components.len() > 1 {
            attributes = format!(" NumberOfComponents=\"{}\"", components.len());
            for (i, name) in components.iter().enumerate() {
                attributes.push_str(&format!(" ComponentName{i}=\"{name}\""));
            }
        }
        appended.declare(out, field.name, &attributes, field.values.data())?;
    }
    writeln!(out, "      </{section}>")?;
    Ok(())
}

/// Text inside a comment, where no two hyphens may stand in a row.
fn comment(text: &str) -> String {
    let mut text = escape(text);
    while text.contains("--") {
        text = text.replace("--", "- -");
    }
    text
}
