//! Programs on the numbers of generated code.

use std::marker::PhantomData;

use linkage_core::Scalar;
use linkage_symbolic::interpret::Arithmetic;
use linkage_symbolic::program::{Binary, Fused, Ternary, Unary};

/// The arithmetic of generated code on scalars `T`, with or without fused multiply-adds. With
/// `ALONE` it is that of calls of which no result depends on the last bit of a sine
/// ([`Program::compares_sines`](linkage_symbolic::program::Program::compares_sines)), with `ROWS`
/// that of sweeps. [`run_by`](linkage_symbolic::interpret::run_by) with this arithmetic gives the
/// bits of generated code. The arithmetic of [`run`](linkage_symbolic::interpret::run) takes sines
/// from the standard library, which generated code does not.
#[derive(Clone, Copy, Debug)]
pub struct Generated<T, const FUSED: bool, const ALONE: bool = false, const ROWS: bool = false>(
    PhantomData<T>,
);

impl<T: Scalar, const FUSED: bool, const ALONE: bool, const ROWS: bool> Arithmetic
    for Generated<T, FUSED, ALONE, ROWS>
{
    type Number = T;

    #[inline(always)]
    fn constant(x: f64) -> T {
        T::from_f64(x)
    }

    #[inline(always)]
    fn unary(op: Unary, a: T) -> T {
        match op {
            Unary::Neg => -a,
            Unary::Abs => a.abs(),
            Unary::Sqrt => a.sqrt(),
            Unary::Sin => Self::sine_pair(a)[0],
            Unary::Cos => Self::sine_pair(a)[1],
            Unary::Tan => a.tan(),
            Unary::Asin => a.asin(),
            Unary::Acos => a.acos(),
            Unary::Atan => a.atan(),
            Unary::Sign => a.sign(),
            Unary::Round => a.whole(),
            Unary::Slack => a.slack(),
            Unary::InverseScale => a.inverse_scale(),
        }
    }

    #[inline(always)]
    fn sine_pair(a: T) -> [T; 2] {
        let (sine, cosine) = match ALONE {
            true => a.sin_cos_shortest::<FUSED, ROWS>(),
            false => a.sin_cos_in_rows::<FUSED, ROWS>(),
        };
        [sine, cosine]
    }

    #[inline(always)]
    fn binary(op: Binary, a: T, b: T) -> T {
        match op {
            Binary::Add => a + b,
            Binary::Sub => a - b,
            Binary::Mul => a * b,
            Binary::Div => a / b,
            Binary::Quotient => a.quotient_with::<FUSED>(b),
            Binary::Atan2 => a.atan2_with::<FUSED>(b),
            Binary::Hypot => a.hypot(b),
            Binary::Min => a.min(b),
            Binary::Max => a.max(b),
        }
    }

    #[inline(always)]
    fn ternary(op: Ternary, a: T, b: T, c: T) -> T {
        match op {
            Ternary::AngleNear => T::angle_near_with::<FUSED>(a, b, c),
            Ternary::GuardedSqrt => a.root_with::<FUSED>(b, c),
            Ternary::Select => T::select(a, b, c),
        }
    }

    #[inline(always)]
    fn fused(op: Fused, a: T, b: T, c: T) -> T {
        match op {
            Fused::MulAdd => a.mul_add::<FUSED>(b, c),
            Fused::MulSub => a.mul_add::<FUSED>(b, -c),
            Fused::SubMul => (-a).mul_add::<FUSED>(b, c),
        }
    }
}
