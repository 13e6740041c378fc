//! A motion that has been computed: its steps with dense output, its events, its end.

use crate::state::State;
use crate::step::{self, Step};
use std::fmt;

/// An event that occurred.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occurrence<const N: usize> {
    /// Index of the event, in the order of [`Problem::event`](crate::Problem::event).
    pub event: usize,
    /// State at which the function of the event is zero.
    pub state: State<N>,
}

/// The end of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ended {
    /// The time that was asked for, or the cause of an error.
    Time,
    /// The event of this index, which stops.
    Event(usize),
}

/// A motion over an interval of time.
#[derive(Clone)]
pub struct Motion<const N: usize> {
    pub(crate) start: State<N>,
    pub(crate) end: State<N>,
    pub(crate) ended: Ended,
    pub(crate) steps: Vec<Step<N>>,
    pub(crate) occurrences: Vec<Occurrence<N>>,
    pub(crate) accepted: usize,
    pub(crate) rejected: usize,
    pub(crate) evaluations: usize,
}

/// Prints no steps, which may be thousands.
impl<const N: usize> fmt::Debug for Motion<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Motion")
            .field("start", &self.start)
            .field("end", &self.end)
            .field("ended", &self.ended)
            .field("occurrences", &self.occurrences)
            .field("steps", &self.accepted)
            .finish_non_exhaustive()
    }
}

impl<const N: usize> Motion<N> {
    /// Creates the motion that has only its start.
    pub(crate) const fn new(start: State<N>) -> Self {
        Self {
            start,
            end: start,
            ended: Ended::Time,
            steps: Vec::new(),
            occurrences: Vec::new(),
            accepted: 0,
            rejected: 0,
            evaluations: 0,
        }
    }

    /// Appends a step.
    pub(crate) fn append(&mut self, step: Step<N>, is_kept: bool) {
        self.end = step.end();
        self.accepted += 1;
        if is_kept {
            self.steps.push(step);
        }
    }

    /// Returns the state at the beginning.
    #[must_use]
    pub const fn start(&self) -> State<N> {
        self.start
    }

    /// Returns the state at the end.
    #[must_use]
    pub const fn end(&self) -> State<N> {
        self.end
    }

    /// Returns the reason of the end.
    #[must_use]
    pub const fn ended(&self) -> Ended {
        self.ended
    }

    /// Returns the events that occurred, in the order of time.
    #[must_use]
    pub fn occurrences(&self) -> &[Occurrence<N>] {
        &self.occurrences
    }

    /// Returns the state at a time in s, from the polynomial of its step; NaN outside of the motion
    /// and without stored steps ([`Problem::only_end`](crate::Problem::only_end)).
    #[must_use]
    pub fn state(&self, time: f64) -> State<N> {
        let inside = time >= self.start.time && time <= self.end.time;
        match step::step_at(&self.steps, time).filter(|_| inside) {
            Some(step) => step.state(time),
            None => State {
                time,
                inputs: [f64::NAN; N],
                speeds: [f64::NAN; N],
            },
        }
    }

    /// Returns `count` states (two or more) at even distances in time, both ends included.
    pub fn states(&self, count: usize) -> impl Iterator<Item = State<N>> + '_ {
        let (start, end) = (self.start.time, self.end.time);
        let last = count.saturating_sub(1).max(1);
        (0..count).map(move |i| {
            if i == last {
                self.end
            } else {
                self.state(start + (end - start) * (i as f64 / last as f64))
            }
        })
    }

    /// Returns the states at the ends of the steps, the start included.
    pub fn step_states(&self) -> impl Iterator<Item = State<N>> + '_ {
        std::iter::once(self.start).chain(self.steps.iter().map(Step::end))
    }

    /// Returns the integral over time of a function of the state, for example the work of a motor,
    /// by a Gauss rule of 8 points over each step. The function must be as smooth as the motion.
    #[must_use]
    pub fn integral(&self, function: impl Fn(&State<N>) -> f64) -> f64 {
        step::integral(&self.steps, function)
    }

    /// Returns the same integral from the start up to each of the [`states`](Self::states) of this
    /// count: work over time, for example.
    #[must_use]
    pub fn integrals(&self, count: usize, function: impl Fn(&State<N>) -> f64) -> Vec<f64> {
        let times: Vec<f64> = self.states(count).map(|state| state.time).collect();
        step::integrals(&self.steps, &times, function)
    }

    /// Returns the number of steps.
    #[must_use]
    pub const fn steps(&self) -> usize {
        self.accepted
    }

    /// Returns the number of steps that were tried and rejected.
    #[must_use]
    pub const fn rejected(&self) -> usize {
        self.rejected
    }

    /// Returns the number of evaluations of the equations of motion.
    #[must_use]
    pub const fn evaluations(&self) -> usize {
        self.evaluations
    }
}
