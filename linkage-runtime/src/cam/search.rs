//! What happens over the turn: places where pressure angle and curvature stand still.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use linkage_core::numeric::maximise::maximise;

use super::contact::{Figures, Rate};
use super::{Cam, Follower};

/// At so many angles per turn it is looked: a motion does nothing within half a degree.
const POSITIONS: usize = 720;

/// Halvings of a step: beyond them there are no numbers between its ends.
pub(super) const HALVINGS: usize = 60;

/// A place where something is highest or lowest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stationary {
    /// The angle of the cam.
    pub angle: f64,
    /// What it is there.
    pub value: f64,
}

/// The angles at which it is looked, both ends of the turn among them.
pub(super) fn angles() -> impl Iterator<Item = f64> {
    (0..=POSITIONS).map(|k| k as f64 * (TAU / POSITIONS as f64))
}

impl<F: Fn(f64) -> [f64; 4]> Cam<F> {
    /// The places where the pressure angle is highest or lowest beside its neighbours, in order; none where the follower rests, none for a flat
    /// face. Roots of its exact derivative.
    pub fn pressure_angles(&self) -> Vec<Stationary> {
        self.stationary(|own| own.pressure)
    }

    /// The same for the curvature of the pitch curve; for a flat face it is the radius of curvature of the profile.
    pub fn curvatures(&self) -> Vec<Stationary> {
        self.stationary(|own| own.bend)
    }

    /// The pressure angle that is farthest from 0.
    pub fn largest_pressure_angle(&self) -> Stationary {
        self.peak(|own| own.pressure, f64::abs)
    }

    /// The place where the profile is most sharply bent, and its radius of curvature there: the least one of those where it is
    /// convex, negative if it is undercut.
    pub fn least_radius(&self) -> Stationary {
        let peak = self.peak(|own| own.bend, |bend| self.sharpness(bend));
        let value = match self.follower {
            Follower::Flat { .. } => peak.value,
            Follower::Roller { radius, .. } | Follower::Swinging { radius, .. } => {
                1.0 / peak.value - radius
            }
        };
        Stationary { value, ..peak }
    }

    /// How sharply the profile is bent outwards: the curvature of the pitch curve, or the radius turned round.
    pub(super) fn sharpness(&self, bend: f64) -> f64 {
        match self.follower {
            Follower::Flat { .. } => -bend,
            Follower::Roller { .. } | Follower::Swinging { .. } => bend,
        }
    }

    /// Negative where it is undercut.
    pub(super) fn left(&self, bend: f64) -> f64 {
        match self.follower {
            Follower::Flat { .. } => bend,
            Follower::Roller { radius, .. } | Follower::Swinging { radius, .. } => {
                1.0 - radius * bend
            }
        }
    }

    fn stationary(&self, of: impl Fn(Figures) -> Rate) -> Vec<Stationary> {
        let all: Vec<f64> = angles().collect();
        // A root at the end of the turn is told by what comes after it.
        let turned = |angle: f64| if angle > TAU { angle - TAU } else { angle };
        let slope = |angle: f64| of(self.figures(turned(angle))).slope;
        let largest = all
            .iter()
            .fold(0.0, |most: f64, &angle| most.max(slope(angle).abs()));
        // Where the follower rests, rounding is left.
        let slope = |angle: f64| {
            Some(slope(angle))
                .filter(|own| own.abs() > NOISE * largest)
                .unwrap_or(0.0)
        };
        let found = all
            .windows(2)
            .filter_map(|own| crossing([own[0], own[1]], slope));
        found
            .map(|angle| Stationary {
                angle,
                value: of(self.figures(angle)).value,
            })
            .collect()
    }

    /// Where a figure of a number is largest: at a place where the number stands still, or at a jump, which a search without
    /// derivatives finds.
    pub(super) fn peak(
        &self,
        of: impl Fn(Figures) -> Rate,
        figure: impl Fn(f64) -> f64,
    ) -> Stationary {
        let value = |angle: f64| of(self.figures(angle)).value;
        let searched = maximise([0.0, TAU], POSITIONS + 1, |angle| figure(value(angle)));
        let searched = searched.map_or(0.0, |own| own.at);
        let first = Stationary {
            angle: searched,
            value: value(searched),
        };
        let roots = self.stationary(&of).into_iter();
        // A root of the derivative tells the place better than a search, which sees no difference about it.
        let same = |own: f64, other: f64| (own - other).abs() <= NOISE * own.abs();
        roots.fold(first, |best, next| {
            let (a, b) = (figure(best.value), figure(next.value));
            if b > a || same(a, b) { next } else { best }
        })
    }
}

/// Of a value: what rounding adds to it, and what a search without derivatives cannot tell from it.
const NOISE: f64 = 1e-12;

/// Where a function changes its sign between two angles; from 0 on it must become another sign, or come from one.
fn crossing([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> Option<f64> {
    let [begin, end] = [of(low), of(high)];
    if begin * end >= 0.0 {
        return (begin != 0.0 && end == 0.0)
            .then_some(high)
            .filter(|_| of(high + (high - low)) * begin < 0.0);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if (of(middle) < 0.0) == (begin < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let [below, above] = [low, high].map(|x| of(x).abs());
    Some(if below < above { low } else { high })
}
