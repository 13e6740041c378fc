//! Sine and cosine of an `f32`, in the way of the module [`sin_cos`](super::sin_cos).
//!
//! All of it is in `f32`: for twice the lanes, and for processors that have no other numbers.
//!
//! Largest errors, in units in the last place, of all numbers up to the limit of 2^20: 0.78 up to
//! 1e5 and 0.93 beyond with fused multiply-add, 0.83 without.

use super::multiply::{one_rounding, single as mul_add};
use core::f32::consts::FRAC_2_PI;

/// Multiplied by this number, 2^20 and above become infinite.
const LIMIT: f32 = f32::from_bits(0x7580_0000);

/// Adding this number rounds to an integer, which the low bits then hold.
const ROUND: f32 = 12_582_912.0;

/// Sine and cosine of an angle in radians; NaN for one of 2^20 and above in size. The sine of -0
/// is 0. One way serves single numbers and rows.
#[inline(always)]
pub(crate) fn sin_cos<const FUSED: bool, const ROWS: bool>(x: f32) -> (f32, f32) {
    let ([high, low], n) = if one_rounding::<FUSED>() {
        reduce::<FUSED>(x)
    } else {
        reduce_in_parts(x)
    };
    // Zero, or infinity times zero.
    let low = mul_add::<FUSED>(x * LIMIT, 0.0, low);
    let (s, c) = reduced::<FUSED>(high, low);
    turned(s, c, n)
}

/// `x` less `n` right angles, in two words, and the low bits of `n`; with fused multiply-add.
#[inline(always)]
fn reduce<const FUSED: bool>(x: f32) -> ([f32; 2], u32) {
    // 24 bits each.
    const FIRST: f32 = f32::from_bits(0x3FC9_0FDB);
    const SECOND: f32 = f32::from_bits(0xB33B_BD2E);
    const THIRD: f32 = f32::from_bits(0xA6F7_2CED);
    let shifted = mul_add::<FUSED>(x, FRAC_2_PI, ROUND);
    let n = shifted - ROUND;
    let rest = mul_add::<FUSED>(-n, FIRST, x);
    let product = n * SECOND;
    let rounding = mul_add::<FUSED>(n, SECOND, -product);
    let high = rest - product;
    let low = (rest - high) - product;
    let low = low - mul_add::<FUSED>(n, THIRD, rounding);
    ([high, low], shifted.to_bits())
}

/// Reduces as [`reduce`] does, without fused multiply-add: by a multiple of 1024 right angles and
/// by at most 513 more, so that products with words of 14 bits are exact.
#[inline(always)]
fn reduce_in_parts(x: f32) -> ([f32; 2], u32) {
    const ROUND_TO_1024: f32 = 1024.0 * ROUND;
    // 12, 13 and 14 bits, the next ones being zeros, and 24 bits.
    const FIRST: f32 = f32::from_bits(0x3FC9_1000);
    const SECOND: f32 = f32::from_bits(0xB695_7800);
    const THIRD: f32 = f32::from_bits(0x2E85_A400);
    const FOURTH: f32 = f32::from_bits(0xA6F7_2CED);
    let most = (x * FRAC_2_PI + ROUND_TO_1024) - ROUND_TO_1024;
    let rest = x - most * FIRST;
    let product = most * SECOND;
    // From what is left: the quotient of a large angle is rounded so coarsely that more than half a
    // right angle would remain.
    let shifted = (rest - product) * FRAC_2_PI + ROUND;
    let few = shifted - ROUND;

    let rest = (rest - few * FIRST) - product;
    let (high, low) = subtract(rest, few * SECOND);
    let (high, lower) = subtract(high, most * THIRD);
    let (high, lowest) = subtract(high, few * THIRD);
    let low = (low + lower) + lowest;
    // A multiple of 1024 leaves alone the bits that count.
    ([high, low - (most + few) * FOURTH], shifted.to_bits())
}

/// `a - b` with its rounding, for a `b` that is smaller, or an exact difference.
#[inline(always)]
fn subtract(a: f32, b: f32) -> (f32, f32) {
    let difference = a - b;
    (difference, (a - difference) - b)
}

/// Sine and cosine of an angle up to a quarter of pi.
#[inline(always)]
fn reduced<const FUSED: bool>(high: f32, low: f32) -> (f32, f32) {
    let z = high * high;
    let sine = mul_add::<FUSED>(-1.951_145_8e-4, z, 8.332_133e-3);
    let sine = mul_add::<FUSED>(sine, z, -0.166_666_54);
    let cosine = mul_add::<FUSED>(2.442_878_6e-5, z, -1.388_727_8e-3);
    let cosine = mul_add::<FUSED>(cosine, z, 0.041_666_646);
    let half = -0.5 * high;
    let base = mul_add::<FUSED>(half, high, 1.0);
    let s = high + mul_add::<FUSED>(high * z, sine, low * base);
    let small = mul_add::<FUSED>(-high, low, mul_add::<FUSED>(half, high, 1.0 - base));
    let c = base + mul_add::<FUSED>(z * z, cosine, small);
    (s, c)
}

/// The pair turned by `n` right angles: in integers, so that it is no branch.
#[inline(always)]
fn turned(s: f32, c: f32, n: u32) -> (f32, f32) {
    const SIGN: u32 = 1 << 31;
    let (s, c) = (s.to_bits(), c.to_bits());
    let swap = (s ^ c) & 0u32.wrapping_sub(n & 1);
    let second = n << 30;
    let first = n << 31;
    (
        f32::from_bits(s ^ swap ^ (second & SIGN)),
        f32::from_bits(c ^ swap ^ ((second ^ first) & SIGN)),
    )
}
