//! Reading numbers from text or bytes, with the place of every fault.

use std::path::Path;
use std::str::FromStr;

use super::super::error::{MeshFault, MeshFileError};
use crate::located::{FilePlace, Position};

/// How the numbers of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Binary {
        /// Bytes with the least significant first.
        little_endian: bool,
        /// Bytes of a size.
        width: usize,
    },
}

/// A mesh file and how far it is read.
#[derive(Debug)]
pub(super) struct Input<'a> {
    path: &'a Path,
    bytes: &'a [u8],
    at: usize,
    encoding: Encoding,
}

impl<'a> Input<'a> {
    pub fn new(path: &'a Path, bytes: &'a [u8]) -> Self {
        Self {
            path,
            bytes,
            at: 0,
            encoding: Encoding::Text,
        }
    }

    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// No list of the file can be longer: guards allocations against a corrupt count.
    pub fn at_most(&self, count: u64) -> usize {
        usize::try_from(count).map_or(self.bytes.len(), |count| count.min(self.bytes.len()))
    }

    /// Where the next thing stands.
    pub fn place(&self) -> FilePlace {
        self.place_of(self.at)
    }

    /// How far the file is read: cheap to take for every element, see [`Input::place_of`].
    pub fn mark(&self) -> usize {
        self.at
    }

    /// A mark in words. Lines are counted only now that one is wanted.
    pub fn place_of(&self, at: usize) -> FilePlace {
        let position = match self.encoding {
            Encoding::Text => {
                // Behind the blanks that come before the next word.
                let rest = self.bytes.get(at..).unwrap_or_default();
                let blanks = rest.iter().position(|byte| !byte.is_ascii_whitespace());
                let at = at + blanks.unwrap_or(0);
                let before = &self.bytes[..at.min(self.bytes.len())];
                Position::Line(1 + before.iter().filter(|&&byte| byte == b'\n').count())
            }
            Encoding::Binary { .. } => Position::Byte(at),
        };
        FilePlace {
            path: self.path.to_owned(),
            position,
        }
    }

    fn blanks(&self) -> usize {
        let rest = &self.bytes[self.at..];
        let used = rest.iter().position(|byte| !byte.is_ascii_whitespace());
        used.unwrap_or(rest.len())
    }

    fn truncated(&self, expected: &str) -> MeshFileError {
        MeshFault::Truncated {
            expected: expected.to_owned(),
        }
        .at(self.place_of(self.bytes.len()))
    }

    /// The name of the section that begins here; `None` at the end of the file.
    pub fn next_section(&mut self) -> Result<Option<&'a str>, MeshFileError> {
        self.at += self.blanks();
        if self.at == self.bytes.len() {
            return Ok(None);
        }
        let start = self.at;
        let line = self.line();
        match std::str::from_utf8(line) {
            Ok(name) if name.starts_with('$') => Ok(Some(name.trim_end())),
            _ => Err(MeshFault::syntax(
                self.place_of(start),
                "the beginning of a section, `$…`",
                excerpt(line),
            )),
        }
    }

    /// The rest of this line, without its end.
    fn line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|&byte| byte == b'\n');
        let line = &rest[..end.unwrap_or(rest.len())];
        self.at += line.len() + usize::from(end.is_some());
        line
    }

    /// The end of a section that was read.
    pub fn end_section(&mut self, name: &str) -> Result<(), MeshFileError> {
        self.at += self.blanks();
        let expected = format!("`{}`", end_of(name));
        if self.at == self.bytes.len() {
            return Err(self.truncated(&expected));
        }
        let start = self.at;
        let line = self.line();
        if line.trim_ascii_end() == end_of(name).as_bytes() {
            return Ok(());
        }
        Err(
            MeshFault::syntax(self.place_of(start), expected, excerpt(line)).with_help(format!(
                "the section `{name}` holds more than the counts in it say"
            )),
        )
    }

    /// Goes behind the end of a section that is not read.
    pub fn skip_section(&mut self, name: &str) -> Result<(), MeshFileError> {
        let end = end_of(name);
        // In text the end is a line of its own; among bytes, a name of this length is no accident.
        let rest = &self.bytes[self.at..];
        let found = rest.windows(end.len()).position(|w| w == end.as_bytes());
        match found {
            Some(found) => {
                self.at += found;
                self.line();
                Ok(())
            }
            None => Err(self.truncated(&format!("`{end}`"))),
        }
    }

    /// The next word of text.
    pub fn word(&mut self, expected: &str) -> Result<&'a str, MeshFileError> {
        self.at += self.blanks();
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(u8::is_ascii_whitespace);
        let word = &rest[..end.unwrap_or(rest.len())];
        if word.is_empty() {
            return Err(self.truncated(expected));
        }
        let start = self.at;
        self.at += word.len();
        std::str::from_utf8(word)
            .map_err(|_| MeshFault::syntax(self.place_of(start), expected, excerpt(word)))
    }

    /// The next number of text, also in a binary file.
    pub fn number_in_text<T: FromStr>(&mut self, expected: &str) -> Result<T, MeshFileError> {
        let word = self.word(expected)?;
        word.parse().map_err(|_| {
            let place = self.place_of(self.at - word.len());
            let error = MeshFault::syntax(place, expected, format!("`{word}`"));
            match word.starts_with('$') {
                true => error.with_help("the section holds less than the counts in it say"),
                false => error,
            }
        })
    }

    /// The next text in quotes. Gmsh writes no escapes: the name ends at the last quote of the line.
    pub fn quoted(&mut self, expected: &str) -> Result<String, MeshFileError> {
        self.at += self.blanks();
        let start = self.at;
        let line = self.line();
        if line.is_empty() {
            return Err(self.truncated(expected));
        }
        let text = String::from_utf8_lossy(line);
        let inner = text
            .trim()
            .strip_prefix('"')
            .and_then(|t| t.strip_suffix('"'));
        inner.map(str::to_owned).ok_or_else(|| {
            MeshFault::syntax(
                self.place_of(start),
                format!("{expected} in quotes"),
                excerpt(line),
            )
        })
    }

    /// Behind the header of a binary file stands the number 1, which tells the byte order.
    pub fn detect_byte_order(&mut self, width: usize) -> Result<(), MeshFileError> {
        self.end_line();
        let start = self.at;
        let little_endian = match self.take::<4>("the number 1 in binary")? {
            [1, 0, 0, 0] => true,
            [0, 0, 0, 1] => false,
            other => {
                return Err(MeshFault::syntax(
                    self.place_of(start),
                    "the number 1 in binary",
                    format!("the bytes {other:?}"),
                )
                .with_help("the file was changed on its way, for example by a transfer as text"));
            }
        };
        self.encoding = Encoding::Binary {
            little_endian,
            width,
        };
        Ok(())
    }

    /// Goes to the next line. Behind a count in text, bytes begin there, whatever they are.
    pub fn end_line(&mut self) {
        self.line();
    }

    fn take<const N: usize>(&mut self, expected: &str) -> Result<[u8; N], MeshFileError> {
        let taken = self.bytes[self.at..].first_chunk::<N>().copied();
        self.at += N;
        taken.ok_or_else(|| self.truncated(expected))
    }

    /// A whole number of four bytes.
    pub fn int(&mut self, expected: &str) -> Result<i32, MeshFileError> {
        match self.encoding {
            Encoding::Text => self.number_in_text(expected),
            Encoding::Binary { little_endian, .. } => {
                let bytes = self.take(expected)?;
                Ok(match little_endian {
                    true => i32::from_le_bytes(bytes),
                    false => i32::from_be_bytes(bytes),
                })
            }
        }
    }

    /// A size or the number of a node or element.
    pub fn size(&mut self, expected: &str) -> Result<u64, MeshFileError> {
        match self.encoding {
            Encoding::Text => self.number_in_text(expected),
            Encoding::Binary {
                little_endian,
                width: 8,
            } => {
                let bytes = self.take(expected)?;
                Ok(match little_endian {
                    true => u64::from_le_bytes(bytes),
                    false => u64::from_be_bytes(bytes),
                })
            }
            Encoding::Binary { little_endian, .. } => {
                let bytes = self.take(expected)?;
                Ok(u64::from(match little_endian {
                    true => u32::from_le_bytes(bytes),
                    false => u32::from_be_bytes(bytes),
                }))
            }
        }
    }

    /// A number of a node or element in version 2, where it has four bytes.
    pub fn number(&mut self, expected: &str) -> Result<u64, MeshFileError> {
        if self.encoding == Encoding::Text {
            return self.number_in_text(expected);
        }
        let start = self.at;
        let number = self.int(expected)?;
        u64::try_from(number)
            .map_err(|_| MeshFault::syntax(self.place_of(start), expected, number.to_string()))
    }

    /// A real number.
    pub fn real(&mut self, expected: &str) -> Result<f64, MeshFileError> {
        match self.encoding {
            Encoding::Text => self.number_in_text(expected),
            Encoding::Binary { little_endian, .. } => {
                let bytes = self.take(expected)?;
                Ok(match little_endian {
                    true => f64::from_le_bytes(bytes),
                    false => f64::from_be_bytes(bytes),
                })
            }
        }
    }
}

fn end_of(section: &str) -> String {
    format!("$End{}", &section[1..])
}

/// The beginning of a line that was not expected.
fn excerpt(line: &[u8]) -> String {
    let start = &line[..line.len().min(40)];
    format!(
        "`{}`",
        String::from_utf8_lossy(start).trim_end().escape_debug()
    )
}
