//! Reading the text.

use super::super::error::Trouble;
use super::super::problem::{Document, FclibProblem, GlobalProblem, LocalProblem, dimension};
use super::matrix;
use super::tokens::{Tokens, count};
use crate::fclib::error::Defect;
use crate::fclib::matrix::FclibMatrix;

/// A problem from its text.
pub fn read(text: &str) -> Result<Document, Trouble> {
    let mut tokens = Tokens::new(text);
    let space = tokens.count("the dimension")?;
    let space = dimension(i64::try_from(space).unwrap_or(i64::MAX))
        .map_err(|defect| defect.on(tokens.line()))?;
    let contacts = tokens.count("the number of contacts")?;
    let contacts_line = tokens.line();
    let unknowns = contacts.checked_mul(space).ok_or_else(|| {
        let expected = "a number of contacts";
        let found = contacts.to_string();
        Defect::Token { expected, found }.on(contacts_line)
    })?;
    let first = matrix::read(&mut tokens)?;
    let first_line = tokens.line();
    let problem = if follows_matrix(&tokens, &first, unknowns) {
        let h = matrix::read(&mut tokens)?;
        let f = tokens.numbers(first.rows(), "an entry of f")?;
        let w = tokens.numbers(unknowns, "an entry of w")?;
        FclibProblem::Global(GlobalProblem {
            dimension: space,
            m: first,
            h,
            f,
            w,
            friction: tokens.numbers(contacts, "a friction coefficient")?,
        })
    } else {
        let expected = (unknowns, unknowns);
        let found = (first.rows(), first.columns());
        if found != expected {
            return Err(Defect::Shape { expected, found }.on(first_line));
        }
        FclibProblem::Local(LocalProblem {
            dimension: space,
            w: first,
            q: tokens.numbers(unknowns, "an entry of q")?,
            friction: tokens.numbers(contacts, "a friction coefficient")?,
        })
    };
    end(&mut tokens)?;
    problem.check().map_err(|(part, defect)| defect.at(part))?;
    Ok(problem.into())
}

/// Whether a second matrix follows, as it does in a global problem: a storage scheme and the size of
/// an H that fits. The entries of a q could only look like that if Siconos printed numbers without
/// exponents.
pub fn follows_matrix(tokens: &Tokens, first: &FclibMatrix, unknowns: usize) -> bool {
    let whole = |offset| tokens.peek(offset).and_then(|word: &str| word.parse().ok());
    let scheme: Option<usize> = whole(0);
    scheme.is_some_and(|scheme| scheme <= 2)
        && whole(1) == Some(first.rows())
        && whole(2) == Some(unknowns)
}

/// Nothing may follow but one whole number.
fn end(tokens: &mut Tokens) -> Result<(), Trouble> {
    if tokens.peek(0).and_then(count).is_some() {
        tokens.count("the end of the file")?;
    }
    match tokens.left() {
        0 => Ok(()),
        _ => {
            let word = tokens.word("the end of the file")?;
            Err(tokens.unexpected("the end of the file", word))
        }
    }
}
