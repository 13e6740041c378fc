/* The square root of a discriminant whose terms have the size of scale: 0 where it is negative by no more than 8 roundoffs of them,
   so that a group closes up to its dead point, and NaN beyond. */
static inline real own_root(real q, real scale)
{
    const real slack = EIGHT_ROUNDOFFS * fabs(scale);
    /* Zero if the sign is set. */
    const real root = sqrt(own_number(own_bits(q) & ((own_bits(q) >> TOP) - 1u)));
    const word infinite = GREATEST_BITS - own_bits(slack);
    const word missing = own_bits(q + slack) | (infinite & own_bits(q));
    return own_number(own_bits(root) | ((word)0 - (missing >> TOP)));
}
