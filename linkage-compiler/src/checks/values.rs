//! Expressions of the declared dimensions alone that have no finite value for them:
//! `sqrt(crank - rocker)`.

use std::collections::BTreeSet;

use linkage_symbolic::Graph;

use crate::algebra::{Names, Nominal, nominal, translate};
use crate::diagnostic::{OriginId, Reporter};
use crate::message_format::MessageFormat;
use crate::model::{BinaryOp, Expr, ExprKind, Mechanism, Name};
use crate::syntax::Word;

/// Reports the innermost expressions of parameters and numbers that are not finite: as errors those
/// that leave a loop without a solution, else as warnings, since other dimensions may be meant to
/// be given, or an infinity to be compared with.
pub(crate) fn check_values(mechanism: &Mechanism, nominal: &Nominal, reporter: &mut Reporter) {
    // A separate graph: nodes made in another order would change the written form of the
    // mechanism's sums.
    let graph = Graph::new();
    let mut names = Names::new(mechanism, &graph);
    translate::translate_lets(&mut names);
    let mut check = Check::new(names, nominal, &[]);
    let all: Vec<usize> = (0..mechanism.loops.len()).collect();
    let used = mechanism.usage(&all).lets;
    for (index, item) in mechanism.lets.iter().enumerate() {
        check.fixed[index] = check.is_fixed(&item.value);
        let occurrence = match used[index] {
            true => Occurrence::InLoop,
            false => Occurrence::Elsewhere,
        };
        check.look_at(&item.value, occurrence);
    }
    for equation in &mechanism.loops {
        check.look_at(&equation.left, Occurrence::Term);
        check.look_at(&equation.right, Occurrence::Term);
    }
    let quantities = mechanism
        .evaluators
        .iter()
        .flat_map(|function| &function.quantities);
    let values = quantities.map(|quantity| &quantity.value);
    for value in values.chain(mechanism.expressions_of_mechanics()) {
        check.look_at(value, Occurrence::Elsewhere);
    }
    for found in std::mem::take(&mut check.found) {
        let fact = check.fact(&found);
        let help = match check.parameters_below(found.expr).is_empty() {
            true => "look for a division by zero, or a root or an arc function out of its range",
            false => "change these dimensions, or what is computed with them",
        };
        match found.fatal {
            true => reporter.error_with_help(found.expr.origin, fact, help),
            false => reporter.warning_with_help(found.expr.origin, fact, help),
        };
    }
}

/// Returns the innermost expression of some loops that has no finite value at given inputs, as
/// text: an expression of dimensions and inputs, not of unknowns.
pub(crate) fn without_value(
    mechanism: &Mechanism,
    nominal: &Nominal,
    inputs: &[f64],
    loops: &[usize],
) -> Option<(OriginId, String)> {
    let graph = Graph::new();
    let mut names = Names::new(mechanism, &graph);
    translate::translate_lets(&mut names);
    let mut check = Check::new(names, nominal, inputs);
    let used = mechanism.usage(loops).lets;
    for (index, item) in mechanism.lets.iter().enumerate() {
        check.fixed[index] = check.is_fixed(&item.value);
        if used[index] {
            check.look_at(&item.value, Occurrence::InLoop);
        }
    }
    for &index in loops {
        check.look_at(&mechanism.loops[index].left, Occurrence::Term);
        check.look_at(&mechanism.loops[index].right, Occurrence::Term);
    }
    let found = std::mem::take(&mut check.found).into_iter().next()?;
    Some((found.expr.origin, check.fact(&found)))
}

/// The position of an expression.
#[derive(Clone, Copy, PartialEq)]
enum Occurrence {
    /// A loop is a sum of it and others.
    Term,
    /// A loop contains it: NaN goes through all values computed with it, an infinity may be the
    /// larger of two numbers.
    InLoop,
    Elsewhere,
}

struct NotFinite<'m> {
    expr: &'m Expr,
    fatal: bool,
}

struct Check<'a, 'm> {
    mechanism: &'m Mechanism,
    nominal: &'a Nominal,
    /// The inputs, if they are considered, too; else empty.
    inputs: &'a [f64],
    names: Names<'m>,
    /// For each derived quantity, true if it depends on dimensions alone.
    fixed: Vec<bool>,
    found: Vec<NotFinite<'m>>,
}

impl<'a, 'm> Check<'a, 'm> {
    fn new(names: Names<'m>, nominal: &'a Nominal, inputs: &'a [f64]) -> Self {
        let mechanism = names.mechanism;
        Self {
            mechanism,
            nominal,
            inputs,
            names,
            fixed: vec![false; mechanism.lets.len()],
            found: Vec::new(),
        }
    }

    fn is_fixed(&self, expr: &Expr) -> bool {
        expr.parts().all(|part| match part.as_name() {
            Some(Name::Let(index)) => self.fixed[index],
            Some(Name::Input(_)) => !self.inputs.is_empty(),
            Some(Name::Unknown(_) | Name::Argument(_)) => false,
            Some(Name::Const(_) | Name::Parameter(_) | Name::Pi) => true,
            None => !part.is_quantity() && !part.ty.is_frame(),
        })
    }

    /// Searches the largest parts that are fixed.
    fn look_at(&mut self, expr: &'m Expr, occurrence: Occurrence) {
        let mut open = vec![(expr, occurrence)];
        while let Some((expr, occurrence)) = open.pop() {
            if self.is_fixed(expr) {
                self.blame(expr, occurrence);
                continue;
            }
            let below = match (&expr.kind, occurrence) {
                (ExprKind::Vector(_), _) => occurrence,
                (_, Occurrence::Term) if expr.summands().is_empty() => Occurrence::InLoop,
                _ => occurrence,
            };
            open.extend(expr.operands().into_iter().map(|operand| (operand, below)));
        }
    }

    /// Finds the innermost parts that are not finite.
    fn blame(&mut self, expr: &'m Expr, occurrence: Occurrence) {
        let mut open = vec![expr];
        while let Some(expr) = open.pop() {
            // A name is reported at its declaration.
            let told = matches!(expr.kind, ExprKind::Name(_) | ExprKind::Number(_));
            if told || self.is_finite(expr) {
                continue;
            }
            let operands = expr.operands();
            let before = open.len();
            open.extend(
                operands
                    .into_iter()
                    .filter(|operand| !self.is_finite(operand)),
            );
            if open.len() == before {
                let fatal = match occurrence {
                    Occurrence::Term => true,
                    Occurrence::InLoop => self.value(expr).iter().any(|x| x.is_nan()),
                    Occurrence::Elsewhere => false,
                };
                self.found.push(NotFinite { expr, fatal });
            }
        }
    }

    fn is_finite(&mut self, expr: &Expr) -> bool {
        self.value(expr).iter().all(|x| x.is_finite())
    }

    fn value(&mut self, expr: &Expr) -> Vec<f64> {
        let scale = translate::internal_per_unit(self.mechanism, &expr.ty);
        let values =
            nominal::evaluated(&mut self.names, expr, &self.nominal.parameters, self.inputs);
        // Zero has no sign for a reader.
        values
            .into_iter()
            .map(|value| value / scale + 0.0)
            .collect()
    }

    /// `` `sqrt` of -50mm is not a finite number, for `crank = 50mm`, `rocker = 100mm` ``
    fn fact(&mut self, NotFinite { expr, .. }: &NotFinite<'m>) -> String {
        let words = MessageFormat::new(self.mechanism);
        let operands = expr.operands().into_iter();
        let operands: Vec<String> = operands
            .map(|operand| words.value(&operand.ty, &self.value(operand)))
            .collect();
        let what = match &expr.kind {
            ExprKind::Call(function, _) => {
                format!("`{}` of {}", function.word(), operands.join(" and "))
            }
            ExprKind::Binary(BinaryOp::Div, ..) => operands.join(" divided by "),
            ExprKind::Binary(BinaryOp::Mul, ..) => operands.join(" times "),
            // Sums are too large.
            _ => "this".to_owned(),
        };
        let below = self.parameters_below(expr);
        let parameters: Vec<String> = below
            .into_iter()
            .map(|index| {
                let parameter = &self.mechanism.parameters[index];
                let values = &self.nominal.parameters[parameter.first_scalar.0..];
                let values = &values[..parameter.tolerances.len()];
                format!(
                    "`{} = {}`",
                    parameter.name,
                    words.value(&parameter.ty, values)
                )
            })
            .collect();
        let of = match parameters.is_empty() {
            true => String::new(),
            false => format!(", for {}", parameters.join(", ")),
        };
        format!("{what} is not a finite number{of}")
    }

    /// The parameters that a value is computed from, through derived quantities, too.
    fn parameters_below(&self, expr: &'m Expr) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut seen = BTreeSet::new();
        let mut open = vec![expr];
        while let Some(expr) = open.pop() {
            for name in expr.parts().filter_map(Expr::as_name) {
                if let Name::Parameter(index) = name {
                    found.insert(index);
                }
                if seen.insert(name) {
                    open.extend(self.mechanism.value_of(name));
                }
            }
        }
        found
    }
}
