//! Where stages end: what the loops and their memory cost together is least.

use std::collections::BTreeSet;

use super::is_free;
use crate::program::{Instruction, Program};

/// Operations that a stage may have without cost, about what a processor looks ahead for two positions.
const SIZE: usize = 64;

/// What a store or a load of what another stage needs or has made costs, and what a loop costs, in operations.
const ACCESS: usize = 1;
const LOOP: usize = 8;

/// The ends of the stages, the cheapest that there are.
pub(super) fn ends(program: &Program, last_uses: &[usize]) -> Vec<usize> {
    let count = program.instructions.len();
    // The least cost of stages up to each instruction, and where the last of them starts.
    let mut best: Vec<(usize, usize)> = vec![(0, 0)];
    for end in 1..=count {
        let mut least = (usize::MAX, 0);
        let mut last = Last::new(program, last_uses, end);
        for start in (0..end).rev() {
            last.begin_at(start);
            if splits_pair(program, start) {
                continue;
            }
            let excess = last.size.saturating_sub(SIZE);
            let own = ACCESS * (last.taken.len() + last.kept) + LOOP + excess * excess / SIZE;
            let cost = best[start].0 + own;
            if cost < least.0 {
                least = (cost, start);
            }
            if last.size > 4 * SIZE {
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

/// What a stage that ends before `end` has to do, while its begin moves to the front.
struct Last<'a> {
    program: &'a Program,
    last_uses: &'a [usize],
    end: usize,
    size: usize,
    /// What it needs of stages before.
    taken: BTreeSet<usize>,
    /// How many of its values later stages need.
    kept: usize,
}

impl<'a> Last<'a> {
    fn new(program: &'a Program, last_uses: &'a [usize], end: usize) -> Self {
        Self {
            program,
            last_uses,
            end,
            size: 0,
            taken: BTreeSet::new(),
            kept: 0,
        }
    }

    /// Adds the instruction before the present begin.
    fn begin_at(&mut self, start: usize) {
        let instruction = &self.program.instructions[start];
        if is_free(instruction) {
            return;
        }
        self.size += instruction.size() as usize;
        self.kept += usize::from(self.last_uses[start] >= self.end);
        self.taken.remove(&start);
        let before = instruction.operands().map(|operand| operand.0);
        let program = self.program;
        self.taken
            .extend(before.filter(|&value| !is_free(&program.instructions[value])));
    }
}

/// Whether a cut before `place` would separate a result from what computes it.
fn splits_pair(program: &Program, place: usize) -> bool {
    matches!(
        program.instructions.get(place),
        Some(Instruction::Second(_))
    )
}
