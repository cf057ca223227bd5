//! Words of a text, each with its line.

use super::super::error::Trouble;
use crate::fclib::error::Defect;

/// The words of a text, from the first to the last.
pub struct Tokens<'a> {
    words: Vec<(usize, &'a str)>,
    next: usize,
}

impl<'a> Tokens<'a> {
    pub fn new(text: &'a str) -> Self {
        let lines = text.lines().enumerate();
        let words = lines.flat_map(|(i, line)| line.split_whitespace().map(move |w| (i + 1, w)));
        Self {
            words: words.collect(),
            next: 0,
        }
    }

    /// How many words are left.
    pub fn left(&self) -> usize {
        self.words.len() - self.next
    }

    /// The word `offset` after the next one, without taking it.
    pub fn peek(&self, offset: usize) -> Option<&'a str> {
        self.words.get(self.next + offset).map(|&(_, word)| word)
    }

    /// The line of the word taken last.
    pub fn line(&self) -> usize {
        let taken = self.next.saturating_sub(1);
        self.words.get(taken).map_or(1, |&(line, _)| line)
    }

    /// Takes a word.
    pub fn word(&mut self, expected: &'static str) -> Result<&'a str, Trouble> {
        let Some(&(_, word)) = self.words.get(self.next) else {
            return Err(Defect::End { expected }.on(self.line()));
        };
        self.next += 1;
        Ok(word)
    }

    /// Takes a number that must be whole and not negative.
    pub fn count(&mut self, expected: &'static str) -> Result<usize, Trouble> {
        let word = self.word(expected)?;
        count(word).ok_or_else(|| self.unexpected(expected, word))
    }

    /// Takes a finite number.
    pub fn number(&mut self, expected: &'static str) -> Result<f64, Trouble> {
        let word = self.word(expected)?;
        match word.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(self.unexpected(expected, word)),
        }
    }

    /// Takes so many numbers, of which all must be there before memory is spent on them.
    pub fn numbers(&mut self, count: usize, expected: &'static str) -> Result<Vec<f64>, Trouble> {
        self.need(Some(count), expected)?;
        (0..count).map(|_| self.number(expected)).collect()
    }

    /// Takes so many counts.
    pub fn counts(&mut self, count: usize, expected: &'static str) -> Result<Vec<usize>, Trouble> {
        self.need(Some(count), expected)?;
        (0..count).map(|_| self.count(expected)).collect()
    }

    /// Fails when fewer words are left, or the number is out of all bounds (`None`).
    pub fn need(&self, count: Option<usize>, expected: &'static str) -> Result<(), Trouble> {
        match count {
            Some(count) if count <= self.left() => Ok(()),
            _ => {
                let line = self.words.last().map_or(1, |&(line, _)| line);
                Err(Defect::End { expected }.on(line))
            }
        }
    }

    /// The word taken last is not what it should be.
    pub fn unexpected(&self, expected: &'static str, found: &str) -> Trouble {
        let found = found.to_owned();
        Defect::Token { expected, found }.on(self.line())
    }
}

/// A whole number ≥ 0. CSparse prints those with `%g`: a million is `1e+06`.
pub fn count(word: &str) -> Option<usize> {
    word.parse().ok().or_else(|| {
        let value = word.parse::<f64>().ok()?;
        ((0.0..=1e15).contains(&value) && value.fract() == 0.0).then_some(value as usize)
    })
}
