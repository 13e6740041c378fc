/* The larger number; NaN if either is. */
static inline real own_max(real a, real b)
{
    return own_number(own_bits(a > b ? a : b) | own_bits(b > a ? b : a));
}
