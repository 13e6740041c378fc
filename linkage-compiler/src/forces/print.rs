//! How reactions are found, as text.

use crate::forces::system;
use std::fmt::Write;

use crate::algebra::Algebra;
use crate::model::{ElementKind, Mechanism};

use super::Forces;
use super::freedom::Way;
use super::system::{Equation, System, Unknown};

/// What is driven, and which motions find which reactions together; nothing for a mechanism without bodies.
pub(crate) fn describe(algebra: &mut Algebra) -> String {
    let mechanism = algebra.mechanism;
    let mut text = String::new();
    if mechanism.bodies.is_empty() {
        return text;
    }
    let mut forces = Forces::new(algebra);
    let system = system::system(&mut forces.at(algebra, &[], true));
    let driven: Vec<String> = system
        .driven
        .iter()
        .map(|way| way_words(mechanism, way))
        .collect();
    let _ = writeln!(text, "driven: {}", driven.join(", "));
    for link in &system.axial {
        let (joint, link) = (
            joint_name(mechanism, link.joint),
            &mechanism.bodies[link.link].name,
        );
        let _ = writeln!(
            text,
            "across `{link}`, {joint} is found from its own moment"
        );
    }
    for block in &system.blocks {
        let _ = writeln!(text, "{}", block_words(mechanism, &system, block));
    }
    text
}

/// `force b3, force b3: coupler turns, rocker turns`
fn block_words(mechanism: &Mechanism, system: &System, block: &[usize]) -> String {
    let unknowns = system.unknowns_of(block).into_iter();
    let unknowns = unknowns.map(|unknown| match &system.unknowns[unknown] {
        Unknown::Reaction(own) => {
            let what = if own.is_moment { "moment" } else { "force" };
            format!("{what} {}", joint_name(mechanism, own.joint))
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
            Equation::Motion(way) => way_words(mechanism, way),
            Equation::Released(component) => {
                format!("{} transmits none", joint_name(mechanism, component.joint))
            }
        });
    let (unknowns, equations): (Vec<_>, Vec<_>) = (unknowns.collect(), equations.collect());
    format!("{}: {}", unknowns.join(", "), equations.join(", "))
}

fn way_words(mechanism: &Mechanism, way: &Way) -> String {
    let does = if way.slides { "slides" } else { "turns" };
    format!("`{}` {does}", mechanism.bodies[way.body].name)
}

/// A joint as messages name it.
pub(super) fn joint_name(mechanism: &Mechanism, joint: usize) -> String {
    let declared = &mechanism.joints[joint];
    match &declared.name {
        Some(name) => format!("`{name}`"),
        None => format!("the joint of `{}`", mechanism.bodies[declared.body].name),
    }
}

/// A body as messages name it; `None` is the frame.
pub(super) fn body_name(mechanism: &Mechanism, body: Option<usize>) -> String {
    match body {
        Some(body) => format!("`{}`", mechanism.bodies[body].name),
        None => "the frame".to_owned(),
    }
}

/// A spring or damper as messages name it.
pub(super) fn element_word(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::Spring => "spring",
        ElementKind::Damper => "damper",
    }
}
