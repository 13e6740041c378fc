//! The drawing: positions of joints at the reference, as expressions of numbers and as numbers.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::linkage::Linkage;
use super::nodes::{difference, name};
use crate::syntax::{
    BinaryOp, Expr, ExprKind, Item, LinkedItem, MechanismDef, Toleranced, find_unit,
};

/// Nested names and operations of a drawn position: more are a mistake, or a circle of names.
const DEPTH: usize = 64;

/// A drawing that is further from the reference of an input than this, in radians or as a part of
/// the length, is a mistake.
pub(super) const DRAWN_APART: f64 = 0.02;

pub(super) struct Drawing {
    values: Values,
    /// The position of each joint; `None` for points that are not drawn.
    pub(super) positions: Vec<Option<Expr>>,
}

/// What names are at the reference.
struct Values {
    constants: BTreeMap<String, Expr>,
    /// Parameters, inputs, joints, estimates and what is derived from them.
    others: BTreeMap<String, Expr>,
}

pub(super) fn drawing(definition: &MechanismDef, linkage: &Linkage) -> Drawing {
    let values = values(definition);
    let joints = linkage.joints.iter();
    let positions = joints
        .map(|joint| {
            let drawn = at_reference(&values, &name(&joint.name), DEPTH);
            (joint.drawn.is_some() || is_constant(&values, &drawn)).then_some(drawn)
        })
        .collect();
    Drawing { values, positions }
}

/// Returns the values that the names of a struct block have at the reference, as far as they are
/// known.
fn values(definition: &MechanismDef) -> Values {
    let mut values = Values {
        constants: BTreeMap::new(),
        others: BTreeMap::new(),
    };
    let mut add = |name: String, value: Expr| {
        values.others.insert(name, value);
    };
    for item in &definition.items {
        match item {
            Item::Param(item) => add(item.name.to_string(), nominal(&item.value)),
            Item::Input(item) => add(item.name.to_string(), item.value.clone()),
            Item::Let(item) => add(item.name.to_string(), item.value.clone()),
            Item::Unknown(item) => {
                if let Some(estimate) = &item.estimate {
                    add(item.name.to_string(), estimate.clone());
                }
            }
            Item::Linked(LinkedItem::Joints(joints)) => {
                for joint in joints {
                    add(joint.name.to_string(), nominal(&joint.position));
                }
            }
            // No other item has a value at the reference.
            _ => {}
        }
    }
    for item in &definition.items {
        if let Item::Const(item) = item {
            values
                .constants
                .insert(item.name.to_string(), item.value.clone());
        }
    }
    values
}

fn is_constant(values: &Values, expr: &Expr) -> bool {
    names(expr).into_iter().all(|name| {
        let text = name.to_string();
        text == "PI" || values.constants.contains_key(&text)
    })
}

/// Returns a value without its tolerances.
pub(super) fn nominal(value: &Toleranced) -> Expr {
    match value {
        Toleranced::Single { nominal, .. } => nominal.clone(),
        Toleranced::Components { components, span } => {
            let components = components.iter().map(|(nominal, _)| nominal.clone());
            Expr {
                kind: ExprKind::Tuple(components.collect()),
                span: *span,
            }
        }
    }
}

impl Drawing {
    /// Returns the vector from one joint to another.
    pub(super) fn vector(&self, from: usize, to: usize) -> Option<Expr> {
        let from = self.positions[from].clone()?;
        Some(difference(self.positions[to].clone()?, from))
    }

    /// Returns the distance of two joints as drawn, in metres.
    pub(super) fn distance(&self, from: usize, to: usize) -> Option<f64> {
        let components = self.components(&self.vector(from, to)?)?;
        Some(components.iter().fold(0.0, |sum: f64, x| sum.hypot(*x)))
    }

    /// Returns true for an expression of numbers and constants alone.
    pub(super) fn is_constant(&self, expr: &Expr) -> bool {
        is_constant(&self.values, expr)
    }

    /// Returns what a name is at the reference.
    pub(super) fn value(&self, name: &str) -> Option<&Expr> {
        let values = &self.values;
        values.constants.get(name).or(values.others.get(name))
    }

    /// Returns an expression with the values that parameters and inputs have at the reference.
    pub(super) fn at_reference(&self, expr: &Expr) -> Expr {
        at_reference(&self.values, expr, DEPTH)
    }

    /// Returns the number of an expression in radians or metres, if it has one.
    pub(super) fn number(&self, expr: &Expr) -> Option<f64> {
        match self.evaluate(expr, DEPTH)?[..] {
            [value] => Some(value),
            _ => None,
        }
    }

    /// Returns the number of an angle in radians, if it has one.
    pub(super) fn angle(&self, expr: &Expr) -> Option<f64> {
        let is_angle = |expr: &Expr| match &expr.kind {
            ExprKind::Number { suffix, .. } => {
                find_unit(suffix).is_some_and(|unit| unit.angle && unit.seconds == 0)
            }
            _ => true,
        };
        is_angle(expr).then(|| self.number(expr)).flatten()
    }

    /// Returns the coordinates of a vector of the plane.
    pub(super) fn coordinates(&self, vector: &Expr) -> Option<[f64; 2]> {
        match self.evaluate(vector, DEPTH)?[..] {
            [x, y] => Some([x, y]),
            _ => None,
        }
    }

    /// Returns the components of a vector, if they are known.
    pub(super) fn components(&self, vector: &Expr) -> Option<Vec<f64>> {
        self.evaluate(vector, DEPTH)
    }

    /// Returns the components of an expression.
    fn evaluate(&self, expr: &Expr, depth: usize) -> Option<Vec<f64>> {
        let depth = depth.checked_sub(1)?;
        let scalar = |expr: &Expr| match self.evaluate(expr, depth)?[..] {
            [value] => Some(value),
            _ => None,
        };
        Some(match &expr.kind {
            ExprKind::Number { text, suffix } => {
                let number: f64 = text.parse().ok()?;
                let scale = match suffix.as_str() {
                    "" => 1.0,
                    unit => find_unit(unit)?.scale.factor(),
                };
                vec![number * scale]
            }
            ExprKind::Name(name) => {
                let text = name.to_string();
                match self.value(&text) {
                    Some(value) => self.evaluate(value, depth)?,
                    None if text == "PI" => vec![std::f64::consts::PI],
                    None => return None,
                }
            }
            ExprKind::Tuple(components) => {
                // A length without its unit is reported where the value is read.
                let is_bare = |expr: &Expr| match &expr.kind {
                    ExprKind::Number { text, suffix } => {
                        suffix.is_empty() && text.parse::<f64>().is_ok_and(|number| number != 0.0)
                    }
                    _ => false,
                };
                if components.iter().any(is_bare) {
                    return None;
                }
                let components = components.iter().map(scalar);
                components.collect::<Option<Vec<f64>>>()?
            }
            ExprKind::Negate(value) => {
                let value = self.evaluate(value, depth)?;
                value.into_iter().map(|component| -component).collect()
            }
            ExprKind::Binary(operator, left, right) => {
                let (left, right) = (self.evaluate(left, depth)?, self.evaluate(right, depth)?);
                combine(*operator, &left, &right)?
            }
            ExprKind::Call(function, arguments) => {
                match (function.to_string().as_str(), &arguments[..]) {
                    ("polar", [length, angle]) => {
                        let (length, angle) = (scalar(length)?, scalar(angle)?);
                        vec![length * angle.cos(), length * angle.sin()]
                    }
                    ("sqrt", [value]) => vec![scalar(value)?.sqrt()],
                    ("sin", [value]) => vec![scalar(value)?.sin()],
                    ("cos", [value]) => vec![scalar(value)?.cos()],
                    ("tan", [value]) => vec![scalar(value)?.tan()],
                    _ => return None,
                }
            }
            ExprKind::Field(..)
            | ExprKind::Index(..)
            | ExprKind::Power(..)
            | ExprKind::List(_)
            | ExprKind::Error => return None,
        })
    }
}

fn combine(operator: BinaryOp, left: &[f64], right: &[f64]) -> Option<Vec<f64>> {
    let pairs = || left.iter().zip(right);
    Some(match (operator, left, right) {
        (BinaryOp::Add, ..) if left.len() == right.len() => pairs().map(|(a, b)| a + b).collect(),
        (BinaryOp::Sub, ..) if left.len() == right.len() => pairs().map(|(a, b)| a - b).collect(),
        (BinaryOp::Mul, [factor], vector) | (BinaryOp::Mul, vector, [factor]) => {
            vector.iter().map(|component| factor * component).collect()
        }
        (BinaryOp::Div, vector, [divisor]) => {
            vector.iter().map(|component| component / divisor).collect()
        }
        _ => return None,
    })
}

/// Returns all names in an expression, those of functions aside.
pub(super) fn names(expr: &Expr) -> Vec<&Ident> {
    let mut found = Vec::new();
    let mut open = vec![expr];
    while let Some(expr) = open.pop() {
        if let ExprKind::Name(name) = &expr.kind {
            found.push(name);
        }
        open.extend(expr.operands());
    }
    found
}

fn at_reference(values: &Values, expr: &Expr, depth: usize) -> Expr {
    let Some(depth) = depth.checked_sub(1) else {
        return expr.clone();
    };
    let inner = |expr: &Expr| at_reference(values, expr, depth);
    let boxed = |expr: &Expr| Box::new(inner(expr));
    let kind = match &expr.kind {
        ExprKind::Name(name) => match values.others.get(&name.to_string()) {
            Some(value) => return inner(value),
            None => return expr.clone(),
        },
        ExprKind::Tuple(parts) => ExprKind::Tuple(parts.iter().map(inner).collect()),
        ExprKind::Call(name, parts) => {
            ExprKind::Call(name.clone(), parts.iter().map(inner).collect())
        }
        ExprKind::Negate(value) => ExprKind::Negate(boxed(value)),
        ExprKind::Field(value, field) => ExprKind::Field(boxed(value), field.clone()),
        ExprKind::Binary(operator, left, right) => {
            ExprKind::Binary(*operator, boxed(left), boxed(right))
        }
        ExprKind::Number { .. }
        | ExprKind::Index(..)
        | ExprKind::Power(..)
        | ExprKind::List(_)
        | ExprKind::Error => return expr.clone(),
    };
    Expr {
        kind,
        span: expr.span,
    }
}
