# `cargo test` (the part `tests`) has built them; each checks what it finds.
for source in crates/tresca/examples/*.rs; do
  name=$(basename "$source" .rs)
  echo "-- $name"
  "target/debug/examples/$name"
done
