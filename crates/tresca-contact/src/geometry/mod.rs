//! Faces as geometry: shapes, flat facets, polygons, search.

pub(crate) mod face;
pub(crate) mod faces;
pub(crate) mod facet;
pub(crate) mod polygon;
pub(crate) mod search;
