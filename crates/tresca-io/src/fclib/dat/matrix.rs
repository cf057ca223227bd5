//! Matrices in text: dense, by blocks, sparse.
//!
//! ```text
//! 0  rows  columns   rows  columns   values by columns
//! 1  rows  columns   blocks  block-rows  block-columns   ends of block rows   ends of block columns
//!                    pointers+1  blocks  row pointers  block columns   { number  values by columns }
//! 2  rows  columns   [origin]  what cs_print prints
//! ```

use super::super::error::Trouble;
use super::super::matrix::check_pointers;
use super::tokens::{Tokens, count};
use crate::fclib::error::Defect;
use crate::fclib::matrix::FclibMatrix;

/// Takes a matrix.
pub fn read(tokens: &mut Tokens) -> Result<FclibMatrix, Trouble> {
    let storage = tokens.count("the storage scheme of a matrix")?;
    let storage_line = tokens.line();
    let rows = tokens.count("the number of rows")?;
    let columns = tokens.count("the number of columns")?;
    let entries = match storage {
        0 => dense(tokens, rows, columns)?,
        1 => blocks(tokens, rows, columns)?,
        2 => sparse(tokens, rows, columns)?,
        other => {
            let other = i64::try_from(other).unwrap_or(i64::MAX);
            return Err(Defect::Storage(other).on(storage_line));
        }
    };
    FclibMatrix::new(rows, columns, entries).map_err(|defect| defect.on(tokens.line()))
}

type Entries = Vec<(usize, usize, f64)>;

fn dense(tokens: &mut Tokens, rows: usize, columns: usize) -> Result<Entries, Trouble> {
    repeated(tokens, rows, columns)?;
    tokens.need(rows.checked_mul(columns), "an entry of a matrix")?;
    let mut entries = Vec::with_capacity(rows * columns);
    for column in 0..columns {
        for row in 0..rows {
            entries.push((row, column, tokens.number("an entry of a matrix")?));
        }
    }
    Ok(entries)
}

fn blocks(tokens: &mut Tokens, rows: usize, columns: usize) -> Result<Entries, Trouble> {
    let blocks = tokens.count("the number of blocks")?;
    if blocks == 0 {
        return Ok(Vec::new());
    }
    let block_rows = tokens.count("the number of block rows")?;
    let block_columns = tokens.count("the number of block columns")?;
    let row_ends = ends(tokens, block_rows, rows)?;
    let column_ends = ends(tokens, block_columns, columns)?;
    let pointers = tokens.count("the number of block row pointers")?;
    let listed = tokens.count("the number of blocks")?;
    if pointers != block_rows + 1 || listed != blocks {
        let (expected, found) = if listed == blocks {
            (block_rows + 1, pointers)
        } else {
            (blocks, listed)
        };
        return Err(Defect::Length { expected, found }.on(tokens.line()));
    }
    let pointers = tokens.counts(pointers, "a block row pointer")?;
    check_pointers(&pointers, blocks).map_err(|defect| defect.on(tokens.line()))?;
    if pointers[block_rows] != blocks {
        let (expected, found) = (blocks, pointers[block_rows]);
        return Err(Defect::Length { expected, found }.on(tokens.line()));
    }
    let block_column = tokens.counts(blocks, "a block column")?;
    let mut entries = Vec::new();
    let mut block_row = 0;
    for (block, &own) in block_column.iter().enumerate() {
        while pointers[block_row + 1] <= block {
            block_row += 1;
        }
        let number = tokens.count("the number of a block")?;
        if number != block {
            let found = number.to_string();
            return Err(tokens.unexpected("the number of the next block", &found));
        }
        let Some(&end) = column_ends.get(own) else {
            return Err(Defect::Outside {
                row: block_row,
                column: own,
                rows: block_rows,
                columns: block_columns,
            }
            .on(tokens.line()));
        };
        for column in start(&column_ends, own)..end {
            for row in start(&row_ends, block_row)..row_ends[block_row] {
                entries.push((row, column, tokens.number("an entry of a block")?));
            }
        }
    }
    Ok(entries)
}

/// Where block `index` begins, from the ends of all.
fn start(ends: &[usize], index: usize) -> usize {
    index.checked_sub(1).map_or(0, |before| ends[before])
}

/// Ends of block rows or columns, which rise to the size of the matrix.
fn ends(tokens: &mut Tokens, blocks: usize, size: usize) -> Result<Vec<usize>, Trouble> {
    let ends = tokens.counts(blocks, "the end of a block")?;
    let last = ends.last().copied().unwrap_or(0);
    if last != size || !ends.is_sorted() {
        let index = ends.len().saturating_sub(1);
        let found = i64::try_from(last).unwrap_or(i64::MAX);
        return Err(Defect::Pointers {
            index,
            found,
            entries: size,
        }
        .on(tokens.line()));
    }
    Ok(ends)
}

/// The printout of CSparse, after an optional number that tells where it came from:
/// `2-by-2, nzmax: 4 nnz: 3, 1-norm: 5` with `col 0 : locations 0 to 1` and `1 : 0.5`, or
/// `triplet: 2-by-2, nzmax: 4 nnz: 3` with `1 0 : 0.5`.
fn sparse(tokens: &mut Tokens, rows: usize, columns: usize) -> Result<Entries, Trouble> {
    const SIZE: &str = "the size of a sparse matrix (`…-by-…`)";
    let mut triplet = false;
    let size = loop {
        let word = tokens.word(SIZE)?;
        if word.contains("-by-") {
            break word;
        }
        triplet = word == "triplet:";
    };
    let found = size
        .trim_end_matches(',')
        .split_once("-by-")
        .and_then(|(rows, columns)| Some((count(rows)?, count(columns)?)))
        .ok_or_else(|| tokens.unexpected(SIZE, size))?;
    let expected = (rows, columns);
    if found != expected {
        return Err(Defect::Shape { expected, found }.on(tokens.line()));
    }
    label(tokens, "nzmax:")?;
    tokens.word("the space for entries")?;
    label(tokens, "nnz:")?;
    let word = tokens.word("the number of entries")?;
    let entries = count(word.trim_end_matches(','))
        .ok_or_else(|| tokens.unexpected("the number of entries", word))?;
    if triplet {
        triplets(tokens, entries)
    } else {
        label(tokens, "1-norm:")?;
        tokens.word("the norm of a matrix")?;
        by_columns(tokens, columns, entries)
    }
}

fn triplets(tokens: &mut Tokens, entries: usize) -> Result<Entries, Trouble> {
    tokens.need(entries.checked_mul(4), "an entry of a matrix")?;
    (0..entries)
        .map(|_| {
            let row = tokens.count("a row")?;
            let column = tokens.count("a column")?;
            label(tokens, ":")?;
            Ok((row, column, tokens.number("an entry of a matrix")?))
        })
        .collect()
}

fn by_columns(tokens: &mut Tokens, columns: usize, count: usize) -> Result<Entries, Trouble> {
    tokens.need(count.checked_mul(3), "an entry of a matrix")?;
    let mut entries = Vec::with_capacity(count);
    for column in 0..columns {
        label(tokens, "col")?;
        tokens.count("a column")?;
        label(tokens, ":")?;
        label(tokens, "locations")?;
        let first = tokens.count("the place of an entry")?;
        label(tokens, "to")?;
        // −1 ends an empty first column.
        let last = tokens.number("the place of an entry")?;
        let end = if last < 0.0 { 0 } else { last as usize + 1 };
        if first != entries.len() || end < first || end > count {
            return Err(Defect::Pointers {
                index: column,
                found: last as i64,
                entries: count,
            }
            .on(tokens.line()));
        }
        for _ in first..end {
            let row = tokens.count("a row")?;
            label(tokens, ":")?;
            entries.push((row, column, tokens.number("an entry of a matrix")?));
        }
    }
    Ok(entries)
}

/// Takes a word that must be this one.
fn label(tokens: &mut Tokens, expected: &'static str) -> Result<(), Trouble> {
    let word = tokens.word(expected)?;
    if word == expected {
        Ok(())
    } else {
        Err(tokens.unexpected(expected, word))
    }
}

/// The sizes stand twice.
fn repeated(tokens: &mut Tokens, rows: usize, columns: usize) -> Result<(), Trouble> {
    let found = (
        tokens.count("the number of rows")?,
        tokens.count("the number of columns")?,
    );
    let expected = (rows, columns);
    if found == expected {
        Ok(())
    } else {
        Err(Defect::Shape { expected, found }.on(tokens.line()))
    }
}
