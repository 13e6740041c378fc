//! Where long programs are cut.

use std::collections::VecDeque;

use linkage_symbolic::interpret::run;
use linkage_symbolic::passes::stages::{Stage, memory, split};
use linkage_symbolic::program::{Binary, Instruction, Program, Source, Unary, Value};

/// What a processor looks ahead for two positions, in operations.
const SIZE: u32 = 64;

/// Blocks one after the other, each from the last value of the block before: `wide` values side by side, then their sums, of two at a time.
/// Every sum of a block is a result. A block has `2 * wide` operations, of which few wait for each other.
fn blocks(count: usize, wide: usize) -> Program {
    let mut program = Program::default();
    let factor = program.push(Instruction::Load(Source::Input(0)));
    let mut last = factor;
    for _ in 0..count {
        let mut open: VecDeque<Value> = (0..wide)
            .map(|_| program.push(Instruction::Binary(Binary::Mul, last, factor)))
            .collect();
        open.push_back(last);
        while let (Some(a), Some(b)) = (open.pop_front(), open.pop_front()) {
            last = program.push(Instruction::Binary(Binary::Sub, a, b));
            if open.is_empty() {
                break;
            }
            open.push_back(last);
        }
        program.outputs.push(last);
    }
    program
}

fn run_stages(stages: &[Stage], x: f64, count: usize) -> Vec<f64> {
    let mut results = vec![f64::NAN; count];
    let mut places = vec![f64::NAN; memory(stages)];
    for stage in stages {
        let outputs = run(&stage.program, |source| match source {
            Source::Carried(index) => places[stage.taken[index]],
            _ => x,
        });
        assert_eq!(carried(&stage.program), stage.taken.len());
        assert_eq!(outputs.len(), stage.kept.len() + stage.results.len());
        let (kept, finished) = outputs.split_at(stage.kept.len());
        for (&place, &value) in stage.kept.iter().zip(kept) {
            places[place] = value;
        }
        for (&result, &value) in stage.results.iter().zip(finished) {
            assert!(results[result].is_nan(), "result {result} comes twice");
            results[result] = value;
        }
    }
    results
}

fn size(program: &Program) -> u32 {
    program.instructions.iter().map(Instruction::size).sum()
}

fn carried(program: &Program) -> usize {
    let is_carried = |own: &&Instruction| matches!(own, Instruction::Load(Source::Carried(_)));
    program.instructions.iter().filter(is_carried).count()
}

/// Between blocks one value is alive, within them many are.
#[test]
fn cuts_are_where_one_value_is_alive() {
    for wide in [10, 14, 20, 30] {
        let program = blocks(40, wide);
        let stages = split(&program);
        assert_eq!(
            run_stages(&stages, 0.9, 40),
            run(&program, |_| 0.9),
            "{wide}"
        );
        let (last, others) = stages.split_last().expect("there is one");
        assert_eq!((last.kept.len(), stages[0].taken.len()), (0, 0));
        for (stage, next) in others.iter().zip(&stages[1..]) {
            assert_eq!((stage.kept.len(), next.taken.len()), (1, 1), "{wide}");
        }
        assert_eq!(memory(&stages), 1, "the place is used again");
        // As large as may be without cost, or little larger: a block does not end where the limit is.
        let block = 2 * wide as u32;
        for stage in others {
            let size = size(&stage.program);
            assert!(size + block > SIZE && size < SIZE + block, "{wide}: {size}");
        }
    }
}

#[test]
fn what_fits_into_one_stage_is_not_cut() {
    assert_eq!(split(&blocks(1, 32)).len(), 1);
    assert_eq!(split(&blocks(2, 16)).len(), 1, "exactly 64");
    assert!(split(&blocks(12, 8)).len() > 1);
    let empty = Program::default();
    assert_eq!(split(&empty).len(), 0);
}

/// Where everything is alive for long, to carry it costs more than a stage that is too large.
#[test]
fn wide_blocks_are_cut_less() {
    let narrow = split(&blocks(4, 15));
    let wide = split(&blocks(2, 30));
    let most = |stages: &[Stage]| stages.iter().map(|own| size(&own.program)).max();
    assert_eq!(narrow.len(), 2);
    assert_eq!(wide.len(), 2);
    assert_eq!(most(&wide), Some(60));
    assert!(most(&narrow) < Some(SIZE + 8));
    let tangled = split(&blocks(1, 60));
    assert_eq!(tangled.len(), 1, "{:?}", most(&tangled));
}

/// Operations that wait for each other: a processor looks ahead as far, and finds fewer that are ready.
#[test]
fn long_chains_are_cut_although_they_are_short() {
    let chain = |count: usize| {
        let mut program = Program::default();
        let x = program.push(Instruction::Load(Source::Input(0)));
        let mut last = x;
        for _ in 0..count {
            last = program.push(Instruction::Binary(Binary::Mul, last, x));
        }
        program.outputs.push(last);
        program
    };
    // Of 4 cycles each.
    assert_eq!(split(&chain(16)).len(), 1);
    let stages = split(&chain(48));
    assert_eq!(stages.len(), 3);
    assert_eq!(run_stages(&stages, 0.9, 1), run(&chain(48), |_| 0.9));
    assert_eq!(split(&blocks(1, 24)).len(), 1);
    // A sine, and a root that waits for it.
    let mut program = Program::default();
    let x = program.push(Instruction::Load(Source::Input(0)));
    let sine = program.push(Instruction::SinCos(x));
    let cosine = program.push(Instruction::Second(sine));
    let mut last = program.push(Instruction::Binary(Binary::Mul, sine, cosine));
    program.outputs.push(last);
    assert_eq!(split(&program).len(), 1);
    for _ in 0..2 {
        last = program.push(Instruction::Unary(Unary::Sqrt, last));
    }
    program.outputs.push(last);
    let stages = split(&program);
    assert_eq!(stages.len(), 2);
    assert_eq!(stages[0].kept.len(), 1, "the product, and not the pair");
}

/// A sine and its cosine stay together although a cut between them would be the cheapest.
#[test]
fn pairs_are_not_separated() {
    let mut program = Program::default();
    let x = program.push(Instruction::Load(Source::Input(0)));
    let mut last = x;
    for _ in 0..12 {
        let sine = program.push(Instruction::SinCos(last));
        let cosine = program.push(Instruction::Second(sine));
        program.outputs.push(sine);
        last = program.push(Instruction::Binary(Binary::Mul, cosine, x));
        for _ in 0..3 {
            last = program.push(Instruction::Unary(Unary::Sqrt, last));
        }
    }
    program.outputs.push(last);
    let stages = split(&program);
    assert!(stages.len() > 3);
    for stage in &stages {
        assert_eq!(stage.program.mistake(), None);
    }
    let expected = run(&program, |_| 0.3);
    assert_eq!(run_stages(&stages, 0.3, expected.len()), expected);
}

/// As in derivatives backwards: what the way there has made is needed on the way back, last made first. What passes a stage by costs it
/// nothing.
#[test]
fn a_way_there_and_back_grows_with_its_length() {
    let accesses = |length: usize| {
        let mut program = Program::default();
        let x = program.push(Instruction::Load(Source::Input(0)));
        let mut there = vec![x];
        for k in 0..length {
            let value = Instruction::Binary(Binary::Mul, there[k], there[k / 2]);
            there.push(program.push(value));
        }
        let mut last = x;
        for &value in there.iter().rev() {
            last = program.push(Instruction::Binary(Binary::Sub, value, last));
        }
        program.outputs.push(last);
        let stages = split(&program);
        assert_eq!(run_stages(&stages, 0.99, 1), run(&program, |_| 0.99));
        assert!(memory(&stages) <= length + 1, "{}", memory(&stages));
        let accesses = stages.iter().map(|own| own.taken.len() + own.kept.len());
        accesses.sum::<usize>()
    };
    let [short, long] = [500, 4000].map(accesses);
    assert!(short > 500 && long < 9 * short, "{short} and {long}");
}

/// Results that are loads or constants come from the last stage, and nothing that is free is carried.
#[test]
fn what_is_free_is_not_carried() {
    let mut program = blocks(10, 10);
    let constant = program.push(Instruction::Constant(2.5));
    let last = program.outputs[9];
    let scaled = program.push(Instruction::Binary(Binary::Mul, constant, last));
    program.outputs.extend([Value(0), constant, scaled]);
    let stages = split(&program);
    assert!(stages.len() > 2);
    assert!(stages.iter().all(|own| own.taken.len() <= 1));
    let (last, others) = stages.split_last().expect("there is one");
    assert!(
        others
            .iter()
            .flat_map(|own| &own.results)
            .all(|&result| result < 10)
    );
    assert!(last.results.ends_with(&[10, 11, 12]));
    assert_eq!(run_stages(&stages, 0.8, 13), run(&program, |_| 0.8));
}
