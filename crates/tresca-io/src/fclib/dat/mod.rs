//! The plain text that Siconos writes (`frictionContact_printInFile` and
//! `globalFrictionContact_printInFile`):
//!
//! ```text
//! local:   dimension  contacts  W        q  mu
//! global:  dimension  contacts  M  H     f  w  mu
//! ```
//!
//! in words separated by any white space, mostly followed by one more 0 or 1 that means nothing to
//! the problem. Nothing says which of the two it is: see [`read::follows_matrix`].

mod matrix;
mod read;
mod tokens;
mod write;

pub(super) use read::read;
