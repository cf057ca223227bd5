//! Keys of the mesh of a body.

use serde::Deserialize;
use toml::Spanned;
use tresca_fem::mesh::CellKind;

use super::super::entries::{Pair, Triple};

/// `mesh`: where the mesh comes from, and where it goes. One of `brick`, `rectangle` and `file` is
/// given, which is checked afterwards, so that the report can say so.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ brick = { … } }`, `{ rectangle = { … } }` or `{ file = \"….msh\" }`"
)]
pub(crate) struct MeshKeys {
    /// A box.
    pub brick: Option<Spanned<Brick>>,
    /// A rectangle.
    pub rectangle: Option<Spanned<Rectangle>>,
    /// Path of a mesh file, relative to the case file.
    pub file: Option<Spanned<String>>,
    /// The group of the file that is the body. Default: all of it.
    pub part: Option<Spanned<String>>,
    /// Factor of all coordinates, positive. Default: 1.
    pub scale: Option<Spanned<f64>>,
    /// A rotation, behind the scale.
    pub rotate: Option<Spanned<RotateKeys>>,
    /// A translation (length), behind the rotation.
    pub translate: Option<Spanned<Vec<Spanned<f64>>>>,
}

/// `rotate`: a rotation by the right-hand rule.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table `{ axis = …, angle = … }`")]
pub(crate) struct RotateKeys {
    /// Direction of the axis. Default in the plane: that of z.
    pub axis: Option<Spanned<Triple<f64>>>,
    /// Angle in degrees.
    pub angle: Spanned<f64>,
    /// A point of the axis (length). Default: the origin.
    pub about: Option<Spanned<Vec<Spanned<f64>>>>,
}

/// `brick`: a box with edges along the axes. Its faces are called `x-`, `x+`, `y-`, `y+`, `z-`, `z+`.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ min = …, max = …, nodes = … }`"
)]
pub struct Brick {
    /// Corner with the smallest coordinates (length).
    pub min: Spanned<Triple<f64>>,
    /// Corner with the largest coordinates (length), each larger than in `min`.
    pub max: Spanned<Triple<f64>>,
    /// Number of corner nodes along x, y and z, ends included; at least 2 each.
    pub nodes: Spanned<Triple<usize>>,
    /// What it is cut into.
    #[serde(default)]
    pub cells: BrickCells,
}

/// `cells` of a brick: what each of its boxes becomes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase", expecting = "the name of a kind of cells")]
pub enum BrickCells {
    /// Eight-node hexahedra.
    #[default]
    Hex8,
    /// Twenty-node hexahedra.
    Hex20,
    /// Twenty-seven-node hexahedra.
    Hex27,
    /// Six four-node tetrahedra.
    Tet4,
    /// Six ten-node tetrahedra.
    Tet10,
    /// Two six-node wedges.
    Wedge6,
}

impl BrickCells {
    /// The kind of the cells.
    pub fn kind(self) -> CellKind {
        match self {
            BrickCells::Hex8 => CellKind::Hex8,
            BrickCells::Hex20 => CellKind::Hex20,
            BrickCells::Hex27 => CellKind::Hex27,
            BrickCells::Tet4 => CellKind::Tet4,
            BrickCells::Tet10 => CellKind::Tet10,
            BrickCells::Wedge6 => CellKind::Wedge6,
        }
    }
}

/// `rectangle`: a rectangle with edges along the axes. Its faces are called `x-`, `x+`, `y-`, `y+`.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ min = …, max = …, nodes = … }`"
)]
pub struct Rectangle {
    /// Corner with the smallest coordinates (length); in an axisymmetric case x is a radius.
    pub min: Spanned<Pair<f64>>,
    /// Corner with the largest coordinates (length), each larger than in `min`.
    pub max: Spanned<Pair<f64>>,
    /// Number of corner nodes along x and y, ends included; at least 2 each.
    pub nodes: Spanned<Pair<usize>>,
    /// What it is cut into.
    #[serde(default)]
    pub cells: PlaneCells,
}

/// `cells` of a rectangle: what each of its small rectangles becomes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase", expecting = "the name of a kind of cells")]
pub enum PlaneCells {
    /// Four-node quadrilaterals.
    #[default]
    #[serde(alias = "quad")]
    Quad4,
    /// Eight-node quadrilaterals.
    Quad8,
    /// Nine-node quadrilaterals.
    Quad9,
    /// Two three-node triangles.
    #[serde(alias = "triangle")]
    Tri3,
    /// Two six-node triangles.
    Tri6,
}

impl PlaneCells {
    /// The kind of the cells.
    pub fn kind(self) -> CellKind {
        match self {
            PlaneCells::Quad4 => CellKind::Quad4,
            PlaneCells::Quad8 => CellKind::Quad8,
            PlaneCells::Quad9 => CellKind::Quad9,
            PlaneCells::Tri3 => CellKind::Tri3,
            PlaneCells::Tri6 => CellKind::Tri6,
        }
    }
}
