//! Transmission angle.

use super::course::Course;
use super::interval::Interval;
use super::stations::{passing, stations};
use core::f64::consts::{FRAC_PI_2, PI};

/// A transmission angle and the input where it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmission {
    /// The input.
    pub at: f64,
    /// The angle between the links, 0 to pi/2.
    pub angle: f64,
}

impl<const N: usize, F: Fn(f64) -> [f64; N]> Course<N, F> {
    /// For an angle between two links, in radians: the least and the greatest transmission angle, which is the acute one of the
    /// angles between their lines, 0 to pi/2.
    ///
    /// It is extreme where the given angle stands still, at ends of the course, and where the links are in line or perpendicular: there
    /// it is 0 or pi/2 exactly.
    ///
    /// ```
    /// use linkage_runtime::summary::Course;
    /// use std::f64::consts::{FRAC_PI_3, TAU};
    ///
    /// let between = |phi: f64| [1.2 + 0.5 * phi.sin(), 0.5 * phi.cos()];
    /// let [least, greatest] = Course::of((0.0, TAU), 360, between)?.transmission_angle();
    /// assert!((least.angle - 0.7).abs() < 1e-15);
    /// assert_eq!(greatest.angle, std::f64::consts::FRAC_PI_2);
    /// # Ok::<(), linkage_runtime::summary::SummaryError>(())
    /// ```
    #[must_use]
    pub fn transmission_angle(&self) -> [Transmission; 2] {
        let first = self.solved[0].stretch.nodes[0];
        let mut found = [self.transmission(first.u, acute(first.jet[0])); 2];
        let mut add = |u: f64, angle: f64| {
            if angle < found[0].angle {
                found[0] = self.transmission(u, angle);
            }
            if angle > found[1].angle {
                found[1] = self.transmission(u, angle);
            }
        };
        for part in &self.solved {
            let chain = stations(part);
            for station in &chain {
                add(station.u(), acute(station.value()));
            }
            for pair in chain.windows(2) {
                let [a, b] = [&pair[0].node, &pair[1].node];
                for angle in [0.0, FRAC_PI_2] {
                    if let Some(bound) = multiple(a.jet[0], b.jet[0], angle) {
                        add(passing(&self.source, a, b, bound), angle);
                    }
                }
            }
        }
        found
    }

    fn transmission(&self, u: f64, angle: f64) -> Transmission {
        let at = Interval::of(&self.source, u, u).from;
        Transmission { at, angle }
    }
}

/// The acute one of the angles between two lines.
fn acute(angle: f64) -> f64 {
    let angle = angle.abs() % PI;
    angle.min(PI - angle)
}

/// `angle` plus a multiple of pi that lies strictly between two numbers.
fn multiple(a: f64, b: f64, angle: f64) -> Option<f64> {
    let (low, high) = (a.min(b), a.max(b));
    let below = (low - angle) % PI;
    let step = if below < 0.0 { -below } else { PI - below };
    let next = low + step;
    (next > low && next < high).then_some(next)
}

#[cfg(test)]
mod tests {
    use super::{PI, multiple};

    /// Strictly between: an angle at the lower end is met half a turn later.
    #[test]
    fn multiples_lie_between() {
        assert_eq!(multiple(0.5, 4.0, 0.5), Some(0.5 + PI));
        assert_eq!(multiple(4.0, 0.5, 0.5), Some(0.5 + PI));
        assert_eq!(multiple(0.5, 0.5 + PI, 0.5), None);
        assert_eq!(multiple(0.4, 0.6, 0.5), Some(0.5));
        assert_eq!(multiple(0.6, 0.7, 0.5), None);
    }
}
