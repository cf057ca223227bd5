//! Cases, and the place in a case file that a fault found while solving speaks of.

use tresca_contact::ContactError;
use tresca_model::{ContactId, LoadId, Subject};

pub use tresca_case::{Case, CaseError};

use crate::error::SolveError;

/// Points an error at the place in the case file that it speaks of.
pub fn locate(case: &Case, error: &SolveError) -> CaseError {
    let body = |name: &str| case.model.body(name).map_or(Subject::Model, Subject::Body);
    let (subject, label, help) = match error {
        SolveError::Floating { body: name, .. } => (
            body(name),
            "nothing holds this body".to_owned(),
            format!(
                "clamp a surface of it, for example `on = [\"{name}.x-\"]` in a [[clamp]] table, or let it \
                 touch another body in a [[contact]]"
            ),
        ),
        SolveError::Coupling {
            contact, source, ..
        } => {
            let (label, help) = coupling_hints(source);
            (
                ContactId(*contact).into(),
                label.to_owned(),
                help.to_owned(),
            )
        }
        SolveError::NonFiniteLoad { load, .. } => (
            LoadId(*load).into(),
            "its value is not a number everywhere".to_owned(),
            "an expression such as sqrt(x) or 1/x has no value at some points of the surface"
                .to_owned(),
        ),
        SolveError::NoContact => (
            Subject::Model,
            "no [[contact]] table in this file".to_owned(),
            "add a [[contact]] with `pair` and `friction`".to_owned(),
        ),
        SolveError::Body { body: name, .. } | SolveError::Factorization { body: name, .. } => {
            (body(name), "this body".to_owned(), String::new())
        }
        _ => (Subject::Model, "in this file".to_owned(), String::new()),
    };
    case.fault(subject, error.to_string(), label, help)
}

/// What to say beside the error of a contact's geometry or law.
fn coupling_hints(source: &ContactError) -> (&'static str, &'static str) {
    match source {
        ContactError::NodeCounts { .. }
        | ContactError::NoPartner { .. }
        | ContactError::SharedPartner { .. } => (
            "the nodes of the two surfaces must lie on one another",
            "give both surfaces the same nodes, or leave `coupling` out: surfaces that are meshed apart are \
             coupled by mortar",
        ),
        ContactError::SlipBound { .. } => (
            "its slip bound is impossible somewhere on the slave surface",
            "a bound is a number ≥ 0; an expression can be kept from going below by max(0, …)",
        ),
        ContactError::Axis { .. } => (
            "its axis is along the contact normal somewhere",
            "the axis of an orthotropic law is projected on the tangent plane of every contact point",
        ),
        _ => ("this contact", ""),
    }
}
