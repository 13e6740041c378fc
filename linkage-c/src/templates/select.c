/* a where s >= 0, b where it is negative, NaN where it is NaN. All choices are made without branches. */
static inline real own_select(real s, real a, real b)
{
    const word bits = own_bits(s);
    /* All bits where s is negative, none where it is -0. */
    const word negative = (word)0 - ((bits & (bits - 1u)) >> TOP);
    const word none = (word)0 - (word)(s != s);
    return own_number((own_bits(a) & ~negative) | (own_bits(b) & negative) | none);
}
