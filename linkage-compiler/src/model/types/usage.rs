//! What loops, bodies and functions are written with.

use super::expression::{Expr, ExprKind, MechanicalQuantity};
use super::mechanics::{Between, Inertia};
use super::mechanism::{EvaluatorDef, Mechanism, Quantity};
use super::name::Name;
use crate::diagnostic::OriginId;

/// Names that loops are written with, directly or through derived quantities.
#[derive(Clone, Debug)]
pub(crate) struct Usage {
    pub(crate) lets: Vec<bool>,
    pub(crate) unknowns: Vec<bool>,
}

impl Mechanism {
    /// What some of the loops are written with, whether it cancels out there or not.
    pub(crate) fn usage(&self, loops: &[usize]) -> Usage {
        let mut usage = Usage {
            lets: vec![false; self.lets.len()],
            unknowns: vec![false; self.unknowns.len()],
        };
        for &number in loops {
            usage.mark(&self.loops[number].left);
            usage.mark(&self.loops[number].right);
        }
        for index in (0..usage.lets.len()).rev() {
            if usage.lets[index] {
                usage.mark(&self.lets[index].value);
            }
        }
        usage
    }
}

impl Mechanism {
    /// Whether an expression is written with one of these unknowns, directly or through derived quantities.
    pub(crate) fn mentions(&self, expr: &Expr, unknowns: &[usize]) -> bool {
        let mut names = expr.parts().filter_map(Expr::as_name);
        names.any(|name| match name {
            Name::Let(index) => self.mentions(&self.lets[index].value, unknowns),
            Name::Unknown(index) => unknowns.contains(&index),
            Name::Const(_) | Name::Parameter(_) | Name::Input(_) | Name::Argument(_) | Name::Pi => {
                false
            }
        })
    }

    /// All that bodies, joints and loads are written with.
    pub(crate) fn expressions_of_mechanics(&self) -> Vec<&Expr> {
        let mut all: Vec<&Expr> = self.gravity.iter().collect();
        for joint in &self.joints {
            all.push(&joint.at);
            all.extend(&joint.direction);
        }
        for body in &self.bodies {
            all.extend(&body.turns);
            all.extend(body.masses.iter().flat_map(|(mass, at)| [mass, at]));
            for (inertia, about) in &body.inertias {
                match inertia {
                    Inertia::Scalar(own) => all.push(own),
                    Inertia::Tensor(rows) => all.extend(rows.iter().flatten()),
                }
                all.extend(about);
            }
        }
        for load in &self.loads {
            all.push(&load.value);
            all.extend(&load.at);
        }
        for element in &self.elements {
            all.push(&element.value);
            all.extend(&element.free);
            if let Between::Points(ends) = &element.between {
                all.extend(ends.iter().map(|(_, at)| at));
            }
        }
        all
    }
}

impl Usage {
    fn mark(&mut self, expr: &Expr) {
        for name in expr.parts().filter_map(Expr::as_name) {
            match name {
                Name::Let(index) => self.lets[index] = true,
                Name::Unknown(index) => self.unknowns[index] = true,
                Name::Const(_)
                | Name::Parameter(_)
                | Name::Input(_)
                | Name::Argument(_)
                | Name::Pi => {}
            }
        }
    }
}

/// The picture that a function asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AskedPicture<'m> {
    /// Points that the user says to be links.
    pub(crate) links: &'m [Vec<Expr>],
    pub(crate) origin: OriginId,
}

impl EvaluatorDef {
    /// `None` if it asks for no picture.
    pub(crate) fn asked_picture(&self) -> Option<AskedPicture<'_>> {
        self.quantities
            .iter()
            .find_map(|own| match &own.value.kind {
                ExprKind::Picture(links) => Some(AskedPicture {
                    links,
                    origin: own.value.origin,
                }),
                _ => None,
            })
    }

    /// Whether it asks for a reaction or moment of a joint.
    /// Whether it asks for forces, or for a picture: what is known of bodies, too.
    pub(crate) fn asks_of_bodies(&self) -> bool {
        let values = self.quantities.iter().map(|own| &own.value);
        values
            .flat_map(Expr::parts)
            .any(|part| matches!(part.kind, ExprKind::Mechanics(_) | ExprKind::Picture(_)))
    }

    pub(crate) fn asks_for_reactions(&self) -> bool {
        self.quantities
            .iter()
            .any(|quantity| has_reactions(&quantity.value))
    }
}

impl Quantity {
    pub(crate) fn is_picture(&self) -> bool {
        matches!(self.value.kind, ExprKind::Picture(_))
    }
}

fn has_reactions(value: &Expr) -> bool {
    value.parts().any(|part| match &part.kind {
        ExprKind::Mechanics(quantity) => quantity.is_of_joints(),
        _ => false,
    })
}

impl MechanicalQuantity {
    /// Whether it is what a joint transmits.
    fn is_of_joints(&self) -> bool {
        match self {
            MechanicalQuantity::Reaction(_) | MechanicalQuantity::Moment(_) => true,
            MechanicalQuantity::Drive(_)
            | MechanicalQuantity::Power
            | MechanicalQuantity::KineticEnergy
            | MechanicalQuantity::PotentialEnergy
            | MechanicalQuantity::ShakingForce
            | MechanicalQuantity::ShakingMoment(_) => false,
        }
    }
}
