//! Search over the turn for places where pressure angle and curvature are stationary.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use linkage_core::numeric::maximise::maximise;

use super::contact::{Figures, Rate};
use super::turn::{HALVINGS, POSITIONS, angles};

/// A place where something is highest or lowest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stationary {
    /// The angle of the cam.
    pub angle: f64,
    /// The value at this angle.
    pub value: f64,
}

/// The places where one of the figures is highest or lowest beside its neighbours, in order: roots
/// of its exact derivative.
pub(super) fn stationary(
    figures: &impl Fn(f64) -> Figures,
    figure_of: impl Fn(Figures) -> Rate,
) -> Vec<Stationary> {
    let angles_of_turn: Vec<f64> = angles().collect();
    // A root at the end of the turn is seen by the values after it.
    let turned = |angle: f64| if angle > TAU { angle - TAU } else { angle };
    let slope = |angle: f64| figure_of(figures(turned(angle))).slope;
    let largest = angles_of_turn
        .iter()
        .fold(0.0, |most: f64, &angle| most.max(slope(angle).abs()));
    // Only rounding is left at a rest of the follower.
    let slope = |angle: f64| {
        Some(slope(angle))
            .filter(|slope| slope.abs() > NOISE * largest)
            .unwrap_or(0.0)
    };
    let found = angles_of_turn
        .windows(2)
        .filter_map(|pair| crossing([pair[0], pair[1]], slope));
    found
        .map(|angle| Stationary {
            angle,
            value: figure_of(figures(angle)).value,
        })
        .collect()
}

/// The place where a figure is largest: a stationary place, or a jump, which a search without
/// derivatives finds.
pub(super) fn peak(
    figures: &impl Fn(f64) -> Figures,
    figure_of: impl Fn(Figures) -> Rate,
    figure: impl Fn(f64) -> f64,
) -> Stationary {
    let value = |angle: f64| figure_of(figures(angle)).value;
    let searched = maximise([0.0, TAU], POSITIONS + 1, |angle| figure(value(angle)));
    let searched = searched.map_or(0.0, |summit| summit.at);
    let first = Stationary {
        angle: searched,
        value: value(searched),
    };
    let roots = stationary(figures, &figure_of).into_iter();
    // A root of the derivative is more exact than a search, which sees no difference about
    // it.
    let same = |one: f64, other: f64| (one - other).abs() <= NOISE * one.abs();
    roots.fold(first, |best, next| {
        let (a, b) = (figure(best.value), figure(next.value));
        if b > a || same(a, b) { next } else { best }
    })
}

/// Rounding error of a value, and the resolution of a search without derivatives, as a part of the
/// value.
const NOISE: f64 = 1e-12;

/// The place between two angles where a function changes its sign. A zero counts if the sign
/// differs on its two sides.
fn crossing([mut low, mut high]: [f64; 2], function: impl Fn(f64) -> f64) -> Option<f64> {
    let [begin, end] = [function(low), function(high)];
    if begin * end >= 0.0 {
        return (begin != 0.0 && end == 0.0)
            .then_some(high)
            .filter(|_| function(high + (high - low)) * begin < 0.0);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if (function(middle) < 0.0) == (begin < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let [below, above] = [low, high].map(|x| function(x).abs());
    Some(if below < above { low } else { high })
}
