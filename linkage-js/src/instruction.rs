//! Instructions as JavaScript. What they are is matched without a wildcard: a new one does not compile before JavaScript knows it.

use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};

/// A program as a function of an assembly, inputs and states of groups without a closed form, which writes its results to `out`.
pub(crate) fn function(program: &Program, inputs: usize) -> String {
    let mut values = Vec::new();
    let mut places: Vec<String> = Vec::with_capacity(program.instructions.len());
    let mut take = |index: usize, value: &str| {
        values.push(format!("v{index} = {value}"));
        format!("v{index}")
    };
    for (index, instruction) in program.instructions.iter().enumerate() {
        let of = |value: Value| &places[value.0][..];
        let place = match *instruction {
            Instruction::Constant(x) => literal(x),
            Instruction::Load(source) => take(index, &place(source, inputs)),
            Instruction::SinCos(a) => {
                // The cosine waits beside it until another sine is asked for.
                let sine = format!("sine({}), w{index} = beside", of(a));
                take(index, &sine)
            }
            Instruction::Second(pair) => format!("w{}", pair.0),
            Instruction::Unary(op, a) => take(index, &unary(op, of(a))),
            Instruction::Binary(op, a, b) => take(index, &binary(op, of(a), of(b))),
            Instruction::Ternary(op, a, b, c) => take(index, &ternary(op, of(a), of(b), of(c))),
            Instruction::Fused(op, a, b, c) => take(index, &fused(op, of(a), of(b), of(c))),
        };
        places.push(place);
    }
    let constants = match values.is_empty() {
        true => String::new(),
        false => format!("const {};", values.join(", ")),
    };
    let outputs = program.outputs.iter().enumerate();
    let results: String = outputs
        .map(|(index, value)| format!(" out[{index}] = {};", places[value.0]))
        .collect();
    format!(
        "(own, x, states, out) => {{ const d = own.dimensions, p = own.prepared; {constants}{results} }}"
    )
}

/// Where a number stands.
fn place(source: Source, inputs: usize) -> String {
    match source {
        Source::Parameter(index) => format!("d[{index}]"),
        Source::Input(index) => format!("x[{index}]"),
        Source::Mode(index) => format!("own.modes[{index}]"),
        Source::Centre(angle) => format!("own.centres[{angle}]"),
        Source::Winding(angle, input) => format!("own.windings[{}]", angle * inputs + input),
        Source::Prepared(slot) => format!("p[{slot}]"),
        Source::State(group, component) => format!("states[{group}][{component}]"),
        Source::Limit => "CORRECTION_LIMIT".to_owned(),
        Source::Carried(_) => unreachable!("whole programs carry nothing"),
    }
}

fn unary(op: Unary, a: &str) -> String {
    match op {
        Unary::Neg => format!("-{a}"),
        Unary::Abs => format!("Math.abs({a})"),
        Unary::Sqrt => format!("Math.sqrt({a})"),
        Unary::Sin => format!("sine({a})"),
        Unary::Cos => format!("cosine({a})"),
        Unary::Tan => format!("tangent({a})"),
        Unary::Asin => format!("Math.asin({a})"),
        Unary::Acos => format!("Math.acos({a})"),
        Unary::Atan => format!("Math.atan({a})"),
        Unary::Sign => format!("signOf({a})"),
        Unary::Whole => format!("whole({a})"),
        Unary::Slack => format!("slack({a})"),
        Unary::InverseScale => format!("inverseScale({a})"),
    }
}

fn binary(op: Binary, a: &str, b: &str) -> String {
    match op {
        Binary::Add => format!("{a} + {b}"),
        Binary::Sub => format!("{a} - {b}"),
        Binary::Mul => format!("{a} * {b}"),
        Binary::Div => format!("{a} / {b}"),
        Binary::Quotient => format!("quotient({a}, {b})"),
        Binary::Atan2 => format!("angleOf({a}, {b})"),
        Binary::Hypot => format!("hypot({a}, {b})"),
        Binary::Min => format!("Math.min({a}, {b})"),
        Binary::Max => format!("Math.max({a}, {b})"),
    }
}

fn ternary(op: Ternary, a: &str, b: &str, c: &str) -> String {
    match op {
        Ternary::AngleNear => format!("angleNear({a}, {b}, {c})"),
        Ternary::Root => format!("root({a}, {b}, {c})"),
        Ternary::Select => format!("select({a}, {b}, {c})"),
    }
}

/// Rounded twice: JavaScript has no fused multiply-add.
fn fused(op: Fused, a: &str, b: &str, c: &str) -> String {
    match op {
        Fused::MulAdd => format!("{a} * {b} + {c}"),
        Fused::MulSub => format!("{a} * {b} - {c}"),
        Fused::SubMul => format!("{c} - {a} * {b}"),
    }
}

/// The number with the fewest digits that JavaScript reads back to the last bit; `-` in front of it is never behind another one.
pub(crate) fn literal(x: f64) -> String {
    match x {
        x if x.is_nan() => "NaN".to_owned(),
        x if x.is_infinite() => format!("({}Infinity)", if x < 0.0 { "-" } else { "" }),
        x if x.is_sign_negative() => format!("({x:?})"),
        x => format!("{x:?}"),
    }
}
