#!/usr/bin/env bash
# num-dual 0.15.1: the Rust example of the README does not compile.
#
# Expected: `fn f<D: DualNum<f64>>(x: D, y: D) -> D` as in the README of this version.
# Seen: error E0107, the trait has no generic argument; the number below a dual number is the associated type `Primitive`.
# Source: https://docs.rs/crate/num-dual/0.15.1/source/README.md and https://docs.rs/num-dual/0.15.1/num_dual/trait.DualNum.html
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'END'
[package]
name = "example"
version = "0.0.0"
edition = "2024"

[dependencies]
num-dual = { version = "=0.15.1", default-features = false }
END
program() {
    printf 'use num_dual::DualNum;\n\npub fn f<D: %s>(x: D, y: D) -> D {\n    x.powi(3) * y.powi(2)\n}\n' "$1" >src/lib.rs
    CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$folder/target} cargo check 2>&1 || true
}
readme=$(program 'DualNum<f64>')
without=$(program 'DualNum')
grep '^error' <<<"$readme"
grep -q 'error\[E0107\]' <<<"$readme" && ! grep -q '^error' <<<"$without"
