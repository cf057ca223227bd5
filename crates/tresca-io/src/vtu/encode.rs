//! The arrays behind the XML: little-endian numbers, each array with its length in bytes (UInt64)
//! ahead, each encoded in base64 by itself.

use std::borrow::Cow;
use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::xml::escape;

/// Bytes encoded at a time: a multiple of 3, so that pieces of base64 join without padding.
const PIECE: usize = 3 << 14;

/// Numbers of one type.
#[derive(Clone, Debug)]
pub(super) enum Data<'a> {
    F64(&'a [f64]),
    I32(&'a [i32]),
    I64(Cow<'a, [i64]>),
    U8(Cow<'a, [u8]>),
}

impl Data<'_> {
    pub(super) fn len(&self) -> usize {
        match self {
            Data::F64(values) => values.len(),
            Data::I32(values) => values.len(),
            Data::I64(values) => values.len(),
            Data::U8(values) => values.len(),
        }
    }

    fn vtk_name(&self) -> &'static str {
        match self {
            Data::F64(_) => "Float64",
            Data::I32(_) => "Int32",
            Data::I64(_) => "Int64",
            Data::U8(_) => "UInt8",
        }
    }

    fn bytes(&self) -> usize {
        let width = match self {
            Data::F64(_) | Data::I64(_) => 8,
            Data::I32(_) => 4,
            Data::U8(_) => 1,
        };
        width * self.len()
    }

    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut stream = Base64::new(out);
        stream.push(&(self.bytes() as u64).to_le_bytes())?;
        match self {
            Data::F64(values) => push_all(&mut stream, values, |v| v.to_le_bytes()),
            Data::I32(values) => push_all(&mut stream, values, |v| v.to_le_bytes()),
            Data::I64(values) => push_all(&mut stream, values, |v| v.to_le_bytes()),
            Data::U8(values) => push_all(&mut stream, values, |v| [v]),
        }?;
        stream.finish()
    }
}

fn push_all<T: Copy, const N: usize>(
    stream: &mut Base64<'_>,
    values: &[T],
    bytes: impl Fn(T) -> [u8; N],
) -> io::Result<()> {
    values
        .iter()
        .try_for_each(|&value| stream.push(&bytes(value)))
}

/// Encodes in large pieces; the stream of the `base64` crate works in pieces of a kilobyte.
struct Base64<'a> {
    out: &'a mut dyn Write,
    bytes: Vec<u8>,
    text: Vec<u8>,
}

impl<'a> Base64<'a> {
    fn new(out: &'a mut dyn Write) -> Self {
        Self {
            out,
            bytes: Vec::with_capacity(PIECE + 8),
            text: vec![0; PIECE / 3 * 4],
        }
    }

    fn push(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.bytes.extend_from_slice(bytes);
        if self.bytes.len() >= PIECE {
            self.encode(PIECE)?;
        }
        Ok(())
    }

    fn finish(mut self) -> io::Result<()> {
        self.encode(self.bytes.len())
    }

    fn encode(&mut self, count: usize) -> io::Result<()> {
        let written = STANDARD
            .encode_slice(&self.bytes[..count], &mut self.text)
            .map_err(io::Error::other)?;
        self.out.write_all(&self.text[..written])?;
        self.bytes.drain(..count);
        Ok(())
    }
}

/// The arrays declared so far, and where the next one will start.
#[derive(Default)]
pub(super) struct Appended<'a> {
    arrays: Vec<Data<'a>>,
    offset: usize,
}

impl<'a> Appended<'a> {
    /// Writes the element that announces an array, and keeps the array for later.
    pub(super) fn declare(
        &mut self,
        out: &mut dyn Write,
        name: &str,
        attributes: &str,
        data: Data<'a>,
    ) -> io::Result<()> {
        writeln!(
            out,
            "        <DataArray type=\"{}\" Name=\"{}\"{attributes} format=\"appended\" offset=\"{}\"/>",
            data.vtk_name(),
            escape(name),
            self.offset,
        )?;
        let length = size_of::<u64>() + data.bytes();
        self.offset += length.div_ceil(3) * 4;
        self.arrays.push(data);
        Ok(())
    }

    /// Writes all arrays in the order of their announcement.
    pub(super) fn write(self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "  <AppendedData encoding=\"base64\">\n    _")?;
        for data in &self.arrays {
            data.write(out)?;
        }
        writeln!(out, "\n  </AppendedData>")
    }
}
