/* Both to 0.80 units in the last place up to 1e5, to as many roundoffs of 1 beyond; NaN from 2^30 on, where they would be noise.
   The angle is reduced to high + low within a quarter of pi by n right angles; n is rounded by adding a large number, whose low bits then
   hold it. */
static inline own_pair own_sin_cos(real x)
{
    const real shifted = x * TWO_OVER_PI + ROUND;
    const real n = shifted - ROUND;
    /* 23 bits twice, for exact products with n, 36 bits, 53 bits. */
    const real rest = (x - n * RIGHT_FIRST) - n * RIGHT_SECOND;
    const real product = n * RIGHT_THIRD;
    const real high = rest - product;
    const real reduced = ((rest - high) - product) - n * RIGHT_FOURTH;
    /* Zero, or infinity times zero. */
    const real low = (x * SINE_LIMIT) * 0.0 + reduced;
    const real z = high * high;
    const real z2 = z * z;
    const real sine = ((1.5896225253711582e-10 * z + -2.5050747680755826e-8) * z2
        + (2.7557313620878265e-6 * z + -0.00019841269829588127)) * z2 + (0.008333333333322116 * z + -0.1666666666666663);
    const real cosine = ((-1.1358533125225159e-11 * z + 2.0875700777873804e-9) * z2
        + (-2.75573141788365e-7 * z + 2.4801587288850152e-5)) * z2 + (-0.0013888888888873054 * z + 0.041666666666666595);
    const real half = -0.5 * high;
    const real base = half * high + 1.0;
    const real s = (high * z) * sine + low * base;
    const real small = -high * low + (half * high + (1.0 - base));
    const real c = z2 * cosine + small;
    /* Turned by n right angles. */
    const word bits = own_bits(shifted);
    const word first = own_bits(high + s);
    const word second = own_bits(base + c);
    const word differing = (first ^ second) & ((word)0 - (bits & 1u));
    own_pair pair;
    pair.sine = own_number(first ^ differing ^ ((bits >> 1) << TOP));
    pair.cosine = own_number(second ^ differing ^ ((bits ^ (bits >> 1)) << TOP));
    return pair;
}
