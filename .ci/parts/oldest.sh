# Clippy knows what the standard library of that version lacks (the part `lints`); only the compiler knows the rest.
oldest=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
if rustup toolchain list 2> /dev/null | grep -q "^$oldest"; then
  cargo "+$oldest" check --workspace --all-targets --target-dir target/oldest
else
  echo "Rust $oldest is not installed here (rustup toolchain install $oldest): not built with it"
fi
