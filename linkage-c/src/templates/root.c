/* The square root of a discriminant whose terms have the size of scale: 0 where it is negative by no more than 8 roundoffs of them,
   so that a group closes up to its dead point, and NaN beyond. The root waits for nothing, and its bits stay where they are. */
static inline real own_root(real q, real scale)
{
    const real slack = EIGHT_ROUNDOFFS * fabs(scale);
    const word bits = own_bits(q);
    /* Their highest bits say: below zero, which -0 is not; no finite scale; more is missing, or anything beside such a scale. */
    const word negative = bits & (bits - 1u);
    const word infinite = GREATEST_BITS - own_bits(slack);
    const word missing = (own_bits(q + slack) | infinite) & negative;
    /* 1, 0, or NaN: all bits are set. */
    const word kept = ONE_BITS & ((negative >> TOP) - 1u);
    return sqrt(fabs(q)) * own_number(kept | ((word)0 - (missing >> TOP)));
}
