//! A deck as a list of keywords with their lines of data.

use std::path::{Path, PathBuf};

use super::super::error::{MeshFault, MeshFileError};
use crate::located::{FilePlace, Position};

/// A deck, cut into keywords.
#[derive(Debug)]
pub(super) struct Deck<'a> {
    pub path: PathBuf,
    pub keywords: Vec<Keyword<'a>>,
}

/// A keyword line and the data behind it.
#[derive(Debug)]
pub(super) struct Keyword<'a> {
    path: &'a Path,
    /// In capitals, words separated by one blank.
    pub name: String,
    parameters: Vec<(String, &'a str)>,
    /// Its line, from 1.
    pub line: usize,
    /// Lines that are not blank, with their numbers.
    pub data: Vec<(usize, &'a str)>,
}

impl<'a> Deck<'a> {
    pub fn new(path: &'a Path, bytes: &'a [u8]) -> Result<Self, MeshFileError> {
        let mut keywords: Vec<Keyword<'a>> = Vec::new();
        // A keyword line that ends with a comma goes on in the next line.
        let mut continued = false;
        for (line, text) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
            let Ok(text) = std::str::from_utf8(text) else {
                // Headings and comments may be in any encoding; numbers and names may not.
                continue;
            };
            let text = text.trim();
            if text.is_empty() || text.starts_with("**") {
                continue;
            }
            match (text.strip_prefix('*'), keywords.last_mut()) {
                (Some(rest), _) => {
                    let mut keyword = Keyword::new(path, line);
                    let mut words = rest.split(',');
                    let name = words.next().unwrap_or_default();
                    keyword.name = name
                        .split_whitespace()
                        .collect::<Vec<_>>()
                        .join(" ")
                        .to_uppercase();
                    keyword.add_parameters(words);
                    keywords.push(keyword);
                    continued = text.ends_with(',');
                }
                (None, Some(keyword)) if continued => {
                    keyword.add_parameters(text.split(','));
                    continued = text.ends_with(',');
                }
                (None, Some(keyword)) => keyword.data.push((line, text)),
                // `parse` has seen that the first thing is a star.
                (None, None) => {}
            }
        }
        Ok(Self {
            path: path.to_owned(),
            keywords,
        })
    }
}

impl<'a> Keyword<'a> {
    fn new(path: &'a Path, line: usize) -> Self {
        Self {
            path,
            name: String::new(),
            parameters: Vec::new(),
            line,
            data: Vec::new(),
        }
    }

    fn add_parameters(&mut self, words: impl Iterator<Item = &'a str>) {
        for word in words {
            let (key, value) = word.split_once('=').unwrap_or((word, ""));
            let key = key.trim().to_uppercase();
            if !key.is_empty() {
                self.parameters.push((key, unquoted(value)));
            }
        }
    }

    /// The value of a parameter; empty for one that has none.
    pub fn parameter(&self, key: &str) -> Option<&'a str> {
        let found = self.parameters.iter().find(|(known, _)| known == key);
        found.map(|(_, value)| *value)
    }

    /// The value of a parameter that must be there.
    pub fn required(&self, key: &str) -> Result<&'a str, MeshFileError> {
        self.parameter(key)
            .filter(|v| !v.is_empty())
            .ok_or_else(|| {
                MeshFault::syntax(
                    self.place(self.line),
                    format!("the parameter `{key}=…` of `*{}`", self.name),
                    "none",
                )
            })
    }

    /// A line in words.
    pub fn place(&self, line: usize) -> FilePlace {
        FilePlace {
            path: self.path.to_owned(),
            position: Position::Line(line),
        }
    }

    /// The entries of all lines of data, each with its line. Commas at the end of a line add none.
    pub fn entries(&self) -> impl Iterator<Item = (usize, &'a str)> + '_ {
        self.data.iter().flat_map(|&(line, text)| {
            text.split(',')
                .map(str::trim)
                .filter(|entry| !entry.is_empty())
                .map(move |entry| (line, entry))
        })
    }

    /// A node or element number.
    pub fn number(&self, line: usize, entry: &str, what: &str) -> Result<u64, MeshFileError> {
        entry
            .parse()
            .map_err(|_| MeshFault::syntax(self.place(line), what, format!("`{entry}`")))
    }

    /// A real number; Fortran's exponents with D are understood.
    pub fn real(&self, line: usize, entry: &str, what: &str) -> Result<f64, MeshFileError> {
        let parsed = entry
            .parse()
            .or_else(|_| entry.replace(['d', 'D'], "e").parse());
        parsed.map_err(|_| MeshFault::syntax(self.place(line), what, format!("`{entry}`")))
    }
}

/// A value without blanks around it and without quotes.
pub(super) fn unquoted(text: &str) -> &str {
    let text = text.trim();
    let inner = text.strip_prefix('"').and_then(|t| t.strip_suffix('"'));
    inner.unwrap_or(text)
}

/// Names count as equal whatever the case of their letters.
pub(super) fn same_name(a: &str, b: &str) -> bool {
    a.eq_ignore_ascii_case(b)
}
