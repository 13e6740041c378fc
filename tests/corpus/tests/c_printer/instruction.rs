//! Instructions as C. What they are is matched without a wildcard: a new one does not compile before C knows it.

use linkage::Scalar;
use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};

/// What computes the value `index` of a program.
pub(crate) fn expression(program: &Program, index: usize) -> String {
    match program.instructions[index] {
        Instruction::Constant(x) => number(x),
        Instruction::Load(source) => place(source),
        Instruction::Unary(op, a) => unary(op, &name(a)),
        Instruction::Binary(op, a, b) => binary(op, &name(a), &name(b)),
        Instruction::Ternary(op, a, b, c) => ternary(op, &name(a), &name(b), &name(c)),
        Instruction::Fused(op, a, b, c) => fused(op, &name(a), &name(b), &name(c)),
        Instruction::SinCos(a) => unary(Unary::Sin, &name(a)),
        Instruction::Second(pair) => match program.instructions[pair.0] {
            Instruction::SinCos(a) => unary(Unary::Cos, &name(a)),
            _ => unreachable!("nothing else has two results"),
        },
    }
}

/// The variable of a value.
pub(crate) fn name(value: Value) -> String {
    format!("v{}", value.0)
}

/// The shortest digits that a C compiler reads back as the same number.
fn number(x: f64) -> String {
    if x.is_nan() {
        "NAN".to_owned()
    } else if x.is_infinite() {
        let sign = if x < 0.0 { "-" } else { "" };
        format!("{sign}INFINITY")
    } else {
        format!("{x:?}")
    }
}

/// Where a number stands: `m` is the struct, `carried` what the stage before hands on.
pub(crate) fn place(source: Source) -> String {
    match source {
        Source::Parameter(index) => format!("m->parameter[{index}]"),
        Source::Input(index) => format!("m->input[{index}]"),
        Source::Mode(index) => format!("m->mode[{index}]"),
        Source::Centre(angle) => format!("m->centre[{angle}]"),
        Source::Winding(angle, input) => format!("m->winding[{angle}][{input}]"),
        Source::Prepared(slot) => format!("m->prepared[{slot}]"),
        Source::State(group, component) => format!("m->state_{group}[{component}]"),
        Source::Carried(index) => format!("carried[{index}]"),
        Source::Limit => number(<f64 as Scalar>::CORRECTION_LIMIT),
    }
}

pub(crate) fn unary(op: Unary, a: &str) -> String {
    match op {
        Unary::Neg => format!("-{a}"),
        Unary::Abs => format!("fabs({a})"),
        Unary::Sqrt => format!("sqrt({a})"),
        Unary::Sin => format!("sin({a})"),
        Unary::Cos => format!("cos({a})"),
        Unary::Tan => format!("tan({a})"),
        Unary::Asin => format!("asin({a})"),
        Unary::Acos => format!("acos({a})"),
        Unary::Atan => format!("atan({a})"),
        Unary::Sign => format!("linkage_sign({a})"),
        Unary::InverseScale => format!("linkage_inverse_scale({a})"),
    }
}

pub(crate) fn binary(op: Binary, a: &str, b: &str) -> String {
    match op {
        Binary::Add => format!("{a} + {b}"),
        Binary::Sub => format!("{a} - {b}"),
        Binary::Mul => format!("{a} * {b}"),
        Binary::Div => format!("{a} / {b}"),
        Binary::Atan2 => format!("atan2({a}, {b})"),
        Binary::Hypot => format!("hypot({a}, {b})"),
        Binary::Min => format!("linkage_min({a}, {b})"),
        Binary::Max => format!("linkage_max({a}, {b})"),
        Binary::Root => format!("linkage_root({a}, {b})"),
    }
}

pub(crate) fn ternary(op: Ternary, a: &str, b: &str, c: &str) -> String {
    match op {
        Ternary::AngleNear => format!("linkage_angle_near({a}, {b}, {c})"),
        Ternary::Select => format!("linkage_select({a}, {b}, {c})"),
    }
}

/// Rounded twice: C's `fma` would be a call on machines that cannot do it.
pub(crate) fn fused(op: Fused, a: &str, b: &str, c: &str) -> String {
    match op {
        Fused::MulAdd => format!("{a} * {b} + {c}"),
        Fused::MulSub => format!("{a} * {b} - {c}"),
        Fused::SubMul => format!("{c} - {a} * {b}"),
    }
}
