//! Costs of programs: numbers of operations, and time.

use crate::graph::Binding;
use crate::operation::Class;
use crate::program::{Instruction, Program, Value};

/// Operation counts by class. A multiply-add is a multiplication and an addition; equal products
/// count once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Additions and subtractions.
    pub add: u32,
    /// Multiplications.
    pub mul: u32,
    /// Divisions.
    pub div: u32,
    /// Square roots, alone and within lengths.
    pub sqrt: u32,
    /// Angles of which sine or cosine is taken.
    pub sin_cos: u32,
    /// Arc tangents of two operands.
    pub atan2: u32,
    /// All else: signs, minima, choices, other functions.
    pub other: u32,
}

impl Count {
    /// Returns the counts in the order of the fields.
    pub fn by_class(self) -> [u32; 7] {
        let Self {
            add,
            mul,
            div,
            sqrt,
            sin_cos,
            atan2,
            other,
        } = self;
        [add, mul, div, sqrt, sin_cos, atan2, other]
    }

    /// Counts the operations of a program.
    pub fn of_program(program: &Program) -> Self {
        let mut count = Self::default();
        let mut products: Vec<[Value; 2]> = Vec::new();
        for (instruction, binding) in program.instructions.iter().zip(program.bindings()) {
            // What is made of constants alone the compiler of the machine computes.
            let class = instruction.class();
            let Some(class) = class.filter(|_| binding > Binding::Constant) else {
                continue;
            };
            let mut operands = instruction.operands();
            let mut factors = || [(); 2].map(|()| operands.next().expect("a product has factors"));
            match class {
                Class::Addition => count.add += 1,
                Class::Multiplication => products.push(sorted(factors())),
                Class::MultiplyAdd => {
                    products.push(sorted(factors()));
                    count.add += 1;
                }
                Class::Division => count.div += 1,
                Class::Root => count.sqrt += 1,
                Class::SineCosine => count.sin_cos += 1,
                Class::ArcTangent => count.atan2 += 1,
                Class::Other => count.other += 1,
            }
        }
        count.mul = distinct(products);
        count
    }

    /// All of them.
    #[must_use]
    pub const fn total(&self) -> u32 {
        self.add + self.mul + self.div + self.sqrt + self.sin_cos + self.atan2 + self.other
    }
}

fn sorted([a, b]: [Value; 2]) -> [Value; 2] {
    [a.min(b), a.max(b)]
}

fn distinct<V: Ord>(mut values: Vec<V>) -> u32 {
    values.sort_unstable();
    values.dedup();
    values.len() as u32
}

/// Returns the time of a call if every operation runs as early as possible, in rough cycles.
pub fn chain(program: &Program) -> u32 {
    let known = arrival_times(program);
    let outputs = program.outputs.iter().map(|output| known[output.0]);
    outputs.max().unwrap_or(0)
}

/// When each value is known, in rough cycles, if everything runs as early as it can.
pub(crate) fn arrival_times(program: &Program) -> Vec<u32> {
    let mut known: Vec<u32> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let mut latest = 0;
        for operand in instruction.operands() {
            latest = latest.max(known[operand.0]);
        }
        known.push(latest + instruction.latency());
    }
    known
}

/// Returns the cost of a program at a call by throughput, where an addition is 1. Lowering chooses
/// between equal programs by this measure.
pub fn time(program: &Program) -> u32 {
    program.instructions.iter().map(Instruction::time).sum()
}
