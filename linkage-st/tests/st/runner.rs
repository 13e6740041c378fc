//! Runs structured text on numbers of IEEE 754.

use std::collections::BTreeMap;

use crate::syntax::{Expression, File, Initial, Kind, Statement, Step, Unit, Variable};

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Real(f64),
    Integer(i64),
    Boolean(bool),
    Members(BTreeMap<String, Value>),
    Entries(Vec<usize>, Vec<Value>),
}

impl Value {
    /// All real numbers, members in the order of their declaration.
    pub(crate) fn reals(&self, file: &File, kind: &Kind) -> Vec<f64> {
        match (self, kind) {
            (Self::Real(x), _) => vec![*x],
            (Self::Members(members), Kind::Named(name)) => {
                let declared = file.types[name].iter();
                let numbers = declared.flat_map(|own| members[&own.name].reals(file, &own.kind));
                numbers.collect()
            }
            (Self::Entries(_, entries), Kind::Array(_, kind)) => entries
                .iter()
                .flat_map(|own| own.reals(file, kind))
                .collect(),
            _ => panic!("{self:?} is no {kind:?}"),
        }
    }

    fn real(self) -> f64 {
        match self {
            Self::Real(x) => x,
            other => panic!("{other:?} is no real number"),
        }
    }

    fn boolean(self) -> bool {
        match self {
            Self::Boolean(x) => x,
            other => panic!("{other:?} is no truth value"),
        }
    }

    fn step(&mut self, step: &Step) -> &mut Self {
        match (self, step) {
            (Self::Members(members), Step::Name(name)) => members
                .get_mut(name)
                .unwrap_or_else(|| panic!("there is no `{name}`")),
            (Self::Entries(sizes, entries), Step::Entry(indices)) => {
                assert_eq!(sizes.len(), indices.len());
                let index = sizes.iter().zip(indices).fold(0, |before, (size, index)| {
                    assert!(index < size);
                    before * size + index
                });
                &mut entries[index]
            }
            (other, step) => panic!("{other:?} has no {step:?}"),
        }
    }
}

/// The variables of a call, by their names.
pub(crate) type Variables = BTreeMap<String, Value>;

impl File {
    /// A variable of a type, with the initial values of its members.
    pub(crate) fn value(&self, kind: &Kind, initial: Option<&Initial>) -> Value {
        match (kind, initial) {
            (Kind::Real, Some(Initial::Number(x))) => Value::Real(*x),
            (Kind::Real, None) => Value::Real(0.0),
            (Kind::Integer, None) => Value::Integer(0),
            (Kind::Boolean, None) => Value::Boolean(false),
            (Kind::Array(sizes, entry), None) => {
                let count = sizes.iter().product();
                Value::Entries(sizes.clone(), vec![self.value(entry, None); count])
            }
            (Kind::Named(name), initial) => {
                let declared = self.types[name].iter();
                let mut members: BTreeMap<String, Value> = declared
                    .map(|own| {
                        (
                            own.name.clone(),
                            self.value(&own.kind, own.initial.as_ref()),
                        )
                    })
                    .collect();
                if let Some(Initial::Members(given)) = initial {
                    for (name, initial) in given {
                        let kind = &self.types[&kind_name(kind)];
                        let member = kind.iter().find(|own| own.name == *name);
                        let kind = &member.expect("a member").kind;
                        members.insert(name.clone(), self.value(kind, Some(initial)));
                    }
                }
                Value::Members(members)
            }
            (kind, initial) => panic!("{kind:?} is not {initial:?}"),
        }
    }

    /// Calls a function block with its inputs and the mechanism; returns its variables.
    pub(crate) fn call(&self, block: &str, mechanism: &mut Value, inputs: &[f64]) -> Variables {
        let block = &self.blocks[&block.to_ascii_lowercase()];
        let mut variables = self.variables(block);
        variables.insert("m".to_owned(), mechanism.clone());
        assert_eq!(block.inputs.len(), inputs.len(), "{}", block.name);
        for (input, x) in block.inputs.iter().zip(inputs) {
            variables.insert(input.name.clone(), Value::Real(*x));
        }
        self.run(&block.body, &mut variables);
        *mechanism = variables["m"].clone();
        variables
    }

    fn variables(&self, unit: &Unit) -> Variables {
        let all = [&unit.inputs, &unit.others, &unit.variables]
            .into_iter()
            .flatten();
        let value = |own: &Variable| self.value(&own.kind, own.initial.as_ref());
        all.map(|own| (own.name.clone(), value(own))).collect()
    }

    fn run(&self, statements: &[Statement], variables: &mut Variables) {
        for statement in statements {
            match statement {
                Statement::Assign(path, expression) => {
                    let value = self.evaluate(expression, variables);
                    let target = find(path, variables);
                    assert_eq!(
                        std::mem::discriminant(target),
                        std::mem::discriminant(&value),
                        "{path:?} has another type"
                    );
                    *target = value;
                }
                Statement::If(branches) => {
                    let mut branches = branches.iter();
                    let taken = branches
                        .find(|(condition, _)| self.evaluate(condition, variables).boolean());
                    if let Some((_, statements)) = taken {
                        self.run(statements, variables);
                    }
                }
            }
        }
    }

    fn evaluate(&self, expression: &Expression, variables: &mut Variables) -> Value {
        match expression {
            Expression::Real(x) => Value::Real(*x),
            Expression::Integer(x) => Value::Integer(*x),
            Expression::Boolean(x) => Value::Boolean(*x),
            Expression::Path(path) => find(path, variables).clone(),
            Expression::Unary("-", a) => Value::Real(-self.evaluate(a, variables).real()),
            Expression::Unary(_, a) => Value::Boolean(!self.evaluate(a, variables).boolean()),
            Expression::Binary(operator, operands) => {
                let [a, b] = operands.each_ref().map(|own| self.evaluate(own, variables));
                binary(operator, a, b)
            }
            Expression::Call(name, operands) => {
                let operands = operands.iter().map(|own| self.evaluate(own, variables));
                self.function(name, operands.collect())
            }
        }
    }

    fn function(&self, name: &str, operands: Vec<Value>) -> Value {
        if name == "sel" {
            let [Value::Boolean(second), a, b] = &operands[..] else {
                panic!("SEL({operands:?})")
            };
            assert_eq!(std::mem::discriminant(a), std::mem::discriminant(b));
            return if *second { b.clone() } else { a.clone() };
        }
        let of_one = match name {
            "abs" => f64::abs,
            "sqrt" => f64::sqrt,
            "tan" => f64::tan,
            "asin" => f64::asin,
            "acos" => f64::acos,
            "atan" => f64::atan,
            _ => {
                let function = &self.functions[name];
                let mut variables = self.variables(function);
                variables.insert(name.to_owned(), Value::Real(0.0));
                assert_eq!(function.inputs.len(), operands.len(), "{name}");
                for (input, x) in function.inputs.iter().zip(operands) {
                    variables.insert(input.name.clone(), Value::Real(x.real()));
                }
                self.run(&function.body, &mut variables);
                return variables[name].clone();
            }
        };
        let [x] = &operands[..] else {
            panic!("{name}({operands:?})")
        };
        Value::Real(of_one(x.clone().real()))
    }
}

fn binary(operator: &str, a: Value, b: Value) -> Value {
    if let "and" | "or" | "xor" = operator {
        let (a, b) = (a.boolean(), b.boolean());
        return Value::Boolean(match operator {
            "and" => a && b,
            "or" => a || b,
            _ => a != b,
        });
    }
    let (a, b) = (a.real(), b.real());
    match operator {
        "+" => Value::Real(a + b),
        "-" => Value::Real(a - b),
        "*" => Value::Real(a * b),
        "/" => Value::Real(a / b),
        "<" => Value::Boolean(a < b),
        ">" => Value::Boolean(a > b),
        "<=" => Value::Boolean(a <= b),
        ">=" => Value::Boolean(a >= b),
        "=" => Value::Boolean(a == b),
        "<>" => Value::Boolean(a != b),
        other => panic!("{other} is no operator"),
    }
}

fn find<'v>(path: &[Step], variables: &'v mut Variables) -> &'v mut Value {
    let [Step::Name(first), steps @ ..] = path else {
        panic!("a path begins with a name")
    };
    let first = variables
        .get_mut(first)
        .unwrap_or_else(|| panic!("there is no `{first}`"));
    steps.iter().fold(first, Value::step)
}

fn kind_name(kind: &Kind) -> String {
    match kind {
        Kind::Named(name) => name.clone(),
        other => panic!("{other:?} has no name"),
    }
}
