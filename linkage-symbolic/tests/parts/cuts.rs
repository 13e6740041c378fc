//! The cuts of long programs against all cuts that there could be.

use std::ops::Range;

use linkage_random::Random;
use linkage_symbolic::passes::stages::{Stage, split};
use linkage_symbolic::program::{Binary, Instruction, Program, Source, Unary, Value};

/// What stages cost, in operations: what of one is beyond that counts by its square, or all of it in proportion if its chain is longer than that;
/// each value that it takes or keeps, and itself.
const SIZE: u32 = 64;
const CHAIN: u32 = 66;
const SINES: u32 = 60;
const ACCESS: u32 = 1;
const LOOP: u32 = 8;

fn cost(size: u32, chain: u32, accesses: usize) -> u32 {
    let excess = size.saturating_sub(SIZE);
    let waiting = size * chain.saturating_sub(CHAIN) / CHAIN;
    LOOP + ACCESS * accesses as u32 + (excess * excess / SIZE).max(waiting)
}

/// Cycles of the longest chain of operations within a range.
fn chain(instructions: &[Instruction], range: Range<usize>) -> u32 {
    let mut ends = vec![0; range.end];
    for k in range {
        let begin = instructions[k].operands().map(|value| ends[value.0]).max();
        let latency = match instructions[k] {
            Instruction::SinCos(_) => SINES,
            other => other.latency(),
        };
        ends[k] = begin.unwrap_or(0) + latency;
    }
    ends.into_iter().max().unwrap_or(0)
}

fn size(instructions: &[Instruction]) -> u32 {
    instructions.iter().map(Instruction::size).sum()
}

/// Two loads, then small and large operations of values before them, mostly of the last ones.
fn program(random: &mut Random, count: usize) -> Program {
    let mut program = Program::default();
    for k in 0..2 {
        program.push(Instruction::Load(Source::Input(k)));
    }
    while program.instructions.len() < count {
        let known = program.instructions.len();
        let mut operand = || Value(known - 1 - random.below(known.min(5)));
        let (a, b) = (operand(), operand());
        let operations = [
            Instruction::Binary(Binary::Sub, a, b),
            Instruction::Binary(Binary::Hypot, a, b),
            Instruction::Binary(Binary::Atan2, a, b),
            Instruction::Unary(Unary::Tan, a),
            Instruction::SinCos(a),
        ];
        let value = program.push(*random.pick(&operations));
        if matches!(program.instructions[value.0], Instruction::SinCos(_)) {
            program.push(Instruction::Second(value));
        }
    }
    program.outputs = vec![Value(program.instructions.len() - 1)];
    program
}

/// How many values of `from` are needed in `to`; loads are repeated.
fn passed(program: &Program, from: Range<usize>, to: Range<usize>) -> usize {
    let needed = |value: &usize| {
        let mut behind = program.instructions[to.clone()].iter();
        behind.any(|own| own.operands().any(|x| x.0 == *value))
    };
    from.filter(|&value| value >= 2).filter(needed).count()
}

/// The least cost among all choices of places.
fn least(program: &Program) -> u32 {
    let count = program.instructions.len();
    let places: Vec<usize> = (3..count)
        .filter(|&place| !matches!(program.instructions[place], Instruction::Second(_)))
        .collect();
    let one = |range: Range<usize>| {
        let taken = passed(program, 0..range.start, range.clone());
        let kept = passed(program, range.clone(), range.end..count);
        let chain = chain(&program.instructions, range.clone());
        cost(size(&program.instructions[range]), chain, taken + kept)
    };
    let choices = 0..1_u32 << places.len();
    let of = |choice: u32| {
        let chosen = (0..places.len()).filter(|k| choice >> k & 1 == 1);
        let (mut total, mut start) = (0, 0);
        for k in chosen {
            total += one(start..places[k]);
            start = places[k];
        }
        total + one(start..count)
    };
    choices.map(of).min().expect("one is not to cut")
}

fn found(stages: &[Stage]) -> u32 {
    let one = |own: &Stage| {
        let instructions = &own.program.instructions;
        cost(
            size(instructions),
            chain(instructions, 0..instructions.len()),
            own.taken.len() + own.kept.len(),
        )
    };
    stages.iter().map(one).sum()
}

#[test]
fn no_other_cuts_are_cheaper() {
    let mut random = Random::new(61);
    let mut stages = 0;
    for case in 0..150 {
        let program = program(&mut random, 4 + case % 9);
        let split = split(&program);
        assert_eq!(found(&split), least(&program), "{program}");
        stages += split.len();
    }
    assert!(stages > 300, "{stages}");
}
