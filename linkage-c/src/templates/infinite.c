/* Whether a number is infinite or NaN. */
static inline int own_infinite(real x)
{
    return (own_bits(x) & INFINITE_BITS) == INFINITE_BITS;
}
