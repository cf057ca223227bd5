//! What load steps speak of, with the states before, between and after them.

use toml::Spanned;

use super::amounts::{Amount, Amounts, Quantity};
use super::contact::Contact;
use super::friction::Friction;
use super::loads::{BodyForce, Gravity, Pressure, Support, Traction};
use super::obstacle::Obstacle;

/// What load steps speak of.
pub(super) struct Loading<'a> {
    pub supports: &'a [Support],
    pub tractions: &'a [Traction],
    pub pressures: &'a [Pressure],
    pub body_forces: &'a [BodyForce],
    pub gravities: &'a [Gravity],
    pub contacts: &'a [Contact],
    pub obstacles: &'a [Obstacle],
}

/// A table that load steps may name, by its number in its list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Item {
    Support(usize),
    Traction(usize),
    Pressure(usize),
    BodyForce(usize),
    Gravity(usize),
    Contact(usize),
    Obstacle(usize),
}

impl<'a> Loading<'a> {
    /// All names, in the order of the lists.
    pub(super) fn names(&self) -> Vec<(&'a Spanned<String>, Item)> {
        fn of<'a, T>(
            list: &'a [T],
            name: impl Fn(&'a T) -> &'a Option<Spanned<String>>,
            item: impl Fn(usize) -> Item,
        ) -> impl Iterator<Item = (&'a Spanned<String>, Item)> {
            let names = list.iter().map(name).enumerate();
            names.filter_map(move |(i, name)| Some((name.as_ref()?, item(i))))
        }
        let obstacles = self.obstacles.iter().enumerate();
        let obstacles = obstacles.map(|(i, obstacle)| (&obstacle.name, Item::Obstacle(i)));
        of(self.supports, |support| &support.name, Item::Support)
            .chain(of(self.tractions, |load| &load.name, Item::Traction))
            .chain(of(self.pressures, |load| &load.name, Item::Pressure))
            .chain(of(self.body_forces, |load| &load.name, Item::BodyForce))
            .chain(of(self.gravities, |load| &load.name, Item::Gravity))
            .chain(of(self.contacts, |pair| &pair.name, Item::Contact))
            .chain(obstacles)
            .collect()
    }

    /// Every table's own value.
    pub(super) fn full(&self) -> Amounts {
        Amounts {
            supports: self.supports.iter().map(|s| s.displacement).collect(),
            tractions: vec![Amount::Factor(1.0); self.tractions.len()],
            pressures: vec![Amount::Factor(1.0); self.pressures.len()],
            body_forces: vec![Amount::Factor(1.0); self.body_forces.len()],
            gravities: vec![Amount::Factor(1.0); self.gravities.len()],
            motions: self
                .obstacles
                .iter()
                .map(|o| o.motion.unwrap_or_default())
                .collect(),
            bounds: vec![Amount::Factor(1.0); self.contacts.len()],
        }
    }

    /// The state before the first step: bodies at rest under no load, surfaces as rough as ever.
    pub(super) fn rest(&self) -> Amounts {
        Amounts {
            supports: self
                .supports
                .iter()
                .map(|s| s.displacement.map(|u| u.map(|_| 0.0)))
                .collect(),
            tractions: vec![Amount::Factor(0.0); self.tractions.len()],
            pressures: vec![Amount::Factor(0.0); self.pressures.len()],
            body_forces: vec![Amount::Factor(0.0); self.body_forces.len()],
            gravities: vec![Amount::Factor(0.0); self.gravities.len()],
            motions: vec![[0.0; 3]; self.obstacles.len()],
            bounds: vec![Amount::Factor(1.0); self.contacts.len()],
        }
    }

    fn own_traction(&self, i: usize) -> Option<[f64; 3]> {
        self.tractions[i].value.constant()
    }

    fn own_pressure(&self, i: usize) -> Option<f64> {
        self.pressures[i].value.get_ref().constant()
    }

    /// The slip bound of a contact whose law has a single one.
    fn own_bound(&self, i: usize) -> Option<f64> {
        match &self.contacts[i].friction {
            Friction::Tresca { bound } | Friction::Bilateral { bound: Some(bound) } => {
                bound.get_ref().constant()
            }
            _ => None,
        }
    }

    /// Whether an item keeps [`Loading::between`] from finding a way.
    pub(super) fn is_stuck(&self, item: Item, from: &Amounts, to: &Amounts) -> bool {
        let half = |from: Amount<f64>, to, own| from.towards(to, 0.5, own).is_none();
        match item {
            Item::Traction(i) => {
                let (from, to) = (from.tractions[i], to.tractions[i]);
                from.towards(to, 0.5, self.own_traction(i)).is_none()
            }
            Item::Pressure(i) => half(from.pressures[i], to.pressures[i], self.own_pressure(i)),
            Item::Contact(i) => half(from.bounds[i], to.bounds[i], self.own_bound(i)),
            // Their own values never vary.
            Item::Support(_) | Item::BodyForce(_) | Item::Gravity(_) | Item::Obstacle(_) => false,
        }
    }

    /// A part t of the way between two states; `None` if there is something that cannot be
    /// interpolated, see [`Amount::towards`].
    pub(super) fn between(&self, from: &Amounts, to: &Amounts, t: f64) -> Option<Amounts> {
        fn each<T: Quantity>(
            from: &[Amount<T>],
            to: &[Amount<T>],
            t: f64,
            own: impl Fn(usize) -> Option<T>,
        ) -> Option<Vec<Amount<T>>> {
            let pairs = from.iter().zip(to).enumerate();
            pairs
                .map(|(i, (from, to))| from.towards(*to, t, own(i)))
                .collect()
        }
        let supports = from.supports.iter().zip(&to.supports);
        Some(Amounts {
            supports: supports
                .map(|(from, to)| {
                    std::array::from_fn(|axis| Some(from[axis]?.towards(to[axis]?, t)))
                })
                .collect(),
            tractions: each(&from.tractions, &to.tractions, t, |i| self.own_traction(i))?,
            pressures: each(&from.pressures, &to.pressures, t, |i| self.own_pressure(i))?,
            body_forces: each(&from.body_forces, &to.body_forces, t, |i| {
                Some(self.body_forces[i].value)
            })?,
            gravities: each(&from.gravities, &to.gravities, t, |i| {
                Some(self.gravities[i].value)
            })?,
            motions: from
                .motions
                .iter()
                .zip(&to.motions)
                .map(|(from, to)| from.towards(*to, t))
                .collect(),
            bounds: each(&from.bounds, &to.bounds, t, |i| self.own_bound(i))?,
        })
    }
}
