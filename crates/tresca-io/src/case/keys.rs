//! Every key of a case file, as it stands in the text. `docs/case-file.md` says the same for readers
//! of the documentation; a test compares the two.
//!
//! Values that a check may want to point at are [`Spanned`]. Whole numbers are accepted where
//! numbers are expected. No unit is fixed: any consistent system will do (mm, N, MPa; m, N, Pa).

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::{DeserializeOwned, Deserializer, SeqAccess, Visitor};
use toml::Spanned;

/// The whole file.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    bound = "S: DeserializeOwned + Default",
    expecting = "a case file"
)]
pub(super) struct CaseKeys<S> {
    /// Headline of reports. Default: the name of the file.
    pub title: Option<String>,
    /// The elastic bodies; at least one.
    pub body: Option<Spanned<Vec<Body>>>,
    /// Surfaces that are held.
    #[serde(default)]
    pub clamp: Vec<ClampKeys>,
    /// Surfaces that are loaded.
    #[serde(default)]
    pub traction: Vec<TractionKeys>,
    /// Pairs of surfaces that may touch.
    #[serde(default)]
    pub contact: Vec<Spanned<ContactKeys>>,
    /// Settings of the solver; the keys are those of the caller's type.
    #[serde(default)]
    pub solver: S,
}

/// `[[body]]`: an elastic body.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[body]]")]
pub struct Body {
    /// How other keys and the written files call the body: letters, digits, `_` and `-`.
    pub name: Spanned<String>,
    /// Where the mesh comes from.
    pub mesh: Spanned<Mesh>,
    /// What the body is made of.
    pub material: Spanned<Material>,
}

/// `mesh`: where the mesh comes from, one kind per body.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    rename_all = "lowercase",
    expecting = "a table `{ brick = { min = …, max = …, nodes = … } }`"
)]
pub enum Mesh {
    /// A box with edges along the axes, cut into eight-node hexahedra.
    Brick(Brick),
}

/// `brick`: a box with edges along the axes. Its faces are called `x-`, `x+`, `y-`, `y+`, `z-`, `z+`.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ min = …, max = …, nodes = … }`"
)]
pub struct Brick {
    /// Corner with the smallest coordinates (length).
    pub min: Spanned<Triple<f64>>,
    /// Corner with the largest coordinates (length), each larger than in `min`.
    pub max: Spanned<Triple<f64>>,
    /// Number of nodes along x, y and z, ends included; at least 2 each.
    pub nodes: Spanned<Triple<usize>>,
}

/// `material`: isotropic linear elasticity.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ young = …, poisson = … }`"
)]
pub struct Material {
    /// Young's modulus (force per area), positive.
    pub young: Spanned<f64>,
    /// Poisson's ratio, above -1 and below 0.5.
    pub poisson: Spanned<f64>,
}

/// `[[clamp]]`: surfaces whose displacement is zero.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[clamp]]")]
pub(super) struct ClampKeys {
    /// The surfaces, each `body.face`.
    pub on: Spanned<Vec<Spanned<String>>>,
}

/// `[[traction]]`: a constant force per area on surfaces.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[traction]]")]
pub(super) struct TractionKeys {
    /// The surfaces, each `body.face`.
    pub on: Spanned<Vec<Spanned<String>>>,
    /// The traction vector (force per area), in the directions of the axes.
    pub value: Spanned<Triple<f64>>,
}

/// `[[contact]]`: two surfaces that may touch.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of keys under [[contact]]")]
pub(super) struct ContactKeys {
    /// Slave and master surface, each `body.face`.
    pub pair: Spanned<Vec<Spanned<String>>>,
    /// What resists sliding.
    pub friction: Spanned<FrictionKeys>,
}

/// `friction`: the law and its figures. All figures of all laws stand here; which of them a law
/// needs is checked afterwards, so that the report can name the law.
#[derive(Debug, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a table `{ law = \"tresca\", bound = … }`"
)]
pub(super) struct FrictionKeys {
    /// The law: `tresca`.
    pub law: Spanned<String>,
    /// Slip bound (force per area), 0 or more: the tangential traction at which the pair slides.
    pub bound: Option<Spanned<f64>>,
}

/// Three values for the directions x, y, z, each with its place in the file.
#[derive(Clone, Debug)]
pub struct Triple<T>(pub [Spanned<T>; 3]);

impl<T: Copy> Triple<T> {
    /// The values alone.
    pub fn values(&self) -> [T; 3] {
        std::array::from_fn(|axis| *self.0[axis].get_ref())
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Triple<T> {
    /// Not derived: the array of the standard library takes the first three of a longer list.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(TripleVisitor(PhantomData))
    }
}

struct TripleVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for TripleVisitor<T> {
    type Value = Triple<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of three numbers [x, y, z]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Triple<T>, A::Error> {
        let mut values = Vec::with_capacity(3);
        while let Some(value) = sequence.next_element()? {
            values.push(value);
        }
        let found = values.len();
        let values = <[Spanned<T>; 3]>::try_from(values)
            .map_err(|_| serde::de::Error::invalid_length(found, &self))?;
        Ok(Triple(values))
    }
}
