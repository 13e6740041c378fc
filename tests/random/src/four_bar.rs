//! Four-bars about their change points: random lengths, and what the lengths say of a turn of the crank.

use std::f64::consts::{PI, TAU};

use crate::Random;

/// What ends an assembly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Two assemblies meet, and both go on.
    ChangePoint,
    /// The assembly ends.
    DeadPoint,
    /// The assembly ends, and closes again.
    Gap,
}

/// Crank, coupler, rocker and frame of a parallelogram, a kite of either kind, or with the longest and the shortest as long as the others.
pub fn at_change_point(random: &mut Random) -> [f64; 4] {
    let [a, b, c] = [0; 3].map(|_| random.between(20.0, 200.0));
    match random.below(6) {
        0 => [a, b, a, b],
        1 => [a, a, b, b],
        2 => [a, b, b, a],
        3 => [a, b, c, b + c - a],
        4 => [a, b, c, a + b - c],
        _ => [a, b, c, a + c - b],
    }
}

/// Of three rounds one has lengths at a change point, one as near to it as a millionth, and one others.
pub fn lengths(random: &mut Random, round: usize) -> [f64; 4] {
    let mut all = at_change_point(random);
    match round % 3 {
        1 => all[random.below(4)] *= 1.0 + random.pick(&[1e-6, -1e-6]),
        2 => all = all.map(|own| own * random.between(0.5, 2.0)),
        _ => {}
    }
    all
}

/// The limits in a turn with where each begins and ends, from where the diagonal between crank and rocker is too long or too short for both. `None`
/// where it is at a limit all the way, or beyond one.
#[must_use]
pub fn limits([crank, coupler, rocker, frame]: [f64; 4]) -> Option<Vec<(Limit, f64, f64)>> {
    let (inner, outer) = ((frame - crank).abs(), frame + crank);
    let (near, far) = ((coupler - rocker).abs(), coupler + rocker);
    let same = |a: f64, b: f64| (a - b).abs() < 1e-13 * outer;
    let angle = |distance: f64| {
        let cosine = (crank * crank + frame * frame - distance * distance) / (2.0 * crank * frame);
        cosine.clamp(-1.0, 1.0).acos()
    };
    // Where both links nearly fold onto a diagonal that nearly vanishes, the slack is near what counts as a dead point over a stretch, and the
    // ends of a gap are as uncertain.
    if !same(inner, near) && inner.max(near) < 3e-3 * outer {
        return None;
    }
    if inner > far || same(inner, far) || outer < near || same(outer, near) {
        return None;
    }
    let mut found = Vec::new();
    if same(inner, near) {
        found.extend([
            (Limit::ChangePoint, 0.0, 0.0),
            (Limit::ChangePoint, TAU, TAU),
        ]);
    } else if inner < near {
        // It is open at both ends of the turn.
        found.push((Limit::DeadPoint, 0.0, angle(near)));
        found.push((Limit::DeadPoint, TAU - angle(near), TAU));
    }
    if same(outer, far) {
        found.push((Limit::ChangePoint, PI, PI));
    } else if outer > far {
        found.push((Limit::Gap, angle(far), TAU - angle(far)));
    }
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    Some(found)
}
