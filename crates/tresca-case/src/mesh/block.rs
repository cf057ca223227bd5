//! Bricks and rectangles: keys, and what they can be.

use serde::Deserialize;
use tresca_fem::FemError;
use tresca_fem::mesh::{self, BrickSpec, CellKind, Mesh, RectangleSpec, Space};
use tresca_io::located::Span;

use crate::analysis::Analysis;
use crate::error::{CaseError, FaultKind};
use crate::expression::names::VARIABLES;
use crate::numbers::Components;
use crate::reader::Reader;
use crate::text::at::At;

/// Nodes that one body may have. Three unknowns per node: a hundred million nodes are beyond any
/// direct factorisation, so a larger number is a slip of the pen, better said before memory runs out.
pub const MAX_NODES: usize = 100_000_000;

/// `brick`: a box with edges along the axes. Its faces are called `x-`, `x+`, `y-`, `y+`, `z-`, `z+`.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ min = …, max = …, nodes = … }`"
)]
pub(crate) struct BrickKeys {
    /// Corner with the smallest coordinates (length).
    pub min: At<Components<f64, 3>>,
    /// Corner with the largest coordinates (length), each larger than in `min`.
    pub max: At<Components<f64, 3>>,
    /// Number of corner nodes along x, y and z, ends included; at least 2 each.
    pub nodes: At<Components<usize, 3>>,
    /// What it is cut into.
    #[serde(default)]
    pub cells: BrickCells,
}

/// `cells` of a brick: what each of its boxes becomes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase", expecting = "the name of a kind of cells")]
pub(crate) enum BrickCells {
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
    fn kind(self) -> CellKind {
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
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ min = …, max = …, nodes = … }`"
)]
pub(crate) struct RectangleKeys {
    /// Corner with the smallest coordinates (length); in an axisymmetric case x is a radius.
    pub min: At<Components<f64, 2>>,
    /// Corner with the largest coordinates (length), each larger than in `min`.
    pub max: At<Components<f64, 2>>,
    /// Number of corner nodes along x and y, ends included; at least 2 each.
    pub nodes: At<Components<usize, 2>>,
    /// What it is cut into.
    #[serde(default)]
    pub cells: PlaneCells,
}

/// `cells` of a rectangle: what each of its small rectangles becomes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase", expecting = "the name of a kind of cells")]
pub(crate) enum PlaneCells {
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
    fn kind(self) -> CellKind {
        match self {
            PlaneCells::Quad4 => CellKind::Quad4,
            PlaneCells::Quad8 => CellKind::Quad8,
            PlaneCells::Quad9 => CellKind::Quad9,
            PlaneCells::Tri3 => CellKind::Tri3,
            PlaneCells::Tri6 => CellKind::Tri6,
        }
    }
}

impl Reader<'_> {
    /// The outer error is one of the keys, the inner one of the finite elements.
    pub(super) fn brick(&self, keys: &At<BrickKeys>) -> Result<Result<Mesh, FemError>, CaseError> {
        self.right_dimension(3, &keys.span())?;
        self.block("brick", &keys.min, &keys.max, &keys.nodes)?;
        let mesh = mesh::brick(&BrickSpec {
            min: keys.min.values(),
            max: keys.max.values(),
            nodes: keys.nodes.values(),
        });
        Ok(mesh.and_then(|mesh| mesh.with_cells(keys.cells.kind())))
    }

    /// As [`Reader::brick`]. `placed`: its coordinates are not yet those of the body.
    pub(super) fn rectangle(
        &self,
        keys: &At<RectangleKeys>,
        placed: bool,
    ) -> Result<Result<Mesh, FemError>, CaseError> {
        self.right_dimension(2, &keys.span())?;
        self.block("rectangle", &keys.min, &keys.max, &keys.nodes)?;
        if !placed {
            self.right_of_axis(keys)?;
        }
        let mesh = mesh::rectangle(&RectangleSpec {
            // Where a radius is negative is seen when the mesh is in its place.
            space: Space::Plane,
            min: keys.min.values(),
            max: keys.max.values(),
            nodes: keys.nodes.values(),
            cells: keys.cells.kind().linear(),
        });
        Ok(mesh.and_then(|mesh| mesh.with_cells(keys.cells.kind())))
    }

    fn right_dimension(&self, dimension: usize, span: &Span) -> Result<(), CaseError> {
        if dimension == self.analysis.dimension() {
            return Ok(());
        }
        let (word, other, help) = match dimension {
            3 => (
                "brick",
                "rectangle",
                "without the key `analysis` a case is about bodies in space",
            ),
            _ => (
                "rectangle",
                "brick",
                "plane cases have the key `analysis` at the top of the file: `plane_strain`, \
                 `plane_stress` or `axisymmetric`",
            ),
        };
        let analysis = self.analysis.word();
        let fault = self
            .fault(
                FaultKind::BadValue,
                span.clone(),
                format!("a {word} does not belong in a case with `analysis = \"{analysis}\"`"),
                format!("expected `{other}`"),
            )
            .with_help(help);
        Err(match &self.analysis_span {
            Some(span) => fault.and_at(span.clone(), "the analysis"),
            None => fault,
        })
    }

    fn right_of_axis(&self, rectangle: &RectangleKeys) -> Result<(), CaseError> {
        let radius = &rectangle.min.value.0[0];
        if self.analysis != Analysis::Axisymmetric || radius.value >= 0.0 {
            return Ok(());
        }
        Err(self
            .fault(
                FaultKind::BadValue,
                radius.span(),
                "the body crosses the axis of revolution",
                format!("expected a radius of 0 or more, found {:?}", radius.value),
            )
            .with_help("in an axisymmetric case x is the radius and y runs along the axis"))
    }

    /// A box or rectangle; `word` is what reports call it.
    fn block<const N: usize>(
        &self,
        word: &str,
        low: &At<Components<f64, N>>,
        high: &At<Components<f64, N>>,
        nodes: &At<Components<usize, N>>,
    ) -> Result<(), CaseError> {
        let volume_word = if N == 2 { "area" } else { "volume" };
        self.finite_components("the corner `min`", low)?;
        self.finite_components("the corner `max`", high)?;
        self.nodes(nodes)?;
        let mut volume = 1.0;
        for (axis, letter) in VARIABLES.into_iter().enumerate().take(N) {
            let (low, high) = (&low.value.0[axis], &high.value.0[axis]);
            let (min, max) = (low.value, high.value);
            let cells = (nodes.value.0[axis].value - 1) as f64;
            let extent = max - min;
            volume *= extent;
            // Neighbouring nodes must differ by more than rounding of their coordinates.
            let resolved = extent / cells > 4.0 * f64::EPSILON * min.abs().max(max.abs());
            if extent > 0.0 && extent.is_finite() && resolved {
                continue;
            }
            let (message, help) = if extent < 0.0 {
                (
                    format!("the {word} is turned inside out: `min` exceeds `max` along {letter}"),
                    "`min` and `max` are probably exchanged",
                )
            } else if extent == 0.0 {
                (
                    format!("the {word} has zero {volume_word}: no extent along {letter}"),
                    "a body is solid; give it an extent in every direction",
                )
            } else {
                (
                    format!("the nodes along {letter} cannot be told apart in double precision"),
                    "move the body closer to the origin, or choose another unit of length",
                )
            };
            return Err(self
                .fault(
                    FaultKind::BadValue,
                    high.span(),
                    message,
                    format!("expected more than {min:?}, found {max:?}"),
                )
                .and_at(low.span(), "the other end")
                .with_help(help));
        }
        if f64::is_normal(volume) {
            return Ok(());
        }
        let extents = if N == 2 { "two" } else { "three" };
        Err(self
            .fault(
                FaultKind::BadValue,
                high.span(),
                format!("the {volume_word} of the {word} is beyond the range of numbers"),
                format!("the product of the {extents} extents is {volume:?}"),
            )
            .with_help("choose another unit of length"))
    }

    fn nodes<const N: usize>(&self, nodes: &At<Components<usize, N>>) -> Result<(), CaseError> {
        for (count, letter) in nodes.value.0.iter().zip(VARIABLES) {
            if count.value < 2 {
                return Err(self
                    .fault(
                        FaultKind::BadValue,
                        count.span(),
                        format!("too few nodes along {letter}"),
                        format!("expected 2 or more, found {}", count.value),
                    )
                    .with_help("nodes are counted with both ends: 2 nodes make one element"));
            }
        }
        let product = nodes
            .value
            .values()
            .iter()
            .try_fold(1_usize, |product, &count| product.checked_mul(count));
        if product.is_some_and(|product| product <= MAX_NODES) {
            return Ok(());
        }
        let found = product.map_or("more than can be counted".to_owned(), |n| n.to_string());
        Err(self
            .fault(
                FaultKind::BadValue,
                nodes.span(),
                "too many nodes",
                format!("expected at most {MAX_NODES} in all, found {found}"),
            )
            .with_help(if N == 2 {
                "the two counts are multiplied: [41, 41] are 1681 nodes"
            } else {
                "the three counts are multiplied: [41, 41, 41] are 68921 nodes"
            }))
    }
}
