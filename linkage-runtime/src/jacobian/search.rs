//! Singular positions on a path.

use alloc::vec::Vec;

use super::matrix::Jacobian;

/// Halvings that leave neighbouring numbers of any range.
const HALVINGS: usize = 1100;

/// Beside a pole the determinant has grown at least so much: it is one over the root of the
/// distance, which is halved many times.
const GROWN: f64 = 100.0;

/// Positions that end shortly before a pole, as tables of coupled groups do: one over the
/// determinant's square is a straight line there, which reaches zero within this part of a step
/// beyond their end.
const SHORTLY: f64 = 1.0 / 64.0;

/// The kind of a singular position (C. Gosselin, J. Angeles, "Singularity analysis of closed-loop
/// kinematic chains", IEEE Trans. Robotics Automation 6, 1990).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SingularityKind {
    /// The determinant of the results by the inputs is zero: inputs move, and the results stand
    /// still in some direction. The drives carry any load there.
    First,
    /// It is infinite: the results can move although the inputs stand still, and the drives hold no
    /// load in some direction. A dead point of the mechanism that is driven by these inputs.
    Second,
    /// Beyond are no positions although the determinant stays finite and heads for no pole: the end
    /// of a range that is served, or both kinds at once.
    End,
}

/// A singular position on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singularity {
    /// The position on the path, to the last digit that the determinant determines.
    pub at: f64,
    /// In which way.
    pub kind: SingularityKind,
}

/// The singular positions that a path passes, in order, and where its positions begin and end.
///
/// `jacobian` gives the derivatives at a place of the path, not finite where there is no position.
/// Between `steps + 1` places at equal distances changes of the determinant's sign, and borders to
/// where it is not finite, are enclosed by halving. Two changes between two neighbouring places are
/// not seen, nor is a position that is touched and not passed.
///
/// The prepared solution of a coupled group ends shortly before a dead point. This end is reported
/// as one of the second kind, at the border, if the determinant grows towards it like one over the
/// root of a distance that is less than a 64th of a step beyond the border: smaller steps ask for
/// more.
///
/// ```
/// use linkage_runtime::jacobian::{Jacobian, SingularityKind, singularities};
///
/// // An arm of two links of length 1, from bent to stretched and on: det J = sin(elbow).
/// let arm = |elbow: f64| {
///     let (sin, cos) = elbow.sin_cos();
///     Jacobian::of_inputs([[-sin, 1.0 + cos], [-sin, cos]])
/// };
/// let found = singularities(arm, [-1.0, 2.0], 100);
/// assert_eq!(found.len(), 1);
/// assert!(found[0].at.abs() < 1e-15 && found[0].kind == SingularityKind::First);
/// ```
pub fn singularities<const N: usize>(
    mut jacobian: impl FnMut(f64) -> Jacobian<f64, N>,
    [from, to]: [f64; 2],
    steps: usize,
) -> Vec<Singularity> {
    let mut at = |along: f64| Sample {
        along,
        determinant: jacobian(along).determinant(),
    };
    let count = steps.max(1);
    let mut found = Vec::new();
    let mut last = at(from);
    for step in 1..=count {
        #[expect(clippy::cast_precision_loss, reason = "nobody takes 2^53 steps")]
        let share = step as f64 / count as f64;
        let next = at(from + (to - from) * share);
        found.extend(between(&mut at, last, next));
        last = next;
    }
    found
}

#[derive(Clone, Copy)]
struct Sample {
    along: f64,
    determinant: f64,
}

impl Sample {
    /// On which side of a singular position it is.
    fn side(self) -> Option<bool> {
        let is_there = self.determinant.is_finite();
        is_there.then_some(self.determinant > 0.0)
    }
}

fn between(
    at: &mut impl FnMut(f64) -> Sample,
    first: Sample,
    second: Sample,
) -> Option<Singularity> {
    if first.side() == second.side() {
        return None;
    }
    let (mut low, mut high) = (first, second);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low.along + high.along);
        if middle == low.along || middle == high.along {
            break;
        }
        let middle = at(middle);
        if middle.side() == low.side() {
            low = middle
        } else {
            high = middle
        }
    }
    // Finite positions, next to the border and far from it.
    let (near, far) = match low.side() {
        Some(_) => (low, first),
        None => (high, second),
    };
    let passes = low.side().is_some() && high.side().is_some();
    let grown = near.determinant.abs() > GROWN * far.determinant.abs();
    let pole = grown || (!passes && heads_for_pole(at, near, far));
    let kind = match (pole, passes) {
        (true, _) => SingularityKind::Second,
        (false, true) => SingularityKind::First,
        (false, false) => SingularityKind::End,
    };
    Some(Singularity {
        at: near.along,
        kind,
    })
}

/// Returns true if the determinant has a pole shortly beyond the border at `near`; `far` is a step
/// away on the side with positions.
fn heads_for_pole(at: &mut impl FnMut(f64) -> Sample, near: Sample, far: Sample) -> bool {
    let beside = at(near.along + SHORTLY * (far.along - near.along));
    let [level, above] =
        [near, beside].map(|position| 1.0 / (position.determinant * position.determinant));
    // The value falls from `above` over `level` to zero within the same distance.
    beside.side().is_some() && above >= 2.0 * level
}
