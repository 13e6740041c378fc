//! Units of numbers: the length unit of the mechanism, and numbers without a unit.

use std::collections::BTreeMap;

use super::zeros::Zeros;
use crate::diagnostic::SourceSpan;
use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, LengthUnit, Name, Type};

/// A name that was declared by numbers without a unit.
#[derive(Clone)]
pub(in crate::model) struct Unitless {
    pub(in crate::model) name: Name,
    pub(in crate::model) text: String,
    /// The number as it is written.
    pub(in crate::model) number: String,
    /// The number with a unit of length.
    pub(in crate::model) length: String,
    /// Another part of the declaration that lacks the unit, too.
    pub(in crate::model) beside: Option<&'static str>,
    pub(in crate::model) span: SourceSpan,
}

/// The units in which numbers are read.
pub(in crate::model) struct AssumedUnits {
    pub(in crate::model) length: LengthUnit,
    /// Names whose number without a unit is taken for a length, and unknowns that are taken for
    /// vectors.
    pub(in crate::model) zeros: Zeros,
    /// Names declared by numbers without a unit.
    pub(in crate::model) unitless: Vec<Unitless>,
    /// For each name, those names declared without a unit that it has its dimension from.
    lacking: BTreeMap<Name, Vec<Name>>,
}

impl AssumedUnits {
    /// Starts without declarations; lengths are in metres until the `unit` item is read.
    pub(in crate::model) fn new(zeros: Zeros) -> Self {
        Self {
            length: LengthUnit::Metre,
            zeros,
            unitless: Vec::new(),
            lacking: BTreeMap::new(),
        }
    }

    /// Returns the type of a declared value: a number without a unit is a number or a length.
    pub(in crate::model) fn declared(&self, name: Name, ty: &Type) -> Type {
        if self.is_taken_for_length(name) {
            ty.with(Dimension::LENGTH)
        } else {
            ty.settled()
        }
    }

    /// Returns true if the number without a unit of this name is taken for a length.
    pub(in crate::model) fn is_taken_for_length(&self, name: Name) -> bool {
        self.zeros.lengths.contains(&name)
    }

    /// Stores the names that a declared value would have its dimension from.
    pub(in crate::model) fn set_lacking(&mut self, name: Name, lacking: Vec<Name>) {
        if !lacking.is_empty() {
            self.lacking.insert(name, lacking);
        }
    }

    /// Returns the names declared without a unit that a number would have its dimension from.
    pub(in crate::model) fn lacking_unit(&self, value: &Expr) -> Vec<Name> {
        let of_all = |values: &mut dyn Iterator<Item = &Expr>| {
            let mut names: Vec<Name> = values
                .flat_map(|operand| self.lacking_unit(operand))
                .collect();
            names.sort_unstable();
            names.dedup();
            names
        };
        match &value.kind {
            ExprKind::Name(name) => self.lacking.get(name).cloned().unwrap_or_default(),
            ExprKind::Negate(operand) | ExprKind::Component(operand, _) => {
                self.lacking_unit(operand)
            }
            ExprKind::Vector(components) => of_all(&mut components.iter()),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
                of_all(&mut [&**a, &**b].into_iter())
            }
            ExprKind::Binary(BinaryOp::Mul, a, b) => {
                let [a, b] = [a, b].map(|operand| self.lacking_unit(operand));
                match (a.is_empty(), b.is_empty()) {
                    (true, _) => b,
                    (_, true) => a,
                    // This is a square. Of different factors, any could be the length.
                    _ if a == b => a,
                    _ => Vec::new(),
                }
            }
            ExprKind::Binary(BinaryOp::Div, a, _) => self.lacking_unit(a),
            ExprKind::Call(function, arguments) => {
                let measured = function.measured_arguments().iter();
                of_all(&mut measured.map(|index| &arguments[*index]))
            }
            // A literal has no declaration, and the others are no numbers by a missing unit.
            _ => Vec::new(),
        }
    }
}
