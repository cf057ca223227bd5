# The whole workspace, so that the features of all other crates stay as they are and nothing else is compiled again.
# `tresca` has no tests that are for this side alone.
cargo test --workspace --exclude tresca --no-default-features --test suite fclib
