//! Periodic steady state of a machine: the speed that repeats itself after a turn, its unevenness.

use crate::equations_of_motion::Reduced;
use crate::event::zero;
use crate::machine::Machine;
use crate::step::{NODES, Step, integral};
use crate::turn::{Stall, Turn, speed};
use std::error::Error;
use std::fmt;

/// Newton's steps, many more than a good start needs.
const NEWTON_STEPS: usize = 50;
/// Difference of the speed for its derivative: the third root of a digit.
const DIFFERENCE: f64 = 6e-6;

/// A motion that repeats itself with every period of the input.
#[derive(Clone, Debug)]
pub struct SteadyState {
    turn: Turn,
    period: f64,
    multiplier: f64,
    slowest: (f64, f64),
    fastest: (f64, f64),
}

impl SteadyState {
    /// Returns the time of a period, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.turn.end()[0]
    }

    /// Returns the mean speed over time: the period of the input over its time, rad/s.
    #[must_use]
    pub fn mean_speed(&self) -> f64 {
        self.period / self.time()
    }

    /// Returns input and speed where the machine is slowest.
    #[must_use]
    pub const fn slowest(&self) -> (f64, f64) {
        self.slowest
    }

    /// Returns input and speed where the machine is fastest.
    #[must_use]
    pub const fn fastest(&self) -> (f64, f64) {
        self.fastest
    }

    /// Returns the degree of unevenness: the difference of the largest and the least speed over the
    /// mean speed.
    #[must_use]
    pub fn unevenness(&self) -> f64 {
        (self.fastest.1 - self.slowest.1) / self.mean_speed()
    }

    /// Returns the factor by which a disturbance of the squared speed changes in one period: the
    /// steady state is stable if it is less than 1.
    #[must_use]
    pub const fn multiplier(&self) -> f64 {
        self.multiplier
    }

    /// Returns the speed at an input of the period; NaN outside of it.
    #[must_use]
    pub fn speed(&self, input: f64) -> f64 {
        self.turn.state(input)[1]
    }

    /// Returns the time since the start of the period at an input of it, s; NaN outside of it.
    #[must_use]
    pub fn time_at_input(&self, input: f64) -> f64 {
        self.turn.state(input)[0]
    }
}

/// The reason why there is no steady state.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NotSteady {
    /// The machine stops within the turn.
    Stalls {
        /// Speed at the start of the turn, rad/s.
        start: f64,
        /// Input at which the turn ends.
        input: f64,
        /// Speed there.
        speed: f64,
    },
    /// The speed does not change the speed after a turn: no torque depends on it.
    Indifferent {
        /// Change of half the squared speed in a turn.
        gain: f64,
    },
    /// Newton's steps do not converge.
    NotFound {
        /// Speed of the last step, rad/s.
        speed: f64,
        /// Relative change of the squared speed in a turn there.
        change: f64,
    },
    /// No flywheel gives the wished unevenness.
    NoFlywheel {
        /// The wished degree of unevenness.
        wished: f64,
        /// Degree of unevenness of the last step.
        unevenness: f64,
    },
    /// The speed to begin with, or the wished unevenness, is not a positive number.
    NotPositive(f64),
}

impl fmt::Display for NotSteady {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stalls {
                start,
                input,
                speed,
            } => write!(
                f,
                "the machine that starts a turn with {start} rad/s ends it at the input {input} with {speed} rad/s\n\
                 help: begin with a larger speed, or use a stronger motor or a flywheel"
            ),
            Self::Indifferent { gain } => write!(
                f,
                "half the squared speed grows by {gain} in each turn, at every speed\nhelp: use a motor or a damper \
                 whose torque depends on the speed"
            ),
            Self::NotFound { speed, change } => write!(
                f,
                "no steady state is found near {speed} rad/s, where the squared speed changes by {:.1} % in a turn\n\
                 help: begin with another speed",
                100.0 * change
            ),
            Self::NoFlywheel { wished, unevenness } => write!(
                f,
                "no flywheel is found for the unevenness {wished}: the last one gives {unevenness}"
            ),
            Self::NotPositive(value) => write!(f, "{value} is not a positive number"),
        }
    }
}

impl Error for NotSteady {}

/// Finds the periodic steady state of a machine near a speed at the start of its period, rad/s.
///
/// Newton's method solves `P(e) = e` for half the squared speed `e = omega^2 / 2` at the start,
/// where `P` is the result of a period. Its derivative is `exp` of the integral of
/// `(d acceleration / d omega) / omega` over the period.
///
/// # Errors
///
/// [`NotSteady`]: the machine stops, no torque depends on the speed, or Newton's steps end
/// elsewhere.
pub fn steady_state<F>(machine: &Machine<F>, near: f64) -> Result<SteadyState, NotSteady>
where
    F: Fn(f64, f64) -> Reduced,
{
    if !(near > 0.0 && near.is_finite()) {
        return Err(NotSteady::NotPositive(near));
    }
    let mut start = near;
    let mut change = f64::NAN;
    for _ in 0..NEWTON_STEPS {
        let turn = Turn::from_speed(machine, start).map_err(|stall| stalls(start, stall))?;
        let half_square = 0.5 * start * start;
        let gain = turn.end()[1] - half_square;
        change = gain / half_square;
        let multiplier = multiplier(machine, &turn);
        // What differences of the acceleration cannot see.
        if (multiplier - 1.0).abs() < DIFFERENCE * DIFFERENCE {
            return Err(NotSteady::Indifferent { gain });
        }
        let step = gain / (1.0 - multiplier);
        if step.abs() <= machine.tolerance * half_square {
            return Ok(state(machine, turn, multiplier));
        }
        // Not below a tenth of the square, and not above ten times of it.
        let next = (half_square + step).clamp(0.1 * half_square, 10.0 * half_square);
        start = (2.0 * next).sqrt();
    }
    Err(NotSteady::NotFound {
        speed: start,
        change,
    })
}

const fn stalls(start: f64, stall: Stall) -> NotSteady {
    NotSteady::Stalls {
        start,
        input: stall.input,
        speed: stall.speed,
    }
}

/// Returns the derivative of half the squared speed after a period with respect to that before.
fn multiplier<F: Fn(f64, f64) -> Reduced>(machine: &Machine<F>, turn: &Turn) -> f64 {
    let exponent = integral(&turn.steps, |state| {
        let omega = speed(&state.phase());
        let [low, high] = [1.0 - DIFFERENCE, 1.0 + DIFFERENCE].map(|part| part * omega);
        let [less, more] = [low, high].map(|omega| machine.acceleration(state.time, omega));
        (more - less) / ((high - low) * omega)
    });
    exponent.exp()
}

/// Returns the steady state with its extreme speeds, at which the acceleration is zero.
fn state<F: Fn(f64, f64) -> Reduced>(
    machine: &Machine<F>,
    turn: Turn,
    multiplier: f64,
) -> SteadyState {
    let first = (machine.start, turn.state(machine.start)[1]);
    let (mut slowest, mut fastest) = (first, first);
    let mut consider = |input: f64, omega: f64| {
        if omega < slowest.1 {
            slowest = (input, omega);
        }
        if omega > fastest.1 {
            fastest = (input, omega);
        }
    };
    for step in &turn.steps {
        let acceleration = |node: usize| {
            let input = step.position(node);
            (input, machine.acceleration(input, speed(&step.nodes[node])))
        };
        for node in 1..NODES {
            consider(step.position(node), speed(&step.nodes[node]));
            let ends = [acceleration(node - 1), acceleration(node)];
            if ends[0].1 * ends[1].1 < 0.0 {
                let input = extreme(machine, step, ends);
                consider(input, speed(&step.state(input).phase()));
            }
        }
    }
    SteadyState {
        turn,
        period: machine.period,
        multiplier,
        slowest,
        fastest,
    }
}

/// Returns the input between two nodes at which the acceleration is zero.
fn extreme<F: Fn(f64, f64) -> Reduced>(
    machine: &Machine<F>,
    step: &Step<1>,
    ends: [(f64, f64); 2],
) -> f64 {
    zero(step, ends, |state| {
        machine.acceleration(state.time, speed(&state.phase()))
    })
}
