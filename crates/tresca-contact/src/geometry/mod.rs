//! Faces as geometry: shapes, flat facets, polygons, search.

mod facet;
mod patch;
mod polygon;
mod search;

pub(crate) use facet::{Facet, Plane};
pub(crate) use patch::{FaceElement, MAX_NODES, Patch, Patches, combine};
pub(crate) use polygon::{Point2, Polygon, cross2};
pub(crate) use search::{FACING, FacetTree, Reach};
