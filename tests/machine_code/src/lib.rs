//! Reads the machine code of a function of this very process, and follows every path through it.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::c_double;

use iced_x86::{
    Decoder, DecoderOptions, FlowControl, Formatter, Instruction, Mnemonic, NasmFormatter, OpKind,
    Register,
};

/// The longest instruction, bytes.
const LONGEST: usize = 15;

/// What the code of a function does apart from computing.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Number of instructions on all paths, those of called functions included.
    pub instructions: usize,
    /// Conditional jumps, as text.
    pub branches: Vec<String>,
    /// Calls of `sin`, `cos` and `sincos`.
    pub sin_cos: usize,
    /// Calls of `atan2`.
    pub atan2: usize,
    /// Jumps and calls to computed addresses, traps.
    pub strange: Vec<String>,
}

#[allow(unsafe_code, reason = "only their addresses are used")]
unsafe extern "C" {
    safe fn sin(x: c_double) -> c_double;
    safe fn cos(x: c_double) -> c_double;
    safe fn atan2(y: c_double, x: c_double) -> c_double;
    fn sincos(x: c_double, sin: *mut c_double, cos: *mut c_double);
}

/// Follows the code from the address of a function. Functions that it calls are followed too, unless they are elementary
/// functions of the C library. Ends at the first conditional jump or strange instruction.
pub fn inspect(entry: *const ()) -> Findings {
    let elementary = BTreeMap::from([
        (destination(sin as *const () as u64), "sin_cos"),
        (destination(cos as *const () as u64), "sin_cos"),
        (destination(sincos as *const () as u64), "sin_cos"),
        (destination(atan2 as *const () as u64), "atan2"),
    ]);
    let mut findings = Findings::default();
    let mut seen = BTreeSet::new();
    // Addresses kept in registers for several calls.
    let mut registers = BTreeMap::new();
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
                    Some(target) => match elementary.get(&target) {
                        Some(&"atan2") => findings.atan2 += 1,
                        Some(_) => findings.sin_cos += 1,
                        None => open.push(target),
                    },
                }
            }
            _ => findings.strange.push(text(&instruction)),
        }
    }
    findings
}

/// A register loaded with an address from the linker's table.
fn loaded(instruction: &Instruction) -> Option<(Register, u64)> {
    let loads = instruction.mnemonic() == Mnemonic::Mov
        && instruction.op0_kind() == OpKind::Register
        && instruction.op0_register().is_gpr64()
        && instruction.op1_kind() == OpKind::Memory
        && instruction.memory_base() == Register::RIP;
    loads.then(|| {
        (
            instruction.op0_register(),
            stored(instruction.ip_rel_memory_address()),
        )
    })
}

/// Where a jump or call leads: a constant address, one stored at a constant address, or one kept in a register.
fn target(instruction: &Instruction, registers: &BTreeMap<Register, u64>) -> Option<u64> {
    match instruction.op0_kind() {
        OpKind::NearBranch64 => Some(instruction.near_branch_target()),
        OpKind::Register => registers.get(&instruction.op0_register()).copied(),
        OpKind::Memory if instruction.memory_base() == Register::RIP => {
            Some(stored(instruction.ip_rel_memory_address()))
        }
        _ => None,
    }
}

/// The end of a chain of jumps, such as an entry of the procedure linkage table.
fn destination(mut address: u64) -> u64 {
    for _ in 0..4 {
        let mut instruction = decode(address);
        if instruction.mnemonic() == Mnemonic::Endbr64 {
            instruction = decode(instruction.next_ip());
        }
        let jumps = matches!(
            instruction.flow_control(),
            FlowControl::IndirectBranch | FlowControl::UnconditionalBranch
        );
        match target(&instruction, &BTreeMap::new()) {
            Some(next) if jumps => address = next,
            _ => break,
        }
    }
    address
}

fn text(instruction: &Instruction) -> String {
    let mut text = String::new();
    NasmFormatter::new().format(instruction, &mut text);
    text
}

#[allow(unsafe_code, reason = "machine code is read where it lies")]
fn decode(address: u64) -> Instruction {
    // SAFETY: `address` is that of an instruction of this process: of a function, or reached from one. Code is mapped in
    // whole pages and followed by more of the file, so the longest instruction can be read.
    let bytes = unsafe { std::slice::from_raw_parts(address as *const u8, LONGEST) };
    Decoder::with_ip(64, bytes, address, DecoderOptions::NONE).decode()
}

#[allow(
    unsafe_code,
    reason = "the linker's table of addresses is read where it lies"
)]
fn stored(address: u64) -> u64 {
    // SAFETY: a jump or call of this process reads its target from here.
    unsafe { std::ptr::read_unaligned(address as *const u64) }
}
