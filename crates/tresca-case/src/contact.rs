//! Contact pairs.

use toml::Spanned;

use super::body::Body;
use super::check::Check;
use super::error::{CaseError, FaultKind};
use super::fields::{Field, Kind};
use super::friction::Friction;
use super::keys::{ContactKeys, Coupling};
use super::obstacle::Obstacle;
use super::source::Span;
use super::surface::Surface;
use tresca_io::names::{listed, nearest};

/// Surfaces that may touch.
#[derive(Clone, Debug)]
pub struct Contact {
    /// How load steps and reports call it.
    pub name: Option<Spanned<String>>,
    /// What may touch what.
    pub partners: Partners,
    /// How the surfaces are coupled.
    pub coupling: Coupling,
    /// Largest distance at which points of the surfaces are coupled (length), positive.
    pub search: Option<f64>,
    /// What the pair does in its tangential plane, and whether it may open.
    pub friction: Friction,
    /// Length that is added to the distance of the undeformed surfaces along the normal; negative for
    /// interference. 0 where the file does not give it.
    pub gap: Spanned<Field>,
    /// The whole table, for reports about the pair.
    pub span: Span,
}

/// What may touch what.
#[derive(Clone, Debug)]
pub enum Partners {
    /// Two surfaces of bodies.
    Surfaces {
        /// The surface that carries the contact forces, first in the file.
        slave: Surface,
        /// The other one.
        master: Surface,
    },
    /// A surface of a body and an obstacle.
    Obstacle {
        /// The surface that carries the contact forces.
        slave: Surface,
        /// Index into [`CaseFile::obstacles`](super::CaseFile::obstacles).
        obstacle: usize,
    },
    /// The outer surfaces of different bodies where they are near.
    Near {
        /// Largest distance (length), positive.
        distance: f64,
        /// Indices into [`CaseFile::bodies`](super::CaseFile::bodies), ascending; two or more.
        bodies: Vec<usize>,
    },
}

impl Partners {
    fn is_same(&self, other: &Partners) -> bool {
        match (self, other) {
            (
                Partners::Surfaces { slave, master },
                Partners::Surfaces {
                    slave: s,
                    master: m,
                },
            ) => (slave.is_same(s) && master.is_same(m)) || (slave.is_same(m) && master.is_same(s)),
            (
                Partners::Obstacle { slave, obstacle },
                Partners::Obstacle {
                    slave: s,
                    obstacle: o,
                },
            ) => slave.is_same(s) && obstacle == o,
            _ => false,
        }
    }
}

impl Check<'_> {
    pub(super) fn contacts(
        &self,
        list: Vec<Spanned<ContactKeys>>,
        bodies: &[Body],
        obstacles: &[Obstacle],
    ) -> Result<Vec<Contact>, CaseError> {
        let mut contacts: Vec<Contact> = Vec::with_capacity(list.len());
        let mut places: Vec<Span> = Vec::with_capacity(list.len());
        for keys in list {
            let span = keys.span();
            let keys = keys.into_inner();
            let (place, partners) = self.partners(&keys, &span, bodies, obstacles)?;
            let friction = self.friction(&keys.friction)?;
            let again = contacts.iter().position(|c| c.partners.is_same(&partners));
            if let Some(first) = again {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        place,
                        "these two surfaces are already a contact pair",
                        "the second time",
                    )
                    .and_at(places[first].clone(), "the first time")
                    .with_help("a pair stands in one [[contact]] only: a second one would constrain the same points again")
                    .into());
            }
            places.push(place);
            let gap = match &keys.gap {
                Some(gap) => self.field("the gap", Kind::Signed, gap, "")?,
                None => Spanned::new(span.clone(), Field::Constant(0.0)),
            };
            let help = "it is the largest distance at which points of the two surfaces are coupled";
            let search = keys.search.as_ref();
            let search = search.map(|search| self.positive("the search distance", search, help));
            contacts.push(Contact {
                name: self.item_name(keys.name)?,
                partners,
                coupling: keys.coupling,
                search: search.transpose()?,
                friction,
                gap,
                span,
            });
        }
        Ok(contacts)
    }

    /// With the place of the keys that say it.
    fn partners(
        &self,
        keys: &ContactKeys,
        span: &Span,
        bodies: &[Body],
        obstacles: &[Obstacle],
    ) -> Result<(Span, Partners), CaseError> {
        match (&keys.pair, &keys.within) {
            (Some(pair), Some(within)) => Err(self
                .fault(
                    FaultKind::Duplicate,
                    within.span(),
                    "`pair` and `within` exclude each other",
                    "pairs are found by this distance",
                )
                .and_at(pair.span(), "the pair is given")
                .with_help("remove one of the two; `search` is the distance at which a given pair is coupled")
                .into()),
            (None, None) => Err(self
                .fault(
                    FaultKind::MissingKey,
                    span.clone(),
                    "missing key `pair`",
                    "expected `pair` in this table",
                )
                .with_help("`pair = [\"slave.face\", \"master.face\"]` names two surfaces; `within = 0.1` finds the pairs by a distance")
                .into()),
            (Some(pair), None) => {
                if let Some(list) = &keys.bodies {
                    return Err(self
                        .fault(
                            FaultKind::UnknownKey,
                            list.span(),
                            "a given pair takes no `bodies`",
                            "expected `within` along with it",
                        )
                        .with_help("remove the key `bodies`")
                        .into());
                }
                Ok((pair.span(), self.pair(pair, bodies, obstacles)?))
            }
            (None, Some(within)) => {
                let help = "outer surfaces of two bodies that are nearer than this become a pair";
                let distance = self.positive("the distance", within, help)?;
                let listed = self.body_list(keys.bodies.as_ref(), bodies)?;
                if listed.len() < 2 {
                    let place = keys.bodies.as_ref().map_or(within.span(), Spanned::span);
                    return Err(self
                        .fault(
                            FaultKind::BadValue,
                            place,
                            "pairs are found between different bodies",
                            "expected two bodies or more",
                        )
                        .with_help("contact of a body with itself is not supported")
                        .into());
                }
                let partners = Partners::Near {
                    distance,
                    bodies: listed,
                };
                Ok((within.span(), partners))
            }
        }
    }

    fn pair(
        &self,
        pair: &Spanned<Vec<Spanned<String>>>,
        bodies: &[Body],
        obstacles: &[Obstacle],
    ) -> Result<Partners, CaseError> {
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
        if obstacles
            .iter()
            .any(|o| o.name.get_ref() == slave.get_ref())
        {
            return Err(self
                .fault(
                    FaultKind::BadReference,
                    slave.span(),
                    "the first of a pair is a surface of a body",
                    "an obstacle",
                )
                .with_help(
                    "write the obstacle second: the first surface carries the contact forces",
                )
                .into());
        }
        let slave = self.surface(slave, bodies)?;
        if let Some(obstacle) = self.obstacle(master, obstacles)? {
            return Ok(Partners::Obstacle { slave, obstacle });
        }
        let master = self.surface(master, bodies)?;
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
        Ok(Partners::Surfaces { slave, master })
    }

    /// The obstacle that a name without a dot means; `None` for one with a dot, and where there are no
    /// obstacles that could be meant.
    fn obstacle(
        &self,
        name: &Spanned<String>,
        obstacles: &[Obstacle],
    ) -> Result<Option<usize>, CaseError> {
        let wanted = name.get_ref().as_str();
        if obstacles.is_empty() || wanted.contains('.') {
            return Ok(None);
        }
        let names: Vec<&str> = obstacles
            .iter()
            .map(|o| o.name.get_ref().as_str())
            .collect();
        match names.iter().position(|&name| name == wanted) {
            Some(obstacle) => Ok(Some(obstacle)),
            None => Err(self
                .fault(
                    FaultKind::BadReference,
                    name.span(),
                    format!("there is no obstacle `{wanted}`"),
                    match nearest(wanted, names.iter().copied()) {
                        Some(near) => format!("did you mean `{near}`?"),
                        None => "expected `body.face`, or the name of an obstacle".to_owned(),
                    },
                )
                .with_help(format!("the obstacles of this case are {}", listed(&names)))
                .into()),
        }
    }
}
