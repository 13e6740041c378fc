//! The system of reactions, assembled from joints and free motions.
//!
//! A link that only a cut joint holds at its other end leaves one number of that joint's reaction
//! open, the force along the link (`links`).

use std::rc::Rc;

use linkage_symbolic::{Graph, Vector};

use crate::algebra::Algebra;
use crate::forces::context::Memo;
use crate::forces::geometry::Geometry;
use crate::forces::joint_motion::Motions;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::AngularVelocities;
use crate::forces::system::{Axial, Component, Equation, System, Unknown};
use crate::forces::{drives, equations, freedom, links};
use crate::model::{Mechanism, Rotation};

/// The system, made when it is first asked for.
pub(super) fn system<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
) -> Rc<System<'m>> {
    if let Some(known) = &memo.system {
        return known.clone();
    }
    let plain = assembled(algebra, bodies, &mut memo.turns, Vec::new());
    let links = links::links(algebra.mechanism, bodies, &plain);
    let system = if links.is_empty() {
        plain
    } else {
        assembled(algebra, bodies, &mut memo.turns, links)
    };
    let system = Rc::new(system);
    memo.system = Some(system.clone());
    system
}

/// The system in which some links leave one number open.
pub(super) fn assembled<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    axial: Vec<Axial>,
) -> System<'m> {
    let (components, released) = reactions(algebra.mechanism, algebra.graph, bodies, &axial);
    let held = components.len() - released.len() + axial.len();
    let Motions { free, driven, ties } = freedom::motions(algebra, bodies, turns, held);
    let mut unknowns: Vec<Unknown> = components.into_iter().map(Unknown::Reaction).collect();
    unknowns.extend(ties.into_iter().map(Unknown::Tie));
    unknowns.extend(spins(algebra.mechanism, &bodies.geometry, &axial));
    let mut system = System {
        unknowns,
        driven,
        axial,
        ..System::default()
    };
    for component in released {
        equations::add(
            algebra.mechanism,
            algebra.graph,
            bodies,
            &mut system,
            Equation::Released(component),
        );
    }
    for way in free {
        if system.axial.iter().all(|link| link.link != way.body) {
            equations::add(
                algebra.mechanism,
                algebra.graph,
                bodies,
                &mut system,
                Equation::Motion(way),
            );
        }
    }
    system.order();
    drives::drive_steady(&bodies.facts.steady, &mut system);
    drives::release_held(algebra.mechanism, algebra.graph, bodies, &mut system);
    system
}

/// Rods that may turn about themselves.
pub(super) fn spins<'m>(
    mechanism: &Mechanism,
    geometry: &Geometry<'m>,
    axial: &[Axial],
) -> Vec<Unknown<'m>> {
    let rods = (0..mechanism.bodies.len()).filter(|&body| {
        let kind = mechanism.joints[mechanism.bodies[body].joint].kind;
        kind.rotation() == Rotation::Freely && axial.iter().all(|link| link.link != body)
    });
    let rods = rods.filter_map(|rod| {
        let along = geometry.rod(rod)?;
        Some(Unknown::Spin { rod, along })
    });
    rods.collect()
}

/// The components of the cut joints' reactions, and equations for those that are none.
pub(super) fn reactions<'m>(
    mechanism: &Mechanism,
    graph: &'m Graph,
    bodies: &Multibody<'m>,
    axial: &[Axial],
) -> (Vec<Component<'m>>, Vec<Component<'m>>) {
    let geometry = &bodies.geometry;
    let plane = geometry.is_plane();
    let (mut unknowns, mut equations) = (Vec::new(), Vec::new());
    for &joint in &bodies.tree.closing {
        let component = |is_moment| {
            move |direction| Component {
                joint,
                is_moment,
                direction,
            }
        };
        let [force, moment] = [false, true].map(component);
        if let Some(link) = axial.iter().find(|link| link.joint == joint) {
            unknowns.push(force(links::link_vector(bodies, link)));
            continue;
        }
        let units = || geometry.units(graph).into_iter();
        let direction = geometry.directions[joint];
        match direction {
            Some(guide) if plane => {
                let normal = Vector([-guide.at(1), guide.at(0)]);
                unknowns.push(force(normal.into()));
            }
            _ => unknowns.extend(units().map(force)),
        }
        let kind = mechanism.joints[joint].kind;
        match kind.rotation() {
            Rotation::Freely => {}
            Rotation::AboutAxis if plane => {}
            Rotation::Not if plane => unknowns.push(moment(Vector([graph.number(1.0)]).into())),
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
