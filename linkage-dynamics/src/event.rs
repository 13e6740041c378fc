//! Events: states at which a function of the motion is zero, located on dense output.

use crate::computed_motion::Occurrence;
use crate::state::State;
use crate::step::{NODES, Step};
use linkage_core::numeric::bracket;
use std::fmt;

/// A function of the state whose zeros are events.
///
/// A zero is found if the function changes its sign between two of the eight points of a step, at
/// which dense output is stored. It is located by bracketing, to the last digit of the time, so that
/// its error is that of dense output. A zero at the start is none, and NaN has no sign.
///
/// ```
/// use linkage_dynamics::{Ended, Event, Problem};
///
/// // A pendulum of 1 m, released at 90 degrees: its lowest position, and its turn.
/// let motion = Problem::new(|_, [phi], [_]: [f64; 1]| [-9.81 * f64::sin(phi)])
///     .start([std::f64::consts::FRAC_PI_2], [0.0])
///     .event(Event::input(0, 0.0))
///     .event(Event::reversal(0).stop())
///     .until(10.0)?;
/// assert_eq!(motion.ended(), Ended::Event(1));
/// let [lowest, turn] = motion.occurrences() else { panic!("two events") };
/// assert!((lowest.state.speeds[0].powi(2) - 2.0 * 9.81).abs() < 1e-7);
/// assert!((turn.state.time - 2.0 * lowest.state.time).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Event<'a, const N: usize> {
    function: Box<dyn Fn(&State<N>) -> f64 + 'a>,
    direction: Direction,
    stops: bool,
}

/// Changes of sign that are events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Direction {
    Both,
    Rising,
    Falling,
}

impl<'a, const N: usize> Event<'a, N> {
    /// Creates the event that `function` crosses zero: a margin less its limit, for example.
    pub fn new(function: impl Fn(&State<N>) -> f64 + 'a) -> Self {
        Self {
            function: Box::new(function),
            direction: Direction::Both,
            stops: false,
        }
    }

    /// Creates the event that an input passes a value.
    #[must_use]
    pub fn input(index: usize, value: f64) -> Self {
        Self::new(move |state| state.inputs[index] - value)
    }

    /// Creates the event that the speed of an input passes a value.
    #[must_use]
    pub fn speed(index: usize, value: f64) -> Self {
        Self::new(move |state| state.speeds[index] - value)
    }

    /// Creates the event that the speed of an input changes its sign.
    #[must_use]
    pub fn reversal(index: usize) -> Self {
        Self::speed(index, 0.0)
    }

    /// Restricts the event to changes from negative to positive.
    #[must_use]
    pub fn rising(mut self) -> Self {
        self.direction = Direction::Rising;
        self
    }

    /// Restricts the event to changes from positive to negative.
    #[must_use]
    pub fn falling(mut self) -> Self {
        self.direction = Direction::Falling;
        self
    }

    /// Makes the event the end of the motion.
    #[must_use]
    pub fn stop(mut self) -> Self {
        self.stops = true;
        self
    }

    /// True if a change of sign in this direction is an event.
    fn concerns(&self, is_rising: bool) -> bool {
        match self.direction {
            Direction::Both => true,
            Direction::Rising => is_rising,
            Direction::Falling => !is_rising,
        }
    }
}

impl<const N: usize> fmt::Debug for Event<'_, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Event")
            .field("direction", &self.direction)
            .field("stops", &self.stops)
            .finish_non_exhaustive()
    }
}

/// Returns the time between two nodes at which a function of the state is zero. Its values there
/// have different signs.
pub(crate) fn zero<const N: usize>(
    step: &Step<N>,
    [low, high]: [(f64, f64); 2],
    function: impl Fn(&State<N>) -> f64,
) -> f64 {
    // From the start of the step, so that the bracket has more digits than the time.
    let after = |time: f64| time - step.start;
    let (low, high) = ((after(low.0), low.1), (after(high.0), high.1));
    let mut value = |x: f64| [function(&step.state(step.start + x)), f64::NAN];
    step.start + bracket::root(low, high, &mut value)
}

/// Events of a motion, with the last value of each that is not zero.
pub(crate) struct EventSearch<'e, 'a, const N: usize> {
    events: &'e [Event<'a, N>],
    last: Vec<(f64, f64)>,
}

impl<'e, 'a, const N: usize> EventSearch<'e, 'a, N> {
    pub(crate) fn new(events: &'e [Event<'a, N>], start: &State<N>) -> Self {
        let values = events.iter().map(|event| (event.function)(start));
        let last = values.map(|value| (start.time, value)).collect();
        Self { events, last }
    }

    /// Appends the events of a step in the order of time, up to the first that stops. Returns that
    /// one.
    pub(crate) fn add(
        &mut self,
        step: &Step<N>,
        occurrences: &mut Vec<Occurrence<N>>,
    ) -> Option<Occurrence<N>> {
        let mut found: Vec<Occurrence<N>> = Vec::new();
        for (index, (event, last)) in self.events.iter().zip(&mut self.last).enumerate() {
            for node in 1..NODES {
                let time = step.position(node);
                let value = (event.function)(&State::new(time, step.nodes[node]));
                let before = std::mem::replace(last, (time, value));
                if value == 0.0 {
                    // The sign before it decides at the next node.
                    *last = if before.1 == 0.0 { *last } else { before };
                }
                let is_crossed = before.1 * value < 0.0;
                if is_crossed && event.concerns(value > 0.0) {
                    let low = (before.0.max(step.start), before.1);
                    let time = zero(step, [low, (time, value)], &event.function);
                    let state = step.state(time);
                    found.push(Occurrence {
                        event: index,
                        state,
                    });
                }
            }
        }
        found.sort_by(|a, b| a.state.time.total_cmp(&b.state.time));
        let stop = found
            .iter()
            .position(|found| self.events[found.event].stops);
        found.truncate(stop.map_or(found.len(), |stop| stop + 1));
        occurrences.extend_from_slice(&found);
        stop.map(|stop| found[stop])
    }
}
