//! Newton's method, and poses followed by it in fine steps or along a way.

use crate::legs::{self, Leg, Pose, determinant, distance, poses_where, reach};

// Newton's method and continuation for equations given as a function.

/// Steps of the differences that make the Jacobian.
const STEP: f64 = 1e-4;

/// Unknowns of size about 1, and the equations' values, of size about 1.
pub(crate) type Equations<'a, const N: usize> = &'a dyn Fn(&[f64; N]) -> [f64; N];

/// One step; gives the largest correction and the determinant.
pub(crate) fn step<const N: usize>(equations: Equations<N>, x: &mut [f64; N]) -> (f64, f64) {
    let value = equations(x);
    let mut rows: Vec<Vec<f64>> = value.iter().map(|v| vec![*v]).collect();
    for column in 0..N {
        let at = |h: f64| {
            let mut moved = *x;
            moved[column] += h;
            equations(&moved)
        };
        let [back, front, far_back, far_front] = [-STEP, STEP, -2.0 * STEP, 2.0 * STEP].map(at);
        for (i, row) in rows.iter_mut().enumerate() {
            let near = 8.0 * (front[i] - back[i]);
            row.push((near - (far_front[i] - far_back[i])) / (12.0 * STEP));
        }
    }
    let (correction, determinant) = solve(rows);
    let mut largest = 0.0;
    for (x, c) in x.iter_mut().zip(&correction) {
        *x -= c;
        largest = crate::largest([largest, *c]);
    }
    (largest, determinant)
}

/// Solves rows of right-hand side and coefficients; gives the determinant as well.
fn solve(mut rows: Vec<Vec<f64>>) -> (Vec<f64>, f64) {
    let n = rows.len();
    let mut determinant = 1.0;
    for column in 1..=n {
        let here = column - 1;
        let by_size =
            |a: &usize, b: &usize| rows[*a][column].abs().total_cmp(&rows[*b][column].abs());
        let pivot = (here..n).max_by(by_size).unwrap_or(here);
        if pivot != here {
            rows.swap(pivot, here);
            determinant = -determinant;
        }
        let top = rows[here].clone();
        determinant *= top[column];
        for row in rows.iter_mut().skip(column) {
            let factor = row[column] / top[column];
            row.iter_mut().zip(&top).for_each(|(x, t)| *x -= factor * t);
        }
    }
    let mut result = vec![0.0; n];
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|k| rows[row][k + 1] * result[k]).sum();
        result[row] = (rows[row][0] - known) / rows[row][row + 1];
    }
    (result, determinant)
}

/// Follows a solution while an input goes from one value to another, as `follow_pose` does.
pub(crate) fn follow<const N: usize>(
    equations: &dyn Fn(f64, &[f64; N]) -> [f64; N],
    start: [f64; N],
    (from, to): (f64, f64),
) -> Result<[f64; N], f64> {
    let (mut at, mut here, mut length) = (from, start, (to - from) / 64.0);
    let mut last = step(&|x| equations(from, x), &mut start.clone()).1;
    while at != to {
        let longest = (last * last).min(0.02);
        length = length.clamp(-longest, longest);
        let next = if (to - at).abs() <= length.abs() {
            to
        } else {
            at + length
        };
        let mut there = here;
        let (mut moved, mut contracts, mut determinant) = (f64::INFINITY, true, 0.0);
        for _ in 0..8 {
            let (now, d) = step(&|x| equations(next, x), &mut there);
            contracts &= now.is_finite() && (now < 0.3 * moved || now < 1e-10);
            (moved, determinant) = (now, d);
            if !contracts || now < 1e-13 {
                break;
            }
        }
        let apart = crate::largest(here.iter().zip(&there).map(|(a, b)| a - b));
        if contracts && apart < 0.1 && (0.6..1.7).contains(&(determinant / last)) {
            (at, here, last) = (next, there, determinant);
            length *= 1.5;
        } else {
            length *= 0.25;
        }
        if length.abs().min(longest) < 1e-8 {
            return Err(at);
        }
    }
    Ok(here)
}

// Continuation of a pose in fine steps.

/// Follows a pose while the legs move with an input from one value to another; `Err` with the input where
/// it ends in a turning point.
///
/// Towards a turning point the determinant goes to zero with the root of the distance: steps are so short
/// that none leads across, where another pose may begin close by.
pub(crate) fn follow_pose(
    legs: impl Fn(f64) -> [Leg; 3],
    pose: Pose,
    way: (f64, f64),
) -> Result<Pose, f64> {
    follow_and_measure(legs, pose, way).map(|(pose, _)| pose)
}

/// The same with the smallest determinant on the way.
pub(crate) fn follow_and_measure(
    legs: impl Fn(f64) -> [Leg; 3],
    pose: Pose,
    (from, to): (f64, f64),
) -> Result<(Pose, f64), f64> {
    let (mut at, mut here, mut length) = (from, pose, (to - from) / 64.0);
    let mut last = determinant(&legs(from), &pose);
    let mut least = last.abs();
    while at != to {
        let longest = (5.0 * last * last).min(0.02);
        length = length.clamp(-longest, longest);
        let next = if (to - at).abs() <= length.abs() {
            to
        } else {
            at + length
        };
        let there = legs(next);
        let mut pose = here;
        let mut moved = f64::INFINITY;
        let mut contracts = true;
        for _ in 0..8 {
            let before = pose;
            legs::step(&there, &mut pose);
            let now = distance(&before, &pose, reach(&there));
            contracts &= now.is_finite() && (now < 0.3 * moved || now < 1e-10);
            moved = now;
        }
        let near = distance(&here, &pose, reach(&there)) < 0.05;
        let determinant = determinant(&there, &pose);
        if contracts && near && (0.6..1.7).contains(&(determinant / last)) {
            (at, here, last) = (next, pose, determinant);
            least = least.min(determinant.abs());
            length *= 1.5;
        } else {
            length *= 0.25;
        }
        if length.abs().min(longest) < 1e-8 {
            return Err(at);
        }
    }
    Ok((here, least))
}

// Poses along a way, found at many places of it in another manner than by following equations.

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
