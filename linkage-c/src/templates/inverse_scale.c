/* A power of two near 1/|x|, 1 for zero and what is not finite: scales lengths without rounding. */
static inline real own_inverse_scale(real x)
{
    const word size = own_bits(x) & ~SIGN_BITS;
    word exponent = size & INFINITE_BITS;
    /* What is outside becomes negative, and its highest bit says so. */
    const word other = (word)0 - (((size - 1u) | (GREATEST_BITS - size)) >> TOP);
    exponent += ((exponent - 1u) >> TOP) * LEAST_BITS;
    exponent -= ((MOST_BITS - exponent) >> TOP) * LEAST_BITS;
    exponent = (exponent & ~other) | (ONE_BITS & other);
    return own_number(TWO_ONES - exponent);
}
