/* HELPER bits: number, either */
/* The bits of a number, and the number of bits; by a union, since memcpy would be a call for some compilers. */
typedef union own_either { real number; word bits; } own_either;

static inline word own_bits(real number)
{
    own_either either;
    either.number = number;
    return either.bits;
}

static inline real own_number(word bits)
{
    own_either either;
    either.bits = bits;
    return either.number;
}
/* HELPER nan */
static inline real own_nan(void)
{
    return own_number(INFINITE_BITS | (INFINITE_BITS >> 1));
}
/* HELPER pair */
typedef struct own_pair { real sine, cosine; } own_pair;
/* HELPER select */
/* a where s >= 0, b where it is negative, NaN where it is NaN. All choices are made without branches. */
static inline real own_select(real s, real a, real b)
{
    const word bits = own_bits(s);
    /* All bits where s is negative, none where it is -0. */
    const word negative = (word)0 - ((bits & (bits - 1u)) >> TOP);
    const word none = (word)0 - (word)(s != s);
    return own_number((own_bits(a) & ~negative) | (own_bits(b) & negative) | none);
}
/* HELPER min */
/* The smaller number; NaN if either is. Of numbers that are equal but for their sign, the negative one. By masks: compilers make
   jumps of choices from constants. */
static inline real own_min(real a, real b)
{
    const word not_a = (word)0 - (word)(b < a);
    const word not_b = (word)0 - (word)(a < b);
    return own_number((own_bits(a) & ~not_a) | (own_bits(b) & ~not_b));
}
/* HELPER max */
/* The larger number; NaN if either is. */
static inline real own_max(real a, real b)
{
    const word not_a = (word)0 - (word)(b > a);
    const word not_b = (word)0 - (word)(a > b);
    return own_number((own_bits(a) & ~not_a) | (own_bits(b) & ~not_b));
}
/* HELPER sign */
/* 1 for zero and above, -1 below. */
static inline real own_sign(real a)
{
    return own_select(a, 1.0, -1.0);
}
/* HELPER slack */
/* By how much rounding may turn negative what was computed from terms of the size x; NaN where that is infinite. */
static inline real own_slack(real x)
{
    return EIGHT_ROUNDOFFS * fabs(x) + 0.0 * x;
}
/* HELPER quotient */
/* a / b, and no number where that is infinite: a rate where the root of a discriminant is 0. */
static inline real own_quotient(real a, real b)
{
    const real quotient = a / b;
    return quotient + 0.0 * quotient;
}
/* HELPER inverse_scale */
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
/* HELPER root */
/* The square root of a discriminant: 0 where it is negative by no more than slack times size, so that a group closes up to its dead
   point, and NaN beyond. The root waits for nothing, and its bits stay where they are. */
static inline real own_root(real q, real slack, real size)
{
    /* Not -0. */
    const word reserve = own_bits(slack * size + q + 0.0);
    /* 1, or 0 where the sign says that the root is of a negative number. */
    const word kept = ONE_BITS & ((own_bits(q) >> TOP) - 1u);
    /* The highest bits say: more is missing; no number. */
    const word missing = reserve | (INFINITE_BITS - reserve);
    return sqrt(fabs(q)) * own_number(kept | ((word)0 - (missing >> TOP)));
}
/* HELPER hypot */
/* The length of (a, b), without overflow on the way. */
static inline real own_hypot(real a, real b)
{
    const real scale = own_inverse_scale(own_max(fabs(a), fabs(b)));
    const real x = a * scale;
    const real y = b * scale;
    return sqrt(x * x + y * y) * own_inverse_scale(scale);
}
/* HELPER sin_cos (double) */
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
/* HELPER sin_cos (fused): unit_vectors */
/* Directions in steps of pi/64: cosine and its rounding error, sine and its rounding error. The last row is for large angles. */
static const real own_unit_vectors[129][4] = {
DIRECTIONS
};

/* Both to 0.78 units in the last place up to 1e5, to as many roundoffs of 1 beyond; NaN from 2^30 on, where they would be noise.
   The angle is n steps and a remainder high + low, whose pair turns the direction of n. */
static inline own_pair own_sin_cos(real x)
{
    const real shifted = fma(x, 20.371832715762604, ROUND);
    const real n = shifted - ROUND;
    /* All bits from 2^30 on, and for what is no number. */
    const word large = (word)0 - ((SINE_END_BITS - 1u - (own_bits(x) & ~SIGN_BITS)) >> TOP);
    const real *row = own_unit_vectors[(own_bits(shifted) & 127u & ~large) | (128u & large)];
    const real cosine = row[0], cosine_rest = row[1], sine = row[2], sine_rest = row[3];
    const real second = n * 1.9135106236586648e-18;
    const real rest = fma(-n, 0.04908738521234052, x);
    const real high = rest - second;
    const real low = fma(-n, 9.074549918685502e-30, (rest - high) - second);
    const real z = high * high;
    const real short_sine = fma(fma(-0.000198410207880214, z, 0.008333333332770617), z, -0.16666666666666666);
    const real short_cosine = fma(fma(-0.0013888664741272228, z, 0.04166666666160223), z, -0.5);
    const real s = fma(high * z, short_sine, low);
    const real of_sine = fma(cosine, s, fma(sine * z, short_cosine, sine_rest));
    const real of_cosine = fma(-sine, s, fma(cosine * z, short_cosine, cosine_rest));
    own_pair pair;
    pair.sine = fma(cosine, high, of_sine) + sine;
    pair.cosine = fma(-sine, high, of_cosine) + cosine;
    return pair;
}
/* HELPER sin_cos (single): difference, subtract */
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
/* HELPER arc (double|fused) */
/* (atan(t) - t) / t^3 in powers of z = t^2, for t up to 1; terms stand side by side. */
static inline real own_arc(real z)
{
    const real z2 = z * z;
    const real z4 = z2 * z2;
    const real z8 = z4 * z4;
    const real a1 = (-0.09090907008061716 * z + 0.11111111007357623) * z2 + (-0.14285714282588602 * z + 0.19999999999951756);
    const real a5 = (-0.05253527287082789 * z + 0.05880529924658981) * z2 + (-0.06666404444295934 * z + 0.07692279891726214);
    const real a9 = (-0.029905926580170068 * z + 0.036643265015795866) * z2 + (-0.04219248393782121 * z + 0.047223501098321345);
    const real a13 = (-0.0028856993516507413 * z + 0.007198057104861487) * z2 + (-0.013902812077726439 * z + 0.021987313385180722);
    const real a17 = 1.3230652873041794e-05 * z2 + (-0.00015221789472131463 * z + 0.0008315912991809981);
    const real first = a5 * z4 + a1;
    const real last = (a17 * z4 + a13) * z4 + a9;
    return (last * z8 + first) * z + -0.3333333333333307;
}
/* HELPER arc (single) */
/* (atan(t) - t) / t^3 in powers of z = t^2, for t up to 1; terms stand side by side. */
static inline real own_arc(real z)
{
    const real z2 = z * z;
    const real a1 = (-0.08400618 * z + 0.10951178) * z2 + (-0.14264041 * z + 0.1999853);
    const real a5 = (-0.0017868582 * z + 0.010886879) * z2 + (-0.031129101 * z + 0.057909753);
    return (a5 * (z2 * z2) + a1) * z + -0.333333;
}
/* HELPER atan2 */
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
/* HELPER angle_near */
/* The direction of (x, y), with the whole turns that bring it nearest to guide. */
static inline real own_angle_near(real y, real x, real guide)
{
    const real angle = own_atan2(y, x);
    const real turns = ((guide - angle) * TURNS + ROUND) - ROUND;
    return (angle + turns * TURN_LOW) + turns * TURN_HIGH;
}
/* HELPER tan */
static inline real own_tan(real x)
{
    const own_pair pair = own_sin_cos(x);
    return pair.sine / pair.cosine;
}
/* HELPER asin */
/* NaN outside of -1 to 1. */
static inline real own_asin(real x)
{
    return own_atan2(x, sqrt((1.0 - x) * (1.0 + x)));
}
/* HELPER acos */
/* NaN outside of -1 to 1. */
static inline real own_acos(real x)
{
    return own_atan2(sqrt((1.0 - x) * (1.0 + x)), x);
}
/* HELPER atan */
static inline real own_atan(real x)
{
    return own_atan2(x, 1.0);
}
/* HELPER whole */
/* The nearest integer. */
static inline real own_whole(real x)
{
    return (x + ROUND) - ROUND;
}
/* HELPER within */
/* x between 0 and most, 0 for NaN. All choices are made without branches. */
static inline real own_within(real x, real most)
{
    const word positive = (word)0 - (word)(x > 0.0);
    const real above = own_number(own_bits(x) & positive);
    const word below = (word)0 - (word)(above < most);
    return own_number((own_bits(above) & below) | (own_bits(most) & ~below));
}
/* HELPER infinite */
/* Whether a number is infinite or NaN. */
static inline int own_infinite(real x)
{
    return (own_bits(x) & INFINITE_BITS) == INFINITE_BITS;
}
