//! Mechanisms whose quantities need every parenthesis when they are printed: powers of sums, negative powers and nested quotients of an input, of
//! dimensions and of an angle that a loop gives. Each language that mechanisms are printed in compares their derivatives with differences of its own
//! positions.

mod differences;
mod expression;

use linkage_random::Random;

use crate::given::{Given, written};
pub use differences::Precision;
use expression::Expression;

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
