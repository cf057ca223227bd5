//! Where things act: names of places as users write them, and what they are in a model.

use std::fmt;

/// A named set of faces, or of nodes, of a body of a model. Only supports act on sets of nodes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Index of the body in [`Model::bodies`](crate::Model::bodies).
    pub body: usize,
    /// Name of the set in the body's mesh.
    pub set: String,
}

/// What a user calls a place: `body.set`, or a body or an obstacle by its name alone.
///
/// Texts are cut at their first dot, as in case files. Where a body has a dot in its name, a pair says what is what:
/// `("bolt.1", "head")`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PlaceName {
    /// Name of the body, or of the obstacle.
    pub owner: String,
    /// Name of a set of its faces or nodes, if not all of it is meant.
    pub set: Option<String>,
}

impl fmt::Display for PlaceName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.set {
            Some(set) => write!(f, "{}.{set}", self.owner),
            None => f.write_str(&self.owner),
        }
    }
}

impl From<&str> for PlaceName {
    fn from(text: &str) -> Self {
        let (owner, set) = match text.split_once('.') {
            Some((body, set)) => (body, Some(set.to_owned())),
            None => (text, None),
        };
        let owner = owner.to_owned();
        Self { owner, set }
    }
}

impl From<(&str, &str)> for PlaceName {
    fn from((body, set): (&str, &str)) -> Self {
        Self {
            owner: body.to_owned(),
            set: Some(set.to_owned()),
        }
    }
}

/// A list of [`PlaceName`]s: one, several, or none.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PlaceNames(pub Vec<PlaceName>);

impl<T: Into<PlaceName>> FromIterator<T> for PlaceNames {
    fn from_iter<I: IntoIterator<Item = T>>(names: I) -> Self {
        Self(names.into_iter().map(Into::into).collect())
    }
}

impl From<PlaceName> for PlaceNames {
    fn from(name: PlaceName) -> Self {
        Self(vec![name])
    }
}

impl From<&str> for PlaceNames {
    fn from(name: &str) -> Self {
        Self(vec![name.into()])
    }
}

impl From<(&str, &str)> for PlaceNames {
    fn from(name: (&str, &str)) -> Self {
        Self(vec![name.into()])
    }
}

impl<T: Into<PlaceName>, const N: usize> From<[T; N]> for PlaceNames {
    fn from(names: [T; N]) -> Self {
        names.into_iter().collect()
    }
}

impl<T: Into<PlaceName>> From<Vec<T>> for PlaceNames {
    fn from(names: Vec<T>) -> Self {
        names.into_iter().collect()
    }
}
