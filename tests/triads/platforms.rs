//! Two ternary links on a common pin, each on two legs: six unknown angles in three loops.

use crate::legs::{Point, turned};
use std::f64::consts::TAU;

/// Samples of the first link's motion.
const SAMPLES: usize = 4000;

/// Two ternary links, their common pin, four legs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Platforms {
    /// Pivots of the legs, two for each link.
    pub(crate) pivots: [Point; 4],
    pub(crate) lengths: [f64; 4],
    /// The second leg's joint and the pin on the first link, from the first leg's joint; then the joints
    /// of the third and fourth leg on the second link, from the pin.
    pub(crate) ends: [Point; 4],
}

/// The first leg's joint, and both directions.
pub(crate) type Pose = [f64; 4];

impl Platforms {
    /// The size that unknown coordinates are divided by.
    pub(crate) const SIZE: f64 = 100.0;

    /// What every leg misses, over its length; coordinates in units of the size.
    pub(crate) fn misses(&self, &[x, y, one, two]: &Pose) -> [f64; 4] {
        let first = [x * Self::SIZE, y * Self::SIZE];
        let pin = plus(first, turned(self.ends[1], one));
        let joints = [
            first,
            plus(first, turned(self.ends[0], one)),
            plus(pin, turned(self.ends[2], two)),
            plus(pin, turned(self.ends[3], two)),
        ];
        std::array::from_fn(|k| {
            let [x, y] = minus(joints[k], self.pivots[k]);
            ((x * x + y * y) / self.lengths[k].powi(2) - 1.0) / 2.0
        })
    }

    /// The first leg's joint for a direction of the first link, on one side or the other; `None` if its
    /// legs do not meet.
    fn joint(&self, one: f64, side: f64) -> Option<Point> {
        let other = minus(self.pivots[1], turned(self.ends[0], one));
        let [x, y] = minus(other, self.pivots[0]);
        let (square, [r, q]) = (x * x + y * y, [self.lengths[0], self.lengths[1]]);
        let along = (square + r * r - q * q) / (2.0 * square);
        let across = (r * r / square - along * along).sqrt();
        let joint = [along * x - side * across * y, along * y + side * across * x];
        (!across.is_nan()).then(|| plus(self.pivots[0], joint))
    }

    /// Cosine and sine of the second direction for a place of the pin, as numerators over one
    /// denominator.
    fn second(&self, pin: Point) -> [f64; 3] {
        let rows: [[f64; 3]; 2] = std::array::from_fn(|k| {
            let ([x, y], [u, v]) = (minus(pin, self.pivots[2 + k]), self.ends[2 + k]);
            let rest = self.lengths[2 + k].powi(2) - x * x - y * y - u * u - v * v;
            [x * u + y * v, y * u - x * v, rest / 2.0]
        });
        let [[a, b, e], [c, d, f]] = rows;
        [e * d - b * f, a * f - e * c, a * d - b * c]
    }

    /// All poses; `None` where two of them nearly coincide.
    ///
    /// The first link's motion is one closed curve, or two: along each of them the second link's misfit
    /// is sampled, and its changes of sign are refined.
    pub(crate) fn poses(&self) -> Option<Vec<Pose>> {
        let mut found = Vec::new();
        for curve in self.curves() {
            let misfit = |t: f64| {
                let (one, side) = curve(t);
                let joint = self.joint(one, side)?;
                let [c, s, d] = self.second(plus(joint, turned(self.ends[1], one)));
                let size = Self::SIZE.powi(4);
                Some((c * c + s * s - d * d) / size / size)
            };
            let at = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
            let values: Vec<Option<f64>> = (0..=SAMPLES).map(|i| misfit(at(i))).collect();
            for i in 0..SAMPLES {
                let (Some(low), Some(high)) = (values[i], values[i + 1]) else {
                    continue;
                };
                if (low > 0.0) == (high > 0.0) {
                    continue;
                }
                let (mut low, mut high, sign) = (at(i), at(i + 1), low > 0.0);
                for _ in 0..45 {
                    let middle = (low + high) / 2.0;
                    if (misfit(middle)? > 0.0) == sign {
                        low = middle
                    } else {
                        high = middle
                    }
                }
                let (one, side) = curve(low);
                let joint = self.joint(one, side)?;
                let [c, s, d] = self.second(plus(joint, turned(self.ends[1], one)));
                let two = (s * d.signum()).atan2(c * d.signum());
                found.push([joint[0] / Self::SIZE, joint[1] / Self::SIZE, one, two]);
            }
            // Three samples that come near zero and turn away from it hide two solutions, or none.
            let turns = values.windows(3).any(|v| match v {
                [Some(a), Some(b), Some(c)] => {
                    let near = (a - b).abs().max((c - b).abs());
                    b.abs() < near && a.signum() == c.signum() && a.signum() == b.signum()
                }
                _ => false,
            });
            if turns {
                return None;
            }
        }
        for pose in &mut found {
            let mut last = (1.0, 0.0);
            for _ in 0..6 {
                last = crate::newton::step(&|x| self.misses(x), pose);
            }
            if last.0 > 1e-12 || last.1.abs() < 1e-6 {
                return None;
            }
        }
        Some(found)
    }

    /// The first link's motion without the second one: direction and side over a parameter from 0 to
    /// 1, closed.
    #[allow(
        clippy::type_complexity,
        reason = "curves as functions of one parameter"
    )]
    fn curves(&self) -> Vec<Box<dyn Fn(f64) -> (f64, f64)>> {
        let samples: Vec<bool> = (0..SAMPLES)
            .map(|i| self.joint(TAU * i as f64 / SAMPLES as f64, 1.0).is_some())
            .collect();
        if samples.iter().all(|closes| *closes) {
            return vec![Box::new(|t| (TAU * t, 1.0)), Box::new(|t| (TAU * t, -1.0))];
        }
        let angle = |i: usize| TAU * i as f64 / SAMPLES as f64;
        let mut curves: Vec<Box<dyn Fn(f64) -> (f64, f64)>> = Vec::new();
        for first in (0..SAMPLES).filter(|&i| samples[i] && !samples[(i + SAMPLES - 1) % SAMPLES]) {
            let length = (0..SAMPLES)
                .take_while(|k| samples[(first + k) % SAMPLES])
                .count();
            let low = self.edge(angle(first), angle(first) - TAU / SAMPLES as f64);
            let last = angle(first + length - 1);
            let high = self.edge(last, last + TAU / SAMPLES as f64);
            let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
            curves.push(Box::new(move |t| {
                let (s, c) = (TAU * t).sin_cos();
                (middle + half * c, s.signum())
            }));
        }
        curves
    }

    /// Between a direction at which the first link's legs meet and one at which they do not.
    fn edge(&self, mut closes: f64, mut opens: f64) -> f64 {
        for _ in 0..60 {
            let middle = (closes + opens) / 2.0;
            if self.joint(middle, 1.0).is_some() {
                closes = middle
            } else {
                opens = middle
            }
        }
        closes
    }
}

fn plus(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}
