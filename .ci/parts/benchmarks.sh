cargo run --release -- bench table1 --sizes 9,16
cargo run --release -- bench coulomb --sizes 9,16
