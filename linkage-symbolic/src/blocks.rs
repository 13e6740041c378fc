//! Programs over many positions: instruction by instruction, each over a block of positions.
//!
//! An instruction is chosen once for a block, and its loop over the block becomes vector code. What
//! does not depend on the position is computed once for all blocks.

use crate::interpret::Arithmetic;
use crate::operation::{Binary, Fused, Specialised, Ternary, Unary};
use crate::program::{Instruction, Program, Source, Value};

/// The number of positions in a block: all values of a program of some hundred instructions are in
/// the nearest memory of the processor.
pub const BLOCK: usize = 64;

/// Source of the numbers that a program loads, and destination of its results.
pub trait Rows<N> {
    /// Begins with the block of positions from `start`.
    fn begin(&mut self, start: usize);
    /// Fills a block with the numbers of a source. Those behind the last position may be any.
    fn load(&mut self, source: Source, block: &mut [N; BLOCK]);
    /// Takes the results number `output`.
    fn store(&mut self, output: usize, block: &[N; BLOCK]);
}

/// A program whose values are in blocks; a block holds several values, one after the other.
#[derive(Clone, Debug, Default)]
pub struct BlockProgram {
    /// What is the same at all positions.
    once: Vec<Step>,
    /// What each block of positions needs.
    each: Vec<Step>,
    /// The number of blocks.
    blocks: usize,
    /// The blocks of the results.
    outputs: Vec<usize>,
}

/// An instruction whose operands are blocks.
#[derive(Clone, Copy, Debug)]
struct Step {
    instruction: Instruction,
    /// The block of its result.
    result: usize,
    /// The block of a cosine.
    second: usize,
}

impl BlockProgram {
    /// Prepares a program; `varies` is true for sources that differ from position to position.
    #[must_use]
    pub fn new(program: &Program, varies: impl Fn(Source) -> bool) -> Self {
        let varying = varying(program, varies);
        let mut places = Places::new(program);
        let (mut once, mut each) = (Vec::new(), Vec::new());
        for (index, &instruction) in program.instructions.iter().enumerate() {
            // A second result is computed with the first.
            if matches!(instruction, Instruction::Second(_)) {
                continue;
            }
            let next = program.instructions.get(index + 1);
            let has_second = matches!(next, Some(Instruction::Second(_)));
            let instruction = match instruction {
                Instruction::SinCos(a) if !has_second => Instruction::Unary(Unary::Sin, a),
                other => other,
            };
            let last = index + usize::from(has_second);
            for result in index..=last {
                places.take(result, varying[index]);
            }
            let step = Step {
                instruction: instruction.with_operands(|value| Value(places.blocks[value.0])),
                result: places.blocks[index],
                second: places.blocks[last],
            };
            if !varying[index] {
                once.push(step);
                continue;
            }
            each.push(step);
            let operands = instruction.operands().map(|value| value.0);
            for value in operands.chain(index..=last).filter(|&value| varying[value]) {
                places.release(value, index);
            }
        }
        let outputs = program.outputs.iter();
        Self {
            once,
            each,
            outputs: outputs.map(|output| places.blocks[output.0]).collect(),
            blocks: places.count,
        }
    }

    /// Runs it at all positions.
    #[inline(always)]
    pub fn run<A: Arithmetic>(&self, positions: usize, rows: &mut impl Rows<A::Number>) {
        let mut numbers = vec![[A::constant(0.0); BLOCK]; self.blocks];
        let mut values: Vec<Option<&mut [A::Number; BLOCK]>> =
            numbers.iter_mut().map(Some).collect();
        for step in &self.once {
            step.run::<A>(&mut values, rows);
        }
        for start in (0..positions).step_by(BLOCK) {
            rows.begin(start);
            for step in &self.each {
                step.run::<A>(&mut values, rows);
            }
            for (output, &block) in self.outputs.iter().enumerate() {
                rows.store(output, block_of(&values, block));
            }
        }
    }
}

/// Which instructions depend on a source that varies.
fn varying(program: &Program, varies: impl Fn(Source) -> bool) -> Vec<bool> {
    let mut varying: Vec<bool> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let loaded = matches!(instruction, Instruction::Load(source) if varies(*source));
        let of_operands = instruction.operands().any(|value| varying[value.0]);
        varying.push(loaded || of_operands);
    }
    varying
}

/// The blocks of values.
struct Places {
    /// The block of each value that has one.
    blocks: Vec<usize>,
    /// For each value the last instruction that needs it, at least the one that computes it; results
    /// are needed to the end.
    last_uses: Vec<usize>,
    /// Blocks whose values nothing needs any more.
    free: Vec<usize>,
    /// The number of blocks.
    count: usize,
}

impl Places {
    fn new(program: &Program) -> Self {
        let count = program.instructions.len();
        let mut last_uses: Vec<usize> = (0..count).collect();
        for (index, instruction) in program.instructions.iter().enumerate() {
            if let Instruction::Second(first) = instruction {
                last_uses[index] = first.0;
                continue;
            }
            for value in instruction.operands() {
                last_uses[value.0] = index;
            }
        }
        for output in &program.outputs {
            last_uses[output.0] = usize::MAX;
        }
        Self {
            blocks: vec![usize::MAX; count],
            last_uses,
            free: Vec::new(),
            count: 0,
        }
    }

    /// Gives a block to a value. Only values that vary get one that was used before: others keep
    /// theirs while all blocks of positions run.
    fn take(&mut self, value: usize, varies: bool) {
        let used = if varies { self.free.pop() } else { None };
        self.blocks[value] = used.unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        });
    }

    /// Takes the block of a value back that nothing needs after the instruction `index`.
    fn release(&mut self, value: usize, index: usize) {
        if self.last_uses[value] <= index {
            self.free.push(self.blocks[value]);
            // An operand may stand twice.
            self.last_uses[value] = usize::MAX;
        }
    }
}

/// A block of values.
#[inline(always)]
fn block_of<'a, N>(values: &'a [Option<&mut [N; BLOCK]>], block: usize) -> &'a [N; BLOCK] {
    values[block].as_deref().expect("no operand is a result")
}

/// An operation over a block.
struct Over<'a, A: Arithmetic, const OPERANDS: usize> {
    operands: [&'a [A::Number; BLOCK]; OPERANDS],
    result: &'a mut [A::Number; BLOCK],
}

macro_rules! over {
    ($Name:ident: $operands:literal, $method:ident, $($operand:ident)*) => {
        impl<A: Arithmetic> Specialised<$Name> for Over<'_, A, $operands> {
            #[inline(always)]
            fn run(&mut self, operation: $Name) {
                let [$($operand),*] = self.operands;
                for (index, result) in self.result.iter_mut().enumerate() {
                    *result = A::$method(operation, $($operand[index]),*);
                }
            }
        }
    };
}
over!(Unary: 1, unary, a);
over!(Binary: 2, binary, a b);
over!(Ternary: 3, ternary, a b c);
over!(Fused: 3, fused, a b c);

impl Step {
    #[inline(always)]
    fn run<A: Arithmetic>(
        &self,
        values: &mut [Option<&mut [A::Number; BLOCK]>],
        rows: &mut impl Rows<A::Number>,
    ) {
        // A result is in no block of its operands, so that its own can be taken out.
        let Some(result) = values[self.result].take() else {
            return;
        };
        match self.instruction {
            Instruction::Constant(x) => *result = [A::constant(x); BLOCK],
            Instruction::Load(source) => rows.load(source, result),
            Instruction::Unary(operation, a) => operation.specialised(&mut Over::<A, 1> {
                operands: [block_of(values, a.0)],
                result,
            }),
            Instruction::Binary(operation, a, b) => operation.specialised(&mut Over::<A, 2> {
                operands: [a, b].map(|value| block_of(values, value.0)),
                result,
            }),
            Instruction::Ternary(operation, a, b, c) => operation.specialised(&mut Over::<A, 3> {
                operands: [a, b, c].map(|value| block_of(values, value.0)),
                result,
            }),
            Instruction::Fused(operation, a, b, c) => operation.specialised(&mut Over::<A, 3> {
                operands: [a, b, c].map(|value| block_of(values, value.0)),
                result,
            }),
            Instruction::SinCos(a) => {
                let Some(cosines) = values[self.second].take() else {
                    return;
                };
                let angles = block_of(values, a.0);
                for index in 0..BLOCK {
                    [result[index], cosines[index]] = A::sine_pair(angles[index]);
                }
                values[self.second] = Some(cosines);
            }
            Instruction::Second(_) => unreachable!("it is computed with its first result"),
        }
        values[self.result] = Some(result);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpret::{OfTable, run};

    /// A program of all kinds of instructions: values that nobody needs, an operand that is both of
    /// a product, a sine without its cosine, a cosine without its sine, results that are constants,
    /// loads and each other.
    fn sample() -> Program {
        let mut program = Program::default();
        let mut push = |instruction| program.push(instruction);
        let x = push(Instruction::Load(Source::Input(0)));
        let a = push(Instruction::Load(Source::Parameter(0)));
        let two = push(Instruction::Constant(2.0));
        let unused = push(Instruction::Binary(Binary::Mul, x, x));
        let square = push(Instruction::Binary(Binary::Mul, a, a));
        let y = push(Instruction::Load(Source::Input(1)));
        let sine = push(Instruction::SinCos(x));
        let pair = push(Instruction::SinCos(y));
        let cosine = push(Instruction::Second(pair));
        let sum = push(Instruction::Fused(Fused::MulAdd, sine, cosine, square));
        let root = push(Instruction::Unary(Unary::Abs, sum));
        let root = push(Instruction::Unary(Unary::Sqrt, root));
        let chosen = push(Instruction::Ternary(Ternary::Select, sine, root, two));
        let angle = push(Instruction::Binary(Binary::Atan2, chosen, y));
        let last = push(Instruction::Binary(Binary::Sub, angle, angle));
        let _ = (unused, last);
        program.outputs = vec![two, angle, x, square, chosen, angle, cosine];
        program
    }

    struct Sample<'a> {
        inputs: &'a [Vec<f64>; 2],
        start: usize,
        found: Vec<Vec<f64>>,
    }

    impl Rows<f64> for Sample<'_> {
        fn begin(&mut self, start: usize) {
            self.start = start;
        }

        fn load(&mut self, source: Source, block: &mut [f64; BLOCK]) {
            for (index, number) in block.iter_mut().enumerate() {
                *number = match source {
                    Source::Input(input) => {
                        let inputs = &self.inputs[input];
                        inputs[(self.start + index).min(inputs.len() - 1)]
                    }
                    _ => 1.5,
                };
            }
        }

        fn store(&mut self, output: usize, block: &[f64; BLOCK]) {
            self.found[output].extend(block);
        }
    }

    #[test]
    fn blocks_have_the_numbers_of_single_positions() {
        let program = sample();
        // One position, a whole block, and one more.
        for positions in [1, BLOCK, BLOCK + 1] {
            let numbers = |factor: f64| -> Vec<f64> {
                (0..positions).map(|k| factor * k as f64 - 3.0).collect()
            };
            // The second input differs from position to position, or is the same everywhere.
            for second in [numbers(-0.11), vec![0.7; positions]] {
                let is_constant = second.iter().all(|x| *x == second[0]);
                let inputs = [numbers(0.37), second];
                let placed = BlockProgram::new(&program, |source| match source {
                    Source::Input(0) => true,
                    Source::Input(_) => !is_constant,
                    _ => false,
                });
                let mut sample = Sample {
                    inputs: &inputs,
                    start: 0,
                    found: vec![Vec::new(); program.outputs.len()],
                };
                placed.run::<OfTable>(positions, &mut sample);
                for position in 0..positions {
                    let expected = run(&program, |source| match source {
                        Source::Input(input) => inputs[input][position],
                        _ => 1.5,
                    });
                    let found = sample.found.iter().map(|column| column[position]);
                    assert_eq!(expected, found.collect::<Vec<f64>>(), "{position}");
                }
            }
        }
    }

    #[test]
    fn blocks_are_used_again() {
        let mut program = Program::default();
        let mut value = program.push(Instruction::Load(Source::Input(0)));
        for _ in 0..100 {
            value = program.push(Instruction::Binary(Binary::Mul, value, value));
        }
        program.outputs = vec![value];
        assert_eq!(BlockProgram::new(&program, |_| true).blocks, 2);
    }
}
