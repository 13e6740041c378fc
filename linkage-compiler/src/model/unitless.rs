//! Numbers without a unit that are used as lengths: reported where they are declared, not where dimensions differ.
//!
//! Where a number meets a length, the declarations without a unit that the number comes from are suspects. If the mechanism has fewer
//! mistakes with suspects as lengths, their units are what is missing.

use std::ops::RangeInclusive;

use super::library::Source;
use super::names::Resolver;
use super::types::{BinaryOp, Dimension, Expr, ExprKind, Name, Type};
use super::zeros::{self, Attempt, Zeros, attempt};
use crate::diagnostic::{Diagnostics, SourceSpan};

/// A vector of such a length may well be a direction, which is a vector of numbers: estimates of directions are rough.
const LENGTHS_OF_DIRECTIONS: RangeInclusive<f64> = 0.5..=2.0;

/// What a name was declared as: numbers without a unit.
#[derive(Clone)]
pub(super) struct Unitless {
    pub(super) name: Name,
    text: String,
    /// As it is written, and as it is with a unit of length.
    number: String,
    length: String,
    /// What else is declared with it and lacks the unit.
    beside: Option<&'static str>,
    span: SourceSpan,
}

/// The attempt to resolve a mechanism whose mistakes say most.
pub(super) fn best_attempt(source: &Source) -> Attempt {
    let best = zeros::best_attempt(source, &[]);
    let lengths = suspected(source, &best);
    if lengths.is_empty() {
        return best;
    }
    let with_units = zeros::best_attempt(source, &lengths);
    if with_units.diagnostics.len() >= best.diagnostics.len() {
        return best;
    }
    without_needless(source, lengths, with_units).told()
}

/// All names that may lack a unit of length, those too that are noticed only when others have one.
fn suspected(source: &Source, first: &Attempt) -> Vec<Name> {
    let mut lengths: Vec<Name> = Vec::new();
    let mut suspects = first.suspects.clone();
    loop {
        suspects.retain(|name| !lengths.contains(name));
        suspects.sort_unstable();
        suspects.dedup();
        if suspects.is_empty() {
            return lengths;
        }
        lengths.append(&mut suspects);
        suspects = attempt(source, Zeros::lengths(&lengths)).suspects;
    }
}

/// The attempt with those lengths alone that lessen the mistakes.
fn without_needless(source: &Source, mut lengths: Vec<Name>, mut best: Attempt) -> Attempt {
    for name in lengths.clone() {
        let fewer: Vec<Name> = lengths.iter().copied().filter(|own| *own != name).collect();
        let other = zeros::best_attempt(source, &fewer);
        if other.diagnostics.len() <= best.diagnostics.len() {
            (lengths, best) = (fewer, other);
        }
    }
    best
}

impl Attempt {
    /// With messages at the numbers that it took for lengths.
    fn told(mut self) -> Attempt {
        let mut told = Diagnostics::default();
        for own in self
            .unitless
            .iter()
            .filter(|own| self.zeros.lengths.contains(&own.name))
        {
            let Unitless {
                text,
                number,
                length,
                ..
            } = own;
            let fact = format!("`{number}` has no unit, but `{text}` is used as a length");
            let help = match own.beside {
                Some(beside) => format!("write `{length}`, and give {beside} a unit, too"),
                None => format!("write `{length}`"),
            };
            told.error_with_help(own.span, fact, help);
        }
        told.append(self.diagnostics);
        self.diagnostics = told;
        self
    }
}

impl Resolver<'_> {
    /// Remembers of a declared value whether its unit may be missing, or whose.
    pub(super) fn note_unitless(&mut self, name: Name, value: &Expr, beside: Option<&'static str>) {
        let lacking = match value.with_unit(self.unit.name()) {
            Some(length) => {
                let text = self.symbols.iter().find(|symbol| symbol.name == name);
                self.unitless.push(Unitless {
                    name,
                    text: text.map_or_else(String::new, |symbol| symbol.text.clone()),
                    number: value.with_unit("").unwrap_or_default(),
                    length,
                    beside,
                    span: self.origins.span(value.origin),
                });
                vec![name]
            }
            None => self.lacking_unit(value),
        };
        if !lacking.is_empty() {
            self.lacking.insert(name, lacking);
        }
    }

    /// Who may lack a unit, if one of two values is a number and the other made of lengths.
    pub(super) fn suspect(&mut self, left: &Expr, right: &Type) {
        let number = |ty: &Type| ty.dimension() == Some(Dimension::NUMBER);
        let length = |ty: &Type| {
            let dimension = ty.dimension().filter(|own| own.is_geometric());
            dimension.is_some_and(|own| own.half_lengths > 0)
        };
        if number(&left.ty) && length(right) {
            let lacking = self.lacking_unit(left);
            self.suspects.extend(lacking);
        }
    }

    /// See [`suspect`](Self::suspect), both ways.
    pub(super) fn suspect_both(&mut self, left: &Expr, right: &Expr) {
        self.suspect(left, &right.ty);
        self.suspect(right, &left.ty);
    }

    /// Names declared without a unit that a number would have its dimension from.
    fn lacking_unit(&self, value: &Expr) -> Vec<Name> {
        let of_all = |values: &mut dyn Iterator<Item = &Expr>| {
            let mut all: Vec<Name> = values.flat_map(|own| self.lacking_unit(own)).collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        match &value.kind {
            ExprKind::Name(name) => self.lacking.get(name).cloned().unwrap_or_default(),
            ExprKind::Negate(own) | ExprKind::Component(own, _) => self.lacking_unit(own),
            ExprKind::Vector(components) => of_all(&mut components.iter()),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
                of_all(&mut [&**a, &**b].into_iter())
            }
            ExprKind::Binary(BinaryOp::Mul, a, b) => {
                let [a, b] = [a, b].map(|own| self.lacking_unit(own));
                match (a.is_empty(), b.is_empty()) {
                    (true, _) => b,
                    (_, true) => a,
                    // A square; of different factors, nobody knows which is the length.
                    _ if a == b => a,
                    _ => Vec::new(),
                }
            }
            ExprKind::Binary(BinaryOp::Div, a, _) => self.lacking_unit(a),
            ExprKind::Call(function, arguments) => {
                let measured = function.measured_arguments().iter();
                of_all(&mut measured.map(|place| &arguments[*place]))
            }
            // A literal has no declaration, and the others are no numbers by a missing unit.
            _ => Vec::new(),
        }
    }
}

impl Expr {
    /// A number without a unit, or a vector of such and zeros that is no direction, written with one.
    fn with_unit(&self, unit: &str) -> Option<String> {
        if let Some(number) = self.bare_number() {
            return Some(format!("{number}{unit}"));
        }
        let ExprKind::Vector(components) = &self.kind else {
            return None;
        };
        let zero = |own: &Expr| matches!(own.kind, ExprKind::Number(0.0));
        let numbers = components.iter().map(|own| match zero(own) {
            true => Some(0.0),
            false => own.bare_number(),
        });
        let numbers: Vec<f64> = numbers.collect::<Option<_>>()?;
        let length = numbers
            .iter()
            .fold(0.0, |length: f64, own| length.hypot(*own));
        if length == 0.0 || LENGTHS_OF_DIRECTIONS.contains(&length) {
            return None;
        }
        let written = numbers.iter().map(|number| match number {
            0.0 => "0".to_owned(),
            number => format!("{number}{unit}"),
        });
        let written: Vec<String> = written.collect();
        Some(format!("({})", written.join(", ")))
    }
}
