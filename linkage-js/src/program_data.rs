//! Programs as data, and the interpreter that runs them in a browser. Its cases print each
//! operation as [`function`](crate::instruction::function) does, so that results are the same to
//! the last bit.

use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, RustCall, Source, Ternary, Unary, Value,
};

use crate::instruction::function_of;

/// The interpreter with its cases left out.
const INTERPRETER: &str = include_str!("engine/interpreter.js");
/// The line of the interpreter that the cases replace.
const CASES: &str = "/* cases */";

/// The first number of each kind of step. Steps of one kind are numbered by their tables.
const SINE_PAIR: usize = LOADS.len();
const FUSED: usize = SINE_PAIR + 1;
const UNARY: usize = FUSED + FUSED_STEPS.len();
const BINARY: usize = UNARY + Unary::ALL.len();
const TERNARY: usize = BINARY + Binary::ALL.len();

/// Numbers that a step loads, in the order of [`load`].
const LOADS: [&str; 8] = [
    "d[a]",
    "x[a]",
    "own.modes[a]",
    "own.centres[a]",
    "own.windings[a]",
    "p[a]",
    "states[a][b]",
    "CORRECTION_LIMIT",
];

/// Multiply-adds, in the order of [`fused`].
const FUSED_STEPS: [&str; 3] = [
    "v[a] * v[b] + v[c]",
    "v[a] * v[b] - v[c]",
    "v[c] - v[a] * v[b]",
];

/// Returns the script of the interpreter.
pub(crate) fn interpreter() -> String {
    let simple = |(step, value): (usize, String)| format!("case {step}: v[k] = {value}; break;");
    let loads = LOADS.iter().map(|load| (*load).to_owned());
    let pair = "sine(v[a]); v[k + 1] = beside".to_owned();
    let fused = FUSED_STEPS.iter().map(|step| (*step).to_owned());
    let unary = Unary::ALL.iter().map(|op| (op.row().name, op.row().call));
    let binary = Binary::ALL.iter().map(|op| (op.row().name, op.row().call));
    let ternary = Ternary::ALL.iter().map(|op| (op.row().name, op.row().call));
    let unary = unary.map(|(name, call)| expression(name, call, &["v[a]"]));
    let binary = binary.map(|(name, call)| expression(name, call, &["v[a]", "v[b]"]));
    let ternary = ternary.map(|(name, call)| expression(name, call, &["v[a]", "v[b]", "v[c]"]));
    let values = loads.chain([pair]).chain(fused);
    let values = values.chain(unary).chain(binary).chain(ternary);
    let cases: Vec<String> = values.enumerate().map(simple).collect();
    INTERPRETER.replace(CASES, &cases.join("\n"))
}

/// The expression of an operation, as printed programs have it.
fn expression(name: &str, call: RustCall, operands: &[&str]) -> String {
    match (call, operands) {
        (RustCall::Operator(sign), [a, b]) => format!("{a} {sign} {b}"),
        (RustCall::Operator(sign), _) => format!("{sign}{}", operands.concat()),
        (RustCall::SinePair(number), _) => {
            format!("{}({})", ["sine", "cosine"][number], operands[0])
        }
        (RustCall::Method(_) | RustCall::FusedMethod(_), _) => {
            format!("{}({})", function_of(name), operands.join(", "))
        }
    }
}

/// Returns a program as JSON: the number of values, constants with their indices, steps of five
/// numbers (kind, index of the value, operands), and indices of the results.
pub(crate) fn json_program(program: &Program, inputs: usize) -> String {
    let mut constants = Vec::new();
    let mut steps = Vec::new();
    for (index, instruction) in program.instructions.iter().enumerate() {
        match *instruction {
            Instruction::Constant(x) => constants.push(format!("[{index}, {}]", json_number(x))),
            // The sine has written it.
            Instruction::Second(_) => {}
            other => {
                let (kind, [a, b, c]) = step(other, inputs);
                steps.push(format!("{kind},{index},{a},{b},{c}"));
            }
        }
    }
    let outputs: Vec<String> = program
        .outputs
        .iter()
        .map(|output| output.0.to_string())
        .collect();
    format!(
        "{{ \"size\": {}, \"constants\": [{}], \"steps\": [{}], \"outputs\": [{}] }}",
        program.instructions.len(),
        constants.join(", "),
        steps.join(", "),
        outputs.join(", ")
    )
}

/// The kind of a step and its operands; 0 for those that it does not have.
fn step(instruction: Instruction, inputs: usize) -> (usize, [usize; 3]) {
    let two = |[a, b]: [Value; 2]| [a.0, b.0, 0];
    match instruction {
        Instruction::Load(source) => load(source, inputs),
        Instruction::SinCos(a) => (SINE_PAIR, [a.0, 0, 0]),
        Instruction::Fused(op, a, b, c) => (FUSED + fused(op), [a.0, b.0, c.0]),
        Instruction::Unary(op, a) => (UNARY + position(Unary::ALL, op), [a.0, 0, 0]),
        Instruction::Binary(op, a, b) => (BINARY + position(Binary::ALL, op), two([a, b])),
        Instruction::Ternary(op, a, b, c) => {
            (TERNARY + position(Ternary::ALL, op), [a.0, b.0, c.0])
        }
        Instruction::Constant(_) | Instruction::Second(_) => unreachable!("these are no steps"),
    }
}

fn load(source: Source, inputs: usize) -> (usize, [usize; 3]) {
    match source {
        Source::Parameter(index) => (0, [index, 0, 0]),
        Source::Input(index) => (1, [index, 0, 0]),
        Source::Mode(index) => (2, [index, 0, 0]),
        Source::Centre(angle) => (3, [angle, 0, 0]),
        Source::Winding(angle, input) => (4, [angle * inputs + input, 0, 0]),
        Source::Prepared(slot) => (5, [slot, 0, 0]),
        Source::State(group, component) => (6, [group, component, 0]),
        Source::Limit => (7, [0; 3]),
        Source::Carried(_) => unreachable!("whole programs carry nothing"),
    }
}

fn fused(op: Fused) -> usize {
    match op {
        Fused::MulAdd => 0,
        Fused::MulSub => 1,
        Fused::SubMul => 2,
    }
}

fn position<O: PartialEq>(all: &[O], op: O) -> usize {
    let index = all.iter().position(|other| *other == op);
    index.expect("a table has all operations")
}

/// A number of JSON that is read back to the last bit: `null` for NaN, and numbers beyond the
/// largest one for infinities.
pub(crate) fn json_number(x: f64) -> String {
    match x {
        x if x.is_nan() => "null".to_owned(),
        x if x.is_infinite() => format!("{}1e999", if x < 0.0 { "-" } else { "" }),
        x => format!("{x:?}"),
    }
}
