#!/usr/bin/env bash
# ode_solvers 0.6.2: with an output interval as long as the motion, the last row of a pendulum is off by 4e8 rad, as a success.
#
# Expected: `Dop853::new(system, 0, end, dx, ...)` writes a row for each `dx`; with `dx = end` these are the start and the end, with the error
# of the steps (1e-9 here).
# Seen: `integrate` returns Ok, and the last row is off by more than 1e6 rad. With `dx = end / 200` the last row is right.
# Source: https://docs.rs/ode_solvers/0.6.2/ode_solvers/dop853/struct.Dop853.html
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'END'
[package]
name = "pendulum"
version = "0.0.0"
edition = "2024"

[dependencies]
ode_solvers = "=0.6.2"
END
cat >src/main.rs <<'END'
use ode_solvers::{Dop853, System, Vector2};

struct Pendulum;

impl System<f64, Vector2<f64>> for Pendulum {
    fn system(&self, _time: f64, state: &Vector2<f64>, rate: &mut Vector2<f64>) {
        rate[0] = state[1];
        rate[1] = -state[0].sin();
    }
}

/// The last row: its time, and the angle there.
fn last(end: f64, interval: f64) -> (f64, f64) {
    let start = Vector2::new(2.0, 0.0);
    let mut solver = Dop853::new(Pendulum, 0.0, end, interval, start, 1e-9, 1e-9);
    solver.integrate().expect("a success");
    let (times, states) = (solver.x_out(), solver.y_out());
    (*times.last().unwrap(), states.last().unwrap()[0])
}

fn main() {
    // Ten swings from 2 rad, by the arithmetic-geometric mean.
    let (mut a, mut b) = (1.0, f64::cos(1.0));
    for _ in 0..20 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    let end = 20.0 * std::f64::consts::PI / a;
    for interval in [end / 200.0, end] {
        let (time, angle) = last(end, interval);
        println!("interval {interval:.2} s: {angle:.6e} rad at {:.2} of the time", time / end);
    }
    let fine = last(end, end / 200.0).1;
    let wide = last(end, end).1;
    assert!((fine - 2.0).abs() < 1e-6, "{fine}");
    assert!((wide - 2.0).abs() > 1e6, "{wide}");
}
END
CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$folder/target} cargo run --quiet --release
