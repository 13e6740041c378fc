/* The smaller number; NaN if either is. Of numbers that are equal but for their sign, the negative one. By masks: compilers make
   jumps of choices from constants. */
static inline real own_min(real a, real b)
{
    const word not_a = (word)0 - (word)(b < a);
    const word not_b = (word)0 - (word)(a < b);
    return own_number((own_bits(a) & ~not_a) | (own_bits(b) & ~not_b));
}
