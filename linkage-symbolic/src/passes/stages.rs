//! Long programs cut into stages, for loops over many positions.
//!
//! A processor overlaps the computations of neighbouring positions only as far as it looks ahead,
//! some hundred operations. A loop over a long dependent program therefore waits for results.
//! Several short loops, each over the same positions, do not wait. Each value that one loop leaves
//! for others costs memory traffic, so cuts are made where few values are left.

mod cuts;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::lookup::Map;
use crate::program::{Instruction, Program, Source, Value};

/// A part of a program. Stages leave values for others in a shared memory, so a stage reads and
/// writes only the values that it uses and makes. Positions in memory are used again once their
/// values are not needed any more.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Loads [`Source::Carried`], one for each of `taken`. Its outputs are first the values of
    /// `kept`, then results.
    pub program: Program,
    /// The positions in memory of the values from stages before.
    pub taken: Vec<usize>,
    /// The positions in memory of the values that later stages need; all of `taken` is read before.
    pub kept: Vec<usize>,
    /// The results of the whole program that the other outputs are.
    pub results: Vec<usize>,
}

/// Returns the number of values that the memory of stages holds.
pub fn memory(stages: &[Stage]) -> usize {
    let kept = stages.iter().flat_map(|stage| &stage.kept);
    kept.max().map_or(0, |last| last + 1)
}

/// Cuts `program` into stages, one if it is short.
pub fn split(program: &Program) -> Vec<Stage> {
    let program = loads_first(program);
    let last_uses = last_uses(&program);
    let mut memory = Memory::default();
    let mut stages = Vec::new();
    let mut start = 0;
    for end in cuts::ends(&program, &last_uses) {
        stages.push(stage(&program, start..end, &last_uses, &mut memory));
        start = end;
    }
    stages
}

/// The use of the memory while stages run.
#[derive(Default)]
struct Memory {
    /// The places of values that are still needed.
    slots: BTreeMap<usize, usize>,
    /// Places that nothing needs any more.
    free: BTreeSet<usize>,
    /// The number of positions.
    size: usize,
}

impl Memory {
    /// A place for `value`.
    fn keep(&mut self, value: usize) -> usize {
        let slot = self.free.pop_first().unwrap_or(self.size);
        self.size = self.size.max(slot + 1);
        self.slots.insert(value, slot);
        slot
    }

    /// Forgets `value`.
    fn drop(&mut self, value: usize) {
        self.free.extend(self.slots.remove(&value));
    }
}

/// The index of the last instruction that needs each value; 0 if none does.
fn last_uses(program: &Program) -> Vec<usize> {
    let mut last = vec![0; program.instructions.len()];
    for (index, instruction) in program.instructions.iter().enumerate() {
        instruction.operands().for_each(|x| last[x.0] = index);
    }
    last
}

/// Returns the instructions of `range`, with the values that they need from stages before, the
/// values that later stages need, and the results that are known now.
fn stage(
    program: &Program,
    range: Range<usize>,
    last_uses: &[usize],
    memory: &mut Memory,
) -> Stage {
    let end = range.end;
    let is_last = end == program.instructions.len();
    let finished = |&(_, value): &(usize, usize)| match program.instructions[value].is_free() {
        true => is_last,
        false => range.contains(&value),
    };
    let results: Vec<(usize, usize)> = program
        .outputs
        .iter()
        .map(|value| value.0)
        .enumerate()
        .filter(finished)
        .collect();
    let mut builder = Builder {
        whole: program,
        range: range.clone(),
        program: Program::default(),
        taken: Vec::new(),
        copies: Map::new(),
    };
    let operations: Vec<usize> = range
        .filter(|&index| !program.instructions[index].is_free())
        .collect();
    for &index in &operations {
        builder.copy(index);
    }
    let next: Vec<usize> = operations
        .into_iter()
        .filter(|&index| last_uses[index] >= end)
        .collect();
    let outputs = next.iter().chain(results.iter().map(|(_, value)| value));
    builder.program.outputs = outputs.map(|&value| builder.copy(value)).collect();
    let taken = builder
        .taken
        .iter()
        .map(|value| memory.slots[value])
        .collect();
    for &value in builder
        .taken
        .iter()
        .filter(|&&value| last_uses[value] < end)
    {
        memory.drop(value);
    }
    Stage {
        program: builder.program,
        taken,
        kept: next.into_iter().map(|value| memory.keep(value)).collect(),
        results: results.into_iter().map(|(result, _)| result).collect(),
    }
}

struct Builder<'a> {
    whole: &'a Program,
    range: Range<usize>,
    program: Program,
    /// Values of stages before that are needed here.
    taken: Vec<usize>,
    /// The positions of the values of the whole program in this one.
    copies: Map<usize, Value>,
}

impl Builder<'_> {
    /// Returns the position of a value, and appends it if it is missing: an instruction of this
    /// stage after its operands, a free instruction, or a load of a value from a stage before.
    fn copy(&mut self, value: usize) -> Value {
        if let Some(&copy) = self.copies.get(&value) {
            return copy;
        }
        let instruction = self.whole.instructions[value];
        let instruction = match self.range.contains(&value) || instruction.is_free() {
            true => {
                for operand in instruction.operands() {
                    self.copy(operand.0);
                }
                instruction.with_operands(|operand| self.copies[&operand.0])
            }
            false => {
                self.taken.push(value);
                Instruction::Load(Source::Carried(self.taken.len() - 1))
            }
        };
        let copy = self.program.push(instruction);
        self.copies.insert(value, copy);
        copy
    }
}

/// The program with its loads and constants first.
fn loads_first(program: &Program) -> Program {
    let (free, others): (Vec<usize>, Vec<usize>) =
        (0..program.instructions.len()).partition(|&k| program.instructions[k].is_free());
    let order = [free, others].concat();
    let mut positions = vec![Value(0); order.len()];
    for (position, &index) in order.iter().enumerate() {
        positions[index] = Value(position);
    }
    let moved = |index: &usize| program.instructions[*index].with_operands(|x| positions[x.0]);
    Program {
        instructions: order.iter().map(moved).collect(),
        outputs: program.outputs.iter().map(|x| positions[x.0]).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpret::run;
    use crate::passes::sine_pairs::pair;
    use crate::program::{Binary, Unary};

    /// `x_(k+1) = x_k * x_k + x_(k-1)`, with a sine in between; every tenth value is a result.
    fn chain(length: usize) -> Program {
        let mut instructions = vec![
            Instruction::Load(Source::Input(0)),
            Instruction::Constant(0.5),
        ];
        let mut outputs = vec![Value(1)];
        for index in 2..length {
            let [before, last] = [Value(index - 2), Value(index - 1)];
            instructions.push(match index % 7 {
                0 => Instruction::Unary(Unary::Sin, last),
                1 => Instruction::Unary(Unary::Cos, before),
                2 => Instruction::Binary(Binary::Mul, last, Value(1)),
                _ => Instruction::Binary(Binary::Sub, last, before),
            });
            if index % 10 == 0 {
                outputs.push(Value(index));
            }
        }
        pair(Program {
            instructions,
            outputs,
        })
    }

    /// All results, stage after stage.
    fn run_stages(stages: &[Stage], x: f64, count: usize) -> Vec<f64> {
        let mut results = vec![f64::NAN; count];
        let mut slots = vec![f64::NAN; memory(stages)];
        for stage in stages {
            let outputs = run(&stage.program, |source| match source {
                Source::Carried(index) => slots[stage.taken[index]],
                _ => x,
            });
            let (kept, finished) = outputs.split_at(stage.kept.len());
            for (&slot, &value) in stage.kept.iter().zip(kept) {
                slots[slot] = value;
            }
            for (&result, &value) in stage.results.iter().zip(finished) {
                results[result] = value;
            }
        }
        results
    }

    #[test]
    fn stages_compute_what_the_program_does() {
        for length in [3, 20, 100, 400, 2000] {
            let program = chain(length);
            let stages = split(&program);
            let staged = run_stages(&stages, 0.7, program.outputs.len());
            assert_eq!(staged, run(&program, |_| 0.7), "{length}");
            assert!(length < 400 || stages.len() > 3, "{}", stages.len());
        }
    }

    #[test]
    fn short_programs_are_one_stage() {
        assert_eq!(split(&chain(6)).len(), 1);
    }
}
