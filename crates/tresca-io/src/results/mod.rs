//! The fields of a case in `.vtu` files. What a field is called stands in [`names`], and nowhere else.

mod body;
mod check;
mod contact;
mod facts;
pub mod names;

pub use body::{BodyFields, NodeContactFields};
pub use check::{CheckedBody, CheckedContact};
pub use contact::{ContactFields, ContactState};
pub use facts::{StepFacts, origin};
