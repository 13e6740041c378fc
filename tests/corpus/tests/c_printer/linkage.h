/* What printed mechanisms compute with: operations that C's library does not have, or not with these results.

   NaN stands for "cannot be assembled" and is passed on by all of them. They are those of the table of operations, to the last
   bit, if the compiler neither fuses products with sums (-ffp-contract=off) nor takes functions of constants for its own
   (-fno-builtin): it rounds those better than the library does. Not for -ffast-math. */
#ifndef LINKAGE_H
#define LINKAGE_H

#include <math.h>
#include <stdint.h>
#include <string.h>

/* +1 for a number that is positive or a zero of either sign, -1 for a negative one. */
static inline double linkage_sign(double a)
{
    if (isnan(a)) return a;
    return a >= 0.0 ? 1.0 : -1.0;
}

/* A power of two near 1/|x|, 1 for zero and what is not finite: scales lengths without rounding. */
static inline double linkage_inverse_scale(double x)
{
    uint64_t bits, exponent;
    if (x == 0.0 || !isfinite(x)) return 1.0;
    memcpy(&bits, &x, sizeof bits);
    /* The exponent alone, mirrored, and kept within what normal numbers have. */
    exponent = bits >> 52 & 0x7ff;
    if (exponent < 1) exponent = 1;
    if (exponent > 2045) exponent = 2045;
    bits = (2046 - exponent) << 52;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Of equal numbers, which differ if they are zeros, the one with a sign: C leaves that to each library. */
static inline double linkage_signed(double a, double b)
{
    return signbit(a) ? a : b;
}

/* NaN if either is: C's fmin and fmax would pass the other one on. */
static inline double linkage_min(double a, double b)
{
    if (isnan(a) || isnan(b)) return NAN;
    return a < b ? a : b < a ? b : linkage_signed(a, b);
}

static inline double linkage_max(double a, double b)
{
    if (isnan(a) || isnan(b)) return NAN;
    return a > b ? a : b > a ? b : linkage_signed(a, b);
}

/* The square root of a discriminant whose terms have the size of `scale`. It closes a group up to the dead point, where rounding
   may leave it negative by 8 roundoffs of them, and refuses beyond. */
static inline double linkage_root(double q, double scale)
{
    if (q > 0.0) return sqrt(q);
    return isfinite(scale) && q >= -0x1p-49 * fabs(scale) ? 0.0 : NAN;
}

/* The direction of (x, y), with the whole turns that bring it nearest to `guide`. */
static inline double linkage_angle_near(double y, double x, double guide)
{
    const double turn = 0x1.921fb54442d18p2;
    const double angle = atan2(y, x);
    return angle + turn * rint((guide - angle) / turn);
}

/* `a` where s >= 0, `b` where it is negative. */
static inline double linkage_select(double s, double a, double b)
{
    if (isnan(s)) return s;
    return s >= 0.0 ? a : b;
}

#endif
