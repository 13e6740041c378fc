//! Which mechanisms are compiled, and which of their functions have sweeps.

use std::collections::BTreeSet;

use linkage_compiler::ir::{CompiledMechanism, Function, PreparedTable};
use linkage_symbolic::program::Instruction;

/// Instructions of a mechanism whose code takes hardly any time to compile.
const SMALL: usize = 800;

/// What takes too long to be compiled always, whatever it has: half of the time goes into the largest one.
const LARGE: usize = 10_000;

/// A mechanism that may be compiled.
pub(super) struct Candidate<'a> {
    pub(super) unit: &'a CompiledMechanism,
    /// Only if it has what no smaller one has, however small it is.
    pub(super) random: bool,
}

/// For each mechanism whether it is compiled: all in long runs, otherwise the small ones and those that have what no smaller one
/// has, but none of the largest. Random mechanisms come last.
pub(super) fn chosen(candidates: &[Candidate<'_>], long: bool) -> Vec<bool> {
    let mut order: Vec<usize> = (0..candidates.len()).collect();
    order.sort_by_key(|&k| (candidates[k].random, size(candidates[k].unit)));
    let mut known = BTreeSet::new();
    let mut chosen = vec![long; candidates.len()];
    for k in order {
        let Candidate { unit, random } = candidates[k];
        let before = known.len();
        known.extend(parts(unit));
        let new = known.len() > before && size(unit) <= LARGE;
        chosen[k] |= new || (size(unit) <= SMALL && !random);
    }
    chosen
}

/// For each function of each mechanism whether its sweeps are compiled, which take two thirds of the time: all in long runs,
/// otherwise those that have what no smaller function has.
pub(super) fn swept(units: &[&CompiledMechanism], long: bool) -> Vec<Vec<bool>> {
    let numbers = |k: usize| (0..units[k].functions.len()).map(move |function| (k, function));
    let mut order: Vec<(usize, usize)> = (0..units.len()).flat_map(numbers).collect();
    order.sort_by_key(|&(k, function)| length(&units[k].functions[function]));
    let mut known = BTreeSet::new();
    let all = units.iter().map(|unit| vec![long; unit.functions.len()]);
    let mut swept: Vec<Vec<bool>> = all.collect();
    for (k, function) in order {
        let before = known.len();
        known.extend(parts_of_sweeps(units[k], &units[k].functions[function]));
        swept[k][function] |= known.len() > before;
    }
    swept
}

/// How many instructions all its functions have.
fn size(unit: &CompiledMechanism) -> usize {
    unit.functions.iter().map(length).sum()
}

fn length(function: &Function) -> usize {
    function.called.program.instructions.len()
}

/// What it consists of: groups, how coupled ones are prepared, operations, what its functions find.
fn parts(unit: &CompiledMechanism) -> BTreeSet<String> {
    let groups = unit.groups.iter().map(|group| group.kind.clone());
    let coupled = unit.coupled.iter();
    let coupled = coupled.map(|own| format!("{}, followed: {}", table(&own.start), own.followed));
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

/// What the sweeps of a function consist of: shapes of fields, arguments, stages, tables of coupled groups, operations.
fn parts_of_sweeps(unit: &CompiledMechanism, function: &Function) -> BTreeSet<String> {
    let shapes = function.fields.iter().map(|field| {
        let text = format!("{:?}", field.shape);
        text.replace(|c: char| c.is_ascii_digit(), "")
    });
    let states = function.states.iter();
    let tables = states.map(|&number| table(&unit.coupled[number].start).to_owned());
    let body = &function.called;
    let mut arguments = function.arguments.iter();
    let has_loads = arguments.any(|&argument| argument >= unit.inputs.len());
    let others = [
        format!("{} arguments", function.arguments.len()),
        format!("{} stages", body.stages.len().min(3)),
        format!("beside: {}", function.beside.is_some()),
        format!("settled: {}", function.settled.is_some()),
        format!("compares sines: {}", body.compares_sines),
        format!("is worth a call: {}", body.is_worth_a_call()),
        format!("has parameters: {}", unit.scalars().count() > 0),
        format!("inputs: {}", unit.inputs.len()),
        // Rows that are followed to other dimensions keep them.
        format!(
            "loads of followed groups: {}",
            !function.states.is_empty() && has_loads
        ),
    ];
    let operations = body.program.instructions.iter().filter_map(operation);
    let all = shapes.chain(tables).chain(others);
    all.chain(operations).collect()
}

/// How a coupled group is prepared.
fn table(start: &Option<PreparedTable>) -> &'static str {
    match start {
        None => "no start",
        Some(PreparedTable::Table(_)) => "a table",
        Some(PreparedTable::Grid(_)) => "a grid",
    }
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
