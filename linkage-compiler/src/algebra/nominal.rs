//! The numbers of the mechanism as written: defaults, tolerances, reference position, estimates.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, SymbolId, evaluate, evaluate_given};

use crate::algebra::names::{Angle, Bound, Names};
use crate::algebra::translate::Translate;
use crate::algebra::value::Value;
use crate::algebra::{scalar, translate};
use crate::model::{Dimension, Expr, ExprKind, Mechanism, Name, Type};

/// Values known at compile time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Nominal {
    pub(crate) parameters: Vec<f64>,
    pub(crate) tolerances: Vec<f64>,
    pub(crate) inputs: Vec<f64>,
    pub(crate) ranges: Vec<Option<(f64, f64)>>,
    /// The declared value of each argument; `None` for a speed or an acceleration.
    pub(crate) arguments: Vec<Option<f64>>,
    /// Components of each unknown's start estimate; zeros where none is given, until the loops are
    /// closed.
    pub(crate) estimates: Vec<Vec<f64>>,
}

/// A number of values, in the unit of a type.
#[derive(Clone, Copy)]
struct Wanted<'t> {
    count: usize,
    unit: &'t Type,
}

impl Nominal {
    /// Evaluates the numbers of a mechanism. Nothing of it stays in the graph: the order of its
    /// nodes is that of the mechanism's formulas.
    pub(crate) fn from_mechanism(names: &mut Names) -> Self {
        names.tried(Self::evaluate_written)
    }

    fn evaluate_written(names: &mut Names) -> Self {
        let mechanism = names.mechanism;
        let mut nominal = Self::default();
        for parameter in &mechanism.parameters {
            let count = parameter.tolerances.len();
            let whole = Wanted {
                count,
                unit: &parameter.ty,
            };
            let component = Wanted { count: 1, ..whole };
            let nominals = numbers(names, &parameter.nominal, whole, &[]);
            nominal.parameters.extend(nominals);
            for tolerance in &parameter.tolerances {
                let value = tolerance
                    .as_ref()
                    .map_or(0.0, |t| numbers(names, t, component, &[])[0]);
                nominal.tolerances.push(value);
            }
        }
        for input in &mechanism.inputs {
            let mut number = |expr| evaluated(names, expr, &[], &[])[0];
            nominal.inputs.push(number(&input.reference));
            let range = input.range.as_ref();
            let range = range.map(|(low, high)| (number(low), number(high)));
            nominal.ranges.push(range);
        }
        for argument in &mechanism.arguments {
            let declared = argument.reference.as_ref();
            let declared = declared.map(|value| scalar_number(names, value, argument.dimension));
            nominal.arguments.push(declared);
        }
        for (unknown, item) in mechanism.unknowns.iter().enumerate() {
            let wanted = Wanted {
                count: names.components_of(unknown),
                unit: &item.ty,
            };
            let estimate = match &item.estimate {
                Some(estimate) => numbers(names, estimate, wanted, &nominal.parameters),
                None => vec![0.0; wanted.count],
            };
            nominal.estimates.push(estimate);
        }
        nominal
    }
}

impl Nominal {
    /// Replaces the estimates that are not given by values that were found.
    pub(crate) fn complete(&mut self, found: &[(usize, Vec<f64>)]) {
        for (unknown, value) in found {
            self.estimates[*unknown].clone_from(value);
        }
    }

    /// Evaluates expressions at the defaults and the reference position. Modes, prepared states and
    /// arguments are NaN.
    pub(crate) fn evaluate(&self, all: &[Ex]) -> Vec<f64> {
        evaluate(all, |source| self.load(source))
    }

    fn load(&self, source: Source) -> f64 {
        match source {
            Source::Parameter(index) => self.parameters[index],
            Source::Input(index) => self.inputs.get(index).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        }
    }
}

impl Angle<'_> {
    /// The model's unknown that this angle is, or stands for.
    pub(crate) fn meant(&self) -> Option<usize> {
        let stands_for = self.stands_for.as_ref();
        self.unknown.or(stands_for.map(|other| other.unknown))
    }

    /// Its start estimate; 0 for a link that the compiler introduced, whose angle nobody can ask
    /// for.
    pub(crate) fn estimate(&self, nominal: &Nominal) -> f64 {
        let summands = self.summands().into_iter();
        summands
            .map(|(unknown, sign)| sign * nominal.estimates[unknown][0])
            .fold(self.estimated, |sum, term| sum + term)
    }

    /// The unknowns of which it is the sum, with their signs; none for a link that the compiler
    /// introduced.
    pub(crate) fn summands(&self) -> Vec<(usize, f64)> {
        match (self.unknown, &self.stands_for) {
            (Some(unknown), _) => vec![(unknown, 1.0)],
            (None, Some(other)) => other.summands.clone(),
            (None, None) => Vec::new(),
        }
    }
}

impl Names<'_> {
    /// Returns the start estimate of a length or a component; 0 for one that the compiler
    /// introduced.
    pub(crate) fn estimate(&self, symbol: SymbolId, nominal: &Nominal) -> f64 {
        let mut all = self.bound.iter().zip(&nominal.estimates);
        let found = all.find_map(|(bound, estimates)| match bound {
            Bound::Angle(_) => None,
            Bound::Lengths(symbols) => {
                let component = symbols.iter().position(|(other, _)| *other == symbol)?;
                estimates.get(component).copied()
            }
        });
        found.unwrap_or(0.0)
    }
}

/// Expressions at the defaults and the reference position, with all unknowns where they are
/// estimated.
pub(crate) fn at_estimates(names: &Names<'_>, nominal: &Nominal, all: &[Ex]) -> Vec<f64> {
    let mut unknowns: Map<SymbolId, f64> = Map::new();
    for angle in &names.angles {
        // A link that the compiler introduced is where the points are that it joins.
        let estimate = angle.drawn + angle.estimate(nominal);
        let values = [estimate.cos(), estimate.sin(), estimate];
        unknowns.extend(angle.symbols().into_iter().zip(values));
    }
    for (bound, estimates) in names.bound.iter().zip(&nominal.estimates) {
        if let Bound::Lengths(symbols) = bound {
            let symbols = symbols.iter().map(|(symbol, _)| *symbol);
            unknowns.extend(symbols.zip(estimates.iter().copied()));
        }
    }
    let load = |source| nominal.load(source);
    evaluate_given(all, load, |symbol| unknowns.get(&symbol).copied())
}

/// An expression of constants and parameters as numbers.
fn numbers(names: &mut Names<'_>, expr: &Expr, wanted: Wanted, parameters: &[f64]) -> Vec<f64> {
    let scale = translate::internal_per_unit(names.mechanism, wanted.unit);
    let mut numbers = match written(names.mechanism, expr, scale) {
        Some(numbers) => numbers,
        None => {
            let numbers = evaluated(names, expr, parameters, &[]).into_iter();
            numbers.map(|number| number / scale).collect()
        }
    };
    if numbers.len() == 1 {
        numbers.resize(wanted.count, numbers[0]);
    }
    numbers
}

/// The declared value of an argument, in the unit of its dimension.
fn scalar_number(names: &mut Names<'_>, expr: &Expr, dimension: Dimension) -> f64 {
    let unit = &Type::Scalar(dimension);
    numbers(names, expr, Wanted { count: 1, unit }, &[])[0]
}

/// Numbers as they are written, if an expression is nothing else, in a unit of this scale: not
/// rounded again.
fn written(mechanism: &Mechanism, expr: &Expr, scale: f64) -> Option<Vec<f64>> {
    match &expr.kind {
        ExprKind::Number(value) => {
            (translate::internal_per_unit(mechanism, &expr.ty) == scale).then(|| vec![*value])
        }
        ExprKind::Negate(inner) => {
            let numbers = written(mechanism, inner, scale)?;
            Some(numbers.into_iter().map(|number| -number).collect())
        }
        ExprKind::Vector(components) => {
            let components = components.iter();
            let numbers: Option<Vec<_>> = components
                .map(|component| written(mechanism, component, scale))
                .collect();
            Some(numbers?.concat())
        }
        ExprKind::Name(Name::Const(index)) => {
            written(mechanism, &mechanism.constants[*index].value, scale)
        }
        _ => None,
    }
}

/// The components of an expression; NaN where one depends on something that is not given.
pub(crate) fn evaluated(
    names: &mut Names<'_>,
    expr: &Expr,
    parameters: &[f64],
    inputs: &[f64],
) -> Vec<f64> {
    let numbers = match names.translate(expr) {
        Value::Vector(vector) => vector.iter().collect(),
        scalar => vec![scalar::number(names, &scalar)],
    };
    let given = |numbers: &[f64], index: usize| numbers.get(index).copied().unwrap_or(f64::NAN);
    evaluate(&numbers, |source| match source {
        Source::Parameter(index) => given(parameters, index),
        Source::Input(index) => given(inputs, index),
        _ => f64::NAN,
    })
}
