//! The version, as result files say it.

/// Version of the library, written into every result file.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
