//! Contact pairs.

use serde::Deserialize;
use tresca_contact::{CouplingMethod, ScalarField};
use tresca_io::located::Span;
use tresca_io::names::{listed, nearest};
use tresca_model::{Contact, ContactWithin, PlaceName, PlaceNames};

use crate::error::{CaseError, FaultKind};
use crate::field::{FieldKeys, Kind};
use crate::friction::FrictionKeys;
use crate::reader::Reader;
use crate::text::at::At;

/// `[[contact]]`: two surfaces that may touch.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[contact]]")]
pub(crate) struct ContactKeys {
    /// How load steps and reports call it.
    pub name: Option<At<String>>,
    /// Slave and master surface, each `body.face`; the second may be the name of an obstacle.
    pub pair: Option<At<Vec<At<String>>>>,
    /// In the place of `pair`: the distance (length) at which outer surfaces become pairs.
    pub within: Option<At<f64>>,
    /// Names of the bodies that `within` looks at. Default: all.
    pub bodies: Option<At<Vec<At<String>>>>,
    /// How the two surfaces are coupled. Default: `auto`.
    #[serde(default)]
    pub coupling: CouplingWord,
    /// Largest distance at which points of the surfaces are coupled (length). Default: by the size of
    /// the faces.
    pub search: Option<At<f64>>,
    /// What resists sliding.
    pub friction: At<FrictionKeys>,
    /// Length that is added to the distance of the surfaces. Default: 0.
    pub gap: Option<At<FieldKeys>>,
}

/// `coupling`: how two surfaces are coupled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case", expecting = "the name of a coupling")]
pub(crate) enum CouplingWord {
    /// Node by node where the nodes of two surfaces of linear faces lie on one another, otherwise mortar.
    #[default]
    Auto,
    /// Each node with the one opposite.
    NodeByNode,
    /// By integrals over the common surface.
    Mortar,
}

impl From<CouplingWord> for CouplingMethod {
    fn from(word: CouplingWord) -> Self {
        match word {
            CouplingWord::Auto => CouplingMethod::Auto,
            CouplingWord::NodeByNode => CouplingMethod::NodeByNode,
            CouplingWord::Mortar => CouplingMethod::Mortar,
        }
    }
}

/// What may touch what.
enum Partners {
    /// A surface and another one, or an obstacle.
    Pair(PlaceName, PlaceName),
    /// The outer surfaces of bodies where they are nearer than a distance.
    Within(f64, PlaceNames),
}

impl Reader<'_> {
    pub(crate) fn contacts(&mut self, list: Vec<At<ContactKeys>>) -> Result<(), CaseError> {
        let mut pairs = Vec::new();
        list.into_iter()
            .try_for_each(|keys| self.contact(keys, &mut pairs))
    }

    /// `pairs`: those of the tables before, with their places.
    fn contact(
        &mut self,
        keys: At<ContactKeys>,
        pairs: &mut Vec<At<[PlaceName; 2]>>,
    ) -> Result<(), CaseError> {
        let span = keys.span();
        let keys = keys.value;
        let (place, partners) = self.partners(&keys, &span)?;
        let friction = self.friction(&keys.friction)?;
        if let Partners::Pair(slave, master) = &partners {
            let mut pair = [slave.clone(), master.clone()];
            pair.sort();
            let pair = At::new(place, pair);
            if let Some(first) = pairs.iter().find(|other| **other == pair) {
                return Err(self
                    .fault(
                        FaultKind::Duplicate,
                        pair.span(),
                        "these two surfaces are already a contact pair",
                        "the second time",
                    )
                    .and_at(first.span(), "the first time")
                    .with_help("a pair stands in one [[contact]] only: a second one would constrain the same points again")
                    );
            }
            pairs.push(pair);
        }
        let gap = match &keys.gap {
            Some(gap) => self.field("the gap", Kind::Signed, gap, "")?,
            None => ScalarField::Constant(0.0),
        };
        let name = self.checked_name(keys.name)?;
        let help = "it is the largest distance at which points of the two surfaces are coupled";
        let search = keys.search.as_ref();
        let search = search.map(|search| self.positive("the search distance", search, help));
        let search = search.transpose()?;
        let text = name.as_ref().map(|name| name.value.clone());
        let (model, coupling) = (&mut self.model, keys.coupling.into());
        let added = match partners {
            Partners::Pair(slave, master) => {
                let mut contact = Contact::new(slave, master, friction)
                    .gap(gap)
                    .coupling(coupling);
                (contact.name, contact.search) = (text, search);
                model.add_contact(contact).map(|id| vec![id])
            }
            Partners::Within(distance, bodies) => {
                let near = ContactWithin::within(distance, friction).bodies(bodies);
                let mut near = near.gap(gap).coupling(coupling);
                near.name = text;
                model.add_contacts_within(near)
            }
        };
        let added = added.map_err(|error| self.refused(&span, error))?;
        let made = added.into_iter().map(Into::into).collect();
        self.origins.note(&span, name, made);
        Ok(())
    }

    /// With the place of the keys that say it.
    fn partners(&self, keys: &ContactKeys, span: &Span) -> Result<(Span, Partners), CaseError> {
        match (&keys.pair, &keys.within) {
            (Some(pair), Some(within)) => Err(self
                .fault(
                    FaultKind::Duplicate,
                    within.span(),
                    "`pair` and `within` exclude each other",
                    "pairs are found by this distance",
                )
                .and_at(pair.span(), "the pair is given")
                .with_help("remove one of the two; `search` is the distance at which a given pair is coupled")),
            (None, None) => Err(self
                .fault(
                    FaultKind::MissingKey,
                    span.clone(),
                    "missing key `pair`",
                    "expected `pair` in this table",
                )
                .with_help("`pair = [\"slave.face\", \"master.face\"]` names two surfaces; `within = 0.1` finds the pairs by a distance")),
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
                        );
                }
                Ok((pair.span(), self.pair(pair)?))
            }
            (None, Some(within)) => {
                let help = "outer surfaces of two bodies that are nearer than this become a pair";
                let distance = self.positive("the distance", within, help)?;
                let listed = self.body_list(keys.bodies.as_ref())?;
                if listed.0.len() < 2 {
                    let place = keys.bodies.as_ref().map_or(within.span(), At::span);
                    return Err(self
                        .fault(
                            FaultKind::BadValue,
                            place,
                            "pairs are found between different bodies",
                            "expected two bodies or more",
                        )
                        .with_help("contact of a body with itself is not supported")
                        );
                }
                Ok((within.span(), Partners::Within(distance, listed)))
            }
        }
    }

    fn pair(&self, pair: &At<Vec<At<String>>>) -> Result<Partners, CaseError> {
        let [slave, master] = pair.as_slice() else {
            return Err(self
                .fault(
                    FaultKind::WrongType,
                    pair.span(),
                    "a contact pair has two surfaces",
                    format!("expected 2 entries, found {}", pair.len()),
                )
                .with_help("write `pair = [\"slave.face\", \"master.face\"]`; more pairs get their own [[contact]]")
                );
        };
        if self.origins.obstacles.contains(slave) {
            return Err(self
                .fault(
                    FaultKind::BadReference,
                    slave.span(),
                    "the first of a pair is a surface of a body",
                    "an obstacle",
                )
                .with_help(
                    "write the obstacle second: the first surface carries the contact forces",
                ));
        }
        let slave = self.surface(slave)?;
        if self.is_obstacle(master)? {
            let obstacle = PlaceName::from(master.as_str());
            return Ok(Partners::Pair(slave.value, obstacle));
        }
        let master = self.surface(master)?;
        if slave == master {
            return Err(self
                .fault(
                    FaultKind::Duplicate,
                    master.span(),
                    "a surface cannot be in contact with itself",
                    "expected another surface than the first",
                )
                .and_at(slave.span(), "the first")
                .with_help("a pair names the two surfaces that face each other"));
        }
        Ok(Partners::Pair(slave.value, master.value))
    }

    /// Whether a name means an obstacle: it has no dot, and there are obstacles that could be meant.
    fn is_obstacle(&self, name: &At<String>) -> Result<bool, CaseError> {
        let obstacles = &self.origins.obstacles;
        if obstacles.is_empty() || name.contains('.') {
            return Ok(false);
        }
        if obstacles.contains(name) {
            return Ok(true);
        }
        let names: Vec<&str> = obstacles.iter().map(|name| name.as_str()).collect();
        Err(self
            .fault(
                FaultKind::BadReference,
                name.span(),
                format!("there is no obstacle `{}`", name.value),
                match nearest(name, names.iter().copied()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => "expected `body.face`, or the name of an obstacle".to_owned(),
                },
            )
            .with_help(format!("the obstacles of this case are {}", listed(&names))))
    }
}
