#!/usr/bin/env bash
# ivp 0.6.0: `RADAU::default().solve` of an oscillator jumps to zero in the first step, and returns a success.
#
# Expected: the mass matrix of a system that has none of its own is the identity, as `mass` is documented, and the cosine comes out.
# Seen: the default storage of the mass matrix is full, and the matrix stays zero, so that the method solves `0 = rate`. With
# `MatrixStorage::Identity` the result is right.
# Source: https://docs.rs/ivp/0.6.0/ivp/methods/struct.RADAU.html (`mass_storage`) and
# https://docs.rs/ivp/0.6.0/ivp/prelude/trait.FirstOrderSystem.html (`mass`)
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'END'
[package]
name = "oscillator"
version = "0.0.0"
edition = "2024"

[dependencies]
ivp = "=0.6.0"
END
cat >src/main.rs <<'END'
use ivp::dense::StepInterpolant;
use ivp::matrix::MatrixStorage;
use ivp::methods::{RADAU, Tolerance};
use ivp::prelude::{FirstOrderSystem, Status};
use ivp::solout::{ControlFlag, SolOut};

/// The solution is the cosine.
struct Oscillator;

impl FirstOrderSystem for Oscillator {
    fn derivative(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        (rate[0], rate[1]) = (state[1], -state[0]);
    }
}

/// The last state.
struct Last(f64, f64);

impl SolOut for Last {
    fn solout(&mut self, _from: f64, to: &mut f64, state: &mut [f64], _dense: Option<&StepInterpolant<'_>>) -> ControlFlag {
        (self.0, self.1) = (*to, state[0]);
        ControlFlag::Continue
    }
}

fn solved(method: RADAU) -> (bool, f64) {
    let mut last = Last(0.0, f64::NAN);
    let tolerance = || Tolerance::Vector(vec![1e-9; 2]);
    let run = method.solve(&Oscillator, 0.0, &[1.0, 0.0], 2.0, tolerance(), tolerance(), Some(&mut last));
    let run = run.expect("no error");
    println!("{:?} at {}: {:.6}, the cosine is {:.6}", run.status, last.0, last.1, last.0.cos());
    (matches!(run.status, Status::Success), last.1 - last.0.cos())
}

fn main() {
    let (is_success, error) = solved(RADAU::default());
    assert!(is_success && error.abs() > 0.1);
    let identity = RADAU { mass_storage: MatrixStorage::Identity, ..RADAU::default() };
    let (is_success, error) = solved(identity);
    assert!(is_success && error.abs() < 1e-6);
}
END
CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$folder/target} cargo run --quiet
