//! Instructions where they lie in this process.

use std::collections::BTreeMap;

use iced_x86::{
    Decoder, DecoderOptions, FlowControl, Formatter, Instruction, Mnemonic, NasmFormatter, OpKind,
    Register,
};

/// The longest instruction, bytes.
const LONGEST: usize = 15;

/// Addresses that registers were loaded with, for several calls.
pub(crate) type Registers = BTreeMap<Register, u64>;

#[allow(unsafe_code, reason = "machine code is read where it lies")]
pub(crate) fn decode(address: u64) -> Instruction {
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

pub(crate) fn text(instruction: &Instruction) -> String {
    let mut text = String::new();
    NasmFormatter::new().format(instruction, &mut text);
    text
}

/// A register loaded with an address from the linker's table.
pub(crate) fn loaded(instruction: &Instruction) -> Option<(Register, u64)> {
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
pub(crate) fn target(instruction: &Instruction, registers: &Registers) -> Option<u64> {
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
pub(crate) fn destination(mut address: u64) -> u64 {
    for _ in 0..4 {
        let mut instruction = decode(address);
        if instruction.mnemonic() == Mnemonic::Endbr64 {
            instruction = decode(instruction.next_ip());
        }
        let jumps = matches!(
            instruction.flow_control(),
            FlowControl::IndirectBranch | FlowControl::UnconditionalBranch
        );
        match target(&instruction, &Registers::new()) {
            Some(next) if jumps => address = next,
            _ => break,
        }
    }
    address
}
