//! Shapes of expressions from the syntax alone, for the skeleton: what is obviously a vector is one, the rest are
//! numbers.

use std::collections::BTreeMap;

use super::outline::{params, plain};
use crate::lower::Shape;
use crate::syntax::{BinaryOp, Expr, ExprKind, Item, MechanismDef, ParamItem, Toleranced};

/// More vectors than most pictures have.
const MANY_POINTS: usize = 64;

/// Names may stand for expressions with names in them; deeper than this, something is wrong with the source.
const DEPTH: usize = 24;

/// The expressions behind the names of a mechanism.
pub(super) struct Guess<'a> {
    names: BTreeMap<String, &'a Expr>,
    vectors: BTreeMap<String, usize>,
    scalar_parameters: usize,
    /// Components of points in the mechanics.
    components: usize,
}

impl<'a> Guess<'a> {
    pub(super) fn new(def: &'a MechanismDef) -> Self {
        let mut guess = Self {
            names: BTreeMap::new(),
            vectors: BTreeMap::new(),
            scalar_parameters: 0,
            components: 2,
        };
        for item in &def.items {
            match item {
                Item::Const(item) | Item::Let(item) | Item::Unknown(item) => {
                    guess.names.entry(plain(&item.name)).or_insert(&item.value);
                }
                Item::Param(param) => match &param.value {
                    Toleranced::Single { nominal, .. } => {
                        guess.names.entry(plain(&param.name)).or_insert(nominal);
                    }
                    Toleranced::Components { components, .. } => {
                        guess.vectors.insert(plain(&param.name), components.len());
                    }
                },
                _ => {}
            }
        }
        let mut points = def.items.iter().filter_map(|item| match item {
            Item::Body(body) => Some(&body.joint.at),
            _ => None,
        });
        if points.any(|point| guess.shape(point, 0) == Shape::Vector(3)) {
            guess.components = 3;
        }
        guess.scalar_parameters = params(def)
            .map(|param| guess.parameter(param).width())
            .sum();
        guess
    }

    pub(super) fn parameter(&self, param: &ParamItem) -> Shape {
        match &param.value {
            Toleranced::Single { nominal, .. } => self.shape(nominal, 0),
            Toleranced::Components { components, .. } => vector(components.len()),
        }
    }

    /// The shape of `expr` in a function of so many inputs, arguments aside.
    pub(super) fn shape(&self, expr: &Expr, inputs: usize) -> Shape {
        self.at_depth(expr, inputs, DEPTH)
    }

    fn at_depth(&self, expr: &Expr, inputs: usize, depth: usize) -> Shape {
        let Some(depth) = depth.checked_sub(1) else {
            return Shape::Scalar;
        };
        let shape = |expr: &Expr| self.at_depth(expr, inputs, depth);
        match &expr.kind {
            ExprKind::Name(name) => {
                let name = plain(name);
                match (self.vectors.get(&name), self.names.get(&name)) {
                    (Some(n), _) => vector(*n),
                    (None, Some(value)) => shape(value),
                    (None, None) => Shape::Scalar,
                }
            }
            ExprKind::Tuple(components) => vector(components.len()),
            ExprKind::Index(array, _) => match shape(array) {
                Shape::Array(_, entry) => *entry,
                _ => Shape::Scalar,
            },
            ExprKind::Field(value, _) if shape(value) == Shape::Frame => Shape::Vector(3),
            ExprKind::Negate(inner) => shape(inner),
            ExprKind::Binary(BinaryOp::Div, left, _) => shape(left),
            ExprKind::Binary(_, left, right) => match shape(left) {
                Shape::Scalar => shape(right),
                other => other,
            },
            ExprKind::Call(function, arguments) => {
                let first = || arguments.first().map_or(Shape::Scalar, shape);
                self.call(&plain(function), &first, arguments, inputs)
            }
            _ => Shape::Scalar,
        }
    }

    fn call(
        &self,
        function: &str,
        first: &dyn Fn() -> Shape,
        arguments: &[Expr],
        inputs: usize,
    ) -> Shape {
        let array = |n: usize, entry: Shape| Shape::Array(n, Box::new(entry));
        match function {
            "polar" | "dir" => Shape::Vector(2),
            "turn" | "point_in" | "coordinates_in" => Shape::Vector(3),
            "reaction" | "shaking_force" => vector(self.components),
            "moment" | "shaking_moment" if self.components == 3 => Shape::Vector(3),
            "frame" => Shape::Frame,
            // So many that no index is beyond its end.
            "picture" => array(MANY_POINTS, vector(self.components)),
            "rotate" | "unit" | "d" | "jerk" => first(),
            "cross" if first() == Shape::Vector(3) => first(),
            "velocity" if inputs > 1 => array(inputs, first()),
            "acceleration" if inputs > 1 => array(inputs, array(inputs, first())),
            "velocity" | "acceleration" => first(),
            "sensitivity" => {
                let listed = match arguments.get(1).map(|list| &list.kind) {
                    // A vector parameter stands for its components.
                    Some(ExprKind::List(list)) => list
                        .iter()
                        .map(|entry| self.shape(entry, inputs).width())
                        .sum(),
                    _ => self.scalar_parameters,
                };
                array(listed, first())
            }
            _ => Shape::Scalar,
        }
    }
}

fn vector(components: usize) -> Shape {
    match components {
        2 | 3 => Shape::Vector(components),
        _ => Shape::Scalar,
    }
}
