//! The bodies with the results that are known already, and the question of a function.

use std::rc::Rc;

use linkage_symbolic::Ex;
use linkage_symbolic::lookup::Map;

use crate::algebra::Algebra;
use crate::forces::body_loads::Loads;
use crate::forces::loading::Loading;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::system::System;
use crate::forces::wrench::{Carried, Wrench};
use crate::model::Mechanism;

/// The bodies, and the results that were computed for functions. The default is for functions that
/// ask for none.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forces<'m> {
    pub(super) bodies: Multibody<'m>,
    pub(super) memo: Memo<'m>,
}

/// Results that were computed already.
#[derive(Clone, Debug, Default)]
pub(super) struct Memo<'m> {
    pub(super) turns: AngularVelocities<'m>,
    pub(super) system: Option<Rc<System<'m>>>,
    /// Entries of the mass matrix, by their inputs in order.
    pub(super) inertias: Map<[usize; 2], Ex<'m>>,
    /// The accelerations of all inputs without drives, for each set of speeds.
    pub(super) driven: Map<Speeds, Rc<Vec<Ex<'m>>>>,
    /// The contact forces of joints with friction, for each set of speeds.
    pub(super) contact_forces: Map<Speeds, Rc<Vec<Ex<'m>>>>,
    /// The forces of each set of loads.
    pub(super) cases: Map<Loading, Case<'m>>,
}

/// The forces of some loads.
#[derive(Clone, Debug)]
pub(super) struct Case<'m> {
    pub(super) loads: Rc<Loads<'m>>,
    pub(super) wrenches: Map<Carried, Wrench<'m>>,
    /// Unknowns of the system that are known already.
    pub(super) solved: Map<usize, Ex<'m>>,
}

/// The speeds that a function lists, and the reactions that it asks for.
pub(crate) struct Question {
    pub(super) speeds: Speeds,
    /// True if reactions are asked for: then drives are found from the joints, too.
    pub(super) with_reactions: bool,
}

impl<'m> Forces<'m> {
    /// Nothing is computed yet but the geometry.
    pub(crate) fn new(algebra: &mut Algebra<'m>) -> Self {
        Self {
            bodies: Multibody::new(algebra),
            memo: Memo::default(),
        }
    }

    /// Forgets all that was made of derivatives.
    pub(crate) fn forget_derivatives(&mut self) {
        self.memo = Memo::default();
    }
}

impl Question {
    /// For a function that lists these inputs and arguments: speeds that it does not list are zero.
    pub(crate) fn new(mechanism: &Mechanism, listed: &[usize], with_reactions: bool) -> Self {
        Self {
            speeds: Speeds::listed(mechanism, listed),
            with_reactions,
        }
    }
}
