//! The command-line program `tresca`.
fn main() {}
