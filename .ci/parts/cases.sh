cargo build --quiet --release
readers=$(.ci/environment readers)
for case in cases/*.toml; do
  name=$(basename "$case" .toml)
  expected=0
  # Wrong on purpose: no equilibrium.
  [ "$name" = pulled-away ] && expected=1
  code=0
  target/release/tresca solve "$case" --quiet --out "out/cases/$name" || code=$?
  if [ "$code" != "$expected" ]; then
    echo "$case ended with exit code $code instead of $expected" >&2
    exit 1
  fi
done
"$readers/python" scripts/check_results.py out/cases/* > /dev/null
mkdir -p out
"$readers/python" scripts/hysteresis.py out/cases/hysteresis pad out/hysteresis.png
