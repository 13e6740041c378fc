#!/usr/bin/env bash
# cargo 1.95.0 (2026-03-21): a check after a build compiles a procedural macro again if the macro and the program share a crate.
#
# Expected: `cargo check` after `cargo build` compiles nothing for the host, since macros are the same programs in both.
# Seen: a crate that the macro and the program share is built once, with the debug information of the program. A check does not build it
# for the program, so Cargo builds it for the macro without debug information, and then all that depends on it: here `proc-macro2`,
# `quote`, `syn`, `unicode-ident` and `serde_derive`. With `profile.dev.debug = 0`, or other features of the shared crate in the macro, nothing is compiled.
# Source: https://doc.rust-lang.org/cargo/reference/profiles.html#build-dependencies
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'END'
[package]
name = "shared"
version = "0.0.0"
edition = "2024"

[dependencies]
proc-macro2 = "=1.0.101"
quote = "=1.0.40"
serde_derive = "=1.0.219"
END
echo 'fn main() { println!("{}", quote::quote!(a + b)); }' >src/main.rs
export CARGO_TARGET_DIR=$folder/target

compiled_by_a_check() {
    cargo build --quiet "$@"
    # The macro and what only it needs: Cargo has one line for a package, also if it builds it twice.
    cargo check "$@" 2>&1 | sed -n 's/^ *Compiling \(serde_derive\|syn\) .*/\1/p' | LC_ALL=C sort | paste -sd' '
    rm -rf target
}

cargo --version
default=$(compiled_by_a_check)
without=$(compiled_by_a_check --config profile.dev.debug=0)
printf 'compiled by a check after a build: %s\nwithout debug information: %s\n' "${default:-nothing}" "${without:-nothing}"
[[ $default == "serde_derive syn" && -z $without ]]
