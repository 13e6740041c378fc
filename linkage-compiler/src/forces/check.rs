//! Are bodies and joints declared so that forces can be found?

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::forces::context::{Forces, Memo};
use crate::forces::joint_motion::JointMotion;
use crate::forces::multibody::Multibody;
use crate::forces::positions::Positions;
use crate::forces::system::{Equation, LARGEST_BLOCK, System};
use crate::forces::{
    assemble, ends, fit, freedom, friction_check, loop_matches, names, rank, shared_angles, steady,
};
use crate::machine::Reference;
use crate::model::{EvaluatorDef, Mechanism};

/// Reports joints whose bodies move apart, points that leave their bodies, motions that nothing
/// holds and reactions that nothing tells.
pub(crate) fn check<'m>(
    algebra: &mut Algebra<'m>,
    forces: &mut Forces<'m>,
    reference: &Reference,
    nominal: &Nominal,
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    if mechanism.bodies.is_empty() {
        return;
    }
    let positions = Positions::new(mechanism, reference, nominal);
    let Forces { bodies, memo } = forces;
    let before = reporter.errors();
    fit::check_fit(algebra, bodies, &mut memo.turns, &positions, reporter);
    ends::check_lengths(algebra, &positions, reporter);
    bodies.facts = steady::steady_motion(algebra, bodies, &mut memo.turns, &positions);
    friction_check::check_numbers(algebra, bodies, &mut memo.turns, &positions, reporter);
    let with_friction = !mechanism.frictions.is_empty();
    let asks = |function: &EvaluatorDef| {
        function.asks_for_reactions() || with_friction && function.asks_for_friction()
    };
    if reporter.errors() == before && mechanism.evaluators.iter().any(asks) {
        bodies.loop_values.arms = loop_matches::link_arms(algebra, bodies, &positions, nominal);
        let system = assemble::system(algebra, bodies, memo);
        check_system(algebra, bodies, memo, &system, &positions, reporter);
        bodies.loop_values.determinants =
            loop_matches::loop_determinants(algebra, &system, &positions, nominal);
        if reporter.errors() == before {
            friction_check::warn_of_jams(algebra, bodies, memo, &positions, reporter);
        }
    }
}

/// Are there as many reactions as motions to be held, and is each in its place?
fn check_system<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    system: &System<'m>,
    positions: &Positions,
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    let before = reporter.errors();
    report_still(mechanism, &bodies.facts.still, system, reporter);
    let undriven = if system.lacks_unknowns() {
        let carried = carried_motions(&bodies.facts.steady, system);
        freedom::undriven_inputs(algebra, bodies, &mut memo.turns, &carried)
    } else {
        Vec::new()
    };
    if undriven.is_empty() {
        report_loose(algebra, bodies, system, reporter);
    } else {
        report_undriven(algebra, bodies, &undriven, reporter);
    }
    report_untold(mechanism, system, reporter);
    if reporter.errors() == before {
        report_blocks(algebra, bodies, system, positions, reporter);
    }
}

/// Returns the motions in which a drive can act: those that inputs alone move, or at a constant
/// rate.
fn carried_motions<'m>(steady: &[(usize, bool)], system: &System<'m>) -> Vec<JointMotion<'m>> {
    let free = system.equations.iter().filter_map(Equation::motion);
    let free = free.filter(|way| steady.contains(&(way.body, way.slides)));
    system.driven.iter().chain(free).copied().collect()
}

/// Reports inputs that move no body in the joint of its declaration.
fn report_undriven(
    algebra: &Algebra,
    bodies: &Multibody,
    undriven: &[usize],
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    let all: Vec<usize> = (0..mechanism.bodies.len()).collect();
    let shared = shared_angles::described(algebra, bodies, &all);
    for &input in undriven {
        let input = &mechanism.inputs[input];
        let help = if input.dimension.angle {
            format!(
                "declare the body that it turns, like `body NAME = pin on BODY at POINT, turns {}`; \
                 if BODY turns too, the joint moves by the angle between both: make that the input",
                input.name
            )
        } else {
            "declare the bodies of the drive; for a cylinder from P to Q these are \
             `body barrel = pin on frame at P, turns angle(Q - P)` and \
             `body rod = slide on barrel at Q along Q - P`, with a `pin` of the rod at Q"
                .to_owned()
        };
        reporter.error(
            input.origin,
            format!(
                "no body is declared by a joint that `{}` moves: reactions cannot be found{shared}\n\
                 help: {help}",
                input.name
            ),
        );
    }
}

/// Drives that drive nothing.
fn report_still(
    mechanism: &Mechanism,
    still: &[(usize, bool)],
    system: &System,
    reporter: &mut Reporter,
) {
    let driven = system.driven.iter();
    for way in driven.filter(|way| still.contains(&(way.body, way.slides))) {
        let body = &mechanism.bodies[way.body];
        let does = if way.slides { "slide" } else { "turn" };
        reporter.error(
            body.origin,
            format!(
                "`{}` does not {does} in {}, and no joint holds it: reactions cannot be found\n\
                     help: if nothing moves there, write `fixed`",
                body.name,
                names::joint_name(mechanism, body.joint),
            ),
        );
    }
}

/// Motions that no reaction holds.
fn report_loose(algebra: &Algebra, bodies: &Multibody, system: &System, reporter: &mut Reporter) {
    let mechanism = algebra.mechanism;
    for (equation, found) in system.matching.coordinates_of.iter().enumerate() {
        let Equation::Motion(way) = &system.equations[equation] else {
            continue;
        };
        if !found.is_empty() {
            continue;
        }
        let body = &mechanism.bodies[way.body];
        let how = if way.slides {
            "sliding along"
        } else {
            "turning in"
        };
        let joint = names::joint_name(mechanism, body.joint);
        let shared = shared_angles::described(algebra, bodies, &[way.body]);
        reporter.error(
            body.origin,
            format!(
                "nothing holds `{0}` against {how} {joint}: reactions cannot be found{shared}\n\
                 help: declare the joint that closes its loop, like `pin NAME = {0} on BODY at POINT;`; let a body hang by the joint \
                 that an input moves",
                body.name
            ),
        );
    }
}

/// Reactions that no motion needs.
fn report_untold(mechanism: &Mechanism, system: &System, reporter: &mut Reporter) {
    let mut reported: Vec<usize> = Vec::new();
    for (unknown, equation) in system.matching.equation_of.iter().enumerate() {
        let joint = system.unknowns[unknown].joint();
        let Some(joint) = joint.filter(|joint| equation.is_none() && !reported.contains(joint))
        else {
            continue;
        };
        reported.push(joint);
        let name = names::joint_name(mechanism, joint);
        reporter.error(
            mechanism.joints[joint].origin,
            format!(
                "equilibrium does not tell the reaction of {name}: there are {} components of reactions in the joints that \
                 close loops, and {} motions that they hold\n\
                 help: leave out a joint that holds what others hold already, or let one of them move more freely",
                system.unknowns.len(),
                system.equations.len(),
            ),
        );
    }
}

/// Groups of equations that are too large, or say the same twice.
fn report_blocks(
    algebra: &Algebra,
    bodies: &Multibody,
    system: &System,
    positions: &Positions,
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    for block in &system.blocks {
        let joints = joints_of(system, block);
        let names = joints
            .iter()
            .map(|&joint| names::joint_name(mechanism, joint));
        let names = names.collect::<Vec<_>>().join(", ");
        let message = if block.len() > LARGEST_BLOCK {
            format!(
                "the reactions of {names} can only be found together: {} equations, more than {LARGEST_BLOCK}\n\
                 help: ask for the torque and the energies only",
                block.len(),
            )
        } else if rank::repeats(system, block, positions) {
            let ends = joints.iter().flat_map(|&joint| {
                let joint = &mechanism.joints[joint];
                [Some(joint.body), joint.on]
            });
            let ends: Vec<usize> = ends.flatten().collect();
            let shared = shared_angles::described(algebra, bodies, &ends);
            format!(
                "equilibrium does not tell the reactions of {names}: the conditions for them repeat each other wherever it moves{shared}\n\
                 help: leave out a joint that holds what others hold already, or let one of them move more freely",
            )
        } else {
            continue;
        };
        let origin = joints.first().map(|&joint| mechanism.joints[joint].origin);
        reporter.error(origin.unwrap_or(mechanism.origin), message);
    }
}

/// The cut joints whose reactions a block finds.
fn joints_of(system: &System, block: &[usize]) -> Vec<usize> {
    let unknowns = system.unknowns_of(block).into_iter();
    let mut joints = Vec::new();
    for joint in unknowns.filter_map(|unknown| system.unknowns[unknown].joint()) {
        if !joints.contains(&joint) {
            joints.push(joint);
        }
    }
    joints
}
