//! Boundaries of the range of an input in which a mechanism works.
//!
//! A *margin* is a function of the input that is positive where the mechanism works and continuous
//! there, and negative or NaN where it does not. A margin that touches zero and rises again counts
//! as working: rounding below zero is allowed for, down to -1e-12, so the margin should be scaled
//! to about 1.

use super::golden_section::{Point, descend};

/// A margin down to here is rounding.
const ROUNDING: f64 = -1e-12;

/// The precision of a boundary, relative to the size of the numbers in the range.
const PRECISION: f64 = 1e-12;

/// A boundary between input values where the mechanism works and input values where it does not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Failure {
    /// The boundary, on the side that fails.
    pub at: f64,
    /// The margin where the failure was noticed, beyond the boundary; NaN where there is none.
    pub margin: f64,
    /// The sampling interval in which the boundary lies, counted from the lower end.
    pub index: usize,
    /// True if it fails above `at` (and works below); otherwise the other way round.
    pub above: bool,
}

/// The first input value, counted from `lo`, at which the mechanism comes apart.
///
/// The range is sampled at `start`, at both ends and at about `samples` places between them; sign
/// changes are located by bisection, and where the samples have a local minimum the function is
/// searched for a dip below zero between them. `start` should be a place that works, inside the
/// range. If the mechanism does not work at `lo`, the result is the upper end of that stretch
/// (`above` is false), or `lo` itself if it works nowhere.
///
/// ```
/// use linkage_core::numeric::range::first_failure;
///
/// // Works while cos x > -0.5.
/// let failure = first_failure(0.0, 6.0, 1.0, 100, |x| f64::cos(x) + 0.5).unwrap();
/// assert!((failure.at - 2.0 * core::f64::consts::FRAC_PI_3).abs() < 1e-11);
/// assert!(failure.above);
/// assert_eq!(first_failure(0.0, 2.0, 1.0, 100, |x| f64::cos(x) + 0.5), None);
/// ```
pub fn first_failure(
    lo: f64,
    hi: f64,
    start: f64,
    samples: usize,
    mut margin: impl FnMut(f64) -> f64,
) -> Option<Failure> {
    let grid = Grid::new(lo, hi, start, samples);
    let margin = &mut margin;

    let mut middle = Point::evaluate(grid.position(0), margin);
    if fails(middle) {
        return Some(start_of_work(&grid, middle, margin));
    }
    let mut before = middle;
    for index in 1..=grid.intervals() {
        let next = Point::evaluate(grid.position(index), margin);
        if fails(next) {
            return Some(boundary(&grid, middle, next, margin));
        }
        if dips(before, middle, next) {
            let bottom = descend(before, next, margin, fails);
            if fails(bottom) {
                return Some(boundary(&grid, before, bottom, margin));
            }
        }
        (before, middle) = (middle, next);
    }
    // A dip beside the upper end shows no minimum among the samples.
    if middle.margin < before.margin {
        let bottom = descend(before, middle, margin, fails);
        return fails(bottom).then(|| boundary(&grid, before, bottom, margin));
    }
    None
}

/// The smallest margin over a range and the input value where it occurs, refined between about
/// `samples` places. If the margin is NaN somewhere among them, that place is the answer.
///
/// ```
/// use linkage_core::numeric::range::minimum;
///
/// let (x, margin) = minimum(0.0, 6.0, 50, |x| f64::cos(x) + 2.0);
/// assert!((x - core::f64::consts::PI).abs() < 1e-6);
/// assert!((margin - 1.0).abs() < 1e-12);
/// ```
pub fn minimum(lo: f64, hi: f64, samples: usize, mut margin: impl FnMut(f64) -> f64) -> (f64, f64) {
    let grid = Grid::new(lo, hi, lo, samples);
    let margin = &mut margin;
    let undefined = |point: Point| point.margin.is_nan();

    let mut middle = Point::evaluate(grid.position(0), margin);
    let (mut before, mut best) = (middle, middle);
    for index in 1..=grid.intervals() {
        if undefined(best) {
            return (best.x, best.margin);
        }
        let next = Point::evaluate(grid.position(index), margin);
        best = best.lower(next);
        if dips(before, middle, next) {
            best = best.lower(descend(before, next, margin, undefined));
        }
        (before, middle) = (middle, next);
    }
    if middle.margin < before.margin {
        best = best.lower(descend(before, middle, margin, undefined));
    }
    (best.x, best.margin)
}

/// Returns whether the middle of three neighbouring samples is a local minimum. At the lower end
/// the first two are the same sample, which then counts if the margin rises from it.
fn dips(before: Point, middle: Point, next: Point) -> bool {
    let (fall, rise) = (before.margin - middle.margin, next.margin - middle.margin);
    fall >= 0.0 && rise >= 0.0 && fall + rise > 0.0
}

fn fails(point: Point) -> bool {
    point.margin.is_nan() || point.margin < ROUNDING
}

/// The end of the stretch without work that begins at the lower end of the range.
fn start_of_work(grid: &Grid, first: Point, margin: &mut impl FnMut(f64) -> f64) -> Failure {
    let mut last = first;
    for index in 1..=grid.intervals() {
        let next = Point::evaluate(grid.position(index), margin);
        if !fails(next) {
            return boundary(grid, next, last, margin);
        }
        last = next;
    }
    Failure {
        at: first.x,
        margin: first.margin,
        index: 0,
        above: true,
    }
}

/// Bisects between a place that works and one that does not.
fn boundary(
    grid: &Grid,
    works: Point,
    broken: Point,
    margin: &mut impl FnMut(f64) -> f64,
) -> Failure {
    let (mut good, mut bad) = (works.x, broken.x);
    let precision = PRECISION * grid.size();
    while (bad - good).abs() > precision {
        let middle = good + 0.5 * (bad - good);
        if middle == good || middle == bad {
            break;
        }
        if margin(middle) > 0.0 {
            good = middle;
        } else {
            bad = middle;
        }
    }
    Failure {
        at: bad,
        margin: broken.margin,
        index: grid.interval_of(bad),
        above: works.x < broken.x,
    }
}

/// Sampling places: both ends, the start, and even steps on each side of the start.
struct Grid {
    lo: f64,
    start: f64,
    hi: f64,
    below: usize,
    above: usize,
}

impl Grid {
    fn new(lo: f64, hi: f64, start: f64, samples: usize) -> Self {
        let (lo, hi) = if hi < lo { (hi, lo) } else { (lo, hi) };
        let start = if start > lo && start < hi { start } else { lo };
        let share = (start - lo) / (hi - lo);
        let samples = samples.max(2);
        // Casting rounds down and turns the NaN of an empty range into 0.
        let below = (share * samples as f64) as usize;
        let below = if start > lo { below.max(1) } else { 0 };
        Self {
            lo,
            start,
            hi,
            below,
            above: samples.saturating_sub(below).max(1),
        }
    }

    fn intervals(&self) -> usize {
        self.below + self.above
    }

    fn position(&self, index: usize) -> f64 {
        let between = |a: f64, b: f64, step: usize, steps: usize| {
            // Exact at both ends.
            if step == steps {
                b
            } else {
                a + (b - a) * (step as f64 / steps as f64)
            }
        };
        match index.checked_sub(self.below) {
            Some(step) => between(self.start, self.hi, step, self.above),
            None => between(self.lo, self.start, index, self.below),
        }
    }

    fn interval_of(&self, x: f64) -> usize {
        (1..self.intervals())
            .take_while(|&index| self.position(index) <= x)
            .count()
    }

    /// Size of the numbers in the range.
    fn size(&self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }
}
