cargo run --release -- solve cases/two-bricks.toml
