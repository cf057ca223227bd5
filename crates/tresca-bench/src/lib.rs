//! The benchmarks of tresca: a model, experiments on it, and a yardstick.
//!
//! - [`two_bricks`]: the model of the founding paper.
//! - [`table1`] and [`coulomb`]: the published table and what Coulomb's law costs beside Tresca's. `tresca bench`
//!   prints them; the counts of small sizes are kept in `counts.toml`, and a test compares.
//! - [`campaign`]: random problems by the thousand, judged by independent oracles.
//! - [`trial`]: any model on the bench, timed as a whole and beside one linear solve of the same bodies.
//!
//! Times of single parts (assembly, factor, kernels, mortar) are in `benches/`; the README says what each
//! benchmark measures and how to read it.

pub mod campaign;
pub mod coulomb;
mod error;
pub mod table1;
pub mod trial;
pub mod two_bricks;

pub use error::BenchError;
