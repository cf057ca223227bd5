//! The keys of a problem, whatever the format.

use std::path::Path;

use crate::names::nearest;
use crate::problem::arrays::{DenseArray, Sparse};
use crate::problem::error::{ProblemError, ProblemFault};

/// Every key, with what it means. Blocks of K may also be called `K0`, `K1`, ….
pub const KEYS: &[(&str, &str)] = &[
    ("K", "stiffness, n × n; or its diagonal blocks K0, K1, …"),
    (
        "kernel",
        "vectors that span the kernel of K, n × r; found without it",
    ),
    ("N", "approach along the normals, m × n"),
    (
        "T",
        "slip, m × n in the plane, 2m × n in space; without it no friction",
    ),
    (
        "B",
        "N and T in one, N first; then `pairs` says where T begins",
    ),
    ("pairs", "m; only with B"),
    ("f", "load, n"),
    ("gap", "gaps, m; 0 without it"),
    ("law", "friction law, a word or one per pair"),
    ("bounds", "slip bounds (forces): a number, m, or m × 2"),
    (
        "coefficients",
        "Coulomb coefficients: a number, m, or m × 2",
    ),
    (
        "limits",
        "upper limits of Coulomb's slip bounds (forces): a number or m",
    ),
    (
        "previous_slip",
        "slip that friction has to be counted from, rows of T",
    ),
    ("start_normal", "normal forces to start from, m"),
    (
        "start_tangential",
        "friction forces to start from, rows of T",
    ),
    ("points", "where the pairs are, m × 3"),
];

/// Words, one for all or one per pair.
pub type Words = Vec<String>;

/// A problem as its files have it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Content {
    /// K: one matrix, or its diagonal blocks.
    pub stiffness: Vec<Sparse>,
    /// Vectors over all dofs, n × r.
    pub kernel: Option<DenseArray>,
    /// N.
    pub normal: Sparse,
    /// T.
    pub tangential: Option<Sparse>,
    /// f.
    pub load: Vec<f64>,
    /// d.
    pub gap: Option<Vec<f64>>,
    /// Friction laws.
    pub law: Option<Words>,
    /// Slip bounds.
    pub bounds: Option<DenseArray>,
    /// Coulomb coefficients.
    pub coefficients: Option<DenseArray>,
    /// Limits of Coulomb's bounds.
    pub limits: Option<DenseArray>,
    /// Slip of the step before.
    pub previous_slip: Option<Vec<f64>>,
    /// λν to start from.
    pub start_normal: Option<Vec<f64>>,
    /// λτ to start from.
    pub start_tangential: Option<Vec<f64>>,
    /// Points of the pairs, m × 3.
    pub points: Option<DenseArray>,
    /// What else a writer wants to say, under `info/` in an archive: name and array. Not read.
    pub info: Vec<(String, DenseArray)>,
}

/// Where arrays come from.
pub(super) trait Source {
    /// The file or folder.
    fn path(&self) -> &Path;
    /// All keys; parts of a matrix such as `K/data` count as that matrix.
    fn keys(&self) -> Vec<String>;
    /// A matrix.
    fn sparse(&mut self, key: &str) -> Result<Sparse, ProblemError>;
    /// An array of numbers.
    fn dense(&mut self, key: &str) -> Result<DenseArray, ProblemError>;
    /// Words.
    fn words(&mut self, key: &str) -> Result<Words, ProblemError>;
}

/// Reads everything.
pub(super) fn collect(source: &mut dyn Source) -> Result<Content, ProblemError> {
    let keys = source.keys();
    let path = source.path().to_owned();
    let known =
        |key: &str| KEYS.iter().any(|(known, _)| *known == key) || block_number(key).is_some();
    if let Some(key) = keys.iter().find(|key| !known(key)) {
        return Err(ProblemFault::Unknown {
            nearest: nearest(key, KEYS.iter().map(|(known, _)| *known)).map(str::to_owned),
        }
        .at(&path, key.clone()));
    }
    let has = |key: &str| keys.iter().any(|own| own == key);
    let missing = |key: &str, meaning| ProblemFault::Missing { meaning }.at(&path, key);
    let wrong = |key: &str, expected: &str, found: String| {
        ProblemFault::Wrong {
            expected: expected.to_owned(),
            found,
        }
        .at(&path, key)
    };

    let blocks = keys.iter().filter_map(|key| block_number(key)).count();
    let stiffness = match (has("K"), blocks) {
        (true, 0) => vec![source.sparse("K")?],
        (true, _) => {
            return Err(wrong(
                "K",
                "either K or the blocks K0, K1, …",
                "both".to_owned(),
            ));
        }
        (false, 0) => {
            return Err(missing(
                "K",
                "the stiffness matrix (or its blocks K0, K1, …)",
            ));
        }
        (false, count) => {
            let mut all = Vec::with_capacity(count);
            for block in 0..count {
                let key = format!("K{block}");
                if !has(&key) {
                    return Err(missing(
                        &key,
                        "the blocks of K are numbered without gaps from 0",
                    ));
                }
                all.push(source.sparse(&key)?);
            }
            all
        }
    };
    let (normal, tangential) = if has("B") {
        if has("N") || has("T") {
            return Err(wrong("B", "either B or N and T", "both".to_owned()));
        }
        if !has("pairs") {
            return Err(missing("pairs", "the number of rows of N in B"));
        }
        let pairs = source.dense("pairs")?;
        let b = source.sparse("B")?;
        match pairs.values[..] {
            [m] if m.fract() == 0.0 && m >= 0.0 && m <= b.shape.0 as f64 => split(&b, m as usize),
            _ => return Err(wrong("pairs", "the number of rows of N in B", pairs.size())),
        }
    } else {
        if !has("N") {
            return Err(missing(
                "N",
                "the rows that give the approach along the normals (or B)",
            ));
        }
        let tangential = if has("T") {
            Some(source.sparse("T")?)
        } else {
            None
        };
        (source.sparse("N")?, tangential)
    };
    if !has("f") {
        return Err(missing("f", "the load vector"));
    }
    let mut vector = |key: &str| -> Result<Option<Vec<f64>>, ProblemError> {
        if !has(key) {
            return Ok(None);
        }
        match source.dense(key)?.into_vector() {
            Ok(values) => Ok(Some(values)),
            Err(dense) => Err(wrong(key, "a vector", dense.size())),
        }
    };
    let load = vector("f")?.unwrap_or_default();
    let gap = vector("gap")?;
    let previous_slip = vector("previous_slip")?;
    let start_normal = vector("start_normal")?;
    let start_tangential = vector("start_tangential")?;
    let mut dense = |key: &str| {
        if has(key) {
            source.dense(key).map(Some)
        } else {
            Ok(None)
        }
    };
    Ok(Content {
        kernel: dense("kernel")?,
        bounds: dense("bounds")?,
        coefficients: dense("coefficients")?,
        limits: dense("limits")?,
        points: dense("points")?,
        law: if has("law") {
            Some(source.words("law")?)
        } else {
            None
        },
        stiffness,
        normal,
        tangential,
        load,
        gap,
        previous_slip,
        start_normal,
        start_tangential,
        info: Vec::new(),
    })
}

/// i of `K<i>`.
fn block_number(key: &str) -> Option<usize> {
    let digits = key.strip_prefix('K')?;
    let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let number = digits.parse().ok().filter(|_| plain)?;
    // `K01` is not the block 1.
    (digits.len() == 1 || !digits.starts_with('0')).then_some(number)
}

/// N and T of B, `pairs` rows of N.
fn split(b: &Sparse, pairs: usize) -> (Sparse, Option<Sparse>) {
    let (rows, columns) = b.shape;
    let mut normal = Sparse {
        shape: (pairs, columns),
        ..Sparse::default()
    };
    let mut tangential = Sparse {
        shape: (rows - pairs, columns),
        ..Sparse::default()
    };
    for ((&row, &column), &value) in b.rows.iter().zip(&b.columns).zip(&b.values) {
        if row < pairs {
            normal.push(row, column, value);
        } else {
            tangential.push(row - pairs, column, value);
        }
    }
    (normal, (rows > pairs).then_some(tangential))
}

/// The arrays of a problem by key: what the writers write.
pub(super) struct Parts<'a> {
    pub sparse: Vec<(String, &'a Sparse)>,
    pub dense: Vec<(&'static str, DenseArray)>,
    pub law: Option<&'a Words>,
}

impl Content {
    pub(super) fn parts(&self) -> Parts<'_> {
        let mut sparse = match &self.stiffness[..] {
            [k] => vec![("K".to_owned(), k)],
            blocks => blocks
                .iter()
                .enumerate()
                .map(|(block, k)| (format!("K{block}"), k))
                .collect(),
        };
        sparse.push(("N".to_owned(), &self.normal));
        sparse.extend(self.tangential.iter().map(|t| ("T".to_owned(), t)));
        let vector = |values: &Vec<f64>| DenseArray::vector(values.clone());
        let optional = [
            ("f", Some(vector(&self.load))),
            ("gap", self.gap.as_ref().map(vector)),
            ("kernel", self.kernel.clone()),
            ("bounds", self.bounds.clone()),
            ("coefficients", self.coefficients.clone()),
            ("limits", self.limits.clone()),
            ("previous_slip", self.previous_slip.as_ref().map(vector)),
            ("start_normal", self.start_normal.as_ref().map(vector)),
            (
                "start_tangential",
                self.start_tangential.as_ref().map(vector),
            ),
            ("points", self.points.clone()),
        ];
        Parts {
            sparse,
            dense: optional
                .into_iter()
                .filter_map(|(key, array)| Some((key, array?)))
                .collect(),
            law: self.law.as_ref(),
        }
    }
}
