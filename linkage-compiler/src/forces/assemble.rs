//! The system of reactions, assembled from joints and free motions.
//!
//! A link that only a cut joint holds at its other end leaves one number of that joint's reaction
//! open, the force along the link (`links`).

use std::rc::Rc;

use linkage_symbolic::Vector;

use crate::forces::context::Mechanics;
use crate::forces::joint_motion::Motions;
use crate::forces::system::{Axial, Component, Equation, System, Unknown};
use crate::forces::{drives, equations, freedom, links};
use crate::model::Rotation;

/// The system, made when it is first asked for.
pub(super) fn system<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Rc<System<'m>> {
    if let Some(known) = &mechanics.forces.memo.system {
        return known.clone();
    }
    let plain = assembled(mechanics, Vec::new());
    let links = links::links(mechanics, &plain);
    let system = if links.is_empty() {
        plain
    } else {
        assembled(mechanics, links)
    };
    let system = Rc::new(system);
    mechanics.forces.memo.system = Some(system.clone());
    system
}

/// The system in which some links leave one number open.
pub(super) fn assembled<'m>(mechanics: &mut Mechanics<'_, 'm>, axial: Vec<Axial>) -> System<'m> {
    let (components, released) = reactions(mechanics, &axial);
    let held = components.len() - released.len() + axial.len();
    let Motions { free, driven, ties } = freedom::motions(mechanics, held);
    let mut unknowns: Vec<Unknown> = components.into_iter().map(Unknown::Reaction).collect();
    unknowns.extend(ties.into_iter().map(Unknown::Tie));
    unknowns.extend(spins(mechanics, &axial));
    let mut system = System {
        unknowns,
        driven,
        axial,
        ..System::default()
    };
    for component in released {
        equations::add(mechanics, &mut system, Equation::Released(component));
    }
    for way in free {
        if system.axial.iter().all(|link| link.link != way.body) {
            equations::add(mechanics, &mut system, Equation::Motion(way));
        }
    }
    system.order();
    drives::drive_steady(mechanics, &mut system);
    drives::release_held(mechanics, &mut system);
    system
}

/// Rods that may turn about themselves.
pub(super) fn spins<'m>(mechanics: &Mechanics<'_, 'm>, axial: &[Axial]) -> Vec<Unknown<'m>> {
    let mechanism = mechanics.algebra.mechanism;
    let rods = (0..mechanism.bodies.len()).filter(|&body| {
        let kind = mechanism.joints[mechanism.bodies[body].joint].kind;
        kind.rotation() == Rotation::Freely && axial.iter().all(|link| link.link != body)
    });
    let rods = rods.filter_map(|rod| {
        let along = mechanics.forces.bodies.geometry.rod(rod)?;
        Some(Unknown::Spin { rod, along })
    });
    rods.collect()
}

/// The components of the cut joints' reactions, and equations for those that are none.
pub(super) fn reactions<'m>(
    mechanics: &Mechanics<'_, 'm>,
    axial: &[Axial],
) -> (Vec<Component<'m>>, Vec<Component<'m>>) {
    let geometry = &mechanics.forces.bodies.geometry;
    let plane = geometry.is_plane();
    let (mut unknowns, mut equations) = (Vec::new(), Vec::new());
    for &joint in &mechanics.forces.bodies.tree.closing {
        let component = |is_moment| {
            move |direction| Component {
                joint,
                is_moment,
                direction,
            }
        };
        let [force, moment] = [false, true].map(component);
        if let Some(link) = axial.iter().find(|link| link.joint == joint) {
            unknowns.push(force(links::link_vector(mechanics, link)));
            continue;
        }
        let units = || geometry.units(mechanics.graph()).into_iter();
        let direction = geometry.directions[joint];
        match direction {
            Some(guide) if plane => {
                let normal = Vector([-guide.at(1), guide.at(0)]);
                unknowns.push(force(normal.into()));
            }
            _ => unknowns.extend(units().map(force)),
        }
        let kind = mechanics.algebra.mechanism.joints[joint].kind;
        match kind.rotation() {
            Rotation::Freely => {}
            Rotation::AboutAxis if plane => {}
            Rotation::Not if plane => {
                unknowns.push(moment(Vector([mechanics.algebra.one()]).into()))
            }
            Rotation::AboutAxis | Rotation::Not => unknowns.extend(units().map(moment)),
        }
        let Some(direction) = direction.filter(|_| !plane) else {
            continue;
        };
        if kind.slides() {
            equations.push(force(direction));
        }
        if kind.rotation() == Rotation::AboutAxis {
            equations.push(moment(direction));
        }
    }
    (unknowns, equations)
}
