//! Sine and cosine of an `f32`, in the way of the module [`sin_cos`](super::sin_cos).
//!
//! With fused multiply-add all of it is in `f32`, for twice the lanes; without, three words of a
//! right angle would need too many parts, and the work is in `f64`.
//!
//! Largest errors, in units in the last place, of all numbers up to the limit: 0.78 up to 1e5 and
//! 0.93 up to 2^20 with fused multiply-add, 0.57 without.

use super::multiply::{one_rounding, single as mul_add};
use core::f32::consts::FRAC_2_PI;

/// Multiplied by this number, 2^20 and above become infinite.
const LIMIT: f32 = f32::from_bits(0x7580_0000);

/// Sine and cosine of an angle in radians; NaN for one of 2^20 and above in size. The sine of -0
/// is 0. One way serves single numbers and rows.
#[inline(always)]
pub(crate) fn sin_cos<const FUSED: bool, const ROWS: bool>(x: f32) -> (f32, f32) {
    if one_rounding::<FUSED>() {
        narrow::<FUSED>(x)
    } else {
        wide(x)
    }
}

/// In `f32`, with fused multiply-add.
#[inline(always)]
fn narrow<const FUSED: bool>(x: f32) -> (f32, f32) {
    const ROUND: f32 = 12_582_912.0;
    let shifted = mul_add::<FUSED>(x, FRAC_2_PI, ROUND);
    let (high, low) = reduce::<FUSED>(x, shifted - ROUND);
    // Zero, or infinity times zero.
    let low = mul_add::<FUSED>(x * LIMIT, 0.0, low);
    let (s, c) = reduced::<FUSED>(high, low);
    turned(s, c, shifted.to_bits())
}

/// `x` less `n` right angles, in two words.
#[inline(always)]
fn reduce<const FUSED: bool>(x: f32, n: f32) -> (f32, f32) {
    // 24 bits each.
    const FIRST: f32 = f32::from_bits(0x3FC9_0FDB);
    const SECOND: f32 = f32::from_bits(0xB33B_BD2E);
    const THIRD: f32 = f32::from_bits(0xA6F7_2CED);
    let rest = mul_add::<FUSED>(-n, FIRST, x);
    let product = n * SECOND;
    let rounding = mul_add::<FUSED>(n, SECOND, -product);
    let high = rest - product;
    let low = (rest - high) - product;
    (high, low - mul_add::<FUSED>(n, THIRD, rounding))
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

/// In `f64`, without fused multiply-add.
#[inline(always)]
fn wide(x: f32) -> (f32, f32) {
    // 33 bits, for exact products with n below 2^20, and 53 bits.
    const FIRST: f64 = f64::from_bits(0x3FF9_21FB_5440_0000);
    const SECOND: f64 = f64::from_bits(0x3DD0_B461_1A62_6331);
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let outside = f64::from(x * LIMIT * 0.0);
    let x = f64::from(x);
    let shifted = x * core::f64::consts::FRAC_2_PI + ROUND;
    let n = shifted - ROUND;
    let r = ((x - n * FIRST) - n * SECOND) + outside;
    let z = r * r;
    let z2 = z * z;
    let sine =
        (8.332_132_974_272_112e-3 * z - 0.166_666_541_770_349_23) - 1.951_145_796_876_183_8e-4 * z2;
    let cosine =
        (0.041_666_644_920_595_53 - 1.388_727_854_775_027e-3 * z) + 2.442_878_656_448_147_3e-5 * z2;
    let s = r + r * z * sine;
    let c = (1.0 - 0.5 * z) + z2 * cosine;
    // The low bits of the integer: all that matters.
    turned(s as f32, c as f32, shifted.to_bits() as u32)
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
