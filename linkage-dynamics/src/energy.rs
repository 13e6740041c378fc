//! Conservative mechanisms with one input: speed from the energy, time from its integral.

use crate::gauss::GaussRule;
use crate::no_motion::NoMotion;
use linkage_core::Scalar;
use linkage_core::numeric::bracket;
use std::cmp::Ordering;
use std::fmt;
use std::num::NonZeroUsize;

/// Points of both Gauss rules of a panel; their difference bounds the error of the coarse one.
const COARSE: NonZeroUsize = NonZeroUsize::new(10).unwrap();
const FINE: NonZeroUsize = NonZeroUsize::new(16).unwrap();
/// Width of the first panel, rad.
const PANEL: f64 = 0.5;
/// Panels below this part of the first one end the motion.
const LEAST_PANEL: f64 = 1e-15;
/// A difference of both rules below this part of the tolerance doubles the next panel.
const EASY: f64 = 1e-4;
/// A difference that halving a panel reduces by less than `GAIN` is rounding, if it is below this.
const ROUNDING: f64 = 1e-8;
const GAIN: f64 = 0.25;
/// Tolerance without another one: twelve digits.
const TOLERANCE: f64 = 1e-12;
/// Newton steps from an input of 16 digits. Each of them doubles the digits: enough for a hundred.
const REFINEMENTS: usize = 3;

/// A conservative mechanism with one input, from a function of the input that returns its reduced
/// inertia and the work of its forces.
///
/// The speed follows from the energy: `J omega^2 / 2 = J_0 omega_0^2 / 2 + W - W_0`. The time is
/// the integral of `1 / omega` over the input, by Gauss rules. Both have no error that grows with
/// the number of turns. `W` is the negative potential energy, plus the work of constant moments.
/// From rest the first digits of `W` cancel: [`force`](Self::force) avoids that.
///
/// `T` is any scalar with one lane: a type with 30 digits returns 30 digits, a dual number the
/// derivatives of time and input with respect to a dimension.
///
/// ```
/// use linkage_dynamics::Conservative;
///
/// // A pendulum of 1 kg and 1 m that falls from 90 degrees: a quarter of its period.
/// let pendulum = Conservative::new(|phi: f64| [1.0, 9.81 * phi.cos()])
///     .start(std::f64::consts::FRAC_PI_2, 0.0);
/// assert!((pendulum.speed(0.0) - (2.0 * 9.81_f64).sqrt()).abs() < 1e-14);
/// let quarter = pendulum.time(0.0)?;
/// assert!((quarter - 1.854_074_677_301_372 / 9.81_f64.sqrt()).abs() < 1e-12);
/// # Ok::<(), linkage_dynamics::NoMotion>(())
/// ```
pub struct Conservative<'a, T, F> {
    /// Inertia and work.
    function: F,
    force: Option<Box<dyn Fn(T) -> T + 'a>>,
    start: T,
    speed: T,
    period: Option<T>,
    tolerance: f64,
    rules: [GaussRule<T>; 2],
}

impl<'a, T: Scalar, F: Fn(T) -> [T; 2]> Conservative<'a, T, F> {
    /// Creates a mechanism from its reduced inertia (moment times s^2) and its work (moment), which
    /// the function returns in this order.
    #[must_use]
    pub fn new(function: F) -> Self {
        const { assert!(T::LANES == 1, "a motion has one time") };
        Self {
            function,
            force: None,
            start: T::from_f64(0.0),
            speed: T::from_f64(0.0),
            period: None,
            tolerance: TOLERANCE,
            rules: [COARSE, FINE].map(GaussRule::new),
        }
    }

    /// Sets input and speed at the start. From rest the mechanism moves where its work grows.
    #[must_use]
    pub fn start(mut self, input: T, speed: T) -> Self {
        (self.start, self.speed) = (input, speed);
        self
    }

    /// Sets the generalised force, the slope of the work: for a start from rest with all digits.
    #[must_use]
    pub fn force(mut self, force: impl Fn(T) -> T + 'a) -> Self {
        self.force = Some(Box::new(force));
        self
    }

    /// Declares that inertia and work repeat themselves with this period of the input. Whole
    /// periods are then multiples of the time of one.
    #[must_use]
    pub fn period(mut self, period: T) -> Self {
        self.period = Some(period);
        self
    }

    /// Sets the relative tolerance of times, 1e-12 without it.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Returns the size of the speed at an input; NaN where the energy does not reach.
    #[must_use]
    pub fn speed(&self, input: T) -> T {
        let [half, two] = [0.5, 2.0].map(T::from_f64);
        let [inertia, work] = (self.function)(input);
        let [first, before] = (self.function)(self.start);
        let kinetic = half * first * self.speed * self.speed + work - before;
        (two * kinetic / inertia).sqrt()
    }

    /// Returns the time in s from the start until the mechanism first reaches an input.
    ///
    /// # Errors
    ///
    /// [`NoMotion`] if the input is not ahead, or is not reached.
    pub fn time(&self, input: T) -> Result<T, NoMotion> {
        let sign = self.direction()?;
        let distance = sign * (input - self.start);
        let zero = T::from_f64(0.0);
        if real(distance) == 0.0 {
            return Ok(zero);
        }
        if !(real(distance) > 0.0 && real(distance).is_finite()) {
            let input = real(input);
            return Err(NoMotion::Behind { input });
        }
        let (mut time, mut done, mut width) = (zero, zero, T::from_f64(PANEL));
        while real(done) < real(distance) {
            let left = distance - done;
            let panel = self.panel(sign, done, width.min(left))?;
            time = time + panel.time;
            done = if panel.width == left {
                distance
            } else {
                done + panel.width
            };
            width = panel.next;
        }
        Ok(time)
    }

    /// Returns the input at a time in s after the start.
    ///
    /// # Errors
    ///
    /// [`NoMotion`] if the mechanism turns or has no position before that time.
    pub fn input(&self, time: T) -> Result<T, NoMotion> {
        let sign = self.direction()?;
        if !(real(time) >= 0.0 && real(time).is_finite()) {
            return Err(NoMotion::BadTime(real(time)));
        }
        let (mut left, mut whole) = (time, T::from_f64(0.0));
        if let Some(period) = self.period {
            let turn = self.time(self.start + sign * period)?;
            let turns = T::from_f64(real(time / turn).floor());
            left = time - turns * turn;
            whole = turns * period;
        }
        let (mut done, mut width) = (T::from_f64(0.0), T::from_f64(PANEL));
        loop {
            let panel = self.panel(sign, done, width)?;
            if real(panel.time) >= real(left) {
                let last = self.part(sign, done, &panel, left);
                return Ok(self.start + sign * (whole + done + last));
            }
            left = left - panel.time;
            done = done + panel.width;
            width = panel.next;
        }
    }

    /// Returns the part of a panel that takes a time.
    fn part(&self, sign: T, done: T, panel: &Panel<T>, left: T) -> T {
        let off = |x: T| self.over(sign, [done, done + x], 1) - left;
        let speed = |x: T| self.speed(self.start + sign * (done + x));
        let end = (real(panel.width), real(panel.time - left));
        let mut value = |x: f64| {
            let x = T::from_f64(x);
            let slope = T::from_f64(1.0) / speed(x);
            [real(off(x)), real(slope)]
        };
        let mut part = T::from_f64(bracket::root((0.0, -real(left)), end, &mut value));
        if T::REFINES && real(part) > 0.0 {
            for _ in 0..REFINEMENTS {
                part = part - off(part) * speed(part);
            }
        }
        part
    }

    /// Returns the sign of the motion.
    fn direction(&self) -> Result<T, NoMotion> {
        let speed = real(self.speed);
        if !speed.is_finite() || speed != 0.0 {
            return Ok(T::from_f64(speed.signum()));
        }
        let near = LEAST_PANEL.sqrt() * PANEL;
        let [less, more] = [-near, near].map(|step| {
            let [_, work] = (self.function)(self.start + T::from_f64(step));
            real(work)
        });
        match more.partial_cmp(&less) {
            Some(Ordering::Greater) => Ok(T::from_f64(1.0)),
            Some(Ordering::Less) => Ok(T::from_f64(-1.0)),
            Some(Ordering::Equal) | None => {
                let input = real(self.start);
                Err(NoMotion::AtRest { input })
            }
        }
    }

    /// Returns the time of a panel that begins at a distance from the start, with a width that both
    /// rules agree on.
    fn panel(&self, sign: T, done: T, mut width: T) -> Result<Panel<T>, NoMotion> {
        let [half, two] = [0.5, 2.0].map(T::from_f64);
        let mut before: Option<(Panel<T>, f64)> = None;
        loop {
            let ends = [done, done + width];
            let [coarse, time] = [0, 1].map(|rule| self.over(sign, ends, rule));
            let off = real((coarse - time).abs() / time);
            let is_easy = off <= EASY * self.tolerance;
            let next = if is_easy { two * width } else { width };
            let panel = Panel { time, width, next };
            let is_finite = real(time).is_finite();
            if is_finite && off <= self.tolerance {
                return Ok(panel);
            }
            let stays = |old: f64| old < ROUNDING && off > GAIN * old;
            if let Some((panel, _)) = before.take_if(|(_, old)| stays(*old)) {
                return Ok(panel);
            }
            before = is_finite.then_some((panel, off));
            width = width * half;
            if real(width) < LEAST_PANEL * PANEL || done + width == done {
                let input = real(self.start + sign * done);
                return Err(NoMotion::Ends { input });
            }
        }
    }

    /// Returns the time between two distances from the start, by one of the rules. From rest the
    /// speed grows with the root of the distance: the integral is that over the root.
    fn over(&self, sign: T, [from, to]: [T; 2], rule: usize) -> T {
        let rule = &self.rules[rule];
        let [zero, half, two] = [0.0, 0.5, 2.0].map(T::from_f64);
        if real(self.speed) != 0.0 || real(from) > 0.0 {
            let [first, before] = (self.function)(self.start);
            let level = half * first * self.speed * self.speed - before;
            return rule.integrate(from, to, |distance| {
                let [inertia, work] = (self.function)(self.start + sign * distance);
                (half * inertia / (level + work)).sqrt()
            });
        }
        let Some(force) = &self.force else {
            let speed = |distance: T| self.speed(self.start + sign * distance);
            return rule.integrate(zero, to.sqrt(), |root| {
                two * root * (T::from_f64(1.0) / speed(root * root))
            });
        };
        rule.integrate(zero, to.sqrt(), |root| {
            let end = root * root;
            let [inertia, _] = (self.function)(self.start + sign * end);
            let force = |distance: T| sign * force(self.start + sign * distance);
            let kinetic = self.rules[0].integrate(zero, end, force);
            two * root * (half * inertia / kinetic).sqrt()
        })
    }
}

/// Returns the number that decisions depend on.
fn real<T: Scalar>(number: T) -> f64 {
    number.lane(0)
}

impl<T: fmt::Debug, F> fmt::Debug for Conservative<'_, T, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Conservative")
            .field("start", &self.start)
            .field("speed", &self.speed)
            .field("period", &self.period)
            .field("tolerance", &self.tolerance)
            .finish_non_exhaustive()
    }
}

/// A panel of the integral over the input.
struct Panel<T> {
    time: T,
    width: T,
    /// Width to try for the next one.
    next: T,
}
