cargo build --quiet --release
# Problems that are always the same.
target/release/tresca bench campaign --problems 1000
# Problems that nobody has seen. About one in a thousand is left undecided, as the documents say: to meet two of these
# is bad luck, to meet them twice in a row is not.
target/release/tresca bench campaign --problems 200 --fresh || target/release/tresca bench campaign --problems 200 --fresh
