//! Conservative mechanisms with one input: speed from the energy, time from its integral.

use crate::no_motion::NoMotion;
use gauss_quad::GaussLegendre;
use linkage_core::numeric::bracket;
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

/// A conservative mechanism with one input, from a function of the input that returns its reduced
/// inertia and the work of its forces.
///
/// The speed follows from the energy: `J omega^2 / 2 = J_0 omega_0^2 / 2 + W - W_0`. The time is
/// the integral of `1 / omega` over the input, by Gauss rules. Both have no error that grows with
/// the number of turns. `W` is the negative potential energy, plus the work of constant moments.
/// From rest the first digits of `W` cancel: [`force`](Self::force) avoids that.
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
pub struct Conservative<'a, F> {
    /// Inertia and work.
    function: F,
    force: Option<Box<dyn Fn(f64) -> f64 + 'a>>,
    start: f64,
    speed: f64,
    period: Option<f64>,
    tolerance: f64,
    rules: [GaussLegendre; 2],
}

impl<'a, F: Fn(f64) -> [f64; 2]> Conservative<'a, F> {
    /// Creates a mechanism from its reduced inertia (moment times s^2) and its work (moment), which
    /// the function returns in this order.
    #[must_use]
    pub fn new(function: F) -> Self {
        Self {
            function,
            force: None,
            start: 0.0,
            speed: 0.0,
            period: None,
            tolerance: TOLERANCE,
            rules: [COARSE, FINE].map(GaussLegendre::new),
        }
    }

    /// Sets input and speed at the start. From rest the mechanism moves where its work grows.
    #[must_use]
    pub fn start(mut self, input: f64, speed: f64) -> Self {
        (self.start, self.speed) = (input, speed);
        self
    }

    /// Sets the generalised force, the slope of the work: for a start from rest with all digits.
    #[must_use]
    pub fn force(mut self, force: impl Fn(f64) -> f64 + 'a) -> Self {
        self.force = Some(Box::new(force));
        self
    }

    /// Declares that inertia and work repeat themselves with this period of the input. Whole
    /// periods are then multiples of the time of one.
    #[must_use]
    pub fn period(mut self, period: f64) -> Self {
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
    pub fn speed(&self, input: f64) -> f64 {
        let [inertia, work] = (self.function)(input);
        let [first, before] = (self.function)(self.start);
        let kinetic = 0.5 * first * self.speed * self.speed + work - before;
        (2.0 * kinetic / inertia).sqrt()
    }

    /// Returns the time in s from the start until the mechanism first reaches an input.
    ///
    /// # Errors
    ///
    /// [`NoMotion`] if the input is not ahead, or is not reached.
    pub fn time(&self, input: f64) -> Result<f64, NoMotion> {
        let sign = self.direction()?;
        let distance = sign * (input - self.start);
        if distance == 0.0 {
            return Ok(0.0);
        }
        if !(distance > 0.0 && distance.is_finite()) {
            return Err(NoMotion::Behind { input });
        }
        let (mut time, mut done, mut width) = (0.0, 0.0, PANEL);
        while done < distance {
            let left = distance - done;
            let panel = self.panel(sign, done, width.min(left))?;
            time += panel.time;
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
    pub fn input(&self, time: f64) -> Result<f64, NoMotion> {
        let sign = self.direction()?;
        if !(time >= 0.0 && time.is_finite()) {
            return Err(NoMotion::BadTime(time));
        }
        let (mut left, mut whole) = (time, 0.0);
        if let Some(period) = self.period {
            let turn = self.time(self.start + sign * period)?;
            let turns = (time / turn).floor();
            left = time - turns * turn;
            whole = turns * period;
        }
        let (mut done, mut width) = (0.0, PANEL);
        loop {
            let panel = self.panel(sign, done, width)?;
            if panel.time >= left {
                let end = (panel.width, panel.time - left);
                let mut off = |x: f64| {
                    let slope = 1.0 / self.speed(self.start + sign * (done + x));
                    [self.over(sign, [done, done + x], 1) - left, slope]
                };
                let last = bracket::root((0.0, -left), end, &mut off);
                return Ok(self.start + sign * (whole + done + last));
            }
            left -= panel.time;
            done += panel.width;
            width = panel.next;
        }
    }

    /// Returns the sign of the motion.
    fn direction(&self) -> Result<f64, NoMotion> {
        if !self.speed.is_finite() || self.speed != 0.0 {
            return Ok(self.speed.signum());
        }
        let near = LEAST_PANEL.sqrt() * PANEL;
        let [less, more] = [-near, near].map(|step| (self.function)(self.start + step)[1]);
        match more.partial_cmp(&less) {
            Some(std::cmp::Ordering::Greater) => Ok(1.0),
            Some(std::cmp::Ordering::Less) => Ok(-1.0),
            Some(std::cmp::Ordering::Equal) | None => Err(NoMotion::AtRest { input: self.start }),
        }
    }

    /// Returns the time of a panel that begins at a distance from the start, with a width that both
    /// rules agree on.
    fn panel(&self, sign: f64, done: f64, mut width: f64) -> Result<Panel, NoMotion> {
        let mut before: Option<(Panel, f64)> = None;
        loop {
            let ends = [done, done + width];
            let [coarse, time] = [0, 1].map(|rule| self.over(sign, ends, rule));
            let off = (coarse - time).abs() / time;
            let is_easy = off <= EASY * self.tolerance;
            let next = if is_easy { 2.0 * width } else { width };
            let panel = Panel { time, width, next };
            if time.is_finite() && off <= self.tolerance {
                return Ok(panel);
            }
            if let Some((panel, _)) =
                before.take_if(|(_, old)| *old < ROUNDING && off > GAIN * *old)
            {
                return Ok(panel);
            }
            before = time.is_finite().then_some((panel, off));
            width *= 0.5;
            if width < LEAST_PANEL * PANEL || done + width == done {
                let input = self.start + sign * done;
                return Err(NoMotion::Ends { input });
            }
        }
    }

    /// Returns the time between two distances from the start, by one of the rules. From rest the
    /// speed grows with the root of the distance: the integral is that over the root.
    fn over(&self, sign: f64, [from, to]: [f64; 2], rule: usize) -> f64 {
        let rule = &self.rules[rule];
        if self.speed != 0.0 || from > 0.0 {
            let [first, before] = (self.function)(self.start);
            let level = 0.5 * first * self.speed * self.speed - before;
            return rule.integrate(from, to, |distance| {
                let [inertia, work] = (self.function)(self.start + sign * distance);
                (0.5 * inertia / (level + work)).sqrt()
            });
        }
        let Some(force) = &self.force else {
            let slowness = |distance: f64| 1.0 / self.speed(self.start + sign * distance);
            return rule.integrate(0.0, to.sqrt(), |root| 2.0 * root * slowness(root * root));
        };
        rule.integrate(0.0, to.sqrt(), |root| {
            let end = root * root;
            let [inertia, _] = (self.function)(self.start + sign * end);
            let force = |distance: f64| sign * force(self.start + sign * distance);
            let kinetic = self.rules[0].integrate(0.0, end, force);
            2.0 * root * (0.5 * inertia / kinetic).sqrt()
        })
    }
}

impl<F> fmt::Debug for Conservative<'_, F> {
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
struct Panel {
    time: f64,
    width: f64,
    /// Width to try for the next one.
    next: f64,
}
