//! Constants and steps that all variants of sine and cosine share.

use super::super::multiply::double as mul_add;

/// Adding this number rounds to an integer, which the low bits then hold.
pub(super) const ROUND: f64 = 6_755_399_441_055_744.0;
/// Limit of the angle, 2^30: beyond it a sine is noise.
pub(super) const LIMIT: f64 = 1_073_741_824.0;
/// Multiplied by this number, [`LIMIT`] and above become infinite.
const TO_INFINITY: f64 = f64::from_bits(0x7E10_0000_0000_0000);

/// `(sin x - x) / x^3` by powers of `x^2`, up to a quarter of pi.
pub(super) const SINE: [f64; 6] = [
    -0.166_666_666_666_666_3,
    0.008_333_333_333_322_116,
    -0.000_198_412_698_295_881_27,
    2.755_731_362_087_826_5e-6,
    -2.505_074_768_075_582_6e-8,
    1.589_622_525_371_158_2e-10,
];
/// `(cos x - 1 + x^2/2) / x^4`
pub(super) const COSINE: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_305_4,
    2.480_158_728_885_015_2e-5,
    -2.755_731_417_883_65e-7,
    2.087_570_077_787_380_4e-9,
    -1.135_853_312_522_515_9e-11,
];

/// `value`, NaN for an angle `x` of 2^30 and above in size.
#[inline(always)]
pub(super) fn unless_large<const FUSED: bool>(x: f64, value: f64) -> f64 {
    // Plus zero, or infinity times zero.
    mul_add::<FUSED>(x * TO_INFINITY, 0.0, value)
}

/// A polynomial with pairs of terms side by side.
#[inline(always)]
pub(super) fn polynomial<const FUSED: bool>(z: f64, z2: f64, c: [f64; 6]) -> f64 {
    let ends = mul_add::<FUSED>(
        mul_add::<FUSED>(c[5], z, c[4]),
        z2,
        mul_add::<FUSED>(c[3], z, c[2]),
    );
    mul_add::<FUSED>(ends, z2, mul_add::<FUSED>(c[1], z, c[0]))
}

/// The pair exchanged and negated as `n` right angles do.
#[inline(always)]
pub(super) fn exchanged(pair: [f64; 2], n: u64) -> (f64, f64) {
    let [sine, cosine] = pair.map(f64::to_bits);
    let odd = (n & 1).wrapping_neg();
    let differing = (sine ^ cosine) & odd;
    let sign_of_sine = n >> 1 << 63;
    let sign_of_cosine = (n ^ n >> 1) << 63;
    (
        f64::from_bits(sine ^ differing ^ sign_of_sine),
        f64::from_bits(cosine ^ differing ^ sign_of_cosine),
    )
}
