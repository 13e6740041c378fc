//! Steps of the integrators of `ivp`, and shorter steps where there are no rates.
//!
//! An integrator reports each step to a receiver. Three findings of the receiver end its call, after
//! which another call begins at the last state: a step that needs dense output, a step that passed
//! a state without rates, and the end of the motion.

use crate::observer::{Finding, Observer, Receive};
use crate::phase::{Phase, Rates, Watched};
use ivp::ivp::FirstOrderSystem;
use ivp::matrix::MatrixStorage;
use ivp::methods::{DOP853, IntegrationResult, RADAU, Tolerance};
use ivp::status::Status;

/// The integrator of a motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// The explicit Runge-Kutta method of order 8 by Dormand and Prince (DOP853), with dense output
    /// of order 7. The default.
    #[default]
    Explicit,
    /// The implicit Runge-Kutta method of order 5 by Radau (Radau IIA), with dense output of order
    /// 3: for stiff springs and strong dampers.
    Implicit,
}

/// Settings of an integrator.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    pub(crate) method: Method,
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

/// The shortest step, as a part of the largest position: a few units of its last digit.
const SHORTEST: f64 = 2e-15;
/// Part of a step that is tried after a step without success.
const SHORTER: f64 = 0.25;
/// Evaluations at the end of a step: 11 stages, the new state, and 3 for dense output.
const EXPLICIT_EVALUATIONS: [usize; 2] = [12, 15];
/// Evaluations at the end of a step: 3 stages and the new state.
const IMPLICIT_EVALUATIONS: [usize; 2] = [4, 4];
/// Steps in one call of an integrator, so that a call without progress ends.
const STEPS: usize = 100_000;

/// The reason why there is no further step.
#[derive(Debug)]
pub(crate) enum Halt<const N: usize> {
    /// All steps lead to states without rates: the first of the last try.
    Undefined(f64, Phase<N>),
    /// A step of this width is still too inaccurate.
    TooShort(f64),
}

/// Numbers of evaluations and of rejected steps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counts {
    pub(crate) evaluations: usize,
    pub(crate) rejected: usize,
}

/// Integrates from a position and a state to a later position, or until the receiver ends it.
pub(crate) fn integrate<const N: usize, R: Rates<N>>(
    settings: Settings,
    rates: &R,
    (start, phase): (f64, Phase<N>),
    end: f64,
    receiver: &mut impl Receive<N>,
) -> (Result<(), Halt<N>>, Counts) {
    let watched = Watched::new(rates);
    let mut rejected = 0;
    let result = attempts(
        settings,
        &watched,
        (start, phase),
        end,
        receiver,
        &mut rejected,
    );
    let evaluations = watched.evaluations();
    let counts = Counts {
        evaluations,
        rejected,
    };
    (result, counts)
}

/// Calls the integrator until the end, each time from the last state.
fn attempts<const N: usize, R: Rates<N>>(
    settings: Settings,
    watched: &Watched<'_, R, N>,
    (start, phase): (f64, Phase<N>),
    end: f64,
    receiver: &mut impl Receive<N>,
    rejected: &mut usize,
) -> Result<(), Halt<N>> {
    let shortest = SHORTEST * start.abs().max(end.abs());
    // The first state needs rates: no step is short enough without.
    watched.derivative(start, &components(&phase), &mut vec![0.0; 2 * N]);
    if let Some((x, phase)) = watched.take_undefined() {
        return Err(Halt::Undefined(x, phase));
    }
    let last = match settings.method {
        Method::Explicit => EXPLICIT_EVALUATIONS,
        Method::Implicit => IMPLICIT_EVALUATIONS,
    };
    let mut observer = Observer::new(watched, receiver, (start, phase), end, last);
    let mut undefined = None;
    let mut first = None;
    loop {
        let begin = observer.x;
        let result = call(settings, watched, &mut observer, first);
        *rejected += result.steps.total - result.steps.accepted;
        let progress = observer.x > begin;
        undefined = watched.take_undefined().or(undefined.filter(|_| !progress));
        let left = end - observer.x;
        let width = if result.h.is_finite() {
            result.h.abs()
        } else {
            left
        };
        let next = match (observer.finding, result.status) {
            (Finding::End, _) | (_, Status::Success) => return Ok(()),
            (Finding::Switch, _) => width,
            (Finding::Undefined, _) => {
                *rejected += 1;
                SHORTER * width
            }
            // After many steps: the counter of the integrator begins again.
            (Finding::None, Status::ProbablyStiff) => width,
            (Finding::None, Status::NeedLargerNMax) if progress => width,
            (Finding::None, _) => SHORTER * width,
        };
        let is_stuck = result.status == Status::StepSizeTooSmall && !progress;
        if is_stuck || next < shortest.min(left) {
            return Err(match undefined {
                Some((x, phase)) => Halt::Undefined(x, phase),
                None => Halt::TooShort(next),
            });
        }
        first = Some(next.min(left));
    }
}

fn components<const N: usize>(phase: &Phase<N>) -> Vec<f64> {
    let mut components = vec![0.0; 2 * N];
    phase.write(&mut components);
    components
}

/// Calls the integrator once, from the state of the observer.
fn call<const N: usize, R: Rates<N>, V: Receive<N>>(
    settings: Settings,
    watched: &Watched<'_, R, N>,
    observer: &mut Observer<'_, '_, R, V, N>,
    first_step: Option<f64>,
) -> IntegrationResult {
    observer.finding = Finding::None;
    let (x, end) = (observer.x, observer.end);
    let state = components(&observer.phase);
    // A list: the integrators change it, and would change one number once for each component.
    let list = |tolerance: f64| Tolerance::Vector(vec![tolerance; 2 * N]);
    let (relative, absolute) = (list(settings.relative), list(settings.absolute));
    let (max_step, dense_output) = (Some(end - x), observer.has_nodes);
    let result = match settings.method {
        Method::Explicit => DOP853 {
            max_step,
            first_step,
            dense_output,
            max_steps: STEPS,
            ..DOP853::default()
        }
        .solve(watched, x, &state, end, relative, absolute, Some(observer)),
        Method::Implicit => RADAU {
            max_step,
            first_step,
            dense_output,
            max_steps: STEPS,
            // The default has a mass matrix of zeros.
            mass_storage: MatrixStorage::Identity,
            ..RADAU::default()
        }
        .solve(watched, x, &state, end, relative, absolute, Some(observer)),
    };
    result.expect("settings in their ranges")
}
