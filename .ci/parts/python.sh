cargo build --quiet --release
package=$(.ci/environment package)
rm -rf target/wheels
# NumPy's crate switches features of shared dependencies, so that they are compiled once more: in the quick profile
# of the tests. Wheels that are given away are built with --release.
"$package/maturin" build --profile dev --quiet --out target/wheels
"$package/pip" uninstall --quiet --yes tresca 2> /dev/null
"$package/pip" install --quiet "$(echo target/wheels/*.whl)[test,examples]"
"$package/python" -m pytest --quiet
export PYTHONWARNINGS=error
mkdir -p out
"$package/python" examples/python/two_bricks.py --nodes 9 --program target/release/tresca
"$package/python" examples/python/load_cycle.py
"$package/python" -W default examples/python/contact_map.py --out out/contact.png
"$package/python" crates/tresca-bench/python/border.py --side 15 --runs 1
"$package/python" crates/tresca-bench/python/clarabel_bricks.py --sizes 5
