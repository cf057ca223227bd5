//! Files in and out: meshes and problems with reports that show the place of an error, and results as VTU,
//! CSV and JSON, written so that a failed run never destroys an earlier result.
//!
//! | module | what it does |
//! |---|---|
//! | [`fclib`] | frictional contact problems of the Siconos group |
//! | [`mesh`] | mesh files: Gmsh, Abaqus, CalculiX |
//! | [`problem`] | contact problems as matrices: `.npz` archives, Matrix Market folders |
//! | [`located`] | what is wrong in a file, and where |
//! | [`names`] | names in reports |
//! | [`atomic`] | sets of files that appear together or not at all |
//! | [`vtu`], [`pvd`] | unstructured grids with fields, and collections of them |
//! | [`results`] | the fields of a solved case and their names |
//! | [`history`] | tables of numbers as CSV |
//! | [`summary`] | summaries as JSON |

pub mod atomic;
mod error;
pub mod fclib;
pub mod history;
pub mod located;
pub mod mesh;
pub mod names;
pub mod problem;
pub mod pvd;
pub mod results;
pub mod summary;
pub mod vtu;
mod xml;

pub use error::WriteError;
