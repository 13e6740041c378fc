//! Long programs cut into stages, for loops over many positions.
//!
//! A processor overlaps the computations of neighbouring positions only as far as it looks ahead, some hundred
//! operations. A loop over a long dependent program therefore waits for results; several short loops, each over the same
//! positions, do not. What is carried from one loop to the next costs memory traffic, so cuts are made where few values are
//! alive.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::program::{Instruction, Program, Source, Value};

/// A part of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Loads [`Source::Carried`] from the stage before. Its outputs are first the values that are carried on, then
    /// results.
    pub program: Program,
    /// How many outputs are carried on.
    pub carried: usize,
    /// Which results of the whole program the other outputs are.
    pub results: Vec<usize>,
}

/// Operations that a stage may have without cost, about what a processor looks ahead for two positions.
const SIZE: usize = 64;

/// What a carried value costs, a store and a load, and what a loop costs, in operations.
const CARRY: usize = 2;
const LOOP: usize = 8;

/// Cuts `program` into stages, one if it is short.
pub fn split(program: &Program) -> Vec<Stage> {
    let program = loads_first(program);
    let last_uses = last_uses(&program);
    let mut stages = Vec::new();
    let mut carried = Vec::new();
    let mut start = 0;
    for end in cuts(&program, &last_uses) {
        let is_alive =
            |value: &usize| last_uses[*value] >= end && !is_free(&program.instructions[*value]);
        let next: Vec<usize> = (0..end).filter(is_alive).collect();
        stages.push(stage(&program, start..end, &carried, &next));
        (start, carried) = (end, next);
    }
    stages
}

/// The index of the last instruction that needs each value; 0 if none does.
fn last_uses(program: &Program) -> Vec<usize> {
    let mut last = vec![0; program.instructions.len()];
    for (index, instruction) in program.instructions.iter().enumerate() {
        instruction.operands().for_each(|x| last[x.0] = index);
    }
    last
}

/// The instructions of `range`, with `carried` values from before, values that are needed later, and the results that
/// are known now.
fn stage(program: &Program, range: Range<usize>, carried: &[usize], next: &[usize]) -> Stage {
    let is_last = range.end == program.instructions.len();
    let finished = |&(_, value): &(usize, usize)| match is_free(&program.instructions[value]) {
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
        carried,
        program: Program::default(),
        places: BTreeMap::new(),
    };
    for index in range {
        if !is_free(&program.instructions[index]) {
            builder.place(index);
        }
    }
    let outputs = next.iter().chain(results.iter().map(|(_, value)| value));
    let outputs: Vec<Value> = outputs.map(|&value| builder.place(value)).collect();
    builder.program.outputs = outputs;
    Stage {
        program: builder.program,
        carried: next.len(),
        results: results.into_iter().map(|(result, _)| result).collect(),
    }
}

struct Builder<'a> {
    whole: &'a Program,
    carried: &'a [usize],
    program: Program,
    /// Where values of the whole program are in this one.
    places: BTreeMap<usize, Value>,
}

impl Builder<'_> {
    /// Where a value is, appended if it is not there yet: an instruction of this stage whose operands are there or
    /// free, or what is carried.
    fn place(&mut self, value: usize) -> Value {
        if let Some(&place) = self.places.get(&value) {
            return place;
        }
        let instruction = match self.carried.binary_search(&value) {
            Ok(index) => Instruction::Load(Source::Carried(index)),
            Err(_) => {
                let instruction = self.whole.instructions[value];
                let operands: Vec<Value> = instruction.operands().collect();
                operands.iter().for_each(|operand| {
                    self.place(operand.0);
                });
                instruction.with_operands(|operand| self.places[&operand.0])
            }
        };
        let place = self.program.push(instruction);
        self.places.insert(value, place);
        place
    }
}

/// The program with its loads and constants first.
fn loads_first(program: &Program) -> Program {
    let (free, others): (Vec<usize>, Vec<usize>) =
        (0..program.instructions.len()).partition(|&k| is_free(&program.instructions[k]));
    let order = [free, others].concat();
    let mut places = vec![Value(0); order.len()];
    for (place, &index) in order.iter().enumerate() {
        places[index] = Value(place);
    }
    let moved = |index: &usize| program.instructions[*index].with_operands(|x| places[x.0]);
    Program {
        instructions: order.iter().map(moved).collect(),
        outputs: program.outputs.iter().map(|x| places[x.0]).collect(),
    }
}

/// Loads and constants are repeated where they are needed and never carried.
fn is_free(instruction: &Instruction) -> bool {
    matches!(instruction, Instruction::Load(_) | Instruction::Constant(_))
}

/// The ends of the stages, the cheapest that there are.
fn cuts(program: &Program, last_uses: &[usize]) -> Vec<usize> {
    let count = program.instructions.len();
    let alive = alive(program, last_uses);
    let mut weights = vec![0];
    for instruction in &program.instructions {
        weights.push(weights[weights.len() - 1] + instruction.size() as usize);
    }
    // The least cost of stages up to each instruction, and where the last of them starts.
    let mut best: Vec<(usize, usize)> = vec![(0, 0)];
    for end in 1..=count {
        let mut least = (usize::MAX, 0);
        for start in (0..end).rev().filter(|&start| !splits_pair(program, start)) {
            let size = weights[end] - weights[start];
            let excess = size.saturating_sub(SIZE);
            let cost = best[start].0 + CARRY * alive[start] + LOOP + excess * excess / SIZE;
            if cost < least.0 {
                least = (cost, start);
            }
            if size > 4 * SIZE {
                break;
            }
        }
        best.push(least);
    }
    let mut ends = Vec::new();
    let mut end = count;
    while end > 0 {
        ends.push(end);
        end = best[end].1;
    }
    ends.reverse();
    ends
}

/// How many values are carried over a cut before each instruction.
fn alive(program: &Program, last_uses: &[usize]) -> Vec<usize> {
    let mut alive: Vec<usize> = vec![0; last_uses.len() + 1];
    let mut ending = vec![0; last_uses.len() + 1];
    for (index, &last) in last_uses.iter().enumerate() {
        alive[index + 1] = alive[index] - ending[index];
        if last > index && !is_free(&program.instructions[index]) {
            alive[index + 1] += 1;
            ending[last] += 1;
        }
    }
    alive
}

/// Whether a cut before `place` would separate a result from what computes it.
fn splits_pair(program: &Program, place: usize) -> bool {
    matches!(
        program.instructions.get(place),
        Some(Instruction::Second(_))
    )
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
        let mut carried: Vec<f64> = Vec::new();
        for stage in stages {
            let outputs = run(&stage.program, |source| match source {
                Source::Carried(index) => carried[index],
                _ => x,
            });
            for (&result, &value) in stage.results.iter().zip(&outputs[stage.carried..]) {
                results[result] = value;
            }
            carried = outputs[..stage.carried].to_vec();
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
