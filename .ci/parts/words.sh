tools=$(.ci/environment tools)
"$tools/typos" --format brief
