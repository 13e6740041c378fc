/* The angle of the vector (x, y), from -pi to pi, to about a unit in the last place: the arc tangent of the smaller component over the larger,
   by a division whose rounding is compensated, then up to two right angles more. Both are scaled by a power of two before, so that nothing
   overflows. */
static inline real own_atan2(real y, real x)
{
    const real width = fabs(x);
    const real height = fabs(y);
    /* Bits of numbers that are not negative are in their order. */
    const word steep = (own_bits(width) - own_bits(height)) & SIGN_BITS;
    const word swapped = (own_bits(width) ^ own_bits(height)) & ((word)0 - (steep >> TOP));
    const real lesser = own_number(own_bits(height) ^ swapped);
    const real larger = own_number(own_bits(width) ^ swapped);
    const word size = own_bits(larger) & INFINITE_BITS;
    const real scale = own_number(TWO_ONES - (size < MOST_BITS ? size : MOST_BITS));
    /* NaN gets lost, and comes back at the end. */
    const word lesser_bits = own_bits(lesser * scale);
    const word larger_bits = own_bits(larger * scale);
    const word turned = own_bits(x) ^ steep;
    const real numerator = own_number((lesser_bits < MOST_BITS ? lesser_bits : MOST_BITS) ^ (turned & SIGN_BITS));
    const real divisor = own_number(larger_bits < MOST_BITS ? larger_bits : MOST_BITS);
    const real reciprocal = 1.0 / own_number(own_bits(divisor) > LEAST_BITS ? own_bits(divisor) : LEAST_BITS);
    /* Products of numbers with half the digits are exact. */
    const real first = own_number(own_bits(numerator * reciprocal) & UPPER_BITS);
    const real divisor_first = own_number(own_bits(divisor) & UPPER_BITS);
    const real missing = (numerator - first * divisor_first) - first * (divisor - divisor_first);
    const real second = missing * reciprocal;
    const real ratio = first + second;
    const real low = (first - ratio) + second;
    /* Two right angles for a negative x, one for a steep vector; the bits of 2 are those of the sign, shifted. */
    const real behind = own_number((own_bits(x) & SIGN_BITS) >> 1);
    const real half = own_number(HALF_BITS | steep);
    const real count = fabs((0.5 - half) - behind);
    const real base = count * RIGHT;
    const real sum = base + ratio;
    const real rest = count * RIGHT_LOW + ((base - sum) + ratio);
    const real z = ratio * ratio;
    /* z * -0.5 + 1 is near 1 / (1 + z), which is close enough for the rounding of the ratio. */
    const real angle = sum + ((ratio * z) * own_arc(z) + (low * (z * -0.5 + 1.0) + rest));
    const word over = (INFINITE_BITS - own_bits(width)) | (INFINITE_BITS - own_bits(height));
    return own_number((own_bits(angle) ^ (own_bits(y) & SIGN_BITS)) | ((word)0 - (over >> TOP)));
}
