//! The states of a group that belong to listed solutions of polynomials.

use super::Correction;
use crate::numeric::roots::{Listing, Variable};
use alloc::vec::Vec;

/// Newton steps that bring a listed solution to rounding.
const POLISH: usize = 4;

/// A listed solution whose last Newton step is larger solves nothing.
const SOLVED: f64 = 1e-6;

/// Two states that differ by less are one.
const SAME: f64 = 1e-9;

/// The states of all real solutions at the inputs `x`, corrected to rounding, each once.
pub fn states(
    variables: &[Variable],
    listing: &Listing,
    x: &[f64],
    correction: &mut dyn Correction,
) -> Vec<Vec<f64>> {
    let mut states: Vec<Vec<f64>> = Vec::new();
    for values in &listing.real {
        let mut state = state(variables, values);
        let mut size = f64::NAN;
        for _ in 0..POLISH {
            size = correction.correct(x, &mut state).size;
        }
        let same = |other: &Vec<f64>| {
            let mut pairs = other.iter().zip(&state);
            pairs.all(|(a, b)| (a - b).abs() <= SAME)
        };
        if size <= SOLVED && !states.iter().any(same) {
            states.push(state);
        }
    }
    states
}

/// The states, about, where real solutions meet that are not listed.
pub fn meeting_states(variables: &[Variable], listing: &Listing) -> Vec<Vec<f64>> {
    let meeting = listing.meeting.iter();
    meeting.map(|values| state(variables, values)).collect()
}

fn state(variables: &[Variable], values: &[[f64; 2]]) -> Vec<f64> {
    let mut state = Vec::new();
    for (variable, value) in variables.iter().zip(values) {
        match variable {
            Variable::Unit | Variable::Point => state.extend(value),
            Variable::Length | Variable::Number => state.push(value[0]),
            Variable::Conjugate => {}
        }
    }
    state
}
