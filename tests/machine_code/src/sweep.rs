//! Code with loops: the clones of a sweep for several instruction sets.

use std::collections::{BTreeMap, BTreeSet};

use iced_x86::{FlowControl, Instruction};

use crate::decode::{Arithmetic, Operation, is_fused, leaves_vectors};
use crate::decode::{Registers, decode, destination, loaded, target, text};
use crate::symbols::{self, Symbol};

/// What a sweep was compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Set {
    /// The flags of the build.
    Baseline,
    /// AVX2 with fused multiply-add.
    Avx2,
    /// AVX-512.
    Avx512,
}

/// What the loops of a function do.
#[derive(Clone, Debug, Default)]
pub struct Loops {
    /// Number of instructions, outside of loops too.
    pub instructions: usize,
    /// Number of instructions in loops.
    pub looping: usize,
    /// Packed arithmetic in loops: number of instructions by number of lanes.
    pub packed: BTreeMap<usize, usize>,
    /// Scalar arithmetic in loops, as text.
    pub scalar: Vec<String>,
    /// Moves between vector registers and general ones in loops, as text.
    pub moves: Vec<String>,
    /// Numbers divided in one pass of the loops.
    pub divisions: usize,
    /// Square roots in one pass of the loops.
    pub roots: usize,
    /// Conditional jumps in loops.
    pub jumps: usize,
    /// Fused multiply-adds, outside of loops too.
    pub fused: usize,
    /// Calls in loops: names of the functions.
    pub calls: Vec<String>,
    /// Functions of the C library that are called, outside of loops too.
    pub library: Vec<&'static str>,
    /// Jumps to computed addresses.
    pub strange: Vec<String>,
}

/// The loops of a sweep: of the function at `entry` and of those that it calls whose names contain `sweep`, by what they
/// are compiled for.
pub fn sweep(entry: *const ()) -> BTreeMap<Set, Loops> {
    let mut clones: BTreeMap<Set, Loops> = BTreeMap::new();
    let mut seen = BTreeSet::new();
    let mut open = vec![destination(entry as u64)];
    while let Some(address) = open.pop() {
        let Some(symbol) = symbols::at(address).filter(|symbol| seen.insert(symbol.start)) else {
            continue;
        };
        let function = Function::read(symbol);
        let called = function.called.values().copied();
        open.extend(called.filter(|&called| {
            symbols::at(called).is_some_and(|symbol| symbol.name.contains("sweep"))
        }));
        function.judge(clones.entry(set(&symbol.name)).or_default());
    }
    clones
}

/// The loops of one function.
pub fn loops(entry: *const ()) -> Loops {
    let symbol = symbols::at(destination(entry as u64)).expect("the function has a name");
    let mut loops = Loops::default();
    Function::read(symbol).judge(&mut loops);
    loops
}

fn set(name: &str) -> Set {
    match name {
        _ if name.contains("15instruction_set4avx2") => Set::Avx2,
        _ if name.contains("15instruction_set6avx512") => Set::Avx512,
        _ => Set::Baseline,
    }
}

struct Function {
    instructions: Vec<Instruction>,
    /// Targets of calls and of jumps to other functions, by the place of the instruction.
    called: BTreeMap<usize, u64>,
    strange: Vec<String>,
}

impl Function {
    fn read(symbol: &Symbol) -> Self {
        let mut function = Self {
            instructions: Vec::new(),
            called: BTreeMap::new(),
            strange: Vec::new(),
        };
        let mut registers = Registers::new();
        let mut address = symbol.start;
        while address < symbol.end {
            let instruction = decode(address);
            registers.extend(loaded(&instruction));
            address = instruction.next_ip();
            let inside = |target: &u64| (symbol.start..symbol.end).contains(target);
            let place = function.instructions.len();
            match instruction.flow_control() {
                FlowControl::Call
                | FlowControl::IndirectCall
                | FlowControl::UnconditionalBranch
                | FlowControl::IndirectBranch => match target(&instruction, &registers) {
                    Some(target) if inside(&target) => {}
                    Some(target) => {
                        function.called.insert(place, destination(target));
                    }
                    None => function.strange.push(text(&instruction)),
                },
                _ => {}
            }
            function.instructions.push(instruction);
        }
        function
    }

    fn judge(self, loops: &mut Loops) {
        let library = symbols::library_functions();
        loops.instructions += self.instructions.len();
        loops.strange.extend(self.strange.iter().cloned());
        loops.fused += self.instructions.iter().filter(|i| is_fused(i)).count();
        let library = self
            .called
            .values()
            .filter_map(|called| library.get(called));
        loops.library.extend(library);
        for place in self.looping() {
            loops.looping += 1;
            let instruction = &self.instructions[place];
            let is_jump = instruction.flow_control() == FlowControl::ConditionalBranch;
            loops.jumps += usize::from(is_jump);
            if let Some(&called) = self.called.get(&place) {
                let name = symbols::at(called).map_or("?", |symbol| &symbol.name);
                loops.calls.push(name.to_owned());
            }
            if leaves_vectors(instruction) {
                loops.moves.push(text(instruction));
            }
            let Some(found) = Arithmetic::of(instruction) else {
                continue;
            };
            match found.operation {
                Operation::Divide => loops.divisions += found.lanes,
                Operation::Root => loops.roots += found.lanes,
                Operation::Other => {}
            }
            match found.packed {
                true => *loops.packed.entry(found.lanes).or_default() += 1,
                false => loops.scalar.push(text(instruction)),
            }
        }
    }

    /// The places of the instructions that can be reached from themselves.
    fn looping(&self) -> Vec<usize> {
        let blocks = self.blocks();
        let starts: Vec<usize> = blocks.iter().map(|block| block.start).collect();
        let follow: Vec<Vec<usize>> = blocks
            .iter()
            .map(|block| self.follow(block.end - 1, &starts))
            .collect();
        let mut places = Vec::new();
        for (index, block) in blocks.into_iter().enumerate() {
            let mut seen = BTreeSet::new();
            let mut open = follow[index].clone();
            while let Some(next) = open.pop() {
                if seen.insert(next) {
                    open.extend(&follow[next]);
                }
            }
            if seen.contains(&index) {
                places.extend(block);
            }
        }
        places
    }

    /// Runs of instructions with no jump into or out of them but at their ends.
    fn blocks(&self) -> Vec<std::ops::Range<usize>> {
        let mut starts = BTreeSet::from([0]);
        for (place, instruction) in self.instructions.iter().enumerate() {
            starts.extend(self.jump(instruction));
            if instruction.flow_control() != FlowControl::Next {
                starts.insert(place + 1);
            }
        }
        starts.insert(self.instructions.len());
        let starts: Vec<usize> = starts.into_iter().collect();
        starts.windows(2).map(|pair| pair[0]..pair[1]).collect()
    }

    /// The place in this function where an instruction jumps to.
    fn jump(&self, instruction: &Instruction) -> Option<usize> {
        let jumps = matches!(
            instruction.flow_control(),
            FlowControl::ConditionalBranch | FlowControl::UnconditionalBranch
        );
        let target = jumps.then(|| instruction.near_branch_target())?;
        self.instructions
            .binary_search_by_key(&target, Instruction::ip)
            .ok()
    }

    /// The blocks that may follow the one that ends with the instruction at `last`.
    fn follow(&self, last: usize, starts: &[usize]) -> Vec<usize> {
        let instruction = &self.instructions[last];
        let next = match instruction.flow_control() {
            FlowControl::Next | FlowControl::ConditionalBranch => Some(last + 1),
            FlowControl::Call | FlowControl::IndirectCall if self.returns(last) => Some(last + 1),
            _ => None,
        };
        let places = next.into_iter().chain(self.jump(instruction));
        places
            .filter_map(|place| starts.binary_search(&place).ok())
            .collect()
    }

    /// Whether the call at `place` may come back: panics do not.
    fn returns(&self, place: usize) -> bool {
        let symbol = self
            .called
            .get(&place)
            .and_then(|&called| symbols::at(called));
        symbol.is_none_or(|symbol| {
            ["panic", "_fail", "handle_error"]
                .iter()
                .all(|word| !symbol.name.contains(word))
        })
    }
}
