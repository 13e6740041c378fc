//! The reactions of cut joints, group by group.

use crate::algebra::elimination;
use crate::forces::links;
use crate::forces::system;
use crate::forces::wrench;
use linkage_symbolic::Ex;

use super::Mechanics;
use super::system::{Equation, LARGEST_BLOCK, System, Unknown};
use super::wrench::Wrench;

/// The reaction of a cut joint on its body; unknowns in `open` count as 0.
pub(super) fn closing_wrench<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    joint: usize,
    open: &[usize],
) -> Wrench<'m> {
    let system = system::system(mechanics);
    let mut sum = match system.axial.iter().find(|own| own.joint == joint) {
        Some(axial) => links::across_link(mechanics, axial),
        None => wrench::zero_wrench(mechanics),
    };
    for (index, unknown) in system.unknowns.iter().enumerate() {
        let Unknown::Reaction(own) = unknown else {
            continue;
        };
        if own.joint != joint || open.contains(&index) {
            continue;
        }
        let part = solved(mechanics, index) * own.direction;
        match own.is_moment {
            true => sum.moment = sum.moment + part,
            false => sum.force = sum.force + part,
        }
    }
    sum
}

/// The value of an unknown.
pub(super) fn solved<'m>(mechanics: &mut Mechanics<'_, 'm>, unknown: usize) -> Ex<'m> {
    if let Some(&known) = mechanics.case().solved.get(&unknown) {
        return known;
    }
    let system = system::system(mechanics);
    let equation = system.matching.equation_of[unknown];
    let block = system
        .blocks
        .iter()
        .find(|block| equation.is_some_and(|e| block.contains(&e)));
    let Some(block) = block.filter(|block| block.len() <= LARGEST_BLOCK) else {
        // Reported by the check of bodies and joints.
        return mechanics.graph().number(f64::NAN);
    };
    let own = system.unknowns_of(block);
    let right: Vec<Ex> = block
        .iter()
        .map(|&equation| -known(mechanics, &system, equation, &own))
        .collect();
    let matrix = system.matrix_of(block);
    let known = mechanics.forces.closed.determinant(block);
    let determinant = known.unwrap_or_else(|| elimination::determinant(mechanics.algebra, &matrix));
    let numerators = elimination::cofactor_products(mechanics.algebra, &matrix, &right);
    // The determinant is known long before the loads.
    let factor = 1.0 / determinant;
    for (&unknown, numerator) in own.iter().zip(numerators) {
        let value = numerator * factor;
        mechanics.case().solved.insert(unknown, value);
    }
    mechanics.case().solved[&unknown]
}

/// What an equation says of all that is known before its block is solved.
fn known<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    system: &System<'m>,
    equation: usize,
    block: &[usize],
) -> Ex<'m> {
    let contained = &system.incidence[equation];
    let is_open = |unknown: &usize| !contained.contains(unknown) || block.contains(unknown);
    let open: Vec<usize> = (0..system.unknowns.len()).filter(is_open).collect();
    match &system.equations[equation] {
        Equation::Released(component) => {
            let wrench = closing_wrench(mechanics, component.joint, &open);
            component.direction.dot(match component.is_moment {
                true => wrench.moment,
                false => wrench.force,
            })
        }
        Equation::Motion(way) => wrench::wrench(mechanics, way.body, &[], &open).along(way),
    }
}
