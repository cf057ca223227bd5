//! Contact pairs.

use toml::Spanned;

use super::body::Body;
use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::fields::{Field, Kind};
use super::friction::Friction;
use super::keys::ContactKeys;
use super::source::Span;
use super::surface::Surface;

/// Two surfaces that may touch.
#[derive(Clone, Debug)]
pub struct Contact {
    /// How load steps and reports call it.
    pub name: Option<Spanned<String>>,
    /// The surface that carries the contact forces, first in the file.
    pub slave: Surface,
    /// The other one.
    pub master: Surface,
    /// What the pair does in its tangential plane, and whether it may open.
    pub friction: Friction,
    /// Length that is added to the distance of the undeformed surfaces along the normal; negative for
    /// interference. 0 where the file does not give it.
    pub gap: Spanned<Field>,
    /// The whole table, for reports about the pair.
    pub span: Span,
}

impl Check<'_> {
    pub(super) fn contacts(
        &self,
        list: Vec<Spanned<ContactKeys>>,
        bodies: &[Body],
    ) -> Result<Vec<Contact>, CaseError> {
        let mut contacts: Vec<Contact> = Vec::with_capacity(list.len());
        for keys in list {
            let span = keys.span();
            let keys = keys.into_inner();
            let [slave, master] = self.pair(&keys.pair, bodies)?;
            let friction = self.friction(&keys.friction)?;
            let again = contacts.iter().find(|c| {
                (c.slave.is_same(&slave) && c.master.is_same(&master))
                    || (c.slave.is_same(&master) && c.master.is_same(&slave))
            });
            if let Some(first) = again {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        keys.pair.span(),
                        "these two surfaces are already a contact pair",
                        "the second time",
                    )
                    .and_at(first.slave.span.start..first.master.span.end, "the first time")
                    .with_help("a pair stands in one [[contact]] only: a second one would constrain the same points again")
                    .into());
            }
            let gap = match &keys.gap {
                Some(gap) => self.field("the gap", Kind::Signed, gap, "")?,
                None => Spanned::new(span.clone(), Field::Constant(0.0)),
            };
            contacts.push(Contact {
                name: self.item_name(keys.name)?,
                slave,
                master,
                friction,
                gap,
                span,
            });
        }
        Ok(contacts)
    }

    fn pair(
        &self,
        pair: &Spanned<Vec<Spanned<String>>>,
        bodies: &[Body],
    ) -> Result<[Surface; 2], CaseError> {
        let [slave, master] = pair.get_ref().as_slice() else {
            return Err(self
                .fault(
                    FaultKind::WrongType,
                    pair.span(),
                    "a contact pair has two surfaces",
                    format!("expected 2 entries, found {}", pair.get_ref().len()),
                )
                .with_help("write `pair = [\"slave.face\", \"master.face\"]`; more pairs get their own [[contact]]")
                .into());
        };
        let (slave, master) = (self.surface(slave, bodies)?, self.surface(master, bodies)?);
        if slave.is_same(&master) {
            return Err(self
                .fault(
                    FaultKind::Duplicate,
                    master.span.clone(),
                    "a surface cannot be in contact with itself",
                    "expected another surface than the first",
                )
                .and_at(slave.span.clone(), "the first")
                .with_help("a pair names the two surfaces that face each other")
                .into());
        }
        Ok([slave, master])
    }
}
