//! Dead points of inputs: a speed that changes its sign without the acceleration for it.
//!
//! At a dead point the inertia is infinite, and the speed of the input is zero at a finite kinetic
//! energy. Positions over time are smooth there, so that an integrator may pass it and return on
//! the same assembly mode, which the mechanism does not. At a true reversal the slope of the
//! speed is the acceleration of the equation of motion. At a dead point it is not: by the equation
//! an infinite inertia has no acceleration.

use crate::equations_of_motion::Equations;
use crate::event::zero;
use crate::state::State;
use crate::step::{NODES, Step};

/// Difference between slope and acceleration, as a part of the larger one, beyond which a reversal
/// is a dead point. Dense output at a tolerance of 1e-3 is off by less.
const DIFFERENCE: f64 = 0.5;
/// Changes of a speed below this multiple of its tolerance are rounding.
const NOISE: f64 = 100.0;
/// Part of the step over which the slope is taken.
const SPAN: f64 = 1e-3;
/// Part of the largest speed below which a dead point is looked for ahead. Nearer to it the input
/// has no digits for its distance. The second one is for a motion that has no further step.
const SLOW: [f64; 2] = [1e-4, 0.05];
/// Multiples of the tolerance that are slow, too.
const SMALL: f64 = 20.0;
/// Change of the acceleration on half of the way to rest below which it is the same.
const STEADY: f64 = 0.05;

/// Returns the input that reaches its dead point directly after a state, and the state there.
/// Speeds below `least` are rounding.
///
/// A slow input that brakes comes to rest within `-v / a`. Where its acceleration is the same after
/// half of that time, it is nearly the same at rest. At a dead point it is not.
pub(crate) fn dead_point_ahead<const N: usize>(
    equations: &impl Equations<N>,
    state: &State<N>,
    fastest: &[f64; N],
    least: f64,
    is_last: bool,
) -> Option<(State<N>, usize)> {
    let slow = SLOW[usize::from(is_last)];
    let is_slow = |input: &usize| {
        let speed = state.speeds[*input].abs();
        speed >= least && speed < (slow * fastest[*input]).max(SMALL * least)
    };
    (0..N).filter(is_slow).find_map(|input| {
        let accelerations = equations.accelerations(state.time, state.inputs, state.speeds);
        let left = -state.speeds[input] / accelerations[input];
        if !(left > 0.0 && left.is_finite()) {
            return None;
        }
        // After a part of the time, at a constant acceleration.
        let after = |part: f64| {
            let mut state = *state;
            state.time += part * left;
            for (i, position) in state.inputs.iter_mut().enumerate() {
                let braked = if i == input { 0.5 * part } else { 0.0 };
                *position += part * left * state.speeds[i] * (1.0 - braked);
            }
            state.speeds[input] *= 1.0 - part;
            state
        };
        let acceleration = |state: &State<N>| {
            equations.accelerations(state.time, state.inputs, state.speeds)[input]
        };
        let rest = after(1.0);
        let (first, half) = (accelerations[input], acceleration(&after(0.5)));
        let is_steady = (half - first).abs() <= STEADY * first.abs();
        (is_steady && !agree(first, acceleration(&rest))).then_some((rest, input))
    })
}

/// Returns true if the slope of a speed is the acceleration of the equation of motion.
fn agree(slope: f64, acceleration: f64) -> bool {
    let size = slope.abs().max(acceleration.abs());
    (slope - acceleration).abs() <= DIFFERENCE * size
}

/// Returns the time and the input of the first dead point in a step.
pub(crate) fn dead_point<const N: usize>(
    equations: &impl Equations<N>,
    step: &Step<N>,
    tolerance: impl Fn(f64) -> f64,
) -> Option<(f64, usize)> {
    let found = (0..N).filter_map(|input| {
        let time = reversal(step, input, &tolerance)?;
        let state = step.state(time);
        let accelerations = equations.accelerations(time, state.inputs, state.speeds);
        let span = SPAN * step.width;
        let speed = |time: f64| step.state(time).speeds[input];
        let slope = (speed(time + span) - speed(time - span)) / (2.0 * span);
        (!agree(slope, accelerations[input])).then_some((time, input))
    });
    found.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Returns the time at which the speed of an input changes its sign, if it changes by more than
/// rounding.
fn reversal<const N: usize>(
    step: &Step<N>,
    input: usize,
    tolerance: impl Fn(f64) -> f64,
) -> Option<f64> {
    let speeds = step.nodes.map(|node| node.speeds[input]);
    let node = (1..NODES).find(|&node| speeds[node - 1] * speeds[node] < 0.0)?;
    let change = (speeds[NODES - 1] - speeds[0]).abs();
    let largest = speeds.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    if change < NOISE * tolerance(largest) {
        return None;
    }
    let ends = [node - 1, node].map(|node| (step.position(node), speeds[node]));
    Some(zero(step, ends, |state| state.speeds[input]))
}
