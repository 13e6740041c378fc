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
