//! The files of a check.

use std::io::Write;

use tresca_io::atomic::OutputSet;
use tresca_io::pvd::{self, PvdPart};
use tresca_io::results::{CheckedBody, CheckedContact, origin};
use tresca_io::{WriteError, summary};

use super::{CONTACT, Destination, node_vectors};
use crate::check::Check;
use crate::version::VERSION;
use tresca_model::Model;

impl Destination {
    /// Writes what [`check`](crate::check()) put together: `<body>.vtu` with what holds and what pulls,
    /// `contact.vtu` with the contact points and their gaps, `<name>.pvd`, `check.json`. All or none.
    ///
    /// # Errors
    /// When a file cannot be written, or a field holds a number that is not finite.
    pub fn write_check(self, name: &str, model: &Model, check: &Check) -> Result<(), WriteError> {
        let mut files = OutputSet::new(self.directory)?;
        let mut parts = Vec::new();
        for (index, body) in model.bodies().iter().enumerate() {
            let file = format!("{}.vtu", body.name);
            files.stage(&file, |out| {
                CheckedBody {
                    mesh: &body.mesh,
                    held_components: &check.held[index],
                    load: &node_vectors(body, &check.nodal_loads[index]),
                    facts: origin(&check.title, VERSION),
                }
                .write(out)
            })?;
            parts.push((body.name.as_str(), file));
        }
        if check.contact_data.iter().any(|data| !data.pairs.is_empty()) {
            let file = format!("{CONTACT}.vtu");
            files.stage(&file, |out| write_contact(check, out))?;
            parts.push((CONTACT, file));
        }
        let parts: Vec<_> = parts
            .iter()
            .map(|(name, file)| PvdPart {
                name,
                file,
                time: 0.0,
            })
            .collect();
        files.stage(&format!("{name}.pvd"), |out| pvd::write(out, &parts))?;
        files.stage("check.json", |out| summary::write(out, check))?;
        files.commit()?;
        Ok(())
    }
}

fn write_contact(check: &Check, out: &mut dyn Write) -> Result<(), WriteError> {
    let pairs = || check.contact_data.iter().flat_map(|data| &data.pairs);
    let number = |(number, data): (usize, &tresca_contact::ContactData)| {
        std::iter::repeat_n(i32::try_from(number).unwrap_or(i32::MAX), data.pairs.len())
    };
    let contacts = check.contact_data.iter().enumerate();
    CheckedContact {
        points: &pairs().map(|pair| pair.point).collect::<Vec<_>>(),
        pair: &contacts.flat_map(number).collect::<Vec<_>>(),
        normal: &pairs().map(|pair| pair.frame.normal).collect::<Vec<_>>(),
        gap: &pairs().map(|pair| pair.gap).collect::<Vec<_>>(),
        area: &pairs().map(|pair| pair.area).collect::<Vec<_>>(),
    }
    .write(out)
}
