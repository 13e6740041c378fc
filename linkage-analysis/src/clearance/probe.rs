//! The least distance at one phase, and its bounds for phases nearby.

use super::minima::Clearance;
use linkage_core::math::double::sqrt;

/// A minimum over the cycle as a function of the phase: half the square of its distance, with slope
/// and second derivative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) q: f64,
    pub(super) slope: f64,
    pub(super) bend: f64,
}

/// All minima at one phase.
#[derive(Clone, Debug)]
pub(super) struct Probe<const K: usize> {
    pub(super) phase: f64,
    pub(super) clearance: Clearance<K>,
    /// One for each minimum.
    pub(super) lines: alloc::vec::Vec<Line>,
    /// The index of the least one.
    pub(super) least: usize,
}

/// The largest speed of the second member, in the unit of its points for a radian, and its largest
/// acceleration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    pub(super) speed: f64,
    pub(super) acceleration: f64,
}

impl Limits {
    /// The largest second derivative by the phase of half the square of a distance that is
    /// `sqrt(2 q)` at one end of a way `width` long: `v.v - E.a`, where `E` grows by the way of the
    /// member at most.
    fn bend(self, q: f64, width: f64) -> f64 {
        let reach = sqrt(2.0 * q) + self.speed * width;
        self.speed * self.speed + reach * self.acceleration
    }
}

impl<const K: usize> Probe<K> {
    /// Half the square of the least distance.
    pub(super) fn q(&self) -> f64 {
        self.lines[self.least].q
    }

    pub(super) fn line(&self) -> Line {
        self.lines[self.least]
    }

    /// A bound for all phases from `self` to `next`. With the shaft's angle and the positions of a
    /// minimum at either end fixed, the distance is not less than the least one, and half its
    /// square is below a parabola with the largest second derivative.
    pub(super) fn bound(&self, next: &Self, limits: Limits) -> f64 {
        let width = next.phase - self.phase;
        let mut bound = f64::INFINITY;
        for a in &self.lines {
            for b in &next.lines {
                let bend = limits.bend(a.q, width).max(limits.bend(b.q, width));
                bound = bound.min(highest(a, b, width, bend));
            }
        }
        bound
    }

    /// An upper bound of the least distance at a phase nearby.
    pub(super) fn square_bound(&self, phase: f64, limits: Limits) -> f64 {
        let x = phase - self.phase;
        let above =
            |line: &Line| line.q + line.slope * x + 0.5 * limits.bend(line.q, x.abs()) * x * x;
        self.lines.iter().map(above).fold(f64::INFINITY, f64::min)
    }

    /// An upper bound of the least distance for phases up to this far to both sides.
    pub(super) fn within(&self, reach: f64, limits: Limits) -> f64 {
        let above = |line: &Line| {
            let bend = limits.bend(line.q, reach);
            line.q + reach * (line.slope.abs() + 0.5 * bend * reach)
        };
        self.lines.iter().map(above).fold(f64::INFINITY, f64::min)
    }

    /// The phase between two others at which the least distance is probably largest, by the
    /// parabolas of the minima at both ends: the top of one of them, or a crossing of two. Each end
    /// has all its minima, so that next to a place with two equal ones both are known.
    pub(super) fn trial(&self, next: &Self) -> f64 {
        let h = next.phase - self.phase;
        let height = |x: f64| {
            if x < 0.5 * h {
                self.parabola(x)
            } else {
                next.parabola(x - h)
            }
        };
        let mut best = 0.5 * h;
        let mut compare = |x: f64| {
            if x > 0.0 && x < h && height(x) > height(best) {
                best = x;
            }
        };
        for (probe, from) in [(self, 0.0), (next, h)] {
            for (index, line) in probe.lines.iter().enumerate() {
                if line.bend < 0.0 {
                    compare(from - line.slope / line.bend);
                }
                for other in &probe.lines[..index] {
                    let steps = crossings(&line.less(other));
                    steps.into_iter().for_each(|x| compare(from + x));
                }
            }
        }
        let steps = crossings(&self.line().less(&next.line().moved(-h)));
        steps.into_iter().for_each(compare);
        self.phase + best
    }

    /// The least distance nearby, by the parabolas of all minima.
    fn parabola(&self, x: f64) -> f64 {
        let values = self.lines.iter().map(|line| line.moved(x).q);
        values.fold(f64::INFINITY, f64::min)
    }
}

impl Line {
    /// The parabola with the origin at a neighbouring phase.
    fn moved(&self, x: f64) -> Self {
        Self {
            q: self.q + x * (self.slope + 0.5 * self.bend * x),
            slope: self.slope + self.bend * x,
            bend: self.bend,
        }
    }

    fn less(&self, other: &Self) -> Self {
        Self {
            q: self.q - other.q,
            slope: self.slope - other.slope,
            bend: self.bend - other.bend,
        }
    }
}

/// The roots of a parabola; NaN if there is none.
fn crossings(line: &Line) -> [f64; 2] {
    let (c, l, s) = (line.q, line.slope, 0.5 * line.bend);
    let root = sqrt(l * l - 4.0 * c * s);
    let sum = -0.5 * (l + root.copysign(l));
    [sum / s, c / sum]
}

/// The highest point below both of two parabolas of the same bend, one from either end. Less that
/// bend they are straight lines, so it is at an end or where they cross.
fn highest(a: &Line, b: &Line, width: f64, bend: f64) -> f64 {
    let from_left = |x: f64| a.q + x * (a.slope + 0.5 * bend * x);
    let from_right = |x: f64| b.q + x * (-b.slope + 0.5 * bend * x);
    let below = |x: f64| from_left(x).min(from_right(width - x));
    let steps = a.slope - b.slope + bend * width;
    let crossing = (from_right(width) - a.q) / steps;
    let ends = below(0.0).max(below(width));
    if crossing > 0.0 && crossing < width {
        ends.max(below(crossing))
    } else {
        ends
    }
}

#[cfg(test)]
mod tests {
    use super::{Limits, Line, highest};

    /// A point on a circle of radius 3 and one at a distance of 5 from its centre: half the square
    /// of their distance is `17 - 15 cos x`, with a second derivative of 15 at most.
    #[test]
    fn bounds_hold_and_are_not_loose() {
        let limits = Limits {
            speed: 3.0,
            acceleration: 3.0,
        };
        let at = |x: f64| Line {
            q: 17.0 - 15.0 * x.cos(),
            slope: 15.0 * x.sin(),
            bend: 15.0 * x.cos(),
        };
        for i in 0..60 {
            let (from, width) = (0.1 * f64::from(i), 0.05 + 0.01 * f64::from(i));
            let [a, b] = [from, from + width].map(at);
            let bend = limits.bend(a.q, width).max(limits.bend(b.q, width));
            let bound = highest(&a, &b, width, bend);
            let inside = (0..=50).map(|k| at(from + width * f64::from(k) / 50.0).q);
            let most = inside.fold(f64::NEG_INFINITY, f64::max);
            assert!(
                bend >= 15.0 && bound >= most,
                "{from} {width}: {bound} {most}"
            );
            assert!(bound <= most + 0.125 * (bend + 15.0) * width * width);
        }
        // Straight lines cross at 0.5; curves with the largest bend are higher there.
        let [a, b] = [
            Line {
                q: 0.0,
                slope: 1.0,
                bend: 5.0,
            },
            Line {
                q: 0.0,
                slope: -1.0,
                bend: 5.0,
            },
        ];
        assert_eq!(
            [0.0, 5.0].map(|bend| highest(&a, &b, 1.0, bend)),
            [0.5, 1.125]
        );
    }
}
