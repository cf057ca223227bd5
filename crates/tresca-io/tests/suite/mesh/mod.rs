//! Mesh files: formats against each other and against reference elements, bodies, bad files.

mod abaqus;
mod bad;
mod bodies;
mod gmsh;
mod reference;
mod support;
mod surfaces;
