cargo build --quiet --release
# Problems that are always the same, and some that nobody has seen.
target/release/tresca bench campaign --problems 1000
target/release/tresca bench campaign --problems 200 --fresh
