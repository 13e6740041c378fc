//! Times and their limits, in a long run on a machine that does nothing else:
//! `cargo test --release -p linkage-playground speed -- --ignored --nocapture --test-threads=1`.
//! Other programs make times longer: the shortest of many is compared with the limit.

mod keys;
mod load;
mod sweeps;
