//! Writing FCLIB.

use std::io::Write;

use hdf5_pure::{FileBuilder, GroupBuilder, LibVer};

use super::super::problem::{Document, FclibProblem, Info, State};
use crate::error::WriteError;
use crate::fclib::matrix::FclibMatrix;

impl Document {
    /// Writes the document in the layout of FCLIB, in the format of HDF5 1.8, matrices by compressed
    /// columns.
    ///
    /// # Errors
    /// [`WriteError::Problem`] when the parts do not fit together, [`WriteError::Hdf5`] for a matrix
    /// whose sizes exceed the 32 bits that FCLIB has for them, and those of the stream.
    pub fn write_hdf5(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        self.writable()?;
        let mut file = FileBuilder::new();
        // FCLIB is read by programs with old libraries.
        file.with_libver_bounds(LibVer::Earliest, LibVer::V18);
        let name = match &self.problem {
            FclibProblem::Local(_) => "fclib_local",
            FclibProblem::Global(_) => "fclib_global",
        };
        let mut group = file.create_group(name);
        problem(&mut group, &self.problem)?;
        info(&mut group, &self.info)?;
        file.add_group(group.finish());
        if let Some(solution) = &self.solution {
            let mut group = file.create_group("solution");
            state(&mut group, solution);
            file.add_group(group.finish());
        }
        if !self.guesses.is_empty() {
            let mut group = file.create_group("guesses");
            integers(&mut group, "number_of_guesses", &[self.guesses.len()])?;
            for (index, guess) in self.guesses.iter().enumerate() {
                let mut own = group.create_group(&(index + 1).to_string());
                state(&mut own, guess);
                group.add_group(own.finish());
            }
            file.add_group(group.finish());
        }
        out.write_all(&file.finish().map_err(refused)?)?;
        Ok(())
    }
}

fn problem(group: &mut GroupBuilder, problem: &FclibProblem) -> Result<(), WriteError> {
    integers(group, "spacedim", &[problem.dimension()])?;
    let mut vectors = group.create_group("vectors");
    match problem {
        FclibProblem::Local(local) => {
            matrix(group, "W", &local.w)?;
            numbers(&mut vectors, "q", &local.q);
        }
        FclibProblem::Global(global) => {
            matrix(group, "M", &global.m)?;
            matrix(group, "H", &global.h)?;
            numbers(&mut vectors, "f", &global.f);
            numbers(&mut vectors, "w", &global.w);
        }
    }
    numbers(&mut vectors, "mu", problem.friction());
    group.add_group(vectors.finish());
    Ok(())
}

fn matrix(group: &mut GroupBuilder, name: &str, matrix: &FclibMatrix) -> Result<(), WriteError> {
    let mut entries = matrix.entries().to_vec();
    // By rows they are; a stable sort makes them by columns, rows ascending.
    entries.sort_by_key(|&(_, column, _)| column);
    let mut pointers = vec![0; matrix.columns() + 1];
    for &(_, column, _) in &entries {
        pointers[column + 1] += 1;
    }
    for column in 0..matrix.columns() {
        pointers[column + 1] += pointers[column];
    }
    let rows: Vec<usize> = entries.iter().map(|&(row, _, _)| row).collect();
    let values: Vec<f64> = entries.iter().map(|&(_, _, value)| value).collect();
    let mut own = group.create_group(name);
    integers(&mut own, "nzmax", &[entries.len()])?;
    integers(&mut own, "m", &[matrix.rows()])?;
    integers(&mut own, "n", &[matrix.columns()])?;
    own.create_dataset("nz").with_i32_data(&[-1]);
    integers(&mut own, "p", &pointers)?;
    integers(&mut own, "i", &rows)?;
    numbers(&mut own, "x", &values);
    group.add_group(own.finish());
    Ok(())
}

fn info(group: &mut GroupBuilder, info: &Info) -> Result<(), WriteError> {
    let texts = [
        ("title", &info.title),
        ("description", &info.description),
        ("math_info", &info.math_info),
    ];
    if texts.iter().all(|(_, text)| text.is_none()) {
        return Ok(());
    }
    let mut own = group.create_group("info");
    for (name, text) in texts {
        let Some(text) = text else { continue };
        // With the zero at the end that programs in C count on.
        let width = u32::try_from(text.len() + 1).map_err(refused)?;
        let dataset = own.create_dataset(name);
        if text.is_ascii() {
            dataset.with_ascii_strings_sized(&[text], width)
        } else {
            dataset.with_strings_sized(&[text], width)
        }
        .map_err(refused)?
        .with_shape(&[]);
    }
    group.add_group(own.finish());
    Ok(())
}

fn state(group: &mut GroupBuilder, state: &State) {
    if let Some(v) = &state.v {
        numbers(group, "v", v);
    }
    numbers(group, "u", &state.u);
    numbers(group, "r", &state.r);
}

fn numbers(group: &mut GroupBuilder, name: &str, values: &[f64]) {
    group.create_dataset(name).with_f64_data(values);
}

fn integers(group: &mut GroupBuilder, name: &str, values: &[usize]) -> Result<(), WriteError> {
    let values: Result<Vec<i32>, _> = values.iter().map(|&value| i32::try_from(value)).collect();
    group
        .create_dataset(name)
        .with_i32_data(&values.map_err(refused)?);
    Ok(())
}

fn refused(error: impl std::error::Error + Send + Sync + 'static) -> WriteError {
    WriteError::Hdf5(Box::new(error))
}
