//! Random expressions of sums, products, powers and quotients.

use linkage_random::Random;

/// An expression over numbered leaves.
#[derive(Clone)]
pub(super) enum Expression {
    Leaf(usize),
    Negative(Box<Self>),
    Sum(Box<Self>, Box<Self>),
    Difference(Box<Self>, Box<Self>),
    Product(Box<Self>, Box<Self>),
    Quotient(Box<Self>, Box<Self>),
    /// A positive or negative power; the language writes it as a product.
    Power(Box<Self>, i32),
}

use Expression::{Difference, Leaf, Negative, Power, Product, Quotient, Sum};

/// Least divisor, and largest value, of an expression that is far from dividing by zero.
const LEAST: f64 = 0.3;
const LARGEST: f64 = 50.0;

/// How tightly the parts of an expression are bound in its text.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Sign,
    Leaf,
}

impl Expression {
    /// An expression of at most this depth.
    pub(super) fn random(depth: usize, random: &mut Random) -> Self {
        if depth == 0 || random.chance(0.1) {
            return Leaf(random.below(super::LEAVES.len()));
        }
        let mut part = || Box::new(Self::random(depth - 1, random));
        let (first, second) = (part(), part());
        match random.below(9) {
            0 => Negative(first),
            1 | 2 => Sum(first, second),
            3 => Difference(first, second),
            4 => Product(first, second),
            5..7 => Quotient(first, second),
            _ => Power(first, *random.pick(&[-3, -2, -1, 2, 3])),
        }
    }

    /// The value for the values of the leaves.
    pub(super) fn value(&self, leaves: &[f64]) -> f64 {
        match self {
            Leaf(index) => leaves[*index],
            Negative(a) => -a.value(leaves),
            Sum(a, b) => a.value(leaves) + b.value(leaves),
            Difference(a, b) => a.value(leaves) - b.value(leaves),
            Product(a, b) => a.value(leaves) * b.value(leaves),
            Quotient(a, b) => a.value(leaves) / b.value(leaves),
            Power(a, exponent) => a.value(leaves).powi(*exponent),
        }
    }

    /// Whether no part is large, and no divisor small.
    pub(super) fn is_steady(&self, leaves: &[f64]) -> bool {
        let divisor = match self {
            Quotient(_, b) => Some(b),
            Power(a, exponent) if *exponent < 0 => Some(a),
            _ => None,
        };
        self.value(leaves).abs() < LARGEST
            && divisor.is_none_or(|own| own.value(leaves).abs() > LEAST)
            && self.parts().all(|own| own.is_steady(leaves))
    }

    /// How many divisions are in it.
    pub(super) fn divisions(&self) -> usize {
        let own = match self {
            Quotient(..) => 1,
            Power(_, exponent) => usize::from(*exponent < 0),
            _ => 0,
        };
        own + self.parts().map(Self::divisions).sum::<usize>()
    }

    fn parts(&self) -> impl Iterator<Item = &Self> {
        let (first, second) = match self {
            Leaf(_) => (None, None),
            Negative(a) | Power(a, _) => (Some(a), None),
            Sum(a, b) | Difference(a, b) | Product(a, b) | Quotient(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second).map(|own| &**own)
    }

    /// The expression in the language, with no parenthesis that is not needed.
    pub(super) fn text(&self, leaves: &[&str]) -> String {
        self.bound(leaves, Binding::Sum)
    }

    /// The expression as a part that must be bound as tightly as this.
    fn bound(&self, leaves: &[&str], least: Binding) -> String {
        let (binding, text) = match self {
            Leaf(index) => (Binding::Leaf, leaves[*index].to_owned()),
            Negative(a) => (
                Binding::Sign,
                format!("-{}", a.bound(leaves, Binding::Sign)),
            ),
            Sum(a, b) | Difference(a, b) => {
                let sign = if matches!(self, Sum(..)) { '+' } else { '-' };
                let [a, b] = [
                    a.bound(leaves, Binding::Sum),
                    b.bound(leaves, Binding::Product),
                ];
                (Binding::Sum, format!("{a} {sign} {b}"))
            }
            Product(a, b) | Quotient(a, b) => {
                let sign = if matches!(self, Product(..)) {
                    '*'
                } else {
                    '/'
                };
                let [a, b] = [
                    a.bound(leaves, Binding::Product),
                    b.bound(leaves, Binding::Sign),
                ];
                (Binding::Product, format!("{a} {sign} {b}"))
            }
            Power(a, exponent) => {
                let factors =
                    vec![a.bound(leaves, Binding::Sign); exponent.unsigned_abs() as usize];
                let text = match exponent {
                    ..0 => format!("1 / {}", factors.join(" / ")),
                    _ => factors.join(" * "),
                };
                (Binding::Product, text)
            }
        };
        if binding < least {
            format!("({text})")
        } else {
            text
        }
    }
}
