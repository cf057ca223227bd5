cargo build --quiet --release
readers=$(.ci/environment readers)
for case in gallery/*/*.toml; do
  name=$(basename "$case" .toml)
  # The mesh of the timings is made on demand.
  [ "$name" = large ] && continue
  target/release/tresca check "$case" > /dev/null
  target/release/tresca solve "$case" --quiet --out "out/gallery/$name"
done
"$readers/python" scripts/check_gallery.py --results out/gallery
"$readers/python" scripts/check_results.py out/gallery/* > /dev/null
