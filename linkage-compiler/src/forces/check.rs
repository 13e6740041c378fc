//! Are bodies and joints declared so that forces can be found?

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::{Diagnostics, Origins};
use crate::formulate::{Reference, places};
use crate::model::{EvaluatorDef, Mechanism};

use super::print::joint_name;
use super::system::{Equation, LARGEST_BLOCK, System};
use super::{Forces, Mechanics};

/// Reports joints whose bodies move apart, points that leave their bodies, motions that nothing holds and reactions
/// that nothing tells.
pub(crate) fn check(
    algebra: &mut Algebra,
    forces: &mut Forces,
    (reference, nominal): (&Reference, &Nominal),
    origins: &Origins,
    diagnostics: &mut Diagnostics,
) {
    let mechanism = algebra.mechanism;
    if mechanism.bodies.is_empty() {
        return;
    }
    let mut mechanics = forces.at(algebra, &[], false);
    let before = diagnostics.len();
    let places = places(nominal, mechanism, reference.longest);
    mechanics.check_fit(reference, &places, origins, diagnostics);
    let mut each = places.iter();
    each.find(|inputs| mechanics.check_lengths((reference, inputs), origins, diagnostics));
    mechanics.look_at_motion(reference, &places);
    if diagnostics.len() == before
        && mechanism
            .evaluators
            .iter()
            .any(EvaluatorDef::asks_for_reactions)
    {
        mechanics.check_system((reference, &places), origins, diagnostics);
    }
}

impl Mechanics<'_, '_> {
    /// Are there as many reactions as motions to be held, and is each in its place?
    fn check_system(
        &mut self,
        (reference, places): (&Reference, &[Vec<f64>]),
        origins: &Origins,
        diagnostics: &mut Diagnostics,
    ) {
        let mechanism = self.algebra.mechanism;
        let system = self.system();
        let before = diagnostics.len();
        for way in &system.driven {
            if !self.forces.still.contains(&(way.body, way.slides)) {
                continue;
            }
            let body = &mechanism.bodies[way.body];
            let does = if way.slides { "slide" } else { "turn" };
            diagnostics.error(
                origins.span(body.origin),
                format!(
                    "`{}` does not {does} in {}, and no joint holds it: reactions cannot be found\n\
                     help: if nothing moves there, write `fixed`",
                    body.name,
                    joint_name(mechanism, body.joint),
                ),
            );
        }
        for (equation, found) in system.matching.coordinates_of.iter().enumerate() {
            let Equation::Motion(way) = &system.equations[equation] else {
                continue;
            };
            if found.is_empty() {
                let body = &mechanism.bodies[way.body];
                let how = if way.slides {
                    "sliding along"
                } else {
                    "turning in"
                };
                let joint = joint_name(mechanism, body.joint);
                diagnostics.error(
                    origins.span(body.origin),
                    format!(
                        "nothing holds `{0}` against {how} {joint}: reactions cannot be found\n\
                         help: declare the joint that closes its loop, like `pin NAME = {0} on BODY at POINT;`; let a body hang by the joint \
                         that an input moves",
                        body.name
                    ),
                );
            }
        }
        let mut joints: Vec<usize> = Vec::new();
        for (unknown, equation) in system.matching.equation_of.iter().enumerate() {
            let joint = system.unknowns[unknown].joint();
            let joint = joint.filter(|joint| equation.is_none() && !joints.contains(joint));
            if let Some(joint) = joint {
                joints.push(joint);
                let name = joint_name(mechanism, joint);
                diagnostics.error(
                    origins.span(mechanism.joints[joint].origin),
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
        if diagnostics.len() != before {
            return;
        }
        for block in &system.blocks {
            let message = if block.len() > LARGEST_BLOCK {
                format!(
                    "the reactions of {} can only be found together: {} equations, more than {LARGEST_BLOCK}\n\
                     help: ask for the torque and the energies only",
                    joint_names(mechanism, &system, block),
                    block.len(),
                )
            } else if self.repeats(&system, block, reference, places) {
                format!(
                    "equilibrium does not tell the reactions of {}: the conditions for them repeat each other wherever it moves\n\
                     help: leave out a joint that holds what others hold already, or let one of them move more freely",
                    joint_names(mechanism, &system, block),
                )
            } else {
                continue;
            };
            let joint = joints_of(&system, block).first().copied();
            let origin = joint.map_or(mechanism.origin, |joint| mechanism.joints[joint].origin);
            diagnostics.error(origins.span(origin), message);
        }
    }
}

/// The cut joints whose reactions a block finds.
fn joints_of(system: &System, block: &[usize]) -> Vec<usize> {
    let unknowns = block
        .iter()
        .flat_map(|&e| &system.matching.coordinates_of[e]);
    let mut joints = Vec::new();
    for joint in unknowns.filter_map(|&unknown| system.unknowns[unknown].joint()) {
        if !joints.contains(&joint) {
            joints.push(joint);
        }
    }
    joints
}

fn joint_names(mechanism: &Mechanism, system: &System, block: &[usize]) -> String {
    let names = joints_of(system, block).into_iter();
    let names: Vec<String> = names.map(|joint| joint_name(mechanism, joint)).collect();
    names.join(", ")
}
