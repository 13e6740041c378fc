//! Which instructions compute with floating-point numbers, and how many at once.

use iced_x86::{Instruction, Mnemonic, Register};

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
