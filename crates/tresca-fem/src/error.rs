//! The one error type of the crate.

use crate::constraints::equation::Dof;
use crate::mesh::kind::CellKind;
use crate::mesh::space::Space;

/// What can be wrong with a mesh, a material, a support or a load.
///
/// Node, cell and face numbers count from zero, as everywhere in the crate.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FemError {
    /// A brick or rectangle has fewer than two nodes along an axis.
    #[error("a structured mesh needs at least 2 nodes along {axis}, found {found}")]
    TooFewNodes {
        /// The axis: x, y or z.
        axis: char,
        /// The number given.
        found: usize,
    },
    /// A brick or rectangle with min ≥ max, or with a bound that is no finite number.
    #[error(
        "a structured mesh needs finite min < max along {axis}, found min = {min}, max = {max}"
    )]
    EmptyBox {
        /// The axis: x, y or z.
        axis: char,
        /// Lower bound given.
        min: f64,
        /// Upper bound given.
        max: f64,
    },
    /// A rectangle in three-dimensional space.
    #[error("a rectangle is a plane or an axisymmetric mesh, not a solid one")]
    SolidRectangle,
    /// A rectangle of cells that cannot fill one.
    #[error("a rectangle is made of quad4 or tri3 cells, found {kind}")]
    RectangleCells {
        /// The cell kind given.
        kind: CellKind,
    },
    /// A material for plane stress on a mesh that is not plane.
    #[error("plane stress needs a plane mesh, found {space}")]
    PlaneStress {
        /// The mesh's space.
        space: Space,
    },
    /// B-bar strains of cells that they are not made for.
    #[error(
        "B-bar is for hex8, wedge6 and quad4 cells, found {kind}: {}",
        b_bar_remedy(*kind)
    )]
    BBarCells {
        /// The first such kind.
        kind: CellKind,
    },
    /// B-bar strains under plane stress.
    #[error(
        "B-bar is not for plane stress, where the thickness is free to change and nothing locks: use the \
         full formulation"
    )]
    BBarPlaneStress,
    /// A name that no formulation has.
    #[error("there is no formulation \"{name}\"; known are full, b_bar")]
    UnknownFormulation {
        /// The name given.
        name: String,
    },
    /// A coordinate is NaN or infinite.
    #[error("node {node} has a coordinate that is no finite number: {point:?}")]
    PointNotFinite {
        /// The node.
        node: usize,
        /// Its coordinates.
        point: [f64; 3],
    },
    /// A point of a plane mesh lies off the plane.
    #[error("node {node} of a plane mesh has z = {z}, expected 0")]
    PointOffPlane {
        /// The node.
        node: usize,
        /// Its third coordinate.
        z: f64,
    },
    /// A point of an axisymmetric mesh lies on the wrong side of the axis.
    #[error("node {node} of an axisymmetric mesh has the radius x = {radius}, expected x >= 0")]
    NegativeRadius {
        /// The node.
        node: usize,
        /// Its first coordinate.
        radius: f64,
    },
    /// A connectivity whose length is no multiple of the cell's node count.
    #[error(
        "block {block} of {kind} cells has {found} node numbers, which is no multiple of {nodes}"
    )]
    RaggedConnectivity {
        /// The cell block.
        block: usize,
        /// Kind of its cells.
        kind: CellKind,
        /// Nodes per cell.
        nodes: usize,
        /// Length of the connectivity.
        found: usize,
    },
    /// A cell kind that does not fill the mesh's space.
    #[error("block {block} holds {kind} cells, which do not fill the space of the mesh ({space})")]
    CellDimension {
        /// The cell block.
        block: usize,
        /// Kind of its cells.
        kind: CellKind,
        /// The mesh's space.
        space: Space,
    },
    /// A cell refers to a node that does not exist.
    #[error("cell {cell} refers to node {node}, but the mesh has {count} nodes")]
    NodeOutOfRange {
        /// The cell.
        cell: usize,
        /// The node it names.
        node: usize,
        /// Number of nodes of the mesh.
        count: usize,
    },
    /// A node that belongs to no cell: it would make the stiffness singular.
    #[error("node {node} belongs to no cell")]
    UnusedNode {
        /// The first such node.
        node: usize,
    },
    /// A face set names a face that does not exist.
    #[error("face set \"{set}\" names face {local} of cell {cell}, which does not exist")]
    FaceOutOfRange {
        /// The face set.
        set: String,
        /// The cell it names.
        cell: usize,
        /// The local face it names.
        local: usize,
    },
    /// A node set names a node that does not exist.
    #[error("node set \"{set}\" names node {node}, but the mesh has {count} nodes")]
    NodeOfSetOutOfRange {
        /// The node set.
        set: String,
        /// The node it names.
        node: usize,
        /// Number of nodes of the mesh.
        count: usize,
    },
    /// A name that no kind of cells has.
    #[error(
        "there are no cells of kind \"{name}\"; known are {}",
        CellKind::ALL.map(CellKind::name).join(", ")
    )]
    UnknownCellKind {
        /// The name given.
        name: String,
    },
    /// A face set that the mesh does not have.
    #[error("there is no face set \"{name}\"; the mesh has: {}", known.join(", "))]
    UnknownFaceSet {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// The map from the reference cell turns inside out.
    #[error(
        "cell {cell}, around {}, is turned inside out: det J = {determinant:.3e} at most (expected > 0); \
         are its nodes numbered the other way round?",
        place(position)
    )]
    InvertedCell {
        /// The lowest such cell.
        cell: usize,
        /// The mean of its nodes' positions.
        position: [f64; 3],
        /// The largest determinant at an integration point.
        determinant: f64,
    },
    /// The map from the reference cell turns inside out in a part of the cell.
    #[error(
        "cell {cell}, around {}, is folded: det J falls to {determinant:.3e} at an integration point \
         (expected > 0 at all of them); a corner has been pushed in, or a middle node lies too far from \
         the middle of its edge",
        place(position)
    )]
    FoldedCell {
        /// The lowest such cell.
        cell: usize,
        /// The mean of its nodes' positions.
        position: [f64; 3],
        /// The smallest determinant at an integration point.
        determinant: f64,
    },
    /// The map from the reference cell collapses.
    #[error(
        "cell {cell}, around {}, is degenerate: it has no volume at an integration point (expected \
         det J > 0); nodes coincide or lie in one plane",
        place(position)
    )]
    DegenerateCell {
        /// The lowest such cell.
        cell: usize,
        /// The mean of its nodes' positions.
        position: [f64; 3],
    },
    /// Cells of a kind that cannot be made of those there are.
    #[error("{from} cells cannot be turned into {to} cells")]
    CellConversion {
        /// Kind of the cells there are.
        from: CellKind,
        /// Kind asked for.
        to: CellKind,
    },
    /// Cells whose cut faces would not meet.
    #[error(
        "the cells cannot be cut into {to} cells that meet face to face: hexahedra must be stacked along \
         their third direction"
    )]
    CutsDoNotMatch {
        /// Kind asked for.
        to: CellKind,
    },
    /// Young's modulus is not positive and finite.
    #[error("Young's modulus must be positive and finite, found {found}")]
    Young {
        /// The value given.
        found: f64,
    },
    /// Poisson's ratio is outside (−1, ½).
    #[error("Poisson's ratio must lie strictly between -1 and 0.5, found {found}")]
    Poisson {
        /// The value given.
        found: f64,
    },
    /// A dof is given two different displacements.
    #[error("component {component} of node {node} is prescribed twice: {first} and {second}")]
    ConflictingSupport {
        /// The node.
        node: usize,
        /// The component (0, 1 or 2).
        component: usize,
        /// The value given first.
        first: f64,
        /// The value given later.
        second: f64,
    },
    /// A support at a dof that does not exist, or with a value that is no number.
    #[error(
        "cannot prescribe component {component} of node {node} to {value}: the body has {nodes} nodes of {components} components, and the value must be finite"
    )]
    InvalidSupport {
        /// The node.
        node: usize,
        /// The component.
        component: usize,
        /// The value.
        value: f64,
        /// Nodes of the body.
        nodes: usize,
        /// Components per node.
        components: usize,
    },
    /// An equation that cannot be read as one.
    #[error("equation {equation} is none: {what}")]
    InvalidEquation {
        /// Number of the equation.
        equation: usize,
        /// What is wrong with it.
        what: &'static str,
    },
    /// The dependent dof of an equation is held by a support.
    #[error(
        "equation {equation} is to determine {dof}, which a support holds; put another of its dofs first"
    )]
    DependentHeld {
        /// Number of the equation.
        equation: usize,
        /// Its dependent dof.
        dof: Dof,
    },
    /// Two equations have the same dependent dof.
    #[error(
        "equations {} and {} are both to determine {dof}; put another dof first in one of them",
        equations[0], equations[1]
    )]
    DependentTwice {
        /// Numbers of the equations.
        equations: [usize; 2],
        /// The dependent dof of both.
        dof: Dof,
    },
    /// Equations refer to each other such that a dependent dof drops out.
    #[error(
        "equation {equation}, between {}, does not determine {} any more once {} put in: they refer to \
         each other in a circle; put another dof first",
        listed(dofs), dofs[0], equations_are(others)
    )]
    EquationCircle {
        /// Number of the equation.
        equation: usize,
        /// Its dofs, the dependent one first.
        dofs: Vec<Dof>,
        /// Numbers of the equations that it was combined with.
        others: Vec<usize>,
    },
    /// An equation that others, or supports, imply.
    #[error(
        "equation {equation}, between {}, says nothing new once {} put in and supports hold what they hold",
        listed(dofs),
        equations_are(others)
    )]
    RedundantEquation {
        /// Number of the equation.
        equation: usize,
        /// Its dofs, the dependent one first.
        dofs: Vec<Dof>,
        /// Numbers of the equations that imply it.
        others: Vec<usize>,
    },
    /// An equation that others, or supports, contradict.
    #[error(
        "equation {equation}, between {}, cannot hold once {} put in and supports hold what they hold: \
         its two sides differ by {excess:.3e}",
        listed(dofs),
        equations_are(others)
    )]
    ContradictoryEquation {
        /// Number of the equation.
        equation: usize,
        /// Its dofs, the dependent one first.
        dofs: Vec<Dof>,
        /// Numbers of the equations that contradict it.
        others: Vec<usize>,
        /// Left side minus right side.
        excess: f64,
    },
    /// Nodes that cannot carry a coupling.
    #[error("the coupling of {nodes} nodes {what}")]
    Coupling {
        /// Number of nodes given.
        nodes: usize,
        /// What is wrong.
        what: &'static str,
    },
    /// Two nodes that are to be tied do not lie where the symmetry puts them.
    #[error(
        "node {node} lies {distance:.3e} away from where the symmetry puts node {partner}, {}",
        place(expected)
    )]
    NotImages {
        /// The dependent node.
        node: usize,
        /// The node that it is tied to.
        partner: usize,
        /// The image of the partner.
        expected: [f64; 3],
        /// How far the node is from there.
        distance: f64,
    },
    /// An initial strain for another mesh, or of values that are no numbers.
    #[error(
        "an initial strain needs {expected} values, one per {per}, all finite; found {given}, of which \
         {finite} are finite"
    )]
    InitialStrain {
        /// What there is one value for.
        per: &'static str,
        /// Number of values expected.
        expected: usize,
        /// Number of values given.
        given: usize,
        /// How many of them are finite.
        finite: usize,
    },
}

/// The first dofs of a list.
fn listed(dofs: &[Dof]) -> String {
    const SHOWN: usize = 4;
    let shown: Vec<String> = dofs.iter().take(SHOWN).map(Dof::to_string).collect();
    let rest = dofs.len().saturating_sub(SHOWN);
    let more = if rest > 0 {
        format!(" and {rest} more")
    } else {
        String::new()
    };
    format!("{}{more}", shown.join(", "))
}

/// "equation 3 is", "equations 1, 2 are", "no other is".
fn equations_are(numbers: &[usize]) -> String {
    let names: Vec<String> = numbers.iter().map(usize::to_string).collect();
    match numbers.len() {
        0 => "no other is".to_owned(),
        1 => format!("equation {} is", names[0]),
        _ => format!("equations {} are", names.join(", ")),
    }
}

/// What to do about cells without a B-bar formulation.
fn b_bar_remedy(kind: CellKind) -> &'static str {
    match kind {
        CellKind::Tet4 => "use tet10 cells, which do not lock",
        CellKind::Tri3 => "use tri6 cells, which do not lock",
        _ => "the full formulation of quadratic cells does not lock",
    }
}

/// A point for people: six digits each.
fn place(point: &[f64; 3]) -> String {
    let [x, y, z] = point.map(|x| format!("{x:.5e}").parse().unwrap_or(x));
    format!("({x}, {y}, {z})")
}
