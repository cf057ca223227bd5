//! Reading FCLIB.

use hdf5_pure::{Error, File, FormatError};

use super::super::error::Trouble;
use super::super::matrix::check_pointers;
use super::super::problem::{
    Document, FclibProblem, GlobalProblem, Info, LocalProblem, State, dimension,
};
use crate::fclib::error::Defect;
use crate::fclib::matrix::FclibMatrix;

/// A problem and what comes with it, from the bytes of the file.
pub fn read(bytes: Vec<u8>) -> Result<Document, Trouble> {
    let reader = Reader(File::from_bytes(bytes).map_err(|error| damaged(error).at("/"))?);
    let (problem, info) = if reader.has("/fclib_local")? {
        (reader.local()?, "/fclib_local/info")
    } else if reader.has("/fclib_global")? {
        (reader.global()?, "/fclib_global/info")
    } else {
        return Err(Defect::NoProblem.at("/"));
    };
    let document = Document {
        info: reader.info(info)?,
        solution: reader.solution()?,
        guesses: reader.guesses()?,
        problem,
    };
    document.check().map_err(|(part, defect)| defect.at(part))?;
    Ok(document)
}

struct Reader(File);

impl Reader {
    fn local(&self) -> Result<FclibProblem, Trouble> {
        for part in ["V", "R"] {
            self.without(&format!("/fclib_local/{part}"))?;
        }
        Ok(FclibProblem::Local(LocalProblem {
            dimension: self.dimension("/fclib_local/spacedim")?,
            w: self.matrix("/fclib_local/W")?,
            q: self.numbers("/fclib_local/vectors/q")?,
            friction: self.numbers("/fclib_local/vectors/mu")?,
        }))
    }

    fn global(&self) -> Result<FclibProblem, Trouble> {
        self.without("/fclib_global/G")?;
        Ok(FclibProblem::Global(GlobalProblem {
            dimension: self.dimension("/fclib_global/spacedim")?,
            m: self.matrix("/fclib_global/M")?,
            h: self.matrix("/fclib_global/H")?,
            f: self.numbers("/fclib_global/vectors/f")?,
            w: self.numbers("/fclib_global/vectors/w")?,
            friction: self.numbers("/fclib_global/vectors/mu")?,
        }))
    }

    fn info(&self, group: &str) -> Result<Info, Trouble> {
        Ok(Info {
            title: self.text(&format!("{group}/title"))?,
            description: self.text(&format!("{group}/description"))?,
            math_info: self.text(&format!("{group}/math_info"))?,
        })
    }

    fn solution(&self) -> Result<Option<State>, Trouble> {
        let there = self.has("/solution")?;
        there.then(|| self.state("/solution")).transpose()
    }

    fn guesses(&self) -> Result<Vec<State>, Trouble> {
        if !self.has("/guesses")? {
            return Ok(Vec::new());
        }
        let count = self.count("/guesses/number_of_guesses")?;
        (1..=count)
            .map(|number| self.state(&format!("/guesses/{number}")))
            .collect()
    }

    fn state(&self, group: &str) -> Result<State, Trouble> {
        let v = format!("{group}/v");
        let v = if self.has(&v)? {
            Some(self.numbers(&v)?)
        } else {
            None
        };
        Ok(State {
            v,
            u: self.numbers(&format!("{group}/u"))?,
            r: self.numbers(&format!("{group}/r"))?,
        })
    }

    fn dimension(&self, name: &str) -> Result<usize, Trouble> {
        dimension(self.integer(name)?).map_err(|defect| defect.at(name))
    }

    fn matrix(&self, group: &str) -> Result<FclibMatrix, Trouble> {
        let part = |name: &str| format!("{group}/{name}");
        let rows = self.count(&part("m"))?;
        let columns = self.count(&part("n"))?;
        let storage = self.integer(&part("nz"))?;
        let pointers = self.counts(&part("p"))?;
        let indices = self.counts(&part("i"))?;
        let values = self.numbers(&part("x"))?;
        let entries = match storage {
            -1 => compressed(&pointers, &indices, &values, columns).map(|triple| {
                triple
                    .map(|(column, row, value)| (row, column, value))
                    .collect()
            }),
            -2 => compressed(&pointers, &indices, &values, rows).map(Iterator::collect),
            0.. => triplets(&pointers, &indices, &values, storage, (rows, columns)),
            other => Err(("nz", Defect::Storage(other))),
        };
        let entries = entries.map_err(|(name, defect)| defect.at(part(name)))?;
        FclibMatrix::new(rows, columns, entries).map_err(|defect| defect.at(group))
    }

    fn has(&self, path: &str) -> Result<bool, Trouble> {
        match self.0.group(path) {
            Ok(_) | Err(Error::NotAGroup(_)) => Ok(true),
            Err(Error::Format(FormatError::PathNotFound(_))) => Ok(false),
            Err(error) => Err(damaged(error).at(path)),
        }
    }

    /// Refuses a part of FCLIB that is not taken over.
    fn without(&self, group: &str) -> Result<(), Trouble> {
        match self.has(group)? {
            true => Err(Defect::Unsupported("linear constraints (G, b or V, R, s)").at(group)),
            false => Ok(()),
        }
    }

    fn numbers(&self, name: &str) -> Result<Vec<f64>, Trouble> {
        let values = self.0.dataset(name).and_then(|set| set.read_f64());
        values.map_err(|error| damaged(error).at(name))
    }

    fn integers(&self, name: &str) -> Result<Vec<i64>, Trouble> {
        let values = self.0.dataset(name).and_then(|set| set.read_i64());
        values.map_err(|error| damaged(error).at(name))
    }

    fn integer(&self, name: &str) -> Result<i64, Trouble> {
        match self.integers(name)?[..] {
            [value] => Ok(value),
            ref values => Err(Defect::Length {
                expected: 1,
                found: values.len(),
            }
            .at(name)),
        }
    }

    fn count(&self, name: &str) -> Result<usize, Trouble> {
        as_count(self.integer(name)?).map_err(|defect| defect.at(name))
    }

    fn counts(&self, name: &str) -> Result<Vec<usize>, Trouble> {
        let counts = self.integers(name)?.into_iter().map(as_count).collect();
        Result::map_err(counts, |defect: Defect| defect.at(name))
    }

    fn text(&self, name: &str) -> Result<Option<String>, Trouble> {
        if !self.has(name)? {
            return Ok(None);
        }
        let text = self.0.dataset(name).and_then(|set| set.read_string());
        let text = text.map_err(|error| damaged(error).at(name))?;
        // Strings of C end with a zero.
        Ok(text
            .first()
            .map(|text| text.trim_end_matches('\0').to_owned()))
    }
}

fn as_count(value: i64) -> Result<usize, Defect> {
    usize::try_from(value).map_err(|_| Defect::Negative(value))
}

fn damaged(error: Error) -> Defect {
    match error {
        Error::Format(FormatError::PathNotFound(_)) => Defect::Missing,
        other => Defect::Hdf5(Box::new(other)),
    }
}

type Part = (&'static str, Defect);

/// (line, index, value) of compressed rows or columns, which are called lines here. There may be more
/// space for entries than there are entries.
fn compressed<'a>(
    pointers: &'a [usize],
    indices: &'a [usize],
    values: &'a [f64],
    lines: usize,
) -> Result<impl Iterator<Item = (usize, usize, f64)> + 'a, Part> {
    if pointers.len() != lines + 1 {
        let (expected, found) = (lines + 1, pointers.len());
        return Err(("p", Defect::Length { expected, found }));
    }
    check_pointers(pointers, indices.len().min(values.len())).map_err(|defect| ("p", defect))?;
    Ok((0..lines).flat_map(move |line| {
        (pointers[line]..pointers[line + 1]).map(move |k| (line, indices[k], values[k]))
    }))
}

/// Entries of a triplet matrix. FCLIB calls `p` its rows and `i` its columns; CSparse, whose structure
/// it is and whose matrices Siconos writes as they are, has it the other way round. The latter is
/// taken unless only the former fits the size of the matrix.
fn triplets(
    p: &[usize],
    i: &[usize],
    values: &[f64],
    count: i64,
    (rows, columns): (usize, usize),
) -> Result<Vec<(usize, usize, f64)>, Part> {
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    for (name, found) in [("p", p.len()), ("i", i.len()), ("x", values.len())] {
        if found < count {
            return Err((
                name,
                Defect::Length {
                    expected: count,
                    found,
                },
            ));
        }
    }
    let (p, i) = (&p[..count], &i[..count]);
    let below = |indices: &[usize], size: usize| indices.iter().all(|&index| index < size);
    let as_csparse = below(i, rows) && below(p, columns);
    let as_described = below(p, rows) && below(i, columns);
    let (row, column) = if as_described && !as_csparse {
        (p, i)
    } else {
        (i, p)
    };
    Ok(row
        .iter()
        .zip(column)
        .zip(values)
        .map(|((&row, &column), &value)| (row, column, value))
        .collect())
}
