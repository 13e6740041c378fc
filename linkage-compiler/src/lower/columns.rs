//! What each number of a result is: its name, its unit, what it was derived from.

use linkage_runtime::Meaning as RuntimeMeaning;

use crate::algebra::AXES;
use crate::model::{EvaluatorDef, Expr, ExprKind, LengthUnit, Mechanism, Quantity, Type, Variable};
use crate::picture::Picture;

pub type Meaning = RuntimeMeaning;

/// One number of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// `p.x`, `e[crank].y`
    pub name: String,
    pub unit: String,
    pub meaning: Meaning,
}

/// The numbers of a function's results, in order.
pub(super) fn columns(
    mechanism: &Mechanism,
    definition: &EvaluatorDef,
    picture: Option<&Picture>,
) -> Vec<Column> {
    let namer = Namer {
        mechanism,
        definition,
    };
    let mut all = Vec::new();
    // Derivatives refer to the quantities themselves, which may stand behind them.
    let mut firsts = Vec::new();
    let mut next = 0;
    for quantity in &definition.quantities {
        firsts.push(next);
        next += match picture.filter(|_| quantity.is_picture()) {
            Some(picture) => picture.vectors().count() * picture.dimension,
            None => leaves(&quantity.value.ty),
        };
    }
    for quantity in &definition.quantities {
        match picture.filter(|_| quantity.is_picture()) {
            Some(picture) => namer.picture(quantity, picture, &mut all),
            None => namer.quantity(quantity, &firsts, &mut all),
        }
    }
    all
}

struct Namer<'a> {
    mechanism: &'a Mechanism,
    definition: &'a EvaluatorDef,
}

impl Namer<'_> {
    fn picture(&self, quantity: &Quantity, picture: &Picture, all: &mut Vec<Column>) {
        let unit = self.mechanism.unit.name();
        for (index, name) in picture.names().enumerate() {
            for axis in &AXES[..picture.dimension] {
                all.push(Column {
                    name: format!("{}[{name}].{axis}", quantity.field),
                    unit: match index < picture.points.len() {
                        true => unit.to_owned(),
                        false => String::new(),
                    },
                    meaning: Meaning::Picture,
                });
            }
        }
    }

    fn quantity(&self, quantity: &Quantity, firsts: &[usize], all: &mut Vec<Column>) {
        let first = all.len();
        let labels = self.labels(&quantity.value);
        let mut flat = Vec::new();
        flatten(
            &quantity.value.ty,
            &labels,
            quantity.field.clone(),
            self.mechanism.unit,
            &mut flat,
        );
        for (offset, (name, unit)) in flat.into_iter().enumerate() {
            let meaning = self.meaning(&quantity.value, offset, firsts);
            debug_assert_eq!(all.len(), first + offset);
            all.push(Column {
                name,
                unit,
                meaning,
            });
        }
    }

    /// Names of the entries of an array, outermost first.
    fn labels(&self, expr: &Expr) -> Vec<Vec<String>> {
        match &expr.kind {
            ExprKind::InputDerivative(inner, order) => {
                let inputs = self.drives();
                let names = inputs
                    .iter()
                    .map(|&input| self.mechanism.input_name(input).to_owned());
                let names: Vec<String> = names.collect();
                let times = if names.len() == 1 {
                    0
                } else {
                    usize::from(*order)
                };
                let mut labels = vec![names; times];
                labels.extend(self.labels(inner));
                labels
            }
            ExprKind::Sensitivity(inner, parameters) => {
                let scalars = &self.mechanism.scalar_parameters;
                let names = parameters.iter().map(|id| scalars[id.0].name.clone());
                let mut labels = vec![names.collect()];
                labels.extend(self.labels(inner));
                labels
            }
            ExprKind::Derivative(inner, _) => self.labels(inner),
            ExprKind::Index(array, _) => self.labels(array).into_iter().skip(1).collect(),
            _ => Vec::new(),
        }
    }

    /// The inputs that the function differentiates by.
    fn drives(&self) -> Vec<usize> {
        let inputs = self.definition.inputs.iter().copied();
        inputs
            .filter(|&input| input < self.mechanism.inputs.len())
            .collect()
    }

    /// What the number at a place in a quantity is.
    fn meaning(&self, expr: &Expr, offset: usize, firsts: &[usize]) -> Meaning {
        let single = match self.drives()[..] {
            [input] => Some(input),
            _ => None,
        };
        match &expr.kind {
            ExprKind::Margin => Meaning::Margin,
            ExprKind::InputDerivative(inner, order) if single.is_some() => Meaning::Rate {
                order: u32::from(*order),
                of: self.column_of(inner, offset, firsts),
            },
            ExprKind::Derivative(inner, variables) => match variables[..] {
                [Variable::Parameter(id)] => Meaning::Sensitivity {
                    parameter: id.0,
                    of: self.column_of(inner, offset, firsts),
                },
                _ if single.is_some_and(|input| {
                    variables.iter().all(|v| *v == Variable::Input(input))
                }) =>
                {
                    Meaning::Rate {
                        order: variables.len() as u32,
                        of: self.column_of(inner, offset, firsts),
                    }
                }
                _ => Meaning::Value,
            },
            ExprKind::Sensitivity(inner, parameters) => {
                let width = leaves(&inner.ty);
                Meaning::Sensitivity {
                    parameter: parameters[offset / width].0,
                    of: self.column_of(inner, offset % width, firsts),
                }
            }
            _ => Meaning::Value,
        }
    }

    /// Where the function has a number of another expression.
    fn column_of(&self, expr: &Expr, offset: usize, firsts: &[usize]) -> Option<usize> {
        let mut quantities = self.definition.quantities.iter();
        let found = quantities.position(|quantity| quantity.value == *expr);
        found.map(|index| firsts[index] + offset)
    }
}

/// How many numbers a value has.
fn leaves(ty: &Type) -> usize {
    match ty {
        Type::Array(entries) => entries.iter().map(leaves).sum(),
        Type::Vector(count, _) | Type::Zero(count) => *count,
        Type::Frame => 12,
        Type::Scalar(_) | Type::Error => 1,
    }
}

/// Names and units of all numbers of a value.
fn flatten(
    ty: &Type,
    labels: &[Vec<String>],
    name: String,
    length: LengthUnit,
    all: &mut Vec<(String, String)>,
) {
    match ty {
        Type::Array(entries) => {
            let (own, inner) = labels.split_first().unzip();
            for (index, entry) in entries.iter().enumerate() {
                let label = own.and_then(|own: &Vec<String>| own.get(index)).cloned();
                let label = label.unwrap_or_else(|| index.to_string());
                flatten(
                    entry,
                    inner.unwrap_or_default(),
                    format!("{name}[{label}]"),
                    length,
                    all,
                );
            }
        }
        Type::Vector(count, dimension) => {
            let unit = dimension.unit(length);
            all.extend(
                AXES[..*count]
                    .iter()
                    .map(|axis| (format!("{name}.{axis}"), unit.clone())),
            );
        }
        Type::Frame => {
            for part in ["origin", "x", "y", "z"] {
                let unit = if part == "origin" { length.name() } else { "" };
                let components = AXES.iter().map(|axis| format!("{name}.{part}.{axis}"));
                all.extend(components.map(|name| (name, unit.to_owned())));
            }
        }
        Type::Zero(count) if *count > 1 => {
            all.extend(
                AXES[..*count]
                    .iter()
                    .map(|axis| (format!("{name}.{axis}"), String::new())),
            );
        }
        Type::Scalar(dimension) => all.push((name, dimension.unit(length))),
        Type::Zero(_) | Type::Error => all.push((name, String::new())),
    }
}
