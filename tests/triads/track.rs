//! Poses along a way, found at many places of it in another manner than by following equations.

use crate::legs::{Leg, Pose, poses_where};

/// A pose must not move by more in one step: millimetres, and a hundred for a radian.
const JUMP: f64 = 5.0;

/// The next pose must be nearer than others by this factor.
const CLEARLY: f64 = 4.0;

/// Steps as shares of the way: the first and longest, and where none leads on.
const LONGEST: f64 = 1.0 / 64.0;
const SHORTEST: f64 = 1e-7;

/// How far two poses are apart.
pub(crate) fn apart(one: &Pose, other: &Pose) -> f64 {
    let turned = 2.0 * ((one.theta - other.theta) / 2.0).sin().abs();
    (one.x - other.x).hypot(one.y - other.y) + 100.0 * turned
}

/// A pose from the link's first point and direction.
pub(crate) fn pose([x, y]: [f64; 2], [c, s]: [f64; 2]) -> Pose {
    Pose {
        x,
        y,
        theta: s.atan2(c),
    }
}

/// Where a pose is at the end of the way, or the share of it where it is lost.
pub(crate) fn track(start: Pose, legs: impl Fn(f64) -> [Leg; 3]) -> Result<Pose, f64> {
    let (mut pose, mut share, mut step) = (start, 0.0_f64, LONGEST);
    while share < 1.0 {
        let next = (share + step).min(1.0);
        match nearest(&pose, &legs(next)) {
            Some(there) => {
                (pose, share) = (there, next);
                step = (2.0 * step).min(LONGEST);
            }
            None if step < SHORTEST => return Err(share),
            None => step *= 0.5,
        }
    }
    Ok(pose)
}

/// The pose that is clearly the next one. Those too far away to make it unclear are not looked at: where one of them ends, or runs off to
/// infinity, this one goes on.
fn nearest(from: &Pose, legs: &[Leg; 3]) -> Option<Pose> {
    let mut all = poses_where(legs, |pose| apart(pose, from) < CLEARLY * JUMP)?;
    all.sort_by(|a, b| apart(a, from).total_cmp(&apart(b, from)));
    let [first, rest @ ..] = &all[..] else {
        return None;
    };
    let far = apart(first, from);
    let clear = rest
        .first()
        .is_none_or(|second| apart(second, from) > CLEARLY * far);
    (far < JUMP && clear).then_some(*first)
}
