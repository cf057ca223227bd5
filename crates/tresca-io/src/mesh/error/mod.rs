//! What can be wrong with a mesh file.

mod words;

use std::error::Error;
use std::fmt;
use std::io;
use std::path::Path;

use tresca_fem::FemError;
use tresca_fem::mesh::Space;

use crate::located::{Fault, FilePlace, Located};
use words::{
    cell_word, found_cells, group_word, known_groups, members_word, nearest_hint, no_cells_help,
};

/// Why a mesh file was refused, and where.
pub type MeshFileError = Located<MeshFault>;

/// What is wrong with a mesh file. Elements and nodes go by the numbers that the file gives them.
#[derive(Debug)]
#[non_exhaustive]
pub enum MeshFault {
    /// The operating system refused.
    Unreadable {
        /// What the operating system says.
        source: io::Error,
    },
    /// Neither Gmsh's format nor an Abaqus deck.
    Format {
        /// Its first characters.
        found: String,
    },
    /// A version of Gmsh's format that is not read.
    Version {
        /// The version as written.
        found: String,
    },
    /// The file ends before it is complete.
    Truncated {
        /// What should follow.
        expected: String,
    },
    /// Something else stands where the format wants a certain thing.
    Syntax {
        /// What should be there.
        expected: String,
        /// What is there.
        found: String,
    },
    /// A part of the format that is not supported.
    Unsupported {
        /// What it is.
        what: String,
    },
    /// An element of a type that is not supported.
    ElementType {
        /// Its number.
        element: u64,
        /// The type in the words of the format.
        name: String,
    },
    /// An element that names a node which the file does not have.
    UnknownNode {
        /// The element.
        element: u64,
        /// The node that it names.
        node: u64,
    },
    /// Two nodes or elements with one number.
    DuplicateNumber {
        /// Node or element.
        what: &'static str,
        /// The number.
        number: u64,
    },
    /// A coordinate that is NaN or infinite.
    NotFinite {
        /// The node.
        node: u64,
        /// Its coordinates.
        point: [f64; 3],
    },
    /// No cells that could fill a body.
    NoCells {
        /// Dimension of the space that asks.
        dimension: usize,
        /// Elements of dimension 1, 2 and 3 that the file has.
        found: [usize; 3],
    },
    /// A mesh of solids for a plane case.
    NotPlane {
        /// The space that asks.
        space: Space,
    },
    /// A group that is not there.
    UnknownGroup {
        /// The name asked for.
        name: String,
        /// The dimension asked for.
        dimension: usize,
        /// The groups of this dimension.
        known: Vec<String>,
    },
    /// A group of another dimension than asked for.
    GroupDimension {
        /// The group.
        name: String,
        /// The dimension asked for.
        expected: usize,
        /// The dimension it has.
        found: usize,
    },
    /// A cell that is turned inside out.
    Inverted {
        /// The element in words.
        element: String,
        /// The mean of its nodes (length).
        centre: [f64; 3],
    },
    /// A cell that is turned inside out in a part.
    Folded {
        /// The element in words.
        element: String,
        /// The mean of its nodes (length).
        centre: [f64; 3],
    },
    /// A cell without volume.
    Degenerate {
        /// The element in words.
        element: String,
        /// The mean of its nodes (length).
        centre: [f64; 3],
    },
    /// A face of a group with material of one body on both sides.
    InteriorFace {
        /// The group.
        group: String,
        /// The element of the group, in words.
        element: String,
        /// The elements on its two sides.
        sides: [String; 2],
    },
    /// A face of a group that belongs to no cell, though all its nodes do.
    MissingFace {
        /// The group.
        group: String,
        /// The element of the group, in words.
        element: String,
    },
    /// A mesh in space for a plane case.
    OffPlane {
        /// The node.
        node: u64,
        /// Its third coordinate after placement (length).
        z: f64,
    },
    /// A mesh that crosses the axis of revolution.
    NegativeRadius {
        /// The node.
        node: u64,
        /// Its first coordinate after placement (length).
        radius: f64,
    },
    /// Faces that cannot be given two sides.
    Orientation {
        /// The group.
        group: Option<String>,
        /// The element where it fails, in words.
        element: String,
        /// What is wrong there.
        reason: &'static str,
    },
    /// A mesh that the finite elements refuse for another reason.
    Refused {
        /// Why.
        source: FemError,
    },
}

impl Fault for MeshFault {
    fn code(&self) -> &'static str {
        match self {
            MeshFault::Unreadable { .. } => "mesh::unreadable",
            MeshFault::Format { .. } => "mesh::format",
            MeshFault::Version { .. } => "mesh::version",
            MeshFault::Truncated { .. } => "mesh::truncated",
            MeshFault::Syntax { .. } => "mesh::syntax",
            MeshFault::Unsupported { .. } => "mesh::unsupported",
            MeshFault::ElementType { .. } => "mesh::element_type",
            MeshFault::UnknownNode { .. } => "mesh::unknown_node",
            MeshFault::DuplicateNumber { .. } => "mesh::duplicate_number",
            MeshFault::NotFinite { .. } => "mesh::not_finite",
            MeshFault::NoCells { .. } => "mesh::no_cells",
            MeshFault::NotPlane { .. } => "mesh::dimension",
            MeshFault::UnknownGroup { .. } => "mesh::unknown_group",
            MeshFault::GroupDimension { .. } => "mesh::group_dimension",
            MeshFault::Inverted { .. } => "mesh::inverted",
            MeshFault::Folded { .. } => "mesh::folded",
            MeshFault::Degenerate { .. } => "mesh::degenerate",
            MeshFault::InteriorFace { .. } => "mesh::interior_face",
            MeshFault::MissingFace { .. } => "mesh::missing_face",
            MeshFault::OffPlane { .. } => "mesh::off_plane",
            MeshFault::NegativeRadius { .. } => "mesh::negative_radius",
            MeshFault::Orientation { .. } => "mesh::orientation",
            MeshFault::Refused { .. } => "mesh::refused",
        }
    }

    fn tell(&self, place: &FilePlace, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MeshFault::Unreadable { source } => write!(
                f,
                "cannot read the mesh file `{}`: {source}",
                place.path.display()
            ),
            MeshFault::Format { found } => write!(
                f,
                "`{}` is no mesh file of a known format: it begins with `{found}`",
                place.path.display()
            ),
            MeshFault::Version { found } => {
                write!(f, "{place}: the MSH format of version {found} is not read")
            }
            MeshFault::Truncated { expected } => {
                write!(f, "{place}: the file ends where {expected} is expected")
            }
            MeshFault::Syntax { expected, found } => {
                write!(f, "{place}: expected {expected}, found {found}")
            }
            MeshFault::Unsupported { what } => write!(f, "{place}: {what} is not supported"),
            MeshFault::ElementType { element, name } => write!(
                f,
                "{place}: element {element} is of the type {name}, which is not supported"
            ),
            MeshFault::UnknownNode { element, node } => write!(
                f,
                "{place}: element {element} refers to node {node}, which the file does not have"
            ),
            MeshFault::DuplicateNumber { what, number } => {
                write!(f, "{place}: there are two {what}s with the number {number}")
            }
            MeshFault::NotFinite { node, point } => write!(
                f,
                "{place}: node {node} has a coordinate that is no finite number: {point:?}"
            ),
            MeshFault::NoCells { dimension, found } => write!(
                f,
                "`{}` has no {} elements: {}",
                place.path.display(),
                cell_word(*dimension),
                found_cells(*found)
            ),
            MeshFault::NotPlane { space } => write!(
                f,
                "`{}` has volume elements, but the case is about bodies in a plane ({space})",
                place.path.display()
            ),
            MeshFault::UnknownGroup {
                name,
                dimension,
                known,
            } => write!(
                f,
                "`{}` has no {} group `{name}`{}",
                place.path.display(),
                group_word(*dimension),
                nearest_hint(name, known)
            ),
            MeshFault::GroupDimension {
                name,
                expected,
                found,
            } => write!(
                f,
                "the group `{name}` of `{}` is no {} group: it consists of {}",
                place.path.display(),
                group_word(*expected),
                members_word(*found)
            ),
            MeshFault::Inverted { element, centre } => write!(
                f,
                "{element} of `{}` is turned inside out (its centre is at {centre:?})",
                place.path.display()
            ),
            MeshFault::Folded { element, centre } => write!(
                f,
                "{element} of `{}` is folded (its centre is at {centre:?})",
                place.path.display()
            ),
            MeshFault::Degenerate { element, centre } => write!(
                f,
                "{element} of `{}` has no volume (its centre is at {centre:?})",
                place.path.display()
            ),
            MeshFault::InteriorFace {
                group,
                element,
                sides,
            } => write!(
                f,
                "{element} of the surface group `{group}` of `{}` lies inside of the body, between {} and {}",
                place.path.display(),
                sides[0],
                sides[1]
            ),
            MeshFault::MissingFace { group, element } => write!(
                f,
                "{element} of the surface group `{group}` of `{}` is not a face of any volume element, though its nodes belong to the body",
                place.path.display()
            ),
            MeshFault::OffPlane { node, z } => write!(
                f,
                "node {node} of `{}` has z = {z:?}, but the case is plane: expected 0",
                place.path.display()
            ),
            MeshFault::NegativeRadius { node, radius } => write!(
                f,
                "node {node} of `{}` has the radius x = {radius:?}, expected 0 or more",
                place.path.display()
            ),
            MeshFault::Orientation {
                group,
                element,
                reason,
            } => write!(
                f,
                "the surface `{}` of `{}` is no orientable surface at {element}: {reason}",
                group.as_deref().unwrap_or("(all)"),
                place.path.display()
            ),
            MeshFault::Refused { source } => write!(
                f,
                "the mesh of `{}` cannot be used: {source}",
                place.path.display()
            ),
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            MeshFault::Format { .. } => {
                "read are Gmsh's .msh files (versions 2.2 and 4.1) and Abaqus or CalculiX decks (.inp)"
            }
            MeshFault::Version { .. } => {
                "save the mesh as version 4.1 or 2.2: `gmsh -format msh41`, or the option \
                 `Mesh.MshFileVersion = 4.1;`"
            }
            MeshFault::Truncated { .. } => {
                "the file is cut off: was the disk full, or is the program that writes it still running?"
            }
            MeshFault::ElementType { .. } => {
                "supported are tetrahedra (4 or 10 nodes), hexahedra (8, 20, 27), wedges (6), triangles \
                 (3, 6), quadrilaterals (4, 8, 9) and lines (2, 3); in Gmsh, `Mesh.ElementOrder` is 1 or 2"
            }
            MeshFault::UnknownNode { .. } => {
                "the file was put together or cut by hand, or its nodes were exported only in part"
            }
            MeshFault::DuplicateNumber { .. } => {
                "files that were joined by hand need numbers that do not overlap"
            }
            MeshFault::NotFinite { .. } => {
                "the program that wrote the mesh has failed; mesh the geometry again"
            }
            MeshFault::NoCells { dimension, found } => no_cells_help(*dimension, *found),
            MeshFault::NotPlane { .. } => {
                "mesh a plane surface for a plane or axisymmetric case, or leave out the key `analysis` \
                 for bodies in space"
            }
            MeshFault::UnknownGroup {
                dimension, known, ..
            } => return Some(known_groups(*dimension, known)),
            MeshFault::GroupDimension { .. } => {
                "in Gmsh, bodies are physical volumes (in the plane: surfaces), and the places where \
                 something acts on them physical surfaces (in the plane: curves)"
            }
            MeshFault::Inverted { .. } => {
                "mesh the place again, finer or with optimisation (Gmsh: `Mesh.Optimize = 1`); if all \
                 elements are inverted, the program that wrote the file numbers their nodes in another \
                 order"
            }
            MeshFault::Folded { .. } => {
                "a corner is pushed in, or a middle node lies too far from the middle of its edge, which \
                 happens where few quadratic elements follow a strong curve; mesh the place finer, or use \
                 `Mesh.HighOrderOptimize = 2` in Gmsh"
            }
            MeshFault::Degenerate { .. } => {
                "nodes of the element coincide or lie in one plane; mesh the place again"
            }
            MeshFault::InteriorFace { .. } => {
                "a surface carries supports, loads or contact only on the outside of a body; take the \
                 inner faces out of the group, or make two bodies of the two sides"
            }
            MeshFault::MissingFace { .. } => {
                "surface and volume were meshed apart, or with different orders; mesh them in one go"
            }
            MeshFault::OffPlane { .. } => {
                "plane meshes lie in the plane of x and y; `rotate` and `translate` can bring them there"
            }
            MeshFault::NegativeRadius { .. } => {
                "in an axisymmetric case x is the radius and y runs along the axis; mesh one half of the \
                 section only"
            }
            MeshFault::Orientation { .. } => {
                "a rigid surface has a front and a back: at most two of its faces meet along an edge"
            }
            _ => return None,
        };
        Some(help.to_owned())
    }

    fn cause(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            MeshFault::Unreadable { source } => Some(source),
            MeshFault::Refused { source } => Some(source),
            _ => None,
        }
    }
}

impl MeshFault {
    /// At a place.
    pub(super) fn at(self, place: impl Into<FilePlace>) -> MeshFileError {
        Located::new(self, place)
    }

    /// A fault of the text without a known cause.
    pub(super) fn syntax(
        place: FilePlace,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> MeshFileError {
        let (expected, found) = (expected.into(), found.into());
        Self::Syntax { expected, found }.at(place)
    }

    /// For `map_err`.
    pub(super) fn unreadable(path: &Path) -> impl FnOnce(io::Error) -> MeshFileError {
        let path = path.to_owned();
        move |source| Self::Unreadable { source }.at(path)
    }
}
