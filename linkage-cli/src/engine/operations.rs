//! Programs with the arithmetic of the runtime. The interpreter of `linkage-symbolic` takes sines from the standard library, which
//! the macro's code does not.

use linkage_runtime::Scalar;
use linkage_runtime::generated::{Single, inlined, single};
use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};

/// A program and where it finds what it loads.
struct Run<'a, L> {
    program: &'a Program,
    load: L,
}

/// The outputs of a program, with the instructions of the build.
pub(super) fn by_build(program: &Program, load: impl Fn(Source) -> f64) -> Vec<f64> {
    inlined(&Run { program, load }, [] as [f64; 0])
}

/// The outputs of a program, with fused multiply-add if the machine has it.
pub(super) fn by_machine(program: &Program, load: impl Fn(Source) -> f64) -> Vec<f64> {
    single(&Run { program, load }, [] as [f64; 0])
}

impl<L: Fn(Source) -> f64> Single<f64, Vec<f64>, 0> for Run<'_, L> {
    #[inline(always)]
    fn at<const FUSED: bool>(&self, []: [f64; 0]) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.program.instructions.len());
        let mut cosine = f64::NAN;
        for instruction in &self.program.instructions {
            let at = |value: Value| -> f64 { values[value.0] };
            let value = match *instruction {
                Instruction::Constant(value) => value,
                Instruction::Load(source) => (self.load)(source),
                Instruction::Unary(operation, a) => unary::<FUSED>(operation, at(a)),
                Instruction::Binary(operation, a, b) => binary::<FUSED>(operation, at(a), at(b)),
                Instruction::Ternary(operation, a, b, c) => {
                    ternary::<FUSED>(operation, at(a), at(b), at(c))
                }
                Instruction::Fused(operation, a, b, c) => {
                    fused::<FUSED>(operation, at(a), at(b), at(c))
                }
                Instruction::SinCos(a) => {
                    let pair = at(a).sin_cos_with::<FUSED>();
                    cosine = pair.1;
                    pair.0
                }
                // Right behind the instruction that found it.
                Instruction::Second(_) => cosine,
            };
            values.push(value);
        }
        let outputs = self.program.outputs.iter();
        outputs.map(|output| values[output.0]).collect()
    }
}

#[inline(always)]
fn unary<const FUSED: bool>(operation: Unary, a: f64) -> f64 {
    match operation {
        Unary::Neg => -a,
        Unary::Abs => Scalar::abs(a),
        Unary::Sqrt => Scalar::sqrt(a),
        Unary::Sin => a.sin_cos_with::<FUSED>().0,
        Unary::Cos => a.sin_cos_with::<FUSED>().1,
        Unary::Tan => Scalar::tan(a),
        Unary::Asin => Scalar::asin(a),
        Unary::Acos => Scalar::acos(a),
        Unary::Atan => Scalar::atan(a),
        Unary::Sign => Scalar::sign(a),
        Unary::InverseScale => a.inverse_scale(),
    }
}

#[inline(always)]
fn binary<const FUSED: bool>(operation: Binary, a: f64, b: f64) -> f64 {
    match operation {
        Binary::Add => a + b,
        Binary::Sub => a - b,
        Binary::Mul => a * b,
        Binary::Div => a / b,
        Binary::Atan2 => a.atan2_with::<FUSED>(b),
        Binary::Hypot => Scalar::hypot(a, b),
        Binary::Min => Scalar::min(a, b),
        Binary::Max => Scalar::max(a, b),
        Binary::Root => Scalar::root(a, b),
    }
}

#[inline(always)]
fn ternary<const FUSED: bool>(operation: Ternary, a: f64, b: f64, c: f64) -> f64 {
    match operation {
        Ternary::AngleNear => f64::angle_near_with::<FUSED>(a, b, c),
        Ternary::Select => Scalar::select(a, b, c),
    }
}

#[inline(always)]
fn fused<const FUSED: bool>(operation: Fused, a: f64, b: f64, c: f64) -> f64 {
    match operation {
        Fused::MulAdd => Scalar::mul_add::<FUSED>(a, b, c),
        Fused::MulSub => Scalar::mul_add::<FUSED>(a, b, -c),
        Fused::SubMul => Scalar::mul_add::<FUSED>(-a, b, c),
    }
}
