//! The builder of a motion: equations, start, accuracy, events.

use crate::computed_motion::Motion;
use crate::equations_of_motion::{Equations, FromAccelerations, FromReduced, OverTime, Reduced};
use crate::error::{Cause, Interrupted};
use crate::event::Event;
use crate::recorder::Recorder;
use crate::state::State;
use crate::stepper::{self, Halt, Method, Settings};

/// Tolerance without another one: eight digits.
const TOLERANCE: f64 = 1e-8;
/// The smallest tolerance that integrators can use in double precision.
const LEAST_TOLERANCE: f64 = 1e-14;
/// A larger tolerance is a mistake.
const LARGEST_TOLERANCE: f64 = 0.1;
/// Steps without another limit: memory for them stays below a gigabyte.
const MOST_STEPS: usize = 1_000_000;

/// A motion to be computed: equations of motion, start, accuracy and events.
///
/// A closure returns the accelerations of the inputs for time, inputs and speeds, all of them
/// arrays. Angles are in rad, times in s. A result that is NaN ends the motion with an error that
/// has the motion up to there.
///
/// ```
/// use linkage_dynamics::Problem;
///
/// // A pendulum of 1 m, released at 60 degrees.
/// let motion = Problem::new(|_, [phi], [_]: [f64; 1]| [-9.81 * f64::sin(phi)])
///     .start([1.0472], [0.0])
///     .tolerance(1e-10)
///     .until(2.0)?;
/// let state = motion.state(1.3);
/// let energy = 0.5 * state.speeds[0].powi(2) - 9.81 * state.inputs[0].cos();
/// assert!((energy + 9.81 * 1.0472_f64.cos()).abs() < 1e-8);
/// # Ok::<(), linkage_dynamics::Interrupted<1>>(())
/// ```
#[derive(Debug)]
pub struct Problem<'a, const N: usize, E> {
    equations: E,
    start: State<N>,
    settings: Settings,
    most_steps: usize,
    keeps_steps: bool,
    events: Vec<Event<'a, N>>,
}

impl<const N: usize, F> Problem<'_, N, FromAccelerations<F>>
where
    F: Fn(f64, [f64; N], [f64; N]) -> [f64; N],
{
    /// Creates a problem from a function of time, inputs and speeds that returns accelerations.
    pub fn new(accelerations: F) -> Self {
        Self::with_equations(FromAccelerations(accelerations))
    }
}

impl<const N: usize, F> Problem<'_, N, FromReduced<F>>
where
    F: Fn(f64, [f64; N], [f64; N]) -> Reduced<N>,
{
    /// Creates a problem from a function of time, inputs and speeds that returns inertia and force.
    /// Errors then separate a missing position, an inertia of zero and a force that is NaN.
    pub fn reduced(equation: F) -> Self {
        Self::with_equations(FromReduced(equation))
    }
}

impl<'a, const N: usize, E: Equations<N>> Problem<'a, N, E> {
    /// Creates a problem from equations of motion.
    pub fn with_equations(equations: E) -> Self {
        Self {
            equations,
            start: State {
                time: 0.0,
                inputs: [0.0; N],
                speeds: [0.0; N],
            },
            settings: Settings {
                method: Method::Explicit,
                relative: TOLERANCE,
                absolute: TOLERANCE,
            },
            most_steps: MOST_STEPS,
            keeps_steps: true,
            events: Vec::new(),
        }
    }

    /// Sets inputs and speeds at the start; without it all are zero.
    #[must_use]
    pub const fn start(mut self, inputs: [f64; N], speeds: [f64; N]) -> Self {
        self.start.inputs = inputs;
        self.start.speeds = speeds;
        self
    }

    /// Sets the time of the start, s; without it zero.
    #[must_use]
    pub const fn start_time(mut self, time: f64) -> Self {
        self.start.time = time;
        self
    }

    /// Sets the tolerance of one step, relative to inputs and speeds and also absolute: 1e-8 without
    /// it. Errors of steps add up over the motion.
    #[must_use]
    pub const fn tolerance(mut self, tolerance: f64) -> Self {
        self.settings.relative = tolerance;
        self.settings.absolute = tolerance;
        self
    }

    /// Sets the absolute tolerance of one step, in the units of inputs and speeds: for inputs that
    /// are much larger or smaller than 1, as lengths in metres. After `tolerance`.
    #[must_use]
    pub const fn absolute_tolerance(mut self, tolerance: f64) -> Self {
        self.settings.absolute = tolerance;
        self
    }

    /// Sets the integrator.
    #[must_use]
    pub const fn method(mut self, method: Method) -> Self {
        self.settings.method = method;
        self
    }

    /// Sets the greatest number of steps, 1,000,000 without it.
    #[must_use]
    pub const fn most_steps(mut self, most: usize) -> Self {
        self.most_steps = most;
        self
    }

    /// Stores no steps: the motion then has start, end and events only, and needs no memory.
    #[must_use]
    pub const fn only_end(mut self) -> Self {
        self.keeps_steps = false;
        self
    }

    /// Adds an event. Its index is the number of events before it.
    #[must_use]
    pub fn event(mut self, event: Event<'a, N>) -> Self {
        self.events.push(event);
        self
    }

    /// Computes the motion from the start to a time in s, or to an event that stops.
    ///
    /// # Errors
    ///
    /// An error has the motion up to its last state, and the [`Cause`]: accelerations that are NaN
    /// or infinite, a dead point, a tolerance that cannot be reached, too many steps, or a number of
    /// the problem that is not finite.
    pub fn until(&self, end: f64) -> Result<Motion<N>, Interrupted<N>> {
        let motion = Motion::new(self.start);
        if let Some(mistake) = self.mistake(end) {
            return Err(Interrupted::new(motion, mistake));
        }
        let rates = OverTime(&self.equations);
        let mut recorder = Recorder::new(
            &self.equations,
            &self.events,
            self.settings,
            self.most_steps,
            self.keeps_steps,
            motion,
        );
        let start = (self.start.time, self.start.phase());
        let (result, counts) = stepper::integrate(self.settings, &rates, start, end, &mut recorder);
        let (motion, cause) = recorder.into_motion(counts, result.is_err());
        let halt = |halt| self.cause(motion.end, halt);
        match cause.or(result.err().map(halt)) {
            Some(cause) => Err(Interrupted::new(motion, cause)),
            None => Ok(motion),
        }
    }

    /// Returns the cause of steps that end at a state.
    fn cause(&self, state: State<N>, halt: Halt<N>) -> Cause<N> {
        match halt {
            Halt::Undefined(time, beyond) => Cause::Undefined {
                state,
                fault: self.equations.fault(time, beyond.inputs, beyond.speeds),
            },
            Halt::TooShort(step) => Cause::Tolerance {
                state,
                step,
                tolerance: self.settings.relative,
            },
        }
    }

    /// Returns the first mistake in the numbers of the problem.
    fn mistake(&self, end: f64) -> Option<Cause<N>> {
        let State { time: start, .. } = self.start;
        let [relative, absolute] = [self.settings.relative, self.settings.absolute];
        let is_usable = |tolerance: &f64| (LEAST_TOLERANCE..=LARGEST_TOLERANCE).contains(tolerance);
        if !is_usable(&relative) {
            return Some(Cause::BadTolerance(relative));
        }
        if !(absolute > 0.0 && absolute.is_finite()) {
            return Some(Cause::BadTolerance(absolute));
        }
        if !(start.is_finite() && self.start.phase().is_finite()) {
            return Some(Cause::BadStart(self.start));
        }
        (!(end > start && end.is_finite())).then_some(Cause::BadEnd { start, end })
    }
}
