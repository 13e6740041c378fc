/* The larger number; NaN if either is. */
static inline real own_max(real a, real b)
{
    const word not_a = (word)0 - (word)(b > a);
    const word not_b = (word)0 - (word)(a > b);
    return own_number((own_bits(a) & ~not_a) | (own_bits(b) & ~not_b));
}
