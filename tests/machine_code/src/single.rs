//! Code without a loop: every path from the entry to the return.

use std::collections::BTreeSet;

use iced_x86::FlowControl;

use crate::decode::{Arithmetic, Operation, is_fused};
use crate::decode::{Registers, decode, destination, loaded, target, text};
use crate::symbols;

/// What the code of a function does apart from computing.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Number of instructions on all paths, those of called functions included.
    pub instructions: usize,
    /// Conditional jumps, as text.
    pub branches: Vec<String>,
    /// Elementary functions of the C library that are called.
    pub library: Vec<&'static str>,
    /// Calls of other functions, which are followed.
    pub calls: usize,
    /// Divisions; a packed one counts for each of its lanes.
    pub divisions: usize,
    /// Lanes of packed divisions that may repeat another one: one for each packed division.
    pub spare_lanes: usize,
    /// Square roots; a packed one counts for each of its lanes.
    pub roots: usize,
    /// Fused multiply-adds.
    pub fused: usize,
    /// Jumps and calls to computed addresses, traps.
    pub strange: Vec<String>,
}

/// Follows the code from the address of a function. Functions that it calls are followed too, unless they are elementary
/// functions of the C library. Ends at the first conditional jump or strange instruction.
pub fn inspect(entry: *const ()) -> Findings {
    let library = symbols::library_functions();
    let mut findings = Findings::default();
    let mut seen = BTreeSet::new();
    let mut registers = Registers::new();
    let mut open = vec![entry as u64];
    // The first fault ends the search: behind it may lie what is no code, such as after a call that does not return.
    while let Some(address) = open.pop()
        && findings.branches.is_empty()
        && findings.strange.is_empty()
    {
        if !seen.insert(address) {
            continue;
        }
        let instruction = decode(address);
        if let Some((register, value)) = loaded(&instruction) {
            registers.insert(register, value);
        }
        findings.instructions += 1;
        findings.fused += usize::from(is_fused(&instruction));
        match Arithmetic::of(&instruction) {
            Some(found) if found.operation == Operation::Divide => {
                findings.divisions += found.lanes;
                findings.spare_lanes += usize::from(found.lanes > 1);
            }
            Some(found) if found.operation == Operation::Root => findings.roots += found.lanes,
            _ => {}
        }
        let next = instruction.next_ip();
        match instruction.flow_control() {
            FlowControl::Next => open.push(next),
            FlowControl::Return => {}
            FlowControl::ConditionalBranch => {
                findings.branches.push(text(&instruction));
                open.extend([next, instruction.near_branch_target()]);
            }
            FlowControl::UnconditionalBranch
            | FlowControl::IndirectBranch
            | FlowControl::Call
            | FlowControl::IndirectCall => {
                let calls = matches!(
                    instruction.flow_control(),
                    FlowControl::Call | FlowControl::IndirectCall
                );
                if calls {
                    open.push(next);
                }
                match target(&instruction, &registers).map(destination) {
                    None => findings.strange.push(text(&instruction)),
                    Some(target) => match library.get(&target) {
                        Some(name) => findings.library.push(name),
                        None => {
                            findings.calls += usize::from(calls);
                            open.push(target);
                        }
                    },
                }
            }
            _ => findings.strange.push(text(&instruction)),
        }
    }
    findings
}

/// The code for a newer instruction set that a function calls where the machine has it.
pub fn chosen(entry: *const ()) -> Option<*const ()> {
    let symbol = symbols::at(destination(entry as u64))?;
    let mut registers = Registers::new();
    let mut address = symbol.start;
    while address < symbol.end {
        let instruction = decode(address);
        registers.extend(loaded(&instruction));
        address = instruction.next_ip();
        if let FlowControl::Call | FlowControl::UnconditionalBranch | FlowControl::ConditionalBranch =
            instruction.flow_control()
            && let Some(target) = target(&instruction, &registers).map(destination)
            && symbols::at(target)
                .is_some_and(|symbol| symbol.name.contains("8dispatch6choice5fused"))
        {
            return Some(target as *const ());
        }
    }
    None
}
