//! The reactions of cut joints from the motions of the tree's joints: a linear system, in small groups.
//!
//! Each free motion gives an equation: the bodies beyond the joint carry no moment about its axis, no force along its guide. Which
//! equation finds which reaction is found by matching, as for the loops; what must be solved together is solved by cofactors, without
//! a choice of pivots. A link that only a cut joint holds at its other end leaves one number of that joint's reaction open, the force
//! along the link (`links`).

use crate::forces::drives;
use crate::forces::freedom;
use crate::forces::links;
use crate::forces::wrench;
use std::rc::Rc;

use linkage_symbolic::{Ex, Vector, Vn};

use crate::structure::matching::{self, Matching};

use super::Mechanics;
use super::freedom::{Motions, Tie, Way};
use super::geometry::{Turns, slides_along, turns_of};
use super::links::Axial;

/// A number to be found.
#[derive(Clone, Debug)]
pub(super) enum Unknown<'m> {
    Reaction(Component<'m>),
    /// The couple of a tie.
    Tie(Tie),
    /// A couple along a rod between ball joints. It is zero, and makes one equation too many three for three.
    Spin {
        rod: usize,
        along: Vn<'m>,
    },
}

/// A component of a cut joint's reaction on the joint's body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Component<'m> {
    pub(super) joint: usize,
    pub(super) is_moment: bool,
    pub(super) direction: Vn<'m>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Equation<'m> {
    /// No work in a free motion.
    Motion(Way<'m>),
    /// What a cut joint does not transmit.
    Released(Component<'m>),
}

#[derive(Clone, Debug, Default)]
pub(super) struct System<'m> {
    pub(super) unknowns: Vec<Unknown<'m>>,
    pub(super) equations: Vec<Equation<'m>>,
    /// What drives move.
    pub(super) driven: Vec<Way<'m>>,
    pub(super) axial: Vec<Axial>,
    pub(super) matrix: Vec<Vec<Ex<'m>>>,
    pub(super) matching: Matching,
    /// The unknowns that each equation contains.
    pub(super) incidence: Vec<Vec<usize>>,
    /// Equations that are solved together.
    pub(super) blocks: Vec<Vec<usize>>,
}

/// Up to this many equations are solved at once: cofactors double with each one more.
pub(super) const LARGEST_BLOCK: usize = 6;

/// From this size on links are taken out of a block: a dyad, which no link makes smaller, has two equations.
const LARGE: usize = 3;

/// The system, made when it is first asked for.
pub(super) fn system<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Rc<System<'m>> {
    if let Some(known) = &mechanics.forces.system {
        return known.clone();
    }
    let plain = assembled(mechanics, Vec::new());
    let links = links::links(mechanics, &plain);
    let system = match links.is_empty() {
        true => plain,
        false => assembled(mechanics, links),
    };
    let system = Rc::new(system);
    mechanics.forces.system = Some(system.clone());
    system
}

/// The system in which some links leave one number open.
fn assembled<'m>(mechanics: &mut Mechanics<'_, 'm>, axial: Vec<Axial>) -> System<'m> {
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
        add(mechanics, &mut system, Equation::Released(component));
    }
    for way in free {
        if system.axial.iter().all(|own| own.link != way.body) {
            add(mechanics, &mut system, Equation::Motion(way));
        }
    }
    system.order();
    drives::drive_steady(mechanics, &mut system);
    drives::release_held(mechanics, &mut system);
    system
}

/// Rods that may turn about themselves.
fn spins<'m>(mechanics: &Mechanics<'_, 'm>, axial: &[Axial]) -> Vec<Unknown<'m>> {
    let mechanism = mechanics.algebra.mechanism;
    let rods = (0..mechanism.bodies.len()).filter(|&body| {
        let kind = mechanism.joints[mechanism.bodies[body].joint].kind;
        turns_of(kind) == Turns::Freely && axial.iter().all(|own| own.link != body)
    });
    let rods = rods.filter_map(|rod| {
        let along = mechanics.forces.geometry.rod(rod)?;
        Some(Unknown::Spin { rod, along })
    });
    rods.collect()
}

/// Adds an equation, with a coefficient for each unknown.
pub(super) fn add<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    system: &mut System<'m>,
    equation: Equation<'m>,
) {
    let unknowns = system.unknowns.iter();
    let row: Vec<Ex> = unknowns
        .map(|unknown| coefficient(mechanics, &equation, unknown))
        .collect();
    let entries = (0..row.len()).filter(|&k| !row[k].is_zero());
    system.incidence.push(entries.collect());
    system.equations.push(equation);
    system.matrix.push(row);
}

/// The components of the cut joints' reactions, and equations for those that are none.
fn reactions<'m>(
    mechanics: &Mechanics<'_, 'm>,
    axial: &[Axial],
) -> (Vec<Component<'m>>, Vec<Component<'m>>) {
    let geometry = &mechanics.forces.geometry;
    let plane = geometry.is_plane();
    let (mut unknowns, mut equations) = (Vec::new(), Vec::new());
    for &joint in &mechanics.forces.tree.closing {
        let component = |is_moment| {
            move |direction| Component {
                joint,
                is_moment,
                direction,
            }
        };
        let [force, moment] = [false, true].map(component);
        if let Some(own) = axial.iter().find(|own| own.joint == joint) {
            unknowns.push(force(links::link_vector(mechanics, own)));
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
        match turns_of(kind) {
            Turns::Freely => {}
            Turns::AboutAxis if plane => {}
            Turns::Not if plane => unknowns.push(moment(Vector([mechanics.algebra.one()]).into())),
            Turns::AboutAxis | Turns::Not => unknowns.extend(units().map(moment)),
        }
        let Some(direction) = direction.filter(|_| !plane) else {
            continue;
        };
        if slides_along(kind) {
            equations.push(force(direction));
        }
        if turns_of(kind) == Turns::AboutAxis {
            equations.push(moment(direction));
        }
    }
    (unknowns, equations)
}

/// How much of an unknown is in an equation.
fn coefficient<'m>(
    mechanics: &Mechanics<'_, 'm>,
    equation: &Equation<'m>,
    unknown: &Unknown<'m>,
) -> Ex<'m> {
    let zero = mechanics.algebra.zero();
    match (equation, unknown) {
        (Equation::Released(released), Unknown::Reaction(own)) => {
            match (released.joint, released.is_moment) == (own.joint, own.is_moment) {
                true => released.direction.dot(own.direction),
                false => zero,
            }
        }
        (Equation::Motion(way), Unknown::Reaction(own)) => {
            let work = work(mechanics, way, own);
            match wrench::joins(mechanics, own.joint, way.body) {
                1 => work,
                -1 => -work,
                _ => zero,
            }
        }
        (Equation::Motion(way), Unknown::Spin { rod, along }) if way.body == *rod => {
            way.direction.dot(*along)
        }
        (Equation::Motion(way), Unknown::Tie(tie)) if !way.slides => {
            let tree = &mechanics.forces.tree;
            let beyond = tie.couples.iter();
            let beyond = beyond.filter(|(body, _)| tree.hangs_on(Some(*body), way.body));
            let share = beyond.map(|(_, share)| share).sum();
            mechanics.graph().number(share)
        }
        (Equation::Released(_) | Equation::Motion(_), Unknown::Spin { .. } | Unknown::Tie(_)) => {
            zero
        }
    }
}

/// The work of a reaction's component in a motion: `d . F`, `d . M`, `d . (r x F)`.
fn work<'m>(mechanics: &Mechanics<'_, 'm>, way: &Way<'m>, unknown: &Component<'m>) -> Ex<'m> {
    match (way.slides, unknown.is_moment) {
        (true, true) => mechanics.algebra.zero(),
        (true, false) | (false, true) => way.direction.dot(unknown.direction),
        (false, false) => {
            let arm = mechanics.arm(way.body, mechanics.forces.geometry.points[unknown.joint]);
            way.direction.dot(arm.moment_of(unknown.direction))
        }
    }
}

impl<'m> Equation<'m> {
    /// The motion, if it is about one.
    pub(super) fn way(&self) -> Option<&Way<'m>> {
        match self {
            Equation::Motion(way) => Some(way),
            Equation::Released(_) => None,
        }
    }
}

impl Unknown<'_> {
    /// The joint whose reaction it belongs to, if it does.
    pub(super) fn joint(&self) -> Option<usize> {
        match self {
            Unknown::Reaction(own) => Some(own.joint),
            Unknown::Tie(_) | Unknown::Spin { .. } => None,
        }
    }
}

impl<'m> System<'m> {
    /// The rows of equations that are solved together, by the unknowns that they find.
    pub(super) fn matrix_of(&self, block: &[usize]) -> Vec<Vec<Ex<'m>>> {
        let own = self.unknowns_of(block);
        let rows = block.iter();
        rows.map(|&equation| own.iter().map(|&k| self.matrix[equation][k]).collect())
            .collect()
    }

    /// Which equation finds which unknown, and in which order.
    pub(super) fn order(&mut self) {
        let rows = vec![1; self.equations.len()];
        self.matching = matching::maximum(&rows, &self.incidence, self.unknowns.len());
        self.blocks = matching::components(&self.incidence, &self.matching);
    }

    /// How many unknowns have an equation.
    pub(super) fn found(&self) -> usize {
        self.matching.equation_of.iter().flatten().count()
    }

    /// The unknowns that a block finds.
    pub(super) fn unknowns_of(&self, block: &[usize]) -> Vec<usize> {
        let found = block.iter().map(|&e| &self.matching.coordinates_of[e]);
        found.flatten().copied().collect()
    }

    /// True if some have none.
    pub(super) fn lacks_equations(&self) -> bool {
        self.found() < self.unknowns.len()
    }

    /// True if gears act on a body.
    pub(super) fn ties(&self, body: usize) -> bool {
        self.unknowns.iter().any(|unknown| match unknown {
            Unknown::Tie(tie) => tie.couples.iter().any(|(own, _)| *own == body),
            Unknown::Reaction(_) | Unknown::Spin { .. } => false,
        })
    }

    /// True if a reaction is found together with many others, by an equation of the body's own motion.
    pub(super) fn in_large_block(&self, joint: usize, body: usize) -> bool {
        let large = self.blocks.iter().filter(|block| block.len() >= LARGE);
        let mut equations = large.flatten().map(|&equation| &self.equations[equation]);
        let unknown =
            |equation: &Equation| matches!(equation, Equation::Motion(way) if way.body == body);
        equations.any(unknown) && self.unknowns.iter().any(|own| own.joint() == Some(joint))
    }
}
