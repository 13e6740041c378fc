//! The equations of the system: the coefficient of each unknown in each equation.

use linkage_symbolic::{Ex, Graph};

use crate::forces::cut_joints;
use crate::forces::joint_motion::JointMotion;
use crate::forces::multibody::Multibody;
use crate::forces::system::{Component, Equation, System, Unknown};
use crate::model::Mechanism;

/// Adds an equation, with a coefficient for each unknown.
pub(super) fn add<'m>(
    mechanism: &Mechanism,
    graph: &'m Graph,
    bodies: &Multibody<'m>,
    system: &mut System<'m>,
    equation: Equation<'m>,
) {
    let unknowns = system.unknowns.iter();
    let row: Vec<Ex> = unknowns
        .map(|unknown| coefficient(mechanism, graph, bodies, &equation, unknown))
        .collect();
    let entries = (0..row.len()).filter(|&k| !row[k].is_zero());
    system.incidence.push(entries.collect());
    system.equations.push(equation);
    system.matrix.push(row);
}

/// The coefficient of an unknown in an equation.
pub(super) fn coefficient<'m>(
    mechanism: &Mechanism,
    graph: &'m Graph,
    bodies: &Multibody<'m>,
    equation: &Equation<'m>,
    unknown: &Unknown<'m>,
) -> Ex<'m> {
    let zero = graph.number(0.0);
    match (equation, unknown) {
        (Equation::Released(released), Unknown::Reaction(component)) => {
            if (released.joint, released.is_moment) == (component.joint, component.is_moment) {
                released.direction.dot(component.direction)
            } else {
                zero
            }
        }
        (Equation::Motion(way), Unknown::Reaction(component)) => {
            let work = work(graph, bodies, way, component);
            match cut_joints::joins(mechanism, &bodies.tree, component.joint, way.body) {
                1 => work,
                -1 => -work,
                _ => zero,
            }
        }
        (Equation::Motion(way), Unknown::Spin { rod, along }) if way.body == *rod => {
            way.direction.dot(*along)
        }
        (Equation::Motion(way), Unknown::Tie(tie)) if !way.slides => {
            let tree = &bodies.tree;
            let beyond = tie.couples.iter();
            let beyond = beyond.filter(|(body, _)| tree.hangs_on(Some(*body), way.body));
            let share = beyond.map(|(_, share)| share).sum();
            graph.number(share)
        }
        (Equation::Released(_) | Equation::Motion(_), Unknown::Spin { .. } | Unknown::Tie(_)) => {
            zero
        }
    }
}

/// The work of a reaction's component in a motion: `d . F`, `d . M`, `d . (r x F)`.
pub(super) fn work<'m>(
    graph: &'m Graph,
    bodies: &Multibody<'m>,
    way: &JointMotion<'m>,
    unknown: &Component<'m>,
) -> Ex<'m> {
    match (way.slides, unknown.is_moment) {
        (true, true) => graph.number(0.0),
        (true, false) | (false, true) => way.direction.dot(unknown.direction),
        (false, false) => {
            let arm = bodies.arm(way.body, bodies.geometry.points[unknown.joint]);
            way.direction.dot(arm.moment_of(unknown.direction))
        }
    }
}
