//! Writing the text.

use std::io::Write;

use super::super::problem::{Document, FclibProblem};
use crate::error::WriteError;
use crate::fclib::matrix::FclibMatrix;

/// The word in the version line of a sparse matrix; readers skip that line.
const WRITER: &str = "CSparse triplets, written by tresca";

impl Document {
    /// Writes the problem as Siconos does; matrices dense, or sparse where that is shorter. The text
    /// has no place for titles, solutions and guesses.
    ///
    /// # Errors
    /// Those of the stream, and [`WriteError::Problem`] when the parts do not fit together.
    pub fn write_dat(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        self.writable()?;
        let problem = &self.problem;
        writeln!(out, "{}\n{}", problem.dimension(), problem.contacts())?;
        match problem {
            FclibProblem::Local(local) => {
                matrix(out, &local.w)?;
                numbers(out, &local.q)?;
            }
            FclibProblem::Global(global) => {
                matrix(out, &global.m)?;
                matrix(out, &global.h)?;
                numbers(out, &global.f)?;
                numbers(out, &global.w)?;
            }
        }
        numbers(out, problem.friction())
    }
}

fn matrix(out: &mut dyn Write, matrix: &FclibMatrix) -> Result<(), WriteError> {
    let (rows, columns) = (matrix.rows(), matrix.columns());
    if matrix.is_rather_dense() {
        writeln!(out, "0\n{rows}\n{columns}\n{rows}\t{columns}")?;
        let mut values = vec![0.0; rows * columns];
        for &(row, column, value) in matrix.entries() {
            values[row + column * rows] = value;
        }
        for column in values.chunks(rows.max(1)) {
            numbers(out, column)?;
        }
        return Ok(());
    }
    let entries = matrix.entries();
    let count = entries.len();
    // 1: the matrix is kept as triplets.
    writeln!(out, "2\n{rows}\n{columns}\n1\n{WRITER}")?;
    writeln!(
        out,
        "triplet: {rows}-by-{columns}, nzmax: {count} nnz: {count}"
    )?;
    for (row, column, value) in entries {
        writeln!(out, "    {row} {column} : {value:.16e}")?;
    }
    Ok(())
}

fn numbers(out: &mut dyn Write, values: &[f64]) -> Result<(), WriteError> {
    for value in values {
        write!(out, " {value:.16e}")?;
    }
    writeln!(out)?;
    Ok(())
}
