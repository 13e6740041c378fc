//! Which mechanisms are compiled.

use std::collections::BTreeSet;

use linkage_compiler::ir::{CompiledMechanism, PreparedTable};
use linkage_symbolic::program::Instruction;

/// Instructions of a mechanism whose code takes hardly any time to compile.
const SMALL: usize = 800;

/// What takes too long to be compiled always, whatever it has: half of the time goes into the largest one.
const LARGE: usize = 10_000;

/// For each mechanism whether it is compiled: all in long runs, otherwise the small ones and those that have what no smaller one
/// has, but none of the largest.
pub(super) fn chosen(units: &[&CompiledMechanism], long: bool) -> Vec<bool> {
    let mut order: Vec<usize> = (0..units.len()).collect();
    order.sort_by_key(|&k| size(units[k]));
    let mut known = BTreeSet::new();
    let mut chosen = vec![long; units.len()];
    for k in order {
        let before = known.len();
        known.extend(parts(units[k]));
        let new = known.len() > before && size(units[k]) <= LARGE;
        chosen[k] |= new || size(units[k]) <= SMALL;
    }
    chosen
}

/// How many instructions all its functions have.
fn size(unit: &CompiledMechanism) -> usize {
    let functions = unit.functions.iter();
    functions
        .map(|function| function.called.program.instructions.len())
        .sum()
}

/// What it consists of: groups, how coupled ones are prepared, operations, what its functions find.
fn parts(unit: &CompiledMechanism) -> BTreeSet<String> {
    let groups = unit.groups.iter().map(|group| group.kind.clone());
    let coupled = unit.coupled.iter().map(|own| {
        let start = match own.start {
            None => "no start",
            Some(PreparedTable::Table(_)) => "a table",
            Some(PreparedTable::Grid(_)) => "a grid",
        };
        format!("{start}, followed: {}", own.followed)
    });
    let functions = unit.functions.iter().flat_map(|function| {
        let columns = function.columns.iter();
        let meanings = columns.map(|column| first_word(&format!("{:?}", column.meaning)));
        let program = function.called.program.instructions.iter();
        let operations = program.filter_map(operation);
        let direction = function
            .sensitivities
            .map(|own| format!("derivatives {own}"));
        meanings.chain(operations).chain(direction)
    });
    groups.chain(coupled).chain(functions).collect()
}

fn operation(instruction: &Instruction) -> Option<String> {
    match instruction {
        Instruction::Constant(_) | Instruction::Second(_) => None,
        Instruction::Load(source) => Some(first_word(&format!("{source:?}"))),
        Instruction::Unary(operation, _) => Some(format!("{operation:?}")),
        Instruction::Binary(operation, ..) => Some(format!("{operation:?}")),
        Instruction::Ternary(operation, ..) => Some(format!("{operation:?}")),
        Instruction::Fused(operation, ..) => Some(format!("{operation:?}")),
        Instruction::SinCos(_) => Some("SinCos".to_owned()),
    }
}

/// The name of a variant, as `Debug` prints it.
fn first_word(text: &str) -> String {
    let end = text.find(|c: char| !c.is_alphanumeric());
    text[..end.unwrap_or(text.len())].to_owned()
}
