//! Problems from files and to files, and results of such problems.

use std::path::{Path, PathBuf};

use tresca_contact::FrictionLaw;
use tresca_io::WriteError;
use tresca_io::atomic::OutputSet;
use tresca_io::problem::{self, Content, DenseArray, ProblemError, ProblemFault, Sparse};

use tresca_system::matrices::{
    AlgebraicError, Conditions, Forces, Friction, Kernel, Matrix, MatrixProblem, PairLaw,
};

use crate::algebraic::assembly::Assembly;
use crate::error::SolveError;
use crate::output::Destination;

/// Why a problem could not be read from files.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// Something is wrong with a file.
    #[error(transparent)]
    File(#[from] ProblemError),
    /// The files are in order, but not what they hold.
    #[error("`{}`: {source}", path.display())]
    Content {
        /// The file or folder.
        path: PathBuf,
        /// What is wrong.
        source: AlgebraicError,
    },
}

/// Reads a problem from an `.npz` archive or a folder of Matrix Market files (docs/problem-files.md).
///
/// # Errors
/// Everything that is wrong with the files, with file, key, expected and found.
pub fn read(path: impl AsRef<Path>) -> Result<MatrixProblem, FileError> {
    let path = path.as_ref();
    from_content(problem::read(path)?, path)
}

fn from_content(content: Content, path: &Path) -> Result<MatrixProblem, FileError> {
    let in_file = |source| FileError::Content {
        path: path.to_owned(),
        source,
    };
    let matrix = |what, sparse: &Sparse| {
        Matrix::from_triplets(sparse.shape, &sparse.rows, &sparse.columns, &sparse.values)
            .map_err(|source| in_file(AlgebraicError::Matrix { what, source }))
    };
    let blocks = content
        .stiffness
        .iter()
        .map(|k| matrix("K", k))
        .collect::<Result<Vec<_>, _>>()?;
    let normal = matrix("N", &content.normal)?;
    let m = normal.rows();
    let tangential = content
        .tangential
        .as_ref()
        .map(|t| matrix("T", t))
        .transpose()?;
    let kernel = match &content.kernel {
        None => Kernel::Find,
        Some(vectors) => Kernel::Given(columns(vectors, path)?),
    };
    let points = content
        .points
        .as_ref()
        .map(|points| triples(points, path))
        .transpose()?;
    let friction = friction(&content, m, tangential.is_some(), path)?;
    let start = match (content.start_normal, content.start_tangential) {
        (None, None) => None,
        (normal, tangential_force) => Some(Forces {
            normal: normal.unwrap_or_else(|| vec![0.0; m]),
            tangential: tangential_force
                .unwrap_or_else(|| vec![0.0; tangential.as_ref().map_or(0, Matrix::rows)]),
            kernel_amounts: Vec::new(),
        }),
    };
    Ok(MatrixProblem {
        stiffness: blocks,
        kernel,
        normal,
        tangential,
        points,
        many_solves: false,
        conditions: Conditions {
            load: content.load,
            gap: content.gap,
            friction,
            previous_slip: content.previous_slip,
            start,
        },
    })
}

/// The problem as files hold it.
///
/// # Errors
/// When there are not as many laws as pairs.
fn to_content(own: &MatrixProblem) -> Result<Content, AlgebraicError> {
    let laws = own.conditions.friction.laws(own.pairs())?;
    let figures = |pick: fn(&PairLaw) -> [f64; 2]| {
        let values: Vec<[f64; 2]> = laws.iter().map(pick).collect();
        if values.iter().all(|[a, b]| a == b) {
            DenseArray::vector(values.iter().map(|[a, _]| *a).collect())
        } else {
            DenseArray {
                shape: vec![values.len(), 2],
                values: values.concat(),
            }
        }
    };
    let used =
        |dense: DenseArray, unused: f64| dense.values.iter().any(|&x| x != unused).then_some(dense);
    let bounds = figures(|law| match *law {
        PairLaw::Tresca { bound } | PairLaw::Bilateral { bound } => [bound; 2],
        PairLaw::Orthotropic { bounds } => bounds,
        _ => [0.0; 2],
    });
    let coefficients = figures(|law| match *law {
        PairLaw::Coulomb { coefficients, .. } => coefficients,
        _ => [0.0; 2],
    });
    let limits = figures(|law| match *law {
        PairLaw::Coulomb { limit, .. } => [limit; 2],
        _ => [f64::INFINITY; 2],
    });
    let mut words: Vec<String> = laws.iter().map(|law| law.name().to_owned()).collect();
    let needs_bounds = words
        .iter()
        .any(|word| ["tresca", "orthotropic"].contains(&word.as_str()));
    let needs_coefficients = words.iter().any(|word| word == "coulomb");
    if words.iter().all(|word| *word == words[0]) {
        words.truncate(1);
    }
    let kernel = match &own.kernel {
        Kernel::Find => None,
        Kernel::Given(vectors) => {
            let n = own.dofs();
            let entry = |k: usize| vectors[k % vectors.len()][k / vectors.len()];
            Some(DenseArray {
                shape: vec![n, vectors.len()],
                values: (0..n * vectors.len()).map(entry).collect(),
            })
        }
    };
    let conditions = &own.conditions;
    Ok(Content {
        stiffness: own.stiffness.iter().map(sparse).collect(),
        kernel,
        normal: sparse(&own.normal),
        tangential: own.tangential.as_ref().map(sparse),
        load: conditions.load.clone(),
        gap: conditions.gap.clone(),
        law: Some(words),
        bounds: if needs_bounds {
            Some(bounds)
        } else {
            used(bounds, 0.0)
        },
        coefficients: if needs_coefficients {
            Some(coefficients)
        } else {
            None
        },
        limits: used(limits, f64::INFINITY),
        previous_slip: conditions.previous_slip.clone(),
        start_normal: conditions.start.as_ref().map(|start| start.normal.clone()),
        start_tangential: conditions
            .start
            .as_ref()
            .map(|start| start.tangential.clone()),
        points: own.points.as_ref().map(|points| DenseArray {
            shape: vec![points.len(), 3],
            values: points.as_flattened().to_vec(),
        }),
        info: Vec::new(),
    })
}

fn sparse(matrix: &Matrix) -> Sparse {
    let mut sparse = Sparse {
        shape: (matrix.rows(), matrix.columns()),
        ..Sparse::default()
    };
    for i in 0..matrix.rows() {
        matrix
            .row(i)
            .for_each(|(j, value)| sparse.push(i, j, value));
    }
    sparse
}

fn wrong(path: &Path, key: &str, expected: String, found: String) -> FileError {
    FileError::File(ProblemFault::Wrong { expected, found }.at(path, key))
}

/// The columns of a matrix; a vector is one.
fn columns(dense: &DenseArray, path: &Path) -> Result<Vec<Vec<f64>>, FileError> {
    match dense.shape[..] {
        [_] => Ok(vec![dense.values.clone()]),
        [_, count] => Ok((0..count)
            .map(|column| {
                dense
                    .values
                    .iter()
                    .skip(column)
                    .step_by(count)
                    .copied()
                    .collect()
            })
            .collect()),
        _ => Err(wrong(
            path,
            "kernel",
            "a matrix, dofs × vectors".to_owned(),
            dense.size(),
        )),
    }
}

fn triples(dense: &DenseArray, path: &Path) -> Result<Vec<[f64; 3]>, FileError> {
    match dense.shape[..] {
        [_, 3] => Ok(dense.values.as_chunks().0.to_vec()),
        _ => Err(wrong(
            path,
            "points",
            "a matrix with 3 columns".to_owned(),
            dense.size(),
        )),
    }
}

/// The laws of the pairs from words and figures.
fn friction(
    content: &Content,
    pairs: usize,
    has_tangents: bool,
    path: &Path,
) -> Result<Friction, FileError> {
    let bounds = content
        .bounds
        .as_ref()
        .map(|dense| figures("bounds", dense, pairs, path))
        .transpose()?;
    let coefficients = content
        .coefficients
        .as_ref()
        .map(|dense| figures("coefficients", dense, pairs, path))
        .transpose()?;
    let limits = content
        .limits
        .as_ref()
        .map(|dense| figures("limits", dense, pairs, path))
        .transpose()?;
    let inferred = || {
        let word = match (&content.bounds, &content.coefficients) {
            (Some(_), Some(_)) => {
                return Err(FileError::File(
                    ProblemFault::Missing {
                        meaning: "there are both `bounds` and `coefficients`",
                    }
                    .at(path, "law"),
                ));
            }
            (Some(bounds), None) if bounds.shape.len() == 2 && bounds.shape[1] == 2 => {
                "orthotropic"
            }
            (Some(_), None) => "tresca",
            (None, Some(_)) => "coulomb",
            (None, None) if has_tangents => {
                return Err(FileError::File(
                    ProblemFault::Missing {
                        meaning: "there is T, but no `law`, no `bounds` and no `coefficients`",
                    }
                    .at(path, "law"),
                ));
            }
            (None, None) => "frictionless",
        };
        Ok(vec![word.to_owned()])
    };
    let words = match &content.law {
        Some(words) => words.clone(),
        None => inferred()?,
    };
    if words.len() != 1 && words.len() != pairs {
        let expected = format!("one word, or one for each of {pairs} pairs");
        return Err(wrong(
            path,
            "law",
            expected,
            format!("{} words", words.len()),
        ));
    }
    let law = |pair: usize| {
        let word = &words[if words.len() == 1 { 0 } else { pair }][..];
        let needed = |key: &'static str, figures: &Option<Vec<[f64; 2]>>| {
            figures
                .as_ref()
                .map(|figures| figures[pair])
                .ok_or_else(|| {
                    FileError::File(
                        ProblemFault::Missing {
                            meaning: "the friction law needs it",
                        }
                        .at(path, key),
                    )
                })
        };
        Ok(match word {
            "frictionless" => PairLaw::Frictionless,
            "tied" => PairLaw::Tied,
            "tresca" => {
                let [bound, second] = needed("bounds", &bounds)?;
                if bound != second {
                    let expected = "one bound per pair for the law `tresca`".to_owned();
                    return Err(wrong(
                        path,
                        "bounds",
                        expected,
                        "two that differ".to_owned(),
                    ));
                }
                PairLaw::Tresca { bound }
            }
            "orthotropic" => PairLaw::Orthotropic {
                bounds: needed("bounds", &bounds)?,
            },
            "coulomb" => PairLaw::Coulomb {
                coefficients: needed("coefficients", &coefficients)?,
                limit: limits
                    .as_ref()
                    .map_or(f64::INFINITY, |limits| limits[pair][0]),
            },
            "bilateral" => PairLaw::Bilateral {
                bound: bounds.as_ref().map_or(0.0, |bounds| bounds[pair][0]),
            },
            other => {
                let known = format!("one of {}", FrictionLaw::NAMES.join(", "));
                return Err(wrong(path, "law", known, format!("`{other}`")));
            }
        })
    };
    let laws: Vec<PairLaw> = (0..pairs).map(law).collect::<Result<_, _>>()?;
    Ok(Friction::PerPair(laws))
}

/// Two figures per pair from a number, one per pair, or two per pair.
fn figures(
    key: &str,
    dense: &DenseArray,
    pairs: usize,
    path: &Path,
) -> Result<Vec<[f64; 2]>, FileError> {
    match (&dense.shape[..], &dense.values[..]) {
        ([] | [1], [value]) => Ok(vec![[*value; 2]; pairs]),
        ([length], values) if *length == pairs => {
            Ok(values.iter().map(|&value| [value; 2]).collect())
        }
        ([length, 2], values) if *length == pairs => Ok(values.as_chunks().0.to_vec()),
        _ => {
            let expected = format!("a number, {pairs} numbers or {pairs} × 2");
            Err(wrong(path, key, expected, dense.size()))
        }
    }
}

/// Why a model was not exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The model is wrong.
    #[error(transparent)]
    Model(#[from] SolveError),
    /// A file could not be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The problem has no consistent set of laws.
    #[error(transparent)]
    Problem(#[from] AlgebraicError),
}

impl Assembly {
    /// Writes the problem: an archive when `to` ends with `.npz`, a folder of Matrix Market files else.
    ///
    /// # Errors
    /// [`ExportError::Write`]; what was there before is then still there.
    pub fn write(&self, to: &Path) -> Result<(), ExportError> {
        let mut content = to_content(&self.problem)?;
        if to.extension().is_some_and(|extension| extension == "npz") {
            let place = |values: Vec<f64>, width: usize| DenseArray {
                shape: vec![values.len() / width, width],
                values,
            };
            let frames = self.pairs.iter().map(|pair| &pair.frame);
            let normals = frames.clone().flat_map(|frame| frame.normal).collect();
            let tangents = frames.flat_map(|frame| frame.tangents.concat()).collect();
            let dofs = self
                .dofs
                .iter()
                .flatten()
                .map(|&number| number as f64)
                .collect();
            let areas = self.pairs.iter().map(|pair| pair.area).collect();
            content.info = vec![
                ("normals".to_owned(), place(normals, 3)),
                ("tangents".to_owned(), place(tangents, 6)),
                ("areas".to_owned(), DenseArray::vector(areas)),
                ("dofs".to_owned(), place(dofs, 3)),
            ];
            let name = to
                .file_name()
                .map(|name| name.to_string_lossy().into_owned());
            let mut files = OutputSet::new(folder_of(to))?;
            files.stage(&name.unwrap_or_default(), |out| {
                problem::write_npz(out, &content)
            })?;
            files.commit()?;
        } else {
            Destination::new(to)?;
            let mut files = OutputSet::new(to)?;
            problem::write_folder(&mut files, &content)?;
            files.commit()?;
        }
        Ok(())
    }
}

/// The folder that a file is in.
fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}
