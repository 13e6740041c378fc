//! The check for undercut.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use super::contact::Figures;
use super::error::CamError;
use super::follower::Follower;
use super::search::{peak, stationary};
use super::turn::{HALVINGS, angles};
use super::undercut::Undercut;
use crate::summary::Interval;

/// Sharpness of the outward bend of the profile: the curvature of the pitch curve, or the negative
/// radius.
pub(super) fn sharpness(follower: &Follower, bend: f64) -> f64 {
    match *follower {
        Follower::Flat { .. } => -bend,
        Follower::Roller { .. } | Follower::Swinging { .. } => bend,
    }
}

/// Negative where it is undercut.
fn left(follower: &Follower, bend: f64) -> f64 {
    match *follower {
        Follower::Flat { .. } => bend,
        Follower::Roller { radius, .. } | Follower::Swinging { radius, .. } => 1.0 - radius * bend,
    }
}

/// Checks whether the profile can be made.
///
/// # Errors
///
/// [`CamError::Undercut`] with the angles, and the radius of a roller or the distance of a flat
/// face that would do.
pub(super) fn check(
    follower: &Follower,
    figures: &impl Fn(f64) -> Figures,
) -> Result<(), CamError> {
    let peak = peak(
        figures,
        |figures| figures.bend,
        |bend| sharpness(follower, bend),
    );
    if left(follower, peak.value) >= 0.0 {
        return Ok(());
    }
    let intervals = undercuts(follower, figures, peak.angle);
    let holds = |interval: &&Interval| {
        let after = peak.angle - interval.from;
        (0.0..=interval.range).contains(&after) || (0.0..=interval.range).contains(&(after + TAU))
    };
    // The peak is one of the places between which they are sought.
    let worst = intervals.iter().find(holds).copied();
    let worst = worst.unwrap_or(Interval {
        from: peak.angle,
        to: peak.angle,
        range: 0.0,
    });
    let (radius, limit) = match *follower {
        Follower::Flat { base } => (peak.value, base - peak.value),
        Follower::Roller { radius, .. } | Follower::Swinging { radius, .. } => {
            (1.0 / peak.value - radius, 1.0 / peak.value)
        }
    };
    let undercut = Undercut {
        intervals,
        worst,
        at: peak.angle,
        radius,
        limit,
    };
    Err(CamError::Undercut {
        undercut,
        follower: *follower,
    })
}

/// The intervals in which the profile is undercut. The positions that are checked contain `peak`
/// and the stationary curvatures: an interval shorter than a step is next to such a place.
fn undercuts(follower: &Follower, figures: &impl Fn(f64) -> Figures, peak: f64) -> Vec<Interval> {
    let left = |angle: f64| left(follower, figures(angle).bend.value);
    let limits = stationary(figures, |figures| figures.bend)
        .into_iter()
        .map(|position| position.angle);
    let mut angles_checked: Vec<f64> = angles().chain(limits).chain([peak]).collect();
    angles_checked.sort_by(f64::total_cmp);
    let mut open = (left(0.0) < 0.0).then_some(0.0);
    let mut found: Vec<[f64; 2]> = Vec::new();
    for pair in angles_checked.windows(2) {
        match (open, left(pair[1]) < 0.0) {
            (None, true) => open = Some(change([pair[0], pair[1]], left)),
            (Some(from), false) => {
                found.push([from, change([pair[0], pair[1]], left)]);
                open = None;
            }
            (None, false) | (Some(_), true) => {}
        }
    }
    if let Some(from) = open {
        match found.first().copied() {
            // It goes on across the seam.
            Some([0.0, end]) => {
                found.remove(0);
                found.push([from, end + TAU]);
            }
            _ => found.push([from, TAU]),
        }
    }
    let interval = |[from, to]: [f64; 2]| Interval {
        from,
        to: if to > TAU { to - TAU } else { to },
        range: to - from,
    };
    found.into_iter().map(interval).collect()
}

/// The place between two angles where a function becomes negative, or ceases to be.
fn change([mut low, mut high]: [f64; 2], function: impl Fn(f64) -> f64) -> f64 {
    let begins = function(low) < 0.0;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if (function(middle) < 0.0) == begins {
            low = middle;
        } else {
            high = middle;
        }
    }
    let [below, above] = [low, high].map(|x| function(x).abs());
    if below < above { low } else { high }
}
