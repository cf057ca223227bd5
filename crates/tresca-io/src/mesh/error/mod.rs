//! What can be wrong with a mesh file.

mod words;

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use tresca_fem::FemError;
use tresca_fem::mesh::Space;

use words::{
    cell_word, found_cells, group_word, known_groups, members_word, nearest_hint, no_cells_help,
};

/// A place in a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub path: PathBuf,
    /// Where in it.
    pub position: Position,
}

/// Where in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// A line of text, from 1.
    Line(usize),
    /// A byte of a binary part, from 0.
    Byte(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display();
        match self.position {
            Position::Line(line) => write!(f, "{path}:{line}"),
            Position::Byte(byte) => write!(f, "{path}, byte {byte}"),
        }
    }
}

/// Why a mesh file was refused. Elements and nodes go by the numbers that the file gives them.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum MeshFileError {
    /// The operating system refused.
    #[error("cannot read the mesh file `{}`: {source}", path.display())]
    #[diagnostic(code(mesh::unreadable))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        #[source]
        source: io::Error,
    },

    /// Neither Gmsh's format nor an Abaqus deck.
    #[error("`{}` is no mesh file of a known format: it begins with `{found}`", path.display())]
    #[diagnostic(
        code(mesh::format),
        help(
            "read are Gmsh's .msh files (versions 2.2 and 4.1) and Abaqus or CalculiX decks (.inp)"
        )
    )]
    Format {
        /// The file.
        path: PathBuf,
        /// Its first characters.
        found: String,
    },

    /// A version of Gmsh's format that is not read.
    #[error("{place}: the MSH format of version {found} is not read")]
    #[diagnostic(
        code(mesh::version),
        help(
            "save the mesh as version 4.1 or 2.2: `gmsh -format msh41`, or the option `Mesh.MshFileVersion = 4.1;`"
        )
    )]
    Version {
        /// Where it stands.
        place: Place,
        /// The version as written.
        found: String,
    },

    /// The file ends before it is complete.
    #[error("{place}: the file ends where {expected} is expected")]
    #[diagnostic(
        code(mesh::truncated),
        help(
            "the file is cut off: was the disk full, or is the program that writes it still running?"
        )
    )]
    Truncated {
        /// The end.
        place: Place,
        /// What should follow.
        expected: String,
    },

    /// Something else stands where the format wants a certain thing.
    #[error("{place}: expected {expected}, found {found}")]
    #[diagnostic(code(mesh::syntax))]
    Syntax {
        /// Where it stands.
        place: Place,
        /// What should be there.
        expected: String,
        /// What is there.
        found: String,
        /// The likely cause.
        #[help]
        help: Option<String>,
    },

    /// A part of the format that is not supported.
    #[error("{place}: {what} is not supported")]
    #[diagnostic(code(mesh::unsupported))]
    Unsupported {
        /// Where it stands.
        place: Place,
        /// What it is.
        what: String,
        /// What to do instead.
        #[help]
        help: String,
    },

    /// An element of a type that is not supported.
    #[error("{place}: element {element} is of the type {name}, which is not supported")]
    #[diagnostic(
        code(mesh::element_type),
        help(
            "supported are tetrahedra (4 or 10 nodes), hexahedra (8, 20, 27), wedges (6), triangles (3, 6), quadrilaterals (4, 8, 9) and lines (2, 3); \
              in Gmsh, `Mesh.ElementOrder` is 1 or 2"
        )
    )]
    ElementType {
        /// Where it stands.
        place: Place,
        /// Its number.
        element: u64,
        /// The type in the words of the format.
        name: String,
    },

    /// An element that names a node which the file does not have.
    #[error("{place}: element {element} refers to node {node}, which the file does not have")]
    #[diagnostic(
        code(mesh::unknown_node),
        help("the file was put together or cut by hand, or its nodes were exported only in part")
    )]
    UnknownNode {
        /// Where it stands.
        place: Place,
        /// The element.
        element: u64,
        /// The node that it names.
        node: u64,
    },

    /// Two nodes or elements with one number.
    #[error("{place}: there are two {what}s with the number {number}")]
    #[diagnostic(
        code(mesh::duplicate_number),
        help("files that were joined by hand need numbers that do not overlap")
    )]
    DuplicateNumber {
        /// Where the second one stands.
        place: Place,
        /// Node or element.
        what: &'static str,
        /// The number.
        number: u64,
    },

    /// A coordinate that is NaN or infinite.
    #[error("{place}: node {node} has a coordinate that is no finite number: {point:?}")]
    #[diagnostic(
        code(mesh::not_finite),
        help("the program that wrote the mesh has failed; mesh the geometry again")
    )]
    NotFinite {
        /// Where it stands.
        place: Place,
        /// The node.
        node: u64,
        /// Its coordinates.
        point: [f64; 3],
    },

    /// No cells that could fill a body.
    #[error("`{}` has no {} elements: {}", path.display(), cell_word(*dimension), found_cells(*found))]
    #[diagnostic(code(mesh::no_cells), help("{}", no_cells_help(*dimension, *found)))]
    NoCells {
        /// The file.
        path: PathBuf,
        /// Dimension of the space that asks.
        dimension: usize,
        /// Elements of dimension 1, 2 and 3 that the file has.
        found: [usize; 3],
    },

    /// A mesh of solids for a plane case.
    #[error("`{}` has volume elements, but the case is about bodies in a plane ({space})", path.display())]
    #[diagnostic(
        code(mesh::dimension),
        help(
            "mesh a plane surface for a plane or axisymmetric case, or leave out the key `analysis` for bodies in space"
        )
    )]
    NotPlane {
        /// The file.
        path: PathBuf,
        /// The space that asks.
        space: Space,
    },

    /// A group that is not there.
    #[error("`{}` has no {} group `{name}`{}", path.display(), group_word(*dimension), nearest_hint(name, known))]
    #[diagnostic(code(mesh::unknown_group), help("{}", known_groups(*dimension, known)))]
    UnknownGroup {
        /// The file.
        path: PathBuf,
        /// The name asked for.
        name: String,
        /// The dimension asked for.
        dimension: usize,
        /// The groups of this dimension.
        known: Vec<String>,
    },

    /// A group of another dimension than asked for.
    #[error("the group `{name}` of `{}` is no {} group: it consists of {}", path.display(), group_word(*expected), members_word(*found))]
    #[diagnostic(
        code(mesh::group_dimension),
        help(
            "in Gmsh, bodies are physical volumes (in the plane: surfaces), and the places where something acts on them physical surfaces (in the plane: curves)"
        )
    )]
    GroupDimension {
        /// The file.
        path: PathBuf,
        /// The group.
        name: String,
        /// The dimension asked for.
        expected: usize,
        /// The dimension it has.
        found: usize,
    },

    /// A cell that is turned inside out.
    #[error("{element} of `{}` is turned inside out (its centre is at {centre:?})", path.display())]
    #[diagnostic(
        code(mesh::inverted),
        help(
            "mesh the place again, finer or with optimisation (Gmsh: `Mesh.Optimize = 1`); if all elements are inverted, the program that wrote the file numbers their nodes in another order"
        )
    )]
    Inverted {
        /// The file.
        path: PathBuf,
        /// The element in words.
        element: String,
        /// The mean of its nodes (length).
        centre: [f64; 3],
    },

    /// A cell that is turned inside out in a part.
    #[error("{element} of `{}` is folded (its centre is at {centre:?})", path.display())]
    #[diagnostic(
        code(mesh::folded),
        help(
            "a corner is pushed in, or a middle node lies too far from the middle of its edge, which happens where few quadratic elements follow a strong curve; \
             mesh the place finer, or use `Mesh.HighOrderOptimize = 2` in Gmsh"
        )
    )]
    Folded {
        /// The file.
        path: PathBuf,
        /// The element in words.
        element: String,
        /// The mean of its nodes (length).
        centre: [f64; 3],
    },

    /// A cell without volume.
    #[error("{element} of `{}` has no volume (its centre is at {centre:?})", path.display())]
    #[diagnostic(
        code(mesh::degenerate),
        help("nodes of the element coincide or lie in one plane; mesh the place again")
    )]
    Degenerate {
        /// The file.
        path: PathBuf,
        /// The element in words.
        element: String,
        /// The mean of its nodes (length).
        centre: [f64; 3],
    },

    /// A face of a group with material of one body on both sides.
    #[error("{element} of the surface group `{group}` of `{}` lies inside of the body, between {} and {}", path.display(), sides[0], sides[1])]
    #[diagnostic(
        code(mesh::interior_face),
        help(
            "a surface carries supports, loads or contact only on the outside of a body; take the inner faces out of the group, or make two bodies of the two sides"
        )
    )]
    InteriorFace {
        /// The file.
        path: PathBuf,
        /// The group.
        group: String,
        /// The element of the group, in words.
        element: String,
        /// The elements on its two sides.
        sides: [String; 2],
    },

    /// A face of a group that belongs to no cell, though all its nodes do.
    #[error("{element} of the surface group `{group}` of `{}` is not a face of any volume element, though its nodes belong to the body", path.display())]
    #[diagnostic(
        code(mesh::missing_face),
        help(
            "surface and volume were meshed apart, or with different orders; mesh them in one go"
        )
    )]
    MissingFace {
        /// The file.
        path: PathBuf,
        /// The group.
        group: String,
        /// The element of the group, in words.
        element: String,
    },

    /// A mesh in space for a plane case.
    #[error("node {node} of `{}` has z = {z:?}, but the case is plane: expected 0", path.display())]
    #[diagnostic(
        code(mesh::off_plane),
        help(
            "plane meshes lie in the plane of x and y; `rotate` and `translate` can bring them there"
        )
    )]
    OffPlane {
        /// The file.
        path: PathBuf,
        /// The node.
        node: u64,
        /// Its third coordinate after placement (length).
        z: f64,
    },

    /// A mesh that crosses the axis of revolution.
    #[error("node {node} of `{}` has the radius x = {radius:?}, expected 0 or more", path.display())]
    #[diagnostic(
        code(mesh::negative_radius),
        help(
            "in an axisymmetric case x is the radius and y runs along the axis; mesh one half of the section only"
        )
    )]
    NegativeRadius {
        /// The file.
        path: PathBuf,
        /// The node.
        node: u64,
        /// Its first coordinate after placement (length).
        radius: f64,
    },

    /// Faces that cannot be given two sides.
    #[error("the surface `{}` of `{}` is no orientable surface at {element}: {reason}", group.as_deref().unwrap_or("(all)"), path.display())]
    #[diagnostic(
        code(mesh::orientation),
        help(
            "a rigid surface has a front and a back: at most two of its faces meet along an edge"
        )
    )]
    Orientation {
        /// The file.
        path: PathBuf,
        /// The group.
        group: Option<String>,
        /// The element where it fails, in words.
        element: String,
        /// What is wrong there.
        reason: &'static str,
    },

    /// A mesh that the finite elements refuse for another reason.
    #[error("the mesh of `{}` cannot be used: {source}", path.display())]
    #[diagnostic(code(mesh::refused))]
    Refused {
        /// The file.
        path: PathBuf,
        /// Why.
        #[source]
        source: FemError,
    },
}

impl MeshFileError {
    /// A fault of the text without a known cause.
    pub(super) fn syntax(
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Self::Syntax {
            place,
            expected: expected.into(),
            found: found.into(),
            help: None,
        }
    }

    /// Adds the likely cause to a fault of the text.
    pub(super) fn because(mut self, cause: impl Into<String>) -> Self {
        if let Self::Syntax { help, .. } = &mut self {
            *help = Some(cause.into());
        }
        self
    }

    /// For `map_err`.
    pub(super) fn unreadable(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Unreadable { path, source }
    }
}
