//! The cuts of long programs against all cuts that there could be.

use linkage_random::Random;
use linkage_symbolic::passes::stages::{Stage, split};
use linkage_symbolic::program::{Binary, Instruction, Program, Source, Unary, Value};

/// What stages cost, in operations: what of one is beyond that counts by its square, each value carried into it and itself.
const SIZE: u32 = 64;
const CARRY: u32 = 2;
const LOOP: u32 = 8;

fn cost(size: u32, carried: usize) -> u32 {
    let excess = size.saturating_sub(SIZE);
    LOOP + CARRY * carried as u32 + excess * excess / SIZE
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

/// How many values are computed before a place and needed behind it; loads are repeated.
fn carried(program: &Program, place: usize) -> usize {
    let needed = |value: &usize| {
        let behind = &program.instructions[place..];
        behind
            .iter()
            .any(|own| own.operands().any(|x| x.0 == *value))
    };
    (2..place).filter(needed).count()
}

/// The least cost among all choices of places.
fn least(program: &Program) -> u32 {
    let places: Vec<usize> = (3..program.instructions.len())
        .filter(|&place| !matches!(program.instructions[place], Instruction::Second(_)))
        .collect();
    let carried: Vec<usize> = places
        .iter()
        .map(|&place| carried(program, place))
        .collect();
    let choices = 0..1_u32 << places.len();
    let of = |choice: u32| {
        let chosen = (0..places.len()).filter(|k| choice >> k & 1 == 1);
        let (mut total, mut start, mut into) = (0, 0, 0);
        for k in chosen {
            total += cost(size(&program.instructions[start..places[k]]), into);
            (start, into) = (places[k], carried[k]);
        }
        total + cost(size(&program.instructions[start..]), into)
    };
    choices.map(of).min().expect("one is not to cut")
}

fn found(stages: &[Stage]) -> u32 {
    let into = [0].into_iter().chain(stages.iter().map(|own| own.carried));
    let stages = stages.iter().zip(into);
    stages
        .map(|(own, into)| cost(size(&own.program.instructions), into))
        .sum()
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
