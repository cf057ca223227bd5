//! The case file: a TOML text that describes bodies, supports, loads and contact pairs.
//!
//! ```
//! let text = r#"
//!     [[body]]
//!     name = "block"
//!     mesh = { brick = { min = [0, 0, 0], max = [2, 1, 1], nodes = [5, 3, 3] } }
//!     material = { young = 5.0e4, poisson = 0.3 }
//!
//!     [[clamp]]
//!     on = ["block.z-"]
//!
//!     [solver]
//!     tolerance = 1e-10
//! "#;
//! let case = tresca_case::Case::parse("block.toml", text)?;
//! assert_eq!(case.model.bodies()[0].mesh.node_count(), 45);
//! assert_eq!(case.model.supports()[0].on[0].set, "z-");
//! assert_eq!(case.settings().tolerance, 1e-10);
//! # Ok::<(), tresca_case::CaseError>(())
//! ```
//!
//! Reading goes in three steps, each with its own sort of error, all of them a [`CaseError`]: text to TOML, TOML to
//! keys (a struct for every table, where every key is documented), and keys to the parts of a
//! [`Model`](tresca_model::Model), one after the other, with the checks that need no stiffness. Mesh files are read on
//! the way. What is found later is reported by [`Case::fault`], at the place that the part of the model comes from.
//!
//! Every noun of the language has a file of its own with its keys and how they are read.

mod analysis;
mod body;
mod case;
mod contact;
mod error;
pub mod expression;
mod field;
mod file;
mod friction;
mod load;
mod locate;
mod mesh;
mod numbers;
mod obstacle;
mod origins;
mod place;
mod placement;
mod reader;
mod step;
mod support;
mod text;
mod value_table;

pub use case::Case;
pub use error::{CaseError, CaseFault, FaultKind};
pub use mesh::MAX_NODES;
pub use step::MAX_INCREMENTS;
