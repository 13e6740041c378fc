//! The distance by which the loops of a group that is followed from its estimates miss, for the
//! message if the estimates lead to no assembly.

use linkage_symbolic::Ex;
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::schedule::schedule_whole;

use crate::algebra::Algebra;
use crate::ir::{CompiledMechanism, MissedLoop};
use crate::message_format::joint_names;
use crate::mobility::difference;
use crate::model::{Mechanism, unknown_frames};
use crate::solve::{Formulation, Solved, Version};

use super::plain::{plain, valued_angles};

/// Adds to each group that is followed the program that computes the distance by which its loops
/// miss in a state.
pub(super) fn missed<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    inliner: &mut Inliner,
    unit: &mut CompiledMechanism,
) {
    for (index, solved) in formulation.groups.iter().enumerate() {
        let Some(prepared) = &solved.prepared else {
            continue;
        };
        if !unit.coupled[prepared.number].followed {
            continue;
        }
        // The unknowns have their values in a given state, not after the steps of a call.
        prepared.define(algebra.graph, Version::Raw);
        let (loops, mut sides) = differences(algebra, solved, unit.longest);
        for frame in loops_of_frames(algebra.mechanism, formulation, index) {
            sides.extend(difference(
                &mut algebra.names,
                &algebra.mechanism.loops[frame],
            ));
        }
        let sides = plain(inliner, &sides);
        // Values of angles take turns that are not followed to where estimates are.
        let told = valued_angles(&inliner.target, &sides).is_empty();
        let group = &mut unit.coupled[prepared.number];
        if told {
            group.missed = schedule_whole(&inliner.target, &sides);
            group.missed_loops = loops;
        }
        prepared.define(algebra.graph, Version::Called);
    }
}

/// Returns the loops that make frames rigid and can be evaluated once a group is solved, not
/// before; the group's own loops are those that are written.
fn loops_of_frames(mechanism: &Mechanism, formulation: &Formulation, group: usize) -> Vec<usize> {
    let is_new = |&index: &usize| {
        let about = mechanism.usage(&[index]).unknowns.into_iter().enumerate();
        let found = about
            .filter(|(_, is_used)| *is_used)
            .map(|(unknown, _)| formulation.last_group_with(unknown));
        unknown_frames::is_loop_of_frame(mechanism, index) && found.max() == Some(Some(group))
    };
    (0..mechanism.loops.len()).filter(is_new).collect()
}

/// The loops of a group, and the differences of their sides.
fn differences<'m>(
    algebra: &mut Algebra<'m>,
    solved: &Solved<'m>,
    longest: f64,
) -> (Vec<MissedLoop>, Vec<Ex<'m>>) {
    let mechanism = algebra.mechanism;
    let loops = solved.group.loops.iter().copied();
    let written = loops.filter(|&index| !unknown_frames::is_loop_of_frame(mechanism, index));
    let (mut missed, mut sides) = (Vec::new(), Vec::new());
    for index in written {
        let equation = &mechanism.loops[index];
        let difference = difference(&mut algebra.names, equation);
        // A side that is 0 may be of any dimension.
        let dimensions = [&equation.left.ty, &equation.right.ty].into_iter();
        let dimensions = dimensions.filter_map(|ty| ty.dimension());
        let dimension = dimensions.max_by_key(|dimension| dimension.half_lengths);
        missed.push(MissedLoop {
            number: index + 1,
            joint: joint_names(mechanism, &[index]),
            rows: difference.len(),
            unit: dimension.map_or_else(String::new, |dimension| dimension.unit(mechanism.unit)),
            scale: dimension.map_or(1.0, |dimension| {
                longest.powf(0.5 * f64::from(dimension.half_lengths))
            }),
        });
        sides.extend(difference);
    }
    (missed, sides)
}
