//! Meshes: points, cells in blocks of one kind, named sets of faces and of nodes.
//!
//! ```
//! use tresca_fem::mesh::{BrickSpec, brick};
//!
//! let mesh = brick(&BrickSpec { min: [0.0; 3], max: [2.0, 1.0, 1.0], nodes: [5, 3, 3] })?;
//! assert_eq!(mesh.points.len(), 45);
//! assert_eq!(mesh.cell_count(), 16);
//! assert_eq!(mesh.nodes_of_set("x+")?.len(), 9);
//! assert!((mesh.volume() - 2.0).abs() < 1e-14);
//! # Ok::<(), tresca_fem::FemError>(())
//! ```

pub(crate) mod brick;
mod convert;
mod cut;
pub(crate) mod data;
pub(crate) mod disjoint_sets;
mod duplicates;
mod elevate;
pub(crate) mod geometry;
mod grid;
pub(crate) mod kind;
mod kind_names;
pub(crate) mod parts;
mod quality;
pub(crate) mod rectangle;
pub(crate) mod space;
mod submesh;
pub(crate) mod topology;

pub use brick::{BrickSpec, brick};
pub use data::{Cell, CellBlock, Face, Mesh};
pub use disjoint_sets::DisjointSets;
pub use geometry::BoundingBox;
pub use kind::CellKind;
pub use parts::Part;
pub use rectangle::{RectangleSpec, rectangle};
pub use space::Space;
pub use topology::{FaceLookup, Incidence};
