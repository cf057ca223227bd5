# Advisories are read from the network and change without us: a chore, see CONTRIBUTING.md.
tools=$(.ci/environment tools)
"$tools/cargo-deny" --locked check licenses bans sources
