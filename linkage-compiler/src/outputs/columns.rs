//! The description of each number of a result: its name, its unit, its origin.

use crate::ir::{Column, Meaning, Picture};
use crate::model::{
    COMPONENTS, Derived, EvaluatorDef, Expr, ExprKind, FRAME_PARTS, LengthUnit, MechanicalQuantity,
    Mechanism, PLANE_PARTS, Quantity, Shape, Type, VECTORS_OF_PLANE, Variable,
};

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
    // Derivatives refer to the quantities themselves, which may come after them.
    let mut firsts = Vec::new();
    let mut next = 0;
    for quantity in &definition.quantities {
        firsts.push(next);
        next += match picture.filter(|_| quantity.is_picture()) {
            Some(picture) => picture.vectors() * picture.dimension,
            None => Shape::from_type(&quantity.value.ty).width(),
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
            for axis in &COMPONENTS[..picture.dimension] {
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
        let names = names(
            &quantity.value.ty,
            &self.labels(&quantity.value),
            quantity.field.clone(),
        );
        for (offset, name) in names.into_iter().enumerate() {
            all.push(Column {
                name,
                unit: self.unit(&quantity.value, offset),
                meaning: self.meaning(&quantity.value, offset, firsts),
            });
        }
    }

    /// Returns the unit of the number at an index in a quantity: for a derivative `mm/rad`,
    /// `rad/mm^2`, `mm/(rad*mm)`.
    fn unit(&self, expr: &Expr, offset: usize) -> String {
        let mut divisors = Vec::new();
        let numerator = self.numerator(expr, offset, &mut divisors);
        let mut powers: Vec<(String, usize)> = Vec::new();
        for divisor in divisors.into_iter().filter(|divisor| !divisor.is_empty()) {
            match powers.iter_mut().find(|(unit, _)| *unit == divisor) {
                Some((_, power)) => *power += 1,
                None => powers.push((divisor, 1)),
            }
        }
        let factors: Vec<String> = powers
            .into_iter()
            .map(|(unit, power)| match power {
                1 => unit,
                _ => format!("{unit}^{power}"),
            })
            .collect();
        let numerator = match numerator.as_str() {
            "" if !factors.is_empty() => "1".to_owned(),
            quotient if quotient.contains('/') && !factors.is_empty() => format!("({quotient})"),
            _ => numerator,
        };
        match factors.len() {
            0 => numerator,
            1 => format!("{numerator}/{}", factors[0]),
            _ => format!("{numerator}/({})", factors.join("*")),
        }
    }

    /// Returns the unit of the differentiated quantity, and adds the units of the variables.
    fn numerator(&self, expr: &Expr, offset: usize, divisors: &mut Vec<String>) -> String {
        let width = |inner: &Expr| Shape::from_type(&inner.ty).width();
        match expr.derived() {
            Some(Derived::ByInputs(inner, order)) => {
                let drives = self.drives();
                let mut entry = offset / width(inner);
                let numerator = self.numerator(inner, offset % width(inner), divisors);
                for _ in 0..order {
                    let input = drives[entry % drives.len()];
                    divisors.push(self.unit_of(Variable::Input(input)));
                    entry /= drives.len();
                }
                numerator
            }
            Some(Derived::ByParameters(inner, parameters)) => {
                let numerator = self.numerator(inner, offset % width(inner), divisors);
                let parameter = parameters[offset / width(inner)];
                divisors.push(self.unit_of(Variable::Parameter(parameter)));
                numerator
            }
            Some(Derived::By(inner, variables)) => {
                let numerator = self.numerator(inner, offset, divisors);
                divisors.extend(variables.iter().map(|&variable| self.unit_of(variable)));
                numerator
            }
            None => {
                let units = units(&expr.ty, self.mechanism.unit);
                units.into_iter().nth(offset).unwrap_or_default()
            }
        }
    }

    fn unit_of(&self, variable: Variable) -> String {
        let dimension = match variable {
            Variable::Input(input) => self.mechanism.inputs[input].dimension,
            Variable::Parameter(id) => self.mechanism.scalar_parameters[id.0].dimension,
        };
        dimension.unit(self.mechanism.unit)
    }

    /// Names of the entries of an array, outermost first.
    fn labels(&self, expr: &Expr) -> Vec<Vec<String>> {
        match expr.derived() {
            Some(Derived::ByInputs(inner, order)) => {
                let inputs = self.drives();
                let names = inputs
                    .iter()
                    .map(|&input| self.mechanism.input_name(input).to_owned());
                let names: Vec<String> = names.collect();
                let times = if names.len() == 1 {
                    0
                } else {
                    usize::from(order)
                };
                let mut labels = vec![names; times];
                labels.extend(self.labels(inner));
                labels
            }
            Some(Derived::ByParameters(inner, parameters)) => {
                let scalars = &self.mechanism.scalar_parameters;
                let names = parameters.iter().map(|id| scalars[id.0].name.clone());
                let mut labels = vec![names.collect()];
                labels.extend(self.labels(inner));
                labels
            }
            Some(Derived::By(inner, _)) => self.labels(inner),
            None => match &expr.kind {
                ExprKind::Index(array, _) => self.labels(array).into_iter().skip(1).collect(),
                ExprKind::Mechanics(MechanicalQuantity::MassMatrix(inputs)) => {
                    let names = inputs.iter().map(|&input| self.mechanism.input_name(input));
                    let names: Vec<String> = names.map(str::to_owned).collect();
                    vec![names.clone(), names]
                }
                // Nothing else is an entry of an array.
                _ => Vec::new(),
            },
        }
    }

    /// The inputs that the function differentiates by.
    fn drives(&self) -> Vec<usize> {
        let inputs = self.definition.inputs.iter().copied();
        inputs
            .filter(|&input| input < self.mechanism.inputs.len())
            .collect()
    }

    /// Returns the meaning of the number at an index in a quantity.
    fn meaning(&self, expr: &Expr, offset: usize, firsts: &[usize]) -> Meaning {
        let single = match self.drives()[..] {
            [input] => Some(input),
            _ => None,
        };
        match expr.derived() {
            None if expr.kind == ExprKind::Margin => Meaning::Margin,
            Some(Derived::ByInputs(inner, order)) if single.is_some() => Meaning::Rate {
                order: u32::from(order),
                of: self.column_of(inner, offset, firsts),
            },
            Some(Derived::By(inner, variables)) => match variables[..] {
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
            Some(Derived::ByParameters(inner, parameters)) => {
                let width = Shape::from_type(&inner.ty).width();
                Meaning::Sensitivity {
                    parameter: parameters[offset / width].0,
                    of: self.column_of(inner, offset % width, firsts),
                }
            }
            Some(Derived::ByInputs(..)) | None => Meaning::Value,
        }
    }

    /// Returns the column of the function with a number of another expression.
    fn column_of(&self, expr: &Expr, offset: usize, firsts: &[usize]) -> Option<usize> {
        let mut quantities = self.definition.quantities.iter();
        let found = quantities.position(|quantity| quantity.value == *expr);
        found.map(|index| firsts[index] + offset)
    }
}

/// Names of all numbers of a value.
fn names(ty: &Type, labels: &[Vec<String>], name: String) -> Vec<String> {
    let components = |count: usize| {
        COMPONENTS[..count]
            .iter()
            .map(|axis| format!("{name}.{axis}"))
    };
    match ty {
        Type::Array(entries) => {
            let (outer, inner) = labels.split_first().unzip();
            let entry = |(index, entry): (usize, &Type)| {
                let label = outer
                    .and_then(|outer: &Vec<String>| outer.get(index))
                    .cloned();
                let label = label.unwrap_or_else(|| index.to_string());
                names(entry, inner.unwrap_or_default(), format!("{name}[{label}]"))
            };
            entries.iter().enumerate().flat_map(entry).collect()
        }
        Type::Frame => FRAME_PARTS
            .into_iter()
            .flat_map(|part| COMPONENTS.map(|axis| format!("{name}.{part}.{axis}")))
            .collect(),
        Type::PlaneFrame => PLANE_PARTS[..VECTORS_OF_PLANE]
            .iter()
            .flat_map(|part| ["x", "y"].map(|axis| format!("{name}.{part}.{axis}")))
            .collect(),
        Type::Vector(count, _) => components(*count).collect(),
        Type::Zero(count) if *count > 1 => components(*count).collect(),
        Type::Scalar(_) | Type::Zero(_) | Type::Error => vec![name],
    }
}

/// Units of all numbers of a value that is no derivative.
fn units(ty: &Type, length: LengthUnit) -> Vec<String> {
    match ty {
        Type::Array(entries) => entries
            .iter()
            .flat_map(|entry| units(entry, length))
            .collect(),
        Type::Vector(count, dimension) => vec![dimension.unit(length); *count],
        Type::Scalar(dimension) => vec![dimension.unit(length)],
        Type::Frame => {
            let origin = vec![length.name().to_owned(); 3];
            origin.into_iter().chain(vec![String::new(); 9]).collect()
        }
        Type::PlaneFrame => {
            let origin = vec![length.name().to_owned(); 2];
            origin.into_iter().chain(vec![String::new(); 4]).collect()
        }
        Type::Zero(count) => vec![String::new(); *count],
        Type::Error => vec![String::new()],
    }
}
