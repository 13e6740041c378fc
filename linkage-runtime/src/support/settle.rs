//! A small step of a coupled group to other dimensions, certified.

use alloc::vec::Vec;
use linkage_core::certificate::{
    ALLOWED_CONTRACTION, CORRECTIONS, FIRST_CORRECTION, SCALES, SETTLED,
};
use linkage_core::numeric::continuation::Correction;
use linkage_core::numeric::roots::Variable;

/// The state near `before` that solves the equations, and its determinant, which has the sign of
/// `sign` (if that has one).
pub(super) fn moved(
    programs: &mut dyn Correction,
    variables: &[Variable],
    x: &[f64],
    before: &[f64],
    sign: f64,
) -> Option<(Vec<f64>, f64)> {
    scales(variables).iter().find_map(|&scale| {
        let mut state = scaled(variables, before, scale);
        let determinant = settle(programs, x, &mut state, sign)?;
        Some((state, determinant))
    })
}

/// The scales of lengths to try: one, if there are none.
pub(super) fn scales(variables: &[Variable]) -> &'static [f64] {
    let has_scale = |variable: &Variable| !matches!(variable, Variable::Unit | Variable::Number);
    let lengths = variables.iter().any(has_scale);
    if lengths { &SCALES } else { &SCALES[..1] }
}

/// A state on another scale of lengths.
pub(super) fn scaled(variables: &[Variable], state: &[f64], scale: f64) -> Vec<f64> {
    let numbers = variables.iter().flat_map(|variable| match variable {
        Variable::Unit => [1.0; 2].iter(),
        Variable::Number => [1.0; 1].iter(),
        Variable::Length | Variable::Point | Variable::Conjugate => [0.0; 1].iter(),
    });
    let pairs = state.iter().zip(numbers);
    pairs
        .map(|(number, &unit)| if unit > 0.0 { *number } else { scale * number })
        .collect()
}

/// Corrects a state; the determinant there, which keeps its sign (if it had one).
fn settle(programs: &mut dyn Correction, x: &[f64], state: &mut [f64], before: f64) -> Option<f64> {
    let mut allowed = FIRST_CORRECTION;
    for _ in 0..CORRECTIONS {
        let step = programs.correct(x, state);
        let sound =
            step.size <= allowed && step.determinant * before >= 0.0 && step.determinant != 0.0;
        if !sound {
            return None;
        }
        if step.size <= SETTLED {
            return Some(step.determinant);
        }
        allowed = ALLOWED_CONTRACTION * step.size;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use linkage_core::numeric::continuation::Step;

    /// Moves from 1 to the root of this square; two solutions meet at 0.
    fn root(square: f64, sign: f64) -> Option<f64> {
        let mut programs = |x: &[f64], state: &mut [f64]| {
            let determinant = 2.0 * state[0];
            let step = (state[0] * state[0] - x[0]) / determinant;
            state[0] -= step;
            Step {
                size: step.abs(),
                determinant,
            }
        };
        let found = moved(&mut programs, &[Variable::Unit], &[square], &[1.0], sign)?;
        Some(found.0[0])
    }

    #[test]
    fn a_small_step_is_taken_and_a_larger_one_refused() {
        assert!(root(1.08, 1.0).is_some_and(|found| (found - 1.08_f64.sqrt()).abs() < 1e-9));
        assert_eq!(root(1.12, 1.0), None);
    }

    #[test]
    fn the_assembly_on_the_other_side_of_a_dead_point_is_refused() {
        assert_eq!(root(1.08, -1.0), None);
        assert_eq!(root(1.08, 0.0), root(1.08, 1.0));
    }
}
