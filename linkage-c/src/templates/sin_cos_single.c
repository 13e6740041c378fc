/* a - b with its rounding, for a b that is smaller, or an exact difference. */
typedef struct own_difference { real high, low; } own_difference;

static inline own_difference own_subtract(real a, real b)
{
    own_difference own;
    own.high = a - b;
    own.low = (a - own.high) - b;
    return own;
}

/* Both to 0.83 units in the last place; NaN from 2^20 on, where they would be noise. The angle is reduced by a multiple of 1024 right
   angles and by at most 513 more, so that products with words of 14 bits are exact. */
static inline own_pair own_sin_cos(real x)
{
    const real most = (x * TWO_OVER_PI + 1024.0 * ROUND) - 1024.0 * ROUND;
    const real coarse = x - most * RIGHT_FIRST;
    const real product = most * RIGHT_SECOND;
    const real shifted = (coarse - product) * TWO_OVER_PI + ROUND;
    const real few = shifted - ROUND;
    const real rest = (coarse - few * RIGHT_FIRST) - product;
    const own_difference one = own_subtract(rest, few * RIGHT_SECOND);
    const own_difference two = own_subtract(one.high, most * RIGHT_THIRD);
    const own_difference three = own_subtract(two.high, few * RIGHT_THIRD);
    const real high = three.high;
    const real reduced = ((one.low + two.low) + three.low) - (most + few) * RIGHT_FOURTH;
    /* Zero, or infinity times zero. */
    const real low = (x * SINE_LIMIT) * 0.0 + reduced;
    const real z = high * high;
    const real sine = (-1.9511458e-4 * z + 8.332133e-3) * z + -0.16666654;
    const real cosine = (2.4428786e-5 * z + -1.3887278e-3) * z + 0.041666646;
    const real half = -0.5 * high;
    const real base = half * high + 1.0;
    const real s = high + ((high * z) * sine + low * base);
    const real small = -high * low + (half * high + (1.0 - base));
    const real c = base + ((z * z) * cosine + small);
    /* Turned by the right angles; a multiple of 1024 leaves alone the bits that count. */
    const word bits = own_bits(shifted);
    const word first = own_bits(s);
    const word second = own_bits(c);
    const word differing = (first ^ second) & ((word)0 - (bits & 1u));
    own_pair pair;
    pair.sine = own_number(first ^ differing ^ ((bits >> 1) << TOP));
    pair.cosine = own_number(second ^ differing ^ ((bits ^ (bits >> 1)) << TOP));
    return pair;
}
