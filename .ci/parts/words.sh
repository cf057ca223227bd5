tools=$(.ci/environment tools)
"$tools/typos" --format brief
python3 -m doctest scripts/docs_width.py
python3 scripts/docs_width.py --check
