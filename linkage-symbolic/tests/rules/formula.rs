//! Formulas as they stand in the names of rules.

use std::collections::BTreeSet;
use std::iter::Peekable;
use std::str::Chars;

use linkage_symbolic::program::{Binary, Ternary, Unary};
use linkage_symbolic::{Graph, NodeId};

use crate::exact::ANGLE;
use crate::numbers::{Symbols, Values};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operation {
    Unary(Unary),
    Binary(Binary),
    Ternary(Ternary),
}

impl Operation {
    pub(crate) fn apply(self, operands: &[f64]) -> f64 {
        match (self, operands) {
            (Self::Unary(op), &[a]) => op.apply([a]),
            (Self::Binary(op), &[a, b]) => op.apply([a, b]),
            (Self::Ternary(op), &[a, b, c]) => op.apply([a, b, c]),
            _ => panic!("{self:?} of {operands:?}"),
        }
    }

    fn named(name: &str) -> Self {
        let unary = Unary::ALL.iter().find(|op| op.row().name == name);
        let binary = Binary::ALL.iter().find(|op| op.row().name == name);
        let ternary = Ternary::ALL.iter().find(|op| op.row().name == name);
        let found = unary.map(|&op| Self::Unary(op));
        let found = found.or(binary.map(|&op| Self::Binary(op)));
        let found = found.or(ternary.map(|&op| Self::Ternary(op)));
        found.unwrap_or_else(|| panic!("no operation {name}"))
    }
}

/// A formula. Letters are those of [`Symbols`].
#[derive(Debug)]
pub(crate) enum Formula {
    Number(f64),
    Letter(char),
    Of(Operation, Vec<Self>),
}

/// Results from here to its inverse lose no digits next to zero and do not overflow, nor do the low halves of [`crate::exact`].
const LEAST: f64 = 1e-250;

impl Formula {
    /// Reads a formula; `f` is an operation.
    pub(crate) fn parse(text: &str, f: Operation) -> Self {
        let mut parser = Parser {
            rest: text.chars().peekable(),
            f,
        };
        let formula = parser.sum();
        assert_eq!(parser.next(), None, "behind the formula in {text}");
        formula
    }

    /// Its node, made by the constructors.
    pub(crate) fn build(&self, graph: &Graph, symbols: &Symbols) -> NodeId {
        match self {
            Self::Number(value) => graph.constant(*value),
            Self::Letter(letter) => symbols.node(graph, *letter),
            Self::Of(operation, parts) => {
                let parts: Vec<_> = parts.iter().map(|x| x.build(graph, symbols)).collect();
                match (operation, &parts[..]) {
                    (Operation::Unary(op), &[a]) => graph.unary(*op, a),
                    (Operation::Binary(op), &[a, b]) => graph.binary(*op, a, b),
                    (Operation::Ternary(op), &[a, b, c]) => graph.ternary(*op, a, b, c),
                    _ => panic!("{self:?}"),
                }
            }
        }
    }

    pub(crate) fn letters(&self) -> BTreeSet<char> {
        match self {
            Self::Number(_) => BTreeSet::new(),
            Self::Letter(letter) => BTreeSet::from([*letter]),
            Self::Of(_, parts) => parts.iter().flat_map(Self::letters).collect(),
        }
    }

    /// Whether it has the sine of an angle that is too large for its exact value to be known here.
    pub(crate) fn has_large_angle(&self, values: &Values) -> bool {
        let Self::Of(operation, parts) = self else {
            return false;
        };
        let of_angle = matches!(operation, Operation::Unary(Unary::Sin | Unary::Cos));
        parts.iter().any(|part| match part {
            Self::Of(..) => part.has_large_angle(values),
            _ => of_angle && (ANGLE..f64::INFINITY).contains(&part.leaf(values).abs()),
        })
    }

    /// How often a value is rounded on its way to the result.
    pub(crate) fn roundings(&self) -> i32 {
        let Self::Of(operation, parts) = self else {
            return 0;
        };
        let parts = parts.iter().map(Self::roundings);
        match operation {
            Operation::Unary(Unary::Neg) => parts.sum(),
            Operation::Unary(Unary::Sin | Unary::Cos) => 1 + parts.sum::<i32>(),
            // Each term has its own.
            Operation::Binary(Binary::Add | Binary::Sub) => 1 + parts.max().unwrap_or(0),
            Operation::Binary(Binary::Mul | Binary::Div) => 1 + parts.sum::<i32>(),
            _ => panic!("{operation:?} is rounded in its own way"),
        }
    }

    /// Its value, if no result on the way overflows or comes near to zero by anything but cancellation. What is divided by zero is infinite
    /// or NaN, and in range.
    pub(crate) fn in_range(&self, values: &Values) -> Option<f64> {
        let fits = |x: f64| x == 0.0 || (LEAST..=LEAST.recip()).contains(&x.abs());
        let Self::Of(operation, parts) = self else {
            let value = self.leaf(values);
            return fits(value).then_some(value);
        };
        let parts = parts.iter().map(|part| part.in_range(values));
        let parts: Vec<f64> = parts.collect::<Option<_>>()?;
        let value = operation.apply(&parts);
        let beside_pole = parts.iter().any(|x| !x.is_finite());
        let fits = match (operation, &parts[..]) {
            _ if beside_pole => true,
            (Operation::Binary(Binary::Div), [_, 0.0]) => true,
            (Operation::Binary(Binary::Mul | Binary::Div), _) if value == 0.0 => {
                parts.contains(&0.0)
            }
            _ => fits(value),
        };
        fits.then_some(value)
    }

    fn leaf(&self, values: &Values) -> f64 {
        match self {
            Self::Number(value) => *value,
            Self::Letter(letter) => values.of_letter(*letter),
            Self::Of(..) => panic!("{self:?} is no leaf"),
        }
    }
}

/// `sum = term {("+" | "-") term}`, `term = "-" term | product ["/" product]`, `product = factor {factor}`.
struct Parser<'a> {
    rest: Peekable<Chars<'a>>,
    f: Operation,
}

impl Parser<'_> {
    fn peek(&mut self) -> Option<char> {
        while self.rest.next_if_eq(&' ').is_some() {}
        self.rest.peek().copied()
    }

    fn next(&mut self) -> Option<char> {
        self.peek();
        self.rest.next()
    }

    fn takes(&mut self, sign: char) -> bool {
        let found = self.peek() == Some(sign);
        if found {
            self.rest.next();
        }
        found
    }

    fn sum(&mut self) -> Formula {
        let mut sum = self.term();
        loop {
            let operation = match self.peek() {
                Some('+') => Binary::Add,
                Some('-') => Binary::Sub,
                _ => return sum,
            };
            self.rest.next();
            sum = binary(operation, sum, self.term());
        }
    }

    fn term(&mut self) -> Formula {
        if self.takes('-') {
            return Formula::Of(Operation::Unary(Unary::Neg), vec![self.term()]);
        }
        let dividend = self.product();
        match self.takes('/') {
            true => binary(Binary::Div, dividend, self.product()),
            false => dividend,
        }
    }

    fn product(&mut self) -> Formula {
        let mut product = self.factor();
        let begins = |c: char| c.is_alphanumeric() || c == '(';
        while self.peek().is_some_and(begins) {
            product = binary(Binary::Mul, product, self.factor());
        }
        product
    }

    fn factor(&mut self) -> Formula {
        if self.takes('(') {
            let sum = self.sum();
            assert!(self.takes(')'), "a parenthesis is open");
            return sum;
        }
        self.peek();
        let mut word = String::new();
        while let Some(c) = self
            .rest
            .next_if(|&c| c.is_alphanumeric() || c == '.' || c == '_')
        {
            word.push(c);
        }
        if let Ok(number) = word.parse() {
            return Formula::Number(number);
        }
        match (word.len(), self.rest.next_if_eq(&'(')) {
            (1, None) => Formula::Letter(word.remove(0)),
            (_, Some(_)) => {
                let operation = match &word[..] {
                    "f" => self.f,
                    name => Operation::named(name),
                };
                let mut parts = vec![self.sum()];
                while self.takes(',') {
                    parts.push(self.sum());
                }
                assert!(self.takes(')'), "{word} is open");
                Formula::Of(operation, parts)
            }
            _ => panic!("what is {word:?}?"),
        }
    }
}

fn binary(operation: Binary, a: Formula, b: Formula) -> Formula {
    Formula::Of(Operation::Binary(operation), vec![a, b])
}
