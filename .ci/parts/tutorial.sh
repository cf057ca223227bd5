cargo build --quiet --release
readers=$(.ci/environment readers)
"$readers/python" scripts/check_tutorial.py --program target/release/tresca
