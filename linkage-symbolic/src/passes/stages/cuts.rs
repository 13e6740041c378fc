//! The ends of stages, for the least cost of loops and memory together.

use crate::program::{Instruction, Program};

/// Operations that a stage may have without cost, about the window of a processor for two
/// positions. Those beyond cost their square: they need more registers than there are.
const SIZE: usize = 64;

/// Costs in operations: of a store or a load of a value that stages pass on, and of a loop.
const ACCESS: usize = 1;
const LOOP: usize = 8;

/// Cycles of the longest chain of operations that neighbouring positions hide. With a longer one,
/// all operations of a stage wait in proportion.
const CHAIN: usize = 66;

/// Cycles of a sine pair in rows, which polynomials compute.
const SINES: usize = 60;

/// Returns the ends of the cheapest stages. Free instructions are first in `program`.
pub(super) fn ends(program: &Program, last_uses: &[usize]) -> Vec<usize> {
    let count = program.instructions.len();
    let free = program
        .instructions
        .iter()
        .take_while(|instruction| instruction.is_free());
    let free = free.count();
    // The least cost of stages up to each instruction, and where the last of them starts.
    let mut best: Vec<(usize, usize)> = vec![(0, 0)];
    best.resize(free + 1, (LOOP, 0));
    let mut last = Last::new(program, last_uses, free);
    for end in free + 1..=count {
        let mut least = (usize::MAX, 0);
        last.end_at(end);
        let mut start = end;
        while start > free {
            start -= 1;
            last.begin_at(start);
            if splits_pair(program, start) {
                continue;
            }
            // A stage that begins with the first operation has what is free, too.
            let first = if start == free { 0 } else { start };
            let cost = best[first].0 + last.cost();
            if cost < least.0 {
                least = (cost, first);
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

/// The cost of a stage that ends before `end`, while its begin moves to the front.
// Slices: an index of a list is a call where nothing is optimised.
struct Last<'a> {
    last_uses: &'a [usize],
    end: usize,
    /// All operations of the program.
    operations: Box<[Operation]>,
    size: usize,
    /// The end for which each value was last found among the used values of a stage.
    used: Box<[usize]>,
    /// The number of values from stages before.
    taken: usize,
    /// The number of its values that later stages need.
    kept: usize,
    /// The longest chain of operations after each operation, in cycles, with the end for which it
    /// was last found.
    chains: Box<[(usize, usize)]>,
    /// The longest chain of operations of the stage.
    chain: usize,
}

/// An instruction, as stages count it.
struct Operation {
    size: usize,
    /// Cycles from its operands to its result.
    latency: usize,
    /// Operands that are not free.
    operands: Vec<usize>,
}

impl<'a> Last<'a> {
    fn new(program: &Program, last_uses: &'a [usize], free: usize) -> Self {
        let operation = |instruction: &Instruction| {
            let operands = instruction.operands().map(|operand| operand.0);
            Operation {
                size: instruction.size() as usize,
                latency: match instruction {
                    Instruction::SinCos(_) => SINES,
                    _ => instruction.latency() as usize,
                },
                operands: operands.filter(|&value| value >= free).collect(),
            }
        };
        Self {
            last_uses,
            end: 0,
            operations: program.instructions.iter().map(operation).collect(),
            size: 0,
            used: vec![0; program.instructions.len()].into(),
            taken: 0,
            kept: 0,
            chains: vec![(0, 0); program.instructions.len()].into(),
            chain: 0,
        }
    }

    /// An empty stage before `end`.
    fn end_at(&mut self, end: usize) {
        self.end = end;
        self.size = 0;
        self.taken = 0;
        self.kept = 0;
        self.chain = 0;
    }

    /// Adds the instruction before the present begin.
    fn begin_at(&mut self, start: usize) {
        let operation = &self.operations[start];
        self.size += operation.size;
        self.kept += usize::from(self.last_uses[start] >= self.end);
        self.taken -= usize::from(self.used[start] == self.end);
        let end = self.end;
        let mut chain = operation.latency;
        let (found, after) = self.chains[start];
        if found == end {
            chain += after;
        }
        self.chain = self.chain.max(chain);
        for &value in &operation.operands {
            let (found, after) = self.chains[value];
            if found != end || after < chain {
                self.chains[value] = (end, chain);
            }
            if self.used[value] != end {
                self.used[value] = end;
                self.taken += 1;
            }
        }
    }

    fn cost(&self) -> usize {
        let excess = self.size.saturating_sub(SIZE);
        let waiting = self.size * self.chain.saturating_sub(CHAIN) / CHAIN;
        ACCESS * (self.taken + self.kept) + LOOP + (excess * excess / SIZE).max(waiting)
    }
}

/// Returns true if a cut before `index` would separate the two results of an instruction.
fn splits_pair(program: &Program, index: usize) -> bool {
    matches!(
        program.instructions.get(index),
        Some(Instruction::Second(_))
    )
}
