//! Motion over the input instead of time, where the speed stays positive.
//!
//! The state is the time and half the square of the speed, `e = omega^2 / 2`, with
//! `de/dphi = acceleration` and `dt/dphi = 1 / omega`. The end of a turn is then a position, and
//! no event.

use crate::equations_of_motion::Reduced;
use crate::machine::Machine;
use crate::observer::Receive;
use crate::phase::{Phase, Rates};
use crate::step::{self, Step};
use crate::stepper;

/// Rates of time and half the squared speed over the input.
struct OverInput<'m, F>(&'m Machine<F>);

impl<F: Fn(f64, f64) -> Reduced> Rates<1> for OverInput<'_, F> {
    fn rates(&self, input: f64, phase: &Phase<1>) -> Phase<1> {
        let speed = speed(phase);
        Phase {
            inputs: [1.0 / speed],
            speeds: [self.0.acceleration(input, speed)],
        }
    }
}

/// Returns the speed of a state; NaN where it has stopped.
pub(crate) fn speed(phase: &Phase<1>) -> f64 {
    (2.0 * phase.speeds[0]).sqrt()
}

/// One turn at a positive speed.
#[derive(Clone, Debug)]
pub(crate) struct Turn {
    /// Steps over the input; their states have the time and half the squared speed.
    pub(crate) steps: Vec<Step<1>>,
}

/// A turn that does not end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stall {
    /// Input at which the turn ends.
    pub(crate) input: f64,
    /// Speed there.
    pub(crate) speed: f64,
}

impl Turn {
    /// Integrates over one period from a speed.
    pub(crate) fn from_speed<F: Fn(f64, f64) -> Reduced>(
        machine: &Machine<F>,
        first: f64,
    ) -> Result<Self, Stall> {
        let start = Phase {
            inputs: [0.0],
            speeds: [0.5 * first * first],
        };
        let rates = OverInput(machine);
        let end = machine.start + machine.period;
        let mut turn = Self { steps: Vec::new() };
        let begin = (machine.start, start);
        let (result, _) = stepper::integrate(machine.settings(), &rates, begin, end, &mut turn);
        match result {
            Ok(()) => Ok(turn),
            Err(_) => {
                let last = turn.steps.last().map(Step::end);
                Err(Stall {
                    input: last.map_or(machine.start, |state| state.time),
                    speed: last.map_or(first, |state| speed(&state.phase())),
                })
            }
        }
    }

    /// Returns time and half the squared speed at the end.
    pub(crate) fn end(&self) -> [f64; 2] {
        let end = self.steps.last().map(Step::end);
        end.map_or([f64::NAN; 2], |state| [state.inputs[0], state.speeds[0]])
    }

    /// Returns the time since the start and the speed at an input.
    pub(crate) fn state(&self, input: f64) -> [f64; 2] {
        step::step_at(&self.steps, input).map_or([f64::NAN; 2], |step| {
            let state = step.state(input);
            [state.inputs[0], speed(&state.phase())]
        })
    }
}

impl Receive<1> for Turn {
    fn needs_nodes(&self, _: &Phase<1>, _: &Phase<1>) -> bool {
        true
    }

    fn step(&mut self, step: Step<1>) -> bool {
        self.steps.push(step);
        true
    }

    fn end(&mut self, _: f64, _: &Phase<1>) -> bool {
        true
    }
}
