//! States of coupled groups, as programs find them.

use std::collections::BTreeSet;

use linkage_core::Scalar;
use linkage_export::FunctionDeclaration;
use linkage_symbolic::program::{Instruction, Program, Source};

use crate::real::Real;
use crate::surface::Surface;

/// The largest correction of a state from a table that is trusted.
pub(crate) fn limit(real: Real) -> String {
    real.literal(match real {
        Real::Double | Real::Fused => f64::CORRECTION_LIMIT,
        Real::Single => f32::CORRECTION_LIMIT,
    })
}

/// Returns true for a function without a coupled group.
pub(crate) fn is_closed(function: &FunctionDeclaration) -> bool {
    function.function.states.is_empty() && function.function.beside.is_none()
}

/// Returns statements that find the states that a program loads, except that of group `except`;
/// `inputs` is the array of all inputs.
pub(crate) fn look_up(
    surface: &Surface,
    program: &Program,
    except: Option<usize>,
    inputs: &str,
) -> String {
    let loads = program.instructions.iter();
    let groups: BTreeSet<usize> = loads
        .filter_map(|instruction| match instruction {
            Instruction::Load(Source::State(group, _)) => Some(*group),
            _ => None,
        })
        .filter(|group| Some(*group) != except)
        .collect();
    let number = surface.real.name();
    let all = groups.iter().map(|&group| {
        let size = surface.declarations.unit.coupled[group].size;
        let private = &surface.declarations.private;
        (
            format!("    {number} state_{group}[{}];\n", size + 1),
            format!("    {private}state_{group}(m, {inputs}, state_{group});\n"),
        )
    });
    let (declared, found): (Vec<String>, Vec<String>) = all.unzip();
    declared.concat() + &found.concat()
}
