//! What the table of a load has to give.

use tresca_io::located::Span;
use tresca_model::{Load, PlaceNames};

use crate::error::CaseError;
use crate::reader::Reader;
use crate::text::at::At;

/// The keys of a kind of load.
pub(crate) trait LoadTable {
    /// The load; `span` is the place of the table.
    fn load(&self, span: &Span, reader: &Reader<'_>) -> Result<Load<PlaceNames>, CaseError>;

    /// How load steps call it.
    fn name(&self) -> Option<At<String>>;
}
