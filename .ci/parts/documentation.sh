# By a configuration, which adds to flags of .cargo/config.toml; the environment variable would replace them.
cargo doc --workspace --no-deps --config 'build.rustdocflags = ["--deny=warnings"]'
