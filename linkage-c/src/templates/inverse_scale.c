/* A power of two near 1/|x|, 1 for zero and what is not finite: scales lengths without rounding. */
static inline real own_inverse_scale(real x)
{
    const word size = own_bits(x) & ~SIGN_BITS;
    word exponent = size & INFINITE_BITS;
    exponent = exponent < LEAST_BITS ? LEAST_BITS : exponent;
    exponent = exponent > MOST_BITS ? MOST_BITS : exponent;
    exponent = size >= INFINITE_BITS || size == 0u ? ONE_BITS : exponent;
    return own_number(TWO_ONES - exponent);
}
