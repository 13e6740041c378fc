#!/usr/bin/env bash
# s_curve 0.1.7, Rust: a motion with limited jerk that goes to smaller positions and begins or ends with a speed.
#
# Behaviour: a motion from 10 to 0 that begins at -1 jumps by 7.07 on its way, and moves at 6.9 within a limit of 2. It
# takes 4.58 s, less than any motion within the limits, and its mirror image from 0 to 10 takes 5.44 s and is right. One
# that ends at -1 jumps by 2.49, and one at -1 throughout by 10.06. From rest to rest the same way is right. Start and
# end of each motion have the given positions and speeds. No error is returned.
#
# A fair guess: the motion to the left is the mirror image of the one to the right.
#
# Source: the README has a trajectory "constrained to maximum jerk, acceleration and velocity". The times of the phases
# have the speeds with the sign of the direction, and `eval_position` in src/lib.rs has them with and without it.
#
# Seen, within a speed of 2, an acceleration of 5 and a jerk of 20:
#   0 to 10 at 1, ends at 0: 5.437 s, largest step 0.0005, fastest 2.00
#   10 to 0 at -1, ends at 0: 4.579 s, largest step 7.0670, fastest 6.91
#   10 to 0 at 0, ends at -1: 4.579 s, largest step 2.4884, fastest 4.91
#   10 to 0 at -1, ends at -1: 5.031 s, largest step 10.0594, fastest 6.98
#   10 to 0 at 0, ends at 0: 5.650 s, largest step 0.0006, fastest 2.00
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cargo init --quiet --vcs none --name check
cargo add --quiet s_curve@=0.1.7
cat >src/main.rs <<'CHECK'
use s_curve::{s_curve_generator, Derivative, SCurveConstraints, SCurveInput, SCurveStartConditions};

const STEPS: usize = 20_000;
const SPEED: f64 = 2.0;

/// Duration, largest step of the position and largest speed of a motion.
fn measure(start_conditions: SCurveStartConditions) -> [f64; 3] {
    let constraints = SCurveConstraints { max_jerk: 20.0, max_acceleration: 5.0, max_velocity: SPEED };
    let ends = [start_conditions.q0, start_conditions.q1, start_conditions.v0, start_conditions.v1];
    let input = SCurveInput { constraints, start_conditions };
    let (parameters, position) = s_curve_generator(&input, Derivative::Position);
    let (_, speed) = s_curve_generator(&input, Derivative::Velocity);
    let duration = parameters.time_intervals.total_duration();
    let found = [position(0.0), position(duration), speed(0.0), speed(duration)];
    assert!(found.iter().zip(ends).all(|(found, end)| (found - end).abs() < 1e-9));
    let times: Vec<f64> = (0..=STEPS).map(|index| duration * index as f64 / STEPS as f64).collect();
    let step = times.windows(2).map(|pair| (position(pair[1]) - position(pair[0])).abs()).fold(0.0, f64::max);
    [duration, step, times.iter().map(|&time| speed(time).abs()).fold(0.0, f64::max)]
}

fn main() {
    for (q0, q1, v0, v1, is_right) in [
        (0.0, 10.0, 1.0, 0.0, true),
        (10.0, 0.0, -1.0, 0.0, false),
        (10.0, 0.0, 0.0, -1.0, false),
        (10.0, 0.0, -1.0, -1.0, false),
        (10.0, 0.0, 0.0, 0.0, true),
    ] {
        let [duration, step, fastest] = measure(SCurveStartConditions { q0, q1, v0, v1 });
        println!("{q0} to {q1} at {v0}, ends at {v1}: {duration:.3} s, largest step {step:.4}, fastest {fastest:.2}");
        assert_eq!(step < 0.001 && fastest < SPEED + 1e-9, is_right);
        assert!(is_right || step > 2.0 && fastest > 2.0 * SPEED);
    }
}
CHECK
CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$folder/target} cargo run --quiet
