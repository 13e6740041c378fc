//! Instructions of this process, and which of them compute with floating-point numbers.

use iced_x86::{
    Decoder, DecoderOptions, FlowControl, Formatter, Instruction, Mnemonic, NasmFormatter, OpKind,
    Register,
};
use std::collections::BTreeMap;

// Instructions where they lie in this process.

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

// Which instructions compute with floating-point numbers, and how many at once.

/// What an instruction computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    Divide,
    Root,
    /// Sums, products and multiply-adds.
    Other,
}

/// A floating-point operation and on how many numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arithmetic {
    pub(crate) operation: Operation,
    /// 1 for a scalar operation, else what fits into the register.
    pub(crate) lanes: usize,
    pub(crate) packed: bool,
}

/// Names of instructions without `v` in front, type and order of operands behind.
const OTHER: [&str; 9] = [
    "add", "sub", "mul", "fmadd", "fmsub", "fnmadd", "fnmsub", "min", "max",
];

impl Arithmetic {
    pub(crate) fn of(instruction: &Instruction) -> Option<Self> {
        let name = name(instruction.mnemonic());
        let (name, size, packed) = [
            ("pd", 8, true),
            ("ps", 4, true),
            ("sd", 8, false),
            ("ss", 4, false),
        ]
        .into_iter()
        .find_map(|(end, size, packed)| Some((name.strip_suffix(end)?, size, packed)))?;
        let name = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let operation = match name {
            "div" => Operation::Divide,
            "sqrt" => Operation::Root,
            _ if OTHER.contains(&name) => Operation::Other,
            _ => return None,
        };
        let lanes = match packed {
            true => instruction.op0_register().size() / size,
            false => 1,
        };
        Some(Self {
            operation,
            lanes,
            packed,
        })
    }
}

/// True for what only the compiler of a fused multiply-add prints.
pub(crate) fn is_fused(instruction: &Instruction) -> bool {
    let name = name(instruction.mnemonic());
    ["fmadd", "fmsub", "fnmadd", "fnmsub"]
        .iter()
        .any(|start| name.starts_with(start))
}

/// The name in lower case, without the `v` of newer encodings.
fn name(mnemonic: Mnemonic) -> String {
    let name = format!("{mnemonic:?}").to_ascii_lowercase();
    name.strip_prefix('v').unwrap_or(&name).to_owned()
}

/// Moves a number between a vector register and a general one: what a loop does whose integer work is not packed.
pub(crate) fn leaves_vectors(instruction: &Instruction) -> bool {
    let is_move = matches!(
        instruction.mnemonic(),
        Mnemonic::Movq | Mnemonic::Vmovq | Mnemonic::Movd | Mnemonic::Vmovd
    );
    let general = |register: Register| register.is_gpr();
    is_move && (general(instruction.op0_register()) || general(instruction.op1_register()))
        || matches!(
            instruction.mnemonic(),
            Mnemonic::Pextrq | Mnemonic::Vpextrq | Mnemonic::Pinsrq | Mnemonic::Vpinsrq
        )
}
