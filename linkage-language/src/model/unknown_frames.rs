//! Unknown frames of a mechanism: the unknowns and loops that they consist of.

use crate::model::{Expr, ExprKind, Function, Mechanism, Name};

/// True for a loop that says what the axes of an unknown frame are.
pub fn is_loop_of_frame(mechanism: &Mechanism, index: usize) -> bool {
    let origin = mechanism.loops[index].origin;
    let mut unknowns = mechanism.unknowns.iter();
    unknowns.any(|unknown| unknown.origin == origin)
}

/// The bodies of space that are unknowns, each with its name, its origin and two of its axes.
pub fn bodies_of_space(mechanism: &Mechanism) -> Vec<(String, Vec<usize>)> {
    let lets = mechanism.lets.iter();
    let frames = lets.filter_map(|binding| {
        Some((
            binding.name.clone(),
            unknowns_of(mechanism, &binding.value)?,
        ))
    });
    frames.filter(|(_, parts)| parts.len() == 3).collect()
}

/// The unknowns of a frame that is unknown.
pub fn unknowns_of(mechanism: &Mechanism, value: &Expr) -> Option<Vec<usize>> {
    let ExprKind::Call(Function::Frame, parts) = &value.kind else {
        return None;
    };
    let names = parts.iter().filter_map(Expr::as_name);
    let unknowns = names.filter_map(|name| match name {
        Name::Unknown(index) => Some(index),
        // Other frames have other parts.
        _ => None,
    });
    let of_frame = |index: &usize| mechanism.unknowns[*index].origin == value.origin;
    let unknowns: Vec<usize> = unknowns.filter(of_frame).collect();
    (!unknowns.is_empty()).then_some(unknowns)
}
