/* The smaller number; NaN if either is. Of numbers that are equal but for their sign, the negative one. */
static inline real own_min(real a, real b)
{
    return own_number(own_bits(a < b ? a : b) | own_bits(b < a ? b : a));
}
