//! Vectors that must have a direction and have none: axes of `turn` and `frame` and arguments of
//! `unit` that are zero, axes of a frame that are parallel, as far as their numbers are known.
//! Vectors that depend on an unknown are left to run time.

mod asked;

use linkage_symbolic::Graph;
use linkage_symbolic::lookup::Map;

use crate::algebra::{Names, Nominal, nominal, translate};
use crate::diagnostic::Reporter;
use crate::message_format::MessageFormat;
use crate::model::{BinaryOp, Expr, ExprKind, Function, Mechanism, Name};

use asked::{Asked, asked_for};

/// Reports every axis and argument of `unit` that is zero, or parallel to the one that it must
/// differ from, for the default dimensions, and in loops those that are zero at the reference
/// input.
pub(crate) fn check_directions(mechanism: &Mechanism, nominal: &Nominal, reporter: &mut Reporter) {
    let asked = asked_for(mechanism);
    if asked.is_empty() {
        return;
    }
    // A separate graph: nodes made in another order would change the written form of the
    // mechanism's sums.
    let graph = Graph::new();
    let mut names = Names::new(mechanism, &graph);
    translate::translate_lets(&mut names);
    let mut check = Check {
        mechanism,
        nominal,
        names,
        inputs: &[],
        sizes: Map::new(),
    };
    let mut told = Vec::new();
    for asked in asked {
        // The axes of an unknown frame are estimated by one frame.
        if told.contains(&asked.vector.origin) {
            continue;
        }
        check.know(&[]);
        let mut position = String::new();
        let mut found = check.mistake(&asked, &position);
        if found.is_none() && asked.in_loop {
            check.know(&nominal.inputs);
            position = MessageFormat::new(mechanism).at_reference(&nominal.inputs);
            found = check.mistake(&asked, &position);
        }
        if let Some((fact, help)) = found {
            told.push(asked.vector.origin);
            reporter.error_with_help(asked.vector.origin, fact, help);
        }
    }
}

struct Check<'a, 'm> {
    mechanism: &'m Mechanism,
    nominal: &'a Nominal,
    names: Names<'m>,
    /// The inputs' values, if they count as known.
    inputs: &'a [f64],
    sizes: Map<Name, f64>,
}

/// Roundoffs of its terms below which a sum is zero.
const ROUNDOFFS: f64 = 8.0;

/// Through so many names the size of terms is followed.
const DEPTH: usize = 32;

impl<'a> Check<'a, '_> {
    fn know(&mut self, inputs: &'a [f64]) {
        self.inputs = inputs;
        self.sizes.clear();
    }

    fn value(&mut self, expr: &Expr) -> Vec<f64> {
        let Self { names, nominal, .. } = self;
        nominal::evaluated(names, expr, &nominal.parameters, self.inputs)
    }

    fn is_zero(&mut self, vector: &Expr) -> bool {
        let largest = largest(&self.value(vector));
        if largest == 0.0 {
            return true;
        }
        !largest.is_nan() && largest <= ROUNDOFFS * f64::EPSILON * self.size(vector, DEPTH)
    }

    /// True if neither of two space vectors is zero, but their product is.
    fn parallel(&mut self, a: &Expr, b: &Expr) -> bool {
        let ([x, y], size) = (
            [self.value(a), self.value(b)],
            self.size(a, DEPTH) * self.size(b, DEPTH),
        );
        let product: Vec<f64> = [(1, 2), (2, 0), (0, 1)]
            .map(|(i, j)| x[i] * y[j] - x[j] * y[i])
            .to_vec();
        !self.is_zero(a) && largest(&product) <= ROUNDOFFS * f64::EPSILON * size
    }

    /// Returns the size of the terms whose sum a value is.
    fn size(&mut self, expr: &Expr, depth: usize) -> f64 {
        match &expr.kind {
            ExprKind::Name(name) if depth > 0 => self.size_of_name(*name, expr, depth - 1),
            ExprKind::Vector(all) => all.iter().map(|x| self.size(x, depth)).sum(),
            ExprKind::Component(a, _) | ExprKind::Negate(a) => self.size(a, depth),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
                self.size(a, depth) + self.size(b, depth)
            }
            ExprKind::Binary(BinaryOp::Mul, a, b) => self.size(a, depth) * self.size(b, depth),
            ExprKind::Binary(BinaryOp::Div, a, b) => self.size(a, depth) / largest(&self.value(b)),
            ExprKind::Call(Function::Cross | Function::Dot, all) => {
                all.iter().map(|x| self.size(x, depth)).product()
            }
            ExprKind::Call(Function::Polar | Function::Rotate | Function::Turn, all) => {
                self.size(&all[0], depth)
            }
            ExprKind::Call(Function::Dir | Function::Sin | Function::Cos, _) => 1.0,
            _ => largest(&self.value(expr)),
        }
    }

    fn size_of_name(&mut self, name: Name, expr: &Expr, depth: usize) -> f64 {
        let Some(definition) = self.definition(name) else {
            return largest(&self.value(expr));
        };
        if let Some(size) = self.sizes.get(&name) {
            return *size;
        }
        let size = self.size(definition, depth);
        self.sizes.insert(name, size);
        size
    }
}

impl<'m> Check<'_, 'm> {
    fn definition(&self, name: Name) -> Option<&'m Expr> {
        let mechanism = self.mechanism;
        match name {
            Name::Const(index) => Some(&mechanism.constants[index].value),
            Name::Parameter(index) => Some(&mechanism.parameters[index].nominal),
            Name::Let(index) => Some(&mechanism.lets[index].value),
            Name::Input(_) | Name::Unknown(_) | Name::Argument(_) | Name::Pi => None,
        }
    }

    /// Returns the fault of a direction, and the advice. `position` is set if the fault is
    /// not everywhere.
    fn mistake(&mut self, asked: &Asked, position: &str) -> Option<(String, String)> {
        let Asked {
            subject, vector, ..
        } = *asked;
        if self.is_zero(vector) {
            let (why, help) = self.reason(vector, "it");
            let help = match position {
                "" => help,
                _ => "choose a reference input at which it has a direction".to_owned(),
            };
            return Some((format!("{subject} has no direction{position}: {why}"), help));
        }
        let beside = asked
            .beside
            .filter(|beside| self.parallel(beside, vector))?;
        let both = self.words(&[beside, vector]);
        let fact = format!("{subject} is parallel to its x axis{position}{both}");
        let help = match position {
            "" => "choose another vector: it lies in the plane of the x and z axes",
            _ => "choose a reference input at which they are not parallel",
        };
        Some((fact, help.to_owned()))
    }

    /// Returns the reason why a vector is zero, and the advice. `subject` is the vector's name in
    /// the message.
    fn reason(&mut self, vector: &Expr, subject: &str) -> (String, String) {
        match &vector.kind {
            ExprKind::Name(name) => {
                if let Some(definition) = self.definition(*name) {
                    let name = format!("`{}`", self.mechanism.name(*name));
                    return self.reason(definition, &name);
                }
            }
            ExprKind::Negate(value) | ExprKind::Binary(BinaryOp::Div, value, _) => {
                return self.reason(value, subject);
            }
            ExprKind::Binary(BinaryOp::Mul, a, b) => {
                let value = if a.ty.components() == Some(1) { b } else { a };
                if self.is_zero(value) {
                    return self.reason(value, subject);
                }
            }
            ExprKind::Binary(BinaryOp::Sub, a, _) if !self.is_zero(a) => {
                let both = self.words(&[a]);
                let fact = format!("{subject} is the difference of equal vectors{both}");
                let help = "choose vectors that differ from each other";
                return (fact, help.to_owned());
            }
            ExprKind::Call(Function::Cross, both) if !both.iter().any(|v| self.is_zero(v)) => {
                let both = self.words(&[&both[0], &both[1]]);
                let fact = format!("{subject} is `cross` of parallel vectors{both}");
                return (fact, "choose vectors that are not parallel".to_owned());
            }
            _ => {}
        }
        let number = vector.ty.dimension().is_some_and(|d| d.half_lengths == 0);
        let help = match (number, vector.ty.components()) {
            (false, _) => "give it a length that is not zero",
            (true, Some(2)) => "write a direction such as `(1, 0)`, of any length",
            (true, _) => "write a direction such as `(0, 0, 1)`, of any length",
        };
        let zero = MessageFormat::new(self.mechanism).vector(&vector.ty, &self.value(vector));
        (format!("{subject} is {zero}"), help.to_owned())
    }

    /// `, (1, 2, 3) and (2, 4, 6)`; nothing if a number is not known.
    fn words(&mut self, vectors: &[&Expr]) -> String {
        let words = MessageFormat::new(self.mechanism);
        let mut parts = Vec::new();
        for vector in vectors {
            let value = self.value(vector);
            if !value.iter().all(|x| x.is_finite()) {
                return String::new();
            }
            parts.push(words.vector(&vector.ty, &value));
        }
        format!(", {}", parts.join(" and "))
    }
}

/// The largest component; NaN if one is.
fn largest(values: &[f64]) -> f64 {
    values
        .iter()
        .fold(0.0, |a: f64, x| match a.is_nan() || x.is_nan() {
            true => f64::NAN,
            false => a.max(x.abs()),
        })
}
