#!/usr/bin/env bash
# differential-equations 0.7.0: DOP853 reaches 1e-12 at the ends of steps, and its dense output is off by 5e-8 between them.
#
# Expected: the continuous extension of order 7 that belongs to the method, with an error near that of the steps.
# Seen: at the tolerance 1e-12 `interpolate` is ten thousand times less accurate than the steps; `ivp` 0.6.0, by the same author and with the
# same method, is not.
# Source: https://docs.rs/differential-equations/0.7.0/differential_equations/ and https://docs.rs/ivp/0.6.0/ivp/
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
differential-equations = "=0.7.0"
ivp = "=0.6.0"
END
cat >src/main.rs <<'END'
use differential_equations::ode::OrdinaryNumericalMethod;
use differential_equations::prelude::{ExplicitRungeKutta, Interpolation, ODE};
use ivp::dense::StepInterpolant;
use ivp::prelude::FirstOrderSystem;
use ivp::solout::{ControlFlag, SolOut};

const TOLERANCE: f64 = 1e-12;

/// The solution is the cosine.
struct Oscillator;

impl ODE<f64, [f64; 2]> for Oscillator {
    fn diff(&self, _time: f64, state: &[f64; 2], rate: &mut [f64; 2]) {
        *rate = [state[1], -state[0]];
    }
}

impl FirstOrderSystem for Oscillator {
    fn derivative(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        (rate[0], rate[1]) = (state[1], -state[0]);
    }
}

/// The largest errors at the ends of steps, and between them.
#[derive(Default)]
struct Errors {
    ends: f64,
    between: f64,
}

impl SolOut for Errors {
    fn solout(&mut self, from: f64, to: &mut f64, state: &mut [f64], dense: Option<&StepInterpolant<'_>>) -> ControlFlag {
        self.ends = self.ends.max((state[0] - to.cos()).abs());
        if let Some(dense) = dense {
            for k in 1..20 {
                let time = from + (*to - from) * f64::from(k) / 20.0;
                let mut found = [0.0; 2];
                dense.interpolate(time, &mut found);
                self.between = self.between.max((found[0] - time.cos()).abs());
            }
        }
        ControlFlag::Continue
    }
}

fn differential_equations() -> Errors {
    let mut solver = ExplicitRungeKutta::dop853().rtol(TOLERANCE).atol(TOLERANCE);
    solver.init(&Oscillator, 0.0, 10.0, &[1.0, 0.0]).expect("a start");
    let mut errors = Errors::default();
    while solver.t() < 9.0 {
        solver.step(&Oscillator).expect("a step");
        let (from, to) = (solver.t_prev(), solver.t());
        errors.ends = errors.ends.max((solver.y()[0] - to.cos()).abs());
        for k in 1..20 {
            let time = from + (to - from) * f64::from(k) / 20.0;
            let found = solver.interpolate(time).expect("a time of the step");
            errors.between = errors.between.max((found[0] - time.cos()).abs());
        }
    }
    errors
}

fn ivp() -> Errors {
    let mut errors = Errors::default();
    let method = ivp::methods::DOP853::default();
    let [relative, absolute] = [TOLERANCE; 2];
    let solved = method.solve(&Oscillator, 0.0, &[1.0, 0.0], 10.0, relative.into(), absolute.into(), Some(&mut errors));
    solved.expect("a success");
    errors
}

fn main() {
    let [first, second] = [differential_equations(), ivp()];
    for (name, errors) in [("differential-equations", &first), ("ivp", &second)] {
        println!("{name}: {:.1e} at steps, {:.1e} between them", errors.ends, errors.between);
    }
    assert!(first.ends < 1e-10 && first.between > 1e3 * first.ends);
    assert!(second.ends < 1e-10 && second.between < 10.0 * second.ends);
}
END
CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$folder/target} cargo run --quiet --release
