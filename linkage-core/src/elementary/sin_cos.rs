//! Sine and cosine of an `f64`.
//!
//! The angle is reduced to `high + low` within a quarter of pi by subtracting `n` right angles
//! (`n` is rounded by adding a large constant, whose low bits then hold `n` modulo 4), the pair of
//! the reduced angle comes from polynomials, and `n` says how to swap and negate it.
//!
//! Largest errors found against 512 bits: 0.80 units in the last place up to 1e5, also next to
//! multiples of a right angle (where both variants round correctly or nearly so), and 0.80
//! roundoffs (2^-53) up to the limit of 2^30.

mod directions;
mod kernel;
mod rows;

pub use directions::directions;

use super::multiply::{double as mul_add, one_rounding};
use kernel::{COSINE, ROUND, SINE, exchanged, polynomial, unless_large};

/// Sine and cosine of an angle in radians; NaN for one of 2^30 and above in size. The sine of -0
/// is 0.
#[inline(always)]
pub(crate) fn sin_cos<const FUSED: bool, const ROWS: bool>(x: f64) -> (f64, f64) {
    let shifted = mul_add::<FUSED>(x, core::f64::consts::FRAC_2_PI, ROUND);
    let (high, low) = reduce::<FUSED>(x, shifted - ROUND);
    let pair = reduced::<FUSED>(high, unless_large::<FUSED>(x, low));
    if ROWS {
        swapped(pair, shifted.to_bits())
    } else {
        turned::<FUSED>(pair, shifted.to_bits())
    }
}

/// Returns sine and cosine in fewer operations than [`sin_cos`] where multiply-adds are fused, with
/// other roundings: by a table for one position, in one word for rows.
#[inline(always)]
pub(crate) fn sin_cos_shortest<const FUSED: bool, const ROWS: bool>(x: f64) -> (f64, f64) {
    match (one_rounding::<FUSED>(), ROWS) {
        (true, true) => rows::sin_cos(x),
        (true, false) => directions::sin_cos(x),
        (false, _) => sin_cos::<FUSED, ROWS>(x),
    }
}

/// `x` less `n` right angles, in two words.
#[inline(always)]
fn reduce<const FUSED: bool>(x: f64, n: f64) -> (f64, f64) {
    if one_rounding::<FUSED>() {
        // 53 bits; 36 bits, for exact products with n below 2^17; 53 bits.
        const FIRST: f64 = f64::from_bits(0x3FF9_21FB_5444_2D18);
        const SECOND: f64 = f64::from_bits(0x3C91_A626_3314_0000);
        const THIRD: f64 = f64::from_bits(0x3A37_01B8_39A2_5205);
        let rest = mul_add::<FUSED>(-n, FIRST, x);
        let high = mul_add::<FUSED>(-n, SECOND, rest);
        let low = mul_add::<FUSED>(-n, SECOND, rest - high);
        (high, mul_add::<FUSED>(-n, THIRD, low))
    } else {
        // 23 bits twice, for exact products with n below 2^30; 36 bits (2^17); 53 bits.
        const FIRST: f64 = f64::from_bits(0x3FF9_21FB_4000_0000);
        const SECOND: f64 = f64::from_bits(0x3E74_442D_0000_0000);
        const THIRD: f64 = f64::from_bits(0x3CF8_4698_98CC_0000);
        const FOURTH: f64 = f64::from_bits(0x3A94_5C06_E0E6_8948);
        let rest = (x - n * FIRST) - n * SECOND;
        let product = n * THIRD;
        let high = rest - product;
        (high, ((rest - high) - product) - n * FOURTH)
    }
}

/// Sine and cosine of an angle up to a quarter of pi, each a large and a small part.
#[inline(always)]
fn reduced<const FUSED: bool>(high: f64, low: f64) -> [[f64; 2]; 2] {
    let z = high * high;
    let z2 = z * z;
    let sine = polynomial::<FUSED>(z, z2, SINE);
    let cosine = polynomial::<FUSED>(z, z2, COSINE);
    let half = -0.5 * high;
    let base = mul_add::<FUSED>(half, high, 1.0);
    let s = mul_add::<FUSED>(high * z, sine, low * base);
    let small = mul_add::<FUSED>(-high, low, mul_add::<FUSED>(half, high, 1.0 - base));
    let c = mul_add::<FUSED>(z2, cosine, small);
    [[high, s], [base, c]]
}

/// The pair turned by `n` right angles, of which `n` has the low bits: products with 1, -1 and 0,
/// which are exact. All that depends on `n` is ready before the sines are, and of a single number
/// nothing goes from the registers of integers to those of floats behind them. (A choice would
/// become a branch in some places.)
#[inline(always)]
fn turned<const FUSED: bool>(pair: [[f64; 2]; 2], n: u64) -> (f64, f64) {
    const ONE: u64 = 1.0_f64.to_bits();
    let [[high, s], [base, c]] = pair;
    let even = (n & 1).wrapping_sub(1) & ONE;
    let odd = even ^ ONE;
    let sign_of_sine = (n ^ n >> 1) << 63;
    let sign_of_cosine = n >> 1 << 63;
    let turned = |sine: u64, cosine: u64| {
        let sine = f64::from_bits(sine | sign_of_sine);
        let cosine = f64::from_bits(cosine | sign_of_cosine);
        let large = mul_add::<FUSED>(base, cosine, high * sine);
        mul_add::<FUSED>(s, sine, mul_add::<FUSED>(c, cosine, large))
    };
    (turned(even, odd), turned(odd, even))
}

/// Returns the result of [`turned`], to the last bit, by the bits of the sines: 13 operations
/// instead of 21, all of them on vectors.
#[inline(always)]
fn swapped(pair: [[f64; 2]; 2], n: u64) -> (f64, f64) {
    let [[high, s], [base, c]] = pair;
    exchanged([high + s, base + c], n)
}
