//! A description of the method that finds the reactions.

use std::fmt::Write;

use crate::algebra::Algebra;
use crate::forces::context::Forces;
use crate::forces::joint_motion::JointMotion;
use crate::forces::system::{Equation, System, Unknown};
use crate::forces::{assemble, names};
use crate::model::Mechanism;

/// Describes the driven motions, and the blocks of motions that find reactions together; empty for
/// a mechanism without bodies.
pub(crate) fn describe(algebra: &mut Algebra) -> String {
    let mechanism = algebra.mechanism;
    let mut text = String::new();
    if mechanism.bodies.is_empty() {
        return text;
    }
    let mut forces = Forces::new(algebra);
    let system = assemble::system(algebra, &forces.bodies, &mut forces.memo);
    let driven: Vec<String> = system
        .driven
        .iter()
        .map(|way| described_motion(mechanism, way))
        .collect();
    let _ = writeln!(text, "driven: {}", driven.join(", "));
    for link in &system.axial {
        let (joint, link) = (
            names::joint_name(mechanism, link.joint),
            &mechanism.bodies[link.link].name,
        );
        let _ = writeln!(
            text,
            "across `{link}`, {joint} is found from its own moment"
        );
    }
    for block in &system.blocks {
        let _ = writeln!(text, "{}", described_block(mechanism, &system, block));
    }
    text
}

/// `force b3, force b3: coupler turns, rocker turns`
fn described_block(mechanism: &Mechanism, system: &System, block: &[usize]) -> String {
    let unknowns = system.unknowns_of(block).into_iter();
    let unknowns = unknowns.map(|unknown| match &system.unknowns[unknown] {
        Unknown::Reaction(component) => {
            let what = if component.is_moment {
                "moment"
            } else {
                "force"
            };
            format!("{what} {}", names::joint_name(mechanism, component.joint))
        }
        Unknown::Spin { rod, .. } => format!("spin of `{}`", mechanism.bodies[*rod].name),
        Unknown::Tie(tie) => {
            let couples = tie.couples.iter();
            let couples = couples
                .map(|&(body, share)| format!("{share} on `{}`", mechanism.bodies[body].name));
            format!("couple ({})", couples.collect::<Vec<_>>().join(", "))
        }
    });
    let equations = block
        .iter()
        .map(|&equation| match &system.equations[equation] {
            Equation::Motion(way) => described_motion(mechanism, way),
            Equation::Released(component) => {
                format!(
                    "{} transmits none",
                    names::joint_name(mechanism, component.joint)
                )
            }
        });
    let (unknowns, equations): (Vec<_>, Vec<_>) = (unknowns.collect(), equations.collect());
    format!("{}: {}", unknowns.join(", "), equations.join(", "))
}

fn described_motion(mechanism: &Mechanism, way: &JointMotion) -> String {
    let does = if way.slides { "slides" } else { "turns" };
    format!("`{}` {does}", mechanism.bodies[way.body].name)
}
