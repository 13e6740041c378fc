//! Mechanisms whose quantities need every parenthesis when they are printed: powers of sums, negative powers and nested quotients of an input, of
//! dimensions and of an angle that a loop gives. Each language that mechanisms are printed in compares their derivatives with differences of its own
//! positions.

mod differences;

use crate::given::{Given, written};
use Expression::{Difference, Leaf, Negative, Power, Product, Quotient, Sum};
pub use differences::Precision;
use linkage_random::Random;

/// Quantities of a random mechanism, besides the rocker's angle.
const QUANTITIES: usize = 8;

/// Depth of a random expression.
const DEPTH: usize = 4;

/// Positions and sets of dimensions at which a random expression must be far from dividing by zero.
const SAMPLES: usize = 60;

/// A four-bar, and three numbers.
const FOUR_BAR: &str = "
    unit mm;
    param a = 1.3;
    param b = 0.8;
    param c = 1.7;
    param crank = 50mm;
    param coupler = 120mm;
    param rocker = 100mm;
    param ground = 140mm;
    input phi = 60deg in 0deg..360deg;
    unknown theta = 40deg;
    unknown psi = 80deg;
    loop polar(crank, phi) + polar(coupler, theta) = (ground, 0) + polar(rocker, psi);
";

/// The dimensions of [`FOUR_BAR`].
const DIMENSIONS: [f64; 7] = [1.3, 0.8, 1.7, 50.0, 120.0, 100.0, 140.0];

/// The numbers that an expression is made of, in the language.
const LEAVES: [&str; 6] = ["a", "b", "c", "sin(phi)", "cos(psi)", "2"];

/// The same numbers for dimensions, the crank's angle and the rocker's.
fn leaves(dimensions: &[f64], phi: f64, psi: f64) -> [f64; LEAVES.len()] {
    let [a, b, c] = [dimensions[0], dimensions[1], dimensions[2]];
    [a, b, c, phi.sin(), psi.cos(), 2.0]
}

/// The rocker's angle, by the triangle of coupler, rocker and the line from the crank's pin to the rocker's pivot.
fn rocker_angle(dimensions: &[f64], phi: f64) -> f64 {
    let [crank, coupler, rocker, ground] = [3, 4, 5, 6].map(|k| dimensions[k]);
    let (x, y) = (crank * phi.cos() - ground, crank * phi.sin());
    let square = x * x + y * y;
    let cosine = (square + rocker * rocker - coupler * coupler) / (2.0 * rocker * square.sqrt());
    y.atan2(x) - cosine.acos()
}

/// A mechanism with its quantities. Its one function gives all of them, then velocity, acceleration, sensitivity, and sensitivity of the velocity of each.
#[derive(Clone)]
pub struct Quotients {
    /// The mechanism.
    pub given: Given,
    /// How many quantities there are.
    quantities: usize,
    /// Quantities behind the first one whose values are known; none for the mechanism of a file.
    trees: Vec<Expression>,
}

impl Quotients {
    /// The mechanism that is tested as generated Rust, too.
    #[must_use]
    pub fn written() -> Self {
        let all = written("tests/corpus/tests/corpus/quotients.rs");
        let given = Given::text(&all[0]);
        let outputs = given.unit.functions[0].called.program.outputs.len();
        Self {
            quantities: outputs / (3 + 2 * DIMENSIONS.len()),
            trees: Vec::new(),
            given,
        }
    }

    /// A mechanism with random quantities, the first of which is the rocker's angle.
    #[must_use]
    pub fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let samples: Vec<_> = (0..SAMPLES)
            .map(|_| {
                let dimensions = DIMENSIONS.map(|x| x * random.between(0.93, 1.07));
                let phi = random.turn();
                leaves(&dimensions, phi, rocker_angle(&dimensions, phi))
            })
            .collect();
        let mut trees = Vec::new();
        while trees.len() < QUANTITIES {
            let tree = Expression::random(DEPTH, &mut random);
            let steady = samples.iter().all(|own| tree.is_steady(own));
            if steady && tree.divisions() >= 2 {
                trees.push(tree);
            }
        }
        Self {
            given: Given::text(&text(&format!("Quotients{seed}"), &trees)),
            quantities: 1 + QUANTITIES,
            trees,
        }
    }
}

/// The mechanism with these quantities.
fn text(name: &str, trees: &[Expression]) -> String {
    let names: Vec<String> = (0..trees.len()).map(|k| format!("q{k}")).collect();
    let definitions = names.iter().zip(trees);
    let definitions: String = definitions
        .map(|(name, tree)| format!("    let {name} = {};\n", tree.text(&LEAVES)))
        .collect();
    let quantities = || std::iter::once("psi").chain(names.iter().map(String::as_str));
    let mut results: Vec<String> = quantities().map(str::to_owned).collect();
    results.extend(quantities().map(|q| format!("v_{q}: velocity({q})")));
    results.extend(quantities().map(|q| format!("a_{q}: acceleration({q})")));
    results.extend(quantities().map(|q| format!("s_{q}: sensitivity({q})")));
    results.extend(quantities().map(|q| format!("m_{q}: sensitivity(velocity({q}))")));
    format!(
        "pub struct {name} {{{FOUR_BAR}{definitions}}}\nimpl {name} {{\n    pub fn motion(phi) -> Motion {{ {} }}\n}}\n",
        results.join(", ")
    )
}

// Random expressions of sums, products, powers and quotients.

/// An expression over numbered leaves.
#[derive(Clone)]
enum Expression {
    Leaf(usize),
    Negative(Box<Self>),
    Sum(Box<Self>, Box<Self>),
    Difference(Box<Self>, Box<Self>),
    Product(Box<Self>, Box<Self>),
    Quotient(Box<Self>, Box<Self>),
    /// A positive or negative power; the language writes it as a product.
    Power(Box<Self>, i32),
}

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
    fn random(depth: usize, random: &mut Random) -> Self {
        if depth == 0 || random.chance(0.1) {
            return Leaf(random.below(LEAVES.len()));
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
    fn value(&self, leaves: &[f64]) -> f64 {
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
    fn is_steady(&self, leaves: &[f64]) -> bool {
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
    fn divisions(&self) -> usize {
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
    fn text(&self, leaves: &[&str]) -> String {
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
