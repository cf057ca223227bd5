cargo build --quiet --release
readers=$(.ci/environment readers)
for problem in crates/tresca-io/tests/data/fclib/*.dat; do
  run=out/fclib/$(basename "$problem" .dat)
  target/release/tresca solve "$problem" --quiet --out "$run"
  target/release/tresca solve "$problem" --law tresca --bound 0.05 --quiet --out "$run-tresca"
done
target/release/tresca export cases/two-bricks-coulomb.toml --to out/exported-bricks.hdf5
target/release/tresca solve out/exported-bricks.hdf5 --quiet --out out/fclib/exported-bricks
"$readers/python" scripts/check_fclib.py out/fclib/*
