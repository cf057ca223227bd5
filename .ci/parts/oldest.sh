# `rust-version` in Cargo.toml is a promise that is kept here: the toolchain in use must not be older, and where it is
# newer, that very version builds the project, too, if it is installed. Clippy knows what the standard library of that
# version lacks (the part `lints`); only the compiler knows the rest.
promised=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
used=$(rustc --version | cut -d ' ' -f 2)
release=${used%%-*} # 1.96.0-nightly
minor=${release%.*}
if [ "$minor" = "$promised" ]; then
  echo "Rust $used is in use, the oldest that is promised: what the other parts build is built with it"
elif [ "$(printf '%s\n' "$promised" "$minor" | sort -V | head -n 1)" = "$minor" ]; then
  echo "Rust $used is in use, older than the $promised that Cargo.toml asks for" >&2
  exit 1
else
  # The exact name: rustup would fetch `1.95` where `1.95.0` is installed.
  pattern="^${promised//./\\.}(\\.[0-9]+)?(-|\$| )"
  installed=$({ rustup toolchain list 2> /dev/null || true; } | grep -E "$pattern" | head -n 1 | cut -d ' ' -f 1 || true)
  if [ -n "$installed" ]; then
    cargo "+$installed" check --workspace --all-targets --target-dir target/oldest
    echo "Rust $used is in use; $installed, the oldest that is promised, builds the project, too"
  else
    echo "Rust $used is in use; $promised, the oldest that is promised, is not installed: NOT built with it" \
      "(rustup toolchain install $promised)"
  fi
fi
