//! Turns of an angle while an input runs through its range.

mod uniform;

use crate::certificate;
use crate::scalar::Scalar;
use core::f64::consts::{PI, TAU};
pub use uniform::uniform;
use uniform::whole;

/// Remainders should stay below this, so that inputs a little outside the range are served too.
const COMFORT: f64 = certificate::COMFORTABLE_STRAY * PI;

/// Remainders must stay below this.
const LIMIT: f64 = certificate::MOST_STRAY * PI;

/// A sum of middles of several inputs that is larger would leave the angle at the start too little
/// of its half turn.
const MOST_MIDDLE: f64 = certificate::MOST_MIDDLE * PI;

/// Longer walks are not begun: thousands of turns of the fastest candidate.
const MOST_RADIANS: f64 = 16384.0;

/// The angle is within half a turn of `centre + turns * x` for every input `x` of a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winding {
    /// The guide at `x = 0`, radians.
    pub centre: f64,
    /// Slope of the guide, radians per unit of input: turns for each turn of an angle.
    pub turns: f64,
}

/// Follows an angle over the range `lo..hi` and finds a straight line near to it.
///
/// `direction(x)` is a vector (not of any particular length) at the angle, NaN where there is none;
/// the angle is continuous, and at `reference` it is the one nearest to `estimate`. It is followed
/// both ways as far as it exists. Of the candidate `rates` (radians per unit of input) the slowest
/// one is taken from which the angle strays by less than 0.8 pi, whole rates before fractions
/// because they hold beyond the range too; else the one from which it strays least, else its mean
/// slope. `None` if it strays by 0.95 pi or more from all of them, does not exist at the
/// reference, or if the fastest candidate turns more than 16384 radians over the range.
///
/// ```
/// use linkage_core::numeric::winding::follow;
///
/// // A crank that turns with the input, 20 degrees ahead.
/// let angle = |x: f64| x + 0.35;
/// let winding = follow(0.0, 6.28, 0.5, 0.9, &[0.0, 1.0, -1.0], |x| {
///     let (sin, cos) = angle(x).sin_cos();
///     [cos, sin]
/// })
/// .unwrap();
/// assert_eq!(winding.turns, 1.0);
/// assert!((winding.centre - 0.35).abs() < 1e-12);
/// ```
pub fn follow(
    lo: f64,
    hi: f64,
    reference: f64,
    estimate: f64,
    rates: &[f64],
    mut direction: impl FnMut(f64) -> [f64; 2],
) -> Option<Winding> {
    let (lo, hi) = if hi < lo { (hi, lo) } else { (lo, hi) };
    if !(lo.is_finite() && hi.is_finite() && reference.is_finite() && estimate.is_finite()) {
        return None;
    }
    let fastest = rates
        .iter()
        .fold(0.0, |fastest: f64, rate| fastest.max(rate.abs()));
    if (hi - lo) * fastest > MOST_RADIANS {
        return None;
    }
    let step = step(hi - lo, fastest);
    let mut path = Path {
        reference,
        estimate,
        direction: &mut direction,
    };

    let mut best: Option<Stray> = None;
    let mut slope = None;
    for rates in rates.chunks(TOGETHER) {
        let mut strays = [Stray::new(0.0); TOGETHER];
        for (stray, rate) in strays.iter_mut().zip(rates) {
            *stray = Stray::new(*rate);
        }
        slope = Some(path.walk([lo, hi], step, &mut strays[..rates.len()])?);
        for stray in &strays[..rates.len()] {
            best = Some(best.map_or(*stray, |best| best.or(*stray)));
        }
    }
    if best.is_none_or(|best| best.width() >= LIMIT) {
        let rate = match slope {
            Some(slope) => slope,
            None => path.walk([lo, hi], step, &mut [])?,
        };
        let mut mean = [Stray::new(rate)];
        path.walk([lo, hi], step, &mut mean)?;
        best = Some(mean[0]);
    }
    best.filter(|best| best.width() < LIMIT).map(Stray::winding)
}

/// The centre of an angle that follows several inputs.
///
/// Along input `i` alone, `angle = c_i + k_i x_i + remainder`, the remainder lying evenly about
/// zero; `m_i = c_i + k_i x_i - angle` at the start is how far the middle of the motion along `i`
/// is from the angle there. Motions along several inputs add up, and so do their middles:
/// `c = angle + sum m_i - sum k_i x_i`, all at the start. Where the sum is so large that the angle
/// at the start would be a turn off, their mean takes its place.
#[derive(Clone, Copy, Debug)]
pub struct Centre {
    angle: f64,
    middle: f64,
    turned: f64,
    inputs: u32,
}

impl Centre {
    /// Starts at an angle of this value.
    pub fn new(angle: f64) -> Self {
        Self {
            angle,
            middle: 0.0,
            turned: 0.0,
            inputs: 0,
        }
    }

    /// Adds the motion along an input that is `x` at the start.
    pub fn add(&mut self, along: Winding, x: f64) {
        self.middle += along.centre + along.turns * x - self.angle;
        self.turned += along.turns * x;
        self.inputs += 1;
    }

    /// The centre for all inputs together.
    pub fn value(&self) -> f64 {
        let middle = if self.middle.abs() > MOST_MIDDLE {
            self.middle / f64::from(self.inputs)
        } else {
            self.middle
        };
        self.angle + middle - self.turned
    }
}

/// Candidate rates that are compared in one walk.
const TOGETHER: usize = 8;

/// First step of a walk: a part of the range, short enough that the fastest candidate turns by a
/// quarter radian.
fn step(range: f64, fastest: f64) -> f64 {
    const FEWEST: f64 = 256.0;
    const MOST: f64 = 65536.0;
    const QUARTER: f64 = 0.25;
    (range / FEWEST)
        .min(QUARTER / fastest.max(1.0))
        .max(range / MOST)
}

/// The largest distance of an angle from a line of a given rate.
#[derive(Clone, Copy)]
struct Stray {
    rate: f64,
    least: f64,
    most: f64,
}

impl Stray {
    fn new(rate: f64) -> Self {
        Self {
            rate,
            least: f64::INFINITY,
            most: f64::NEG_INFINITY,
        }
    }

    fn include(&mut self, x: f64, angle: f64) {
        let rest = angle - self.rate * x;
        self.least = self.least.min(rest);
        self.most = self.most.max(rest);
    }

    fn width(&self) -> f64 {
        0.5 * (self.most - self.least)
    }

    /// The better of two: among those that stray little a whole rate, then the slower one; else the
    /// one that strays less.
    fn or(self, other: Self) -> Self {
        let (mine, its) = (self.width(), other.width());
        let whole = self.is_whole();
        let faster = other.rate.abs() - self.rate.abs();
        let other_is_better = match (mine < COMFORT, its < COMFORT) {
            (true, true) if whole != other.is_whole() => !whole,
            (true, true) => faster < 0.0 || (faster == 0.0 && its < mine),
            (true, false) => false,
            (false, true) => true,
            (false, false) => its < mine,
        };
        if other_is_better { other } else { self }
    }

    /// Returns whether the line repeats with every turn of the input, and so serves beyond the
    /// range too.
    fn is_whole(&self) -> bool {
        self.rate % 1.0 == 0.0
    }

    fn winding(self) -> Winding {
        Winding {
            centre: 0.5 * (self.least + self.most),
            turns: self.rate,
        }
    }
}

/// An angle that is followed from the reference.
struct Path<'a, F> {
    reference: f64,
    estimate: f64,
    direction: &'a mut F,
}

impl<F: FnMut(f64) -> [f64; 2]> Path<'_, F> {
    /// Follows the angle to both ends and returns its mean slope.
    fn walk(&mut self, ends: [f64; 2], step: f64, strays: &mut [Stray]) -> Option<f64> {
        let angle = self.near(self.reference, self.estimate)?;
        let [lower, upper] = ends.map(|end| self.one_way(end, step, angle, strays));
        let run = upper.0 - lower.0;
        Some(if run > 0.0 {
            (upper.1 - lower.1) / run
        } else {
            0.0
        })
    }

    /// Follows the angle from the reference to one end; returns where it got to, and the angle.
    fn one_way(&mut self, end: f64, step: f64, angle: f64, strays: &mut [Stray]) -> (f64, f64) {
        let run = end - self.reference;
        let steps = if step > 0.0 {
            (run.abs() / step) as usize + 1
        } else {
            1
        };
        let mut last = (self.reference, angle);
        strays
            .iter_mut()
            .for_each(|stray| stray.include(last.0, last.1));
        for index in 1..=steps {
            let target = if index == steps {
                end
            } else {
                self.reference + run * (index as f64 / steps as f64)
            };
            while last.0 != target {
                let Some(next) = self.advance(last, target) else {
                    return last;
                };
                last = next;
                strays
                    .iter_mut()
                    .for_each(|stray| stray.include(last.0, last.1));
            }
        }
        last
    }

    /// Steps towards `target`, halving the step while the angle turns by much.
    fn advance(&mut self, from: (f64, f64), target: f64) -> Option<(f64, f64)> {
        /// In radians: the nearest of the angles that fit is the one that was meant.
        const MUCH: f64 = 0.5;
        const HALVINGS: usize = 30;

        let mut to = target;
        let mut next = self.near(to, from.1);
        for _ in 0..HALVINGS {
            let small = next.is_some_and(|angle| (angle - from.1).abs() <= MUCH);
            let middle = from.0 + 0.5 * (to - from.0);
            if small || middle == from.0 || middle == to {
                break;
            }
            to = middle;
            next = self.near(to, from.1);
        }
        next.map(|angle| (to, angle))
    }

    /// The angle at `x` that is nearest to `guide`.
    fn near(&mut self, x: f64, guide: f64) -> Option<f64> {
        let [cos, sin] = (self.direction)(x);
        let exists = cos.is_finite() && sin.is_finite() && (cos != 0.0 || sin != 0.0);
        exists.then(|| {
            let turn = Scalar::atan2(sin, cos) - guide;
            guide + (turn - TAU * whole(turn / TAU))
        })
    }
}
