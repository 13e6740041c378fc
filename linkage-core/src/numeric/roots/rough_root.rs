//! A square root without a library.

/// Returns the square root to two digits, which is enough for choosing step sizes.
pub(super) fn rough_root(square: f64) -> f64 {
    const HALF_BIAS: u64 = 0x1ff8_0000_0000_0000;
    let guess = f64::from_bits((square.to_bits() >> 1) + HALF_BIAS);
    0.5 * (guess + square / guess)
}
