//! Names that loops, bodies and functions contain.

use std::collections::BTreeSet;

use super::expression::{Expr, ExprKind, MechanicalQuantity};
use super::function_words::Function;
use super::mechanics::{Between, Contact, Inertia};
use super::mechanism::{EvaluatorDef, Mechanism, Quantity};
use super::name::Name;
use crate::diagnostic::OriginId;

/// Names that loops are written with, directly or through derived quantities.
#[derive(Clone, Debug)]
pub struct Usage {
    pub lets: Vec<bool>,
    pub unknowns: Vec<bool>,
}

impl Mechanism {
    /// Returns the names in some of the loops, even if they cancel out.
    pub fn usage(&self, loops: &[usize]) -> Usage {
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
    /// Returns true if an expression contains one of these unknowns, directly or through derived
    /// quantities.
    pub fn mentions(&self, expr: &Expr, unknowns: &[usize]) -> bool {
        let mut names = expr.parts().filter_map(Expr::as_name);
        names.any(|name| match name {
            Name::Let(index) => self.mentions(&self.lets[index].value, unknowns),
            Name::Unknown(index) => unknowns.contains(&index),
            Name::Const(_) | Name::Parameter(_) | Name::Input(_) | Name::Argument(_) | Name::Pi => {
                false
            }
        })
    }

    /// Returns the parameters that are lengths of links: `polar(crank, phi)` with an angle that is an
    /// input or an unknown. An offset, as in `polar(offset, theta + 90deg)`, may be negative.
    pub fn link_lengths(&self) -> BTreeSet<usize> {
        let loops = self.loops.iter();
        let sides = loops.flat_map(|equation| [&equation.left, &equation.right]);
        let lets = self.lets.iter().map(|item| &item.value);
        let parts = lets.chain(sides).flat_map(Expr::parts);
        let lengths = parts.filter_map(|part| match &part.kind {
            ExprKind::Call(Function::Polar, arguments) => {
                match (arguments[0].as_name()?, arguments[1].as_name()?) {
                    (Name::Parameter(index), Name::Input(_) | Name::Unknown(_)) => Some(index),
                    _ => None,
                }
            }
            _ => None,
        });
        lengths.collect()
    }

    /// All that bodies, joints and loads are written with.
    pub fn expressions_of_mechanics(&self) -> Vec<&Expr> {
        let mut values: Vec<&Expr> = self.gravity.iter().collect();
        for joint in &self.joints {
            values.push(&joint.at);
            values.extend(&joint.direction);
        }
        for body in &self.bodies {
            values.extend(&body.turns);
            values.extend(body.masses.iter().flat_map(|(mass, at)| [mass, at]));
            for (inertia, about) in &body.inertias {
                match inertia {
                    Inertia::Scalar(value) => values.push(value),
                    Inertia::Tensor(rows) => values.extend(rows.iter().flatten()),
                }
                values.extend(about);
            }
        }
        for load in &self.loads {
            values.push(&load.value);
            values.extend(&load.at);
        }
        for element in &self.elements {
            values.push(&element.value);
            values.extend(&element.free);
            if let Between::Points(ends) = &element.between {
                values.extend(ends.iter().map(|(_, at)| at));
            }
        }
        for friction in &self.frictions {
            values.push(&friction.coefficient);
            match &friction.contact {
                Contact::Pin(radius) => values.push(radius),
                Contact::Guide(length) => values.extend(length),
            }
        }
        values
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

/// The picture of a function.
#[derive(Clone, Copy, Debug)]
pub struct AskedPicture<'m> {
    /// Points that the user joins to links.
    pub links: &'m [Vec<Expr>],
    pub origin: OriginId,
}

impl EvaluatorDef {
    /// Returns `None` for a function without a picture.
    pub fn asked_picture(&self) -> Option<AskedPicture<'_>> {
        self.quantities
            .iter()
            .find_map(|quantity| match &quantity.value.kind {
                ExprKind::Picture(links) => Some(AskedPicture {
                    links,
                    origin: quantity.value.origin,
                }),
                _ => None,
            })
    }

    /// Returns true for a function with forces or with a picture, which depend on bodies.
    pub fn asks_of_bodies(&self) -> bool {
        let values = self.quantities.iter().map(|quantity| &quantity.value);
        values
            .flat_map(Expr::parts)
            .any(|part| matches!(part.kind, ExprKind::Mechanics(_) | ExprKind::Picture(_)))
    }

    pub fn asks_for_reactions(&self) -> bool {
        self.quantities
            .iter()
            .any(|quantity| has_reactions(&quantity.value))
    }

    /// Returns true if friction, where there is any, changes a quantity of the function.
    pub fn asks_for_friction(&self) -> bool {
        let mut parts = self
            .quantities
            .iter()
            .flat_map(|quantity| quantity.value.parts());
        parts.any(|part| match &part.kind {
            ExprKind::Mechanics(quantity) => quantity.depends_on_friction(),
            _ => false,
        })
    }
}

impl Quantity {
    pub fn is_picture(&self) -> bool {
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
    /// Returns true for a quantity that friction changes.
    fn depends_on_friction(&self) -> bool {
        match self {
            MechanicalQuantity::Reaction(_)
            | MechanicalQuantity::Moment(_)
            | MechanicalQuantity::Drive(_)
            | MechanicalQuantity::Power
            | MechanicalQuantity::FrictionPower
            | MechanicalQuantity::Efficiency
            | MechanicalQuantity::GeneralisedForce(_)
            | MechanicalQuantity::DrivenAcceleration(_) => true,
            MechanicalQuantity::KineticEnergy
            | MechanicalQuantity::PotentialEnergy
            | MechanicalQuantity::ShakingForce
            | MechanicalQuantity::ShakingMoment(_)
            | MechanicalQuantity::Inertia(_)
            | MechanicalQuantity::MassMatrix(_)
            | MechanicalQuantity::Bias(_) => false,
        }
    }

    /// Returns true for a quantity that a joint transmits.
    fn is_of_joints(&self) -> bool {
        match self {
            MechanicalQuantity::Reaction(_) | MechanicalQuantity::Moment(_) => true,
            MechanicalQuantity::Drive(_)
            | MechanicalQuantity::Power
            | MechanicalQuantity::FrictionPower
            | MechanicalQuantity::Efficiency
            | MechanicalQuantity::KineticEnergy
            | MechanicalQuantity::PotentialEnergy
            | MechanicalQuantity::ShakingForce
            | MechanicalQuantity::ShakingMoment(_)
            | MechanicalQuantity::Inertia(_)
            | MechanicalQuantity::MassMatrix(_)
            | MechanicalQuantity::Bias(_)
            | MechanicalQuantity::GeneralisedForce(_)
            | MechanicalQuantity::DrivenAcceleration(_) => false,
        }
    }
}
