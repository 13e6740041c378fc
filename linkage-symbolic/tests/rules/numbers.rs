//! What the letters of formulas stand for.

use linkage_random::Random;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Graph, NodeId};

/// `k` and `m` where rules want two numbers: positive, not 1, not powers of two.
pub(crate) const NUMBERS: [[f64; 2]; 4] = [[3.0, 0.1], [0.7, 5.0], [1e-5, 37.0], [1.1, 1.3]];

/// Numbers that have their own way with operations.
pub(crate) const SPECIAL: [f64; 14] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    1.0,
    -1.0,
    5e-324,
    -5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    -3.7,
    1e200,
];

/// The symbols in the order in which they are made: what stands first here stands first in sums.
const SYMBOLS: [(char, Source); 6] = [
    ('p', Source::Parameter(0)),
    ('q', Source::Parameter(1)),
    ('r', Source::Parameter(2)),
    ('x', Source::Input(0)),
    ('y', Source::Input(1)),
    ('z', Source::Input(2)),
];

/// The letters as nodes.
pub(crate) struct Symbols {
    nodes: [NodeId; 6],
    numbers: [f64; 2],
}

impl Symbols {
    pub(crate) fn new(graph: &Graph, numbers: [f64; 2]) -> Self {
        let nodes = SYMBOLS.map(|(_, source)| graph.source(source));
        Self { nodes, numbers }
    }

    pub(crate) fn node(&self, graph: &Graph, letter: char) -> NodeId {
        match letter {
            'k' => graph.constant(self.numbers[0]),
            'm' => graph.constant(self.numbers[1]),
            _ => self.nodes[place(|symbol| symbol.0 == letter)],
        }
    }
}

/// The letters as random numbers.
#[derive(Debug)]
pub(crate) struct Values {
    symbols: [f64; 6],
    numbers: [f64; 2],
}

impl Values {
    pub(crate) fn new(random: &mut Random, symbols: &Symbols) -> Self {
        let mut values = [0.0; 6];
        for k in 0..values.len() {
            // Equal and opposite numbers cancel.
            values[k] = match (k, random.below(10)) {
                (1.., 0) => values[random.below(k)],
                (1.., 1) => -values[random.below(k)],
                _ => number(random),
            };
        }
        Self {
            symbols: values,
            numbers: symbols.numbers,
        }
    }

    pub(crate) fn of_letter(&self, letter: char) -> f64 {
        match letter {
            'k' => self.numbers[0],
            'm' => self.numbers[1],
            _ => self.symbols[place(|symbol| symbol.0 == letter)],
        }
    }

    pub(crate) fn of_source(&self, source: Source) -> f64 {
        self.symbols[place(|symbol| symbol.1 == source)]
    }
}

fn place(is: impl Fn(&(char, Source)) -> bool) -> usize {
    SYMBOLS.iter().position(is).expect("a letter of formulas")
}

/// Mostly a number of everyday size, so that results are mostly in range.
fn number(random: &mut Random) -> f64 {
    let sign = if random.chance(0.5) { 1.0 } else { -1.0 };
    match random.below(20) {
        0..10 => sign * random.between(0.0, 10.0),
        10..15 => sign * random.ratio(1e-30, 1e30),
        15 => sign * random.ratio(1e-300, 1e300),
        16 => f64::from_bits(random.bits()),
        _ => *random.pick(&SPECIAL),
    }
}
