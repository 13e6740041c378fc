#!/usr/bin/env bash
# symdiff 2.1.0: the gradient of the root of a square has the wrong sign for negative numbers.
#
# Expected: `sqrt(x^2)` is `|x|`, and its derivative at -3 is -1.
# Seen: the simplification takes `sqrt(b^(2k))` for `b^k`, and the generated gradient is 1. The function itself is unchanged and returns 3.
# Source: https://docs.rs/symdiff/2.1.0, documentation of `SimplifyTransformer` in `src/transformers.rs`
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'END'
[package]
name = "root"
version = "0.0.0"
edition = "2024"

[dependencies]
symdiff = "=2.1.0"
END
cat >src/main.rs <<'END'
#[symdiff::gradient(var = x, dim = 1)]
fn distance(x: &[f64]) -> f64 {
    x[0].powi(2).sqrt()
}

fn main() {
    println!("{} {:?}", distance(&[-3.0]), distance_gradient(&[-3.0]));
}
END
seen=$(CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$folder/target} cargo run --quiet 2>/dev/null)
printf 'value and gradient of sqrt(x^2) at -3: %s\n' "$seen"
[[ $seen == "3 [1.0]" ]]
