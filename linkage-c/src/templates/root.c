/* The square root of a discriminant whose terms have the size of scale: 0 where it is negative by no more than 8 roundoffs of them,
   so that a group closes up to its dead point, and NaN beyond. The root waits for nothing, and its bits stay where they are. */
static inline real own_root(real q, real scale)
{
    const real slack = EIGHT_ROUNDOFFS * fabs(scale);
    /* Negative if more is missing, or anything where the scale is infinite. Then all bits are set: NaN. Of -0 nothing is missing. */
    const word infinite = GREATEST_BITS - own_bits(slack);
    const word missing = own_bits(q + slack) | (infinite & own_bits(q + 0.0));
    const real none = own_number((word)0 - (missing >> TOP));
    const real kept = own_number(ONE_BITS & ((own_bits(q) >> TOP) - 1u));
    return sqrt(fabs(q)) * kept + none;
}
