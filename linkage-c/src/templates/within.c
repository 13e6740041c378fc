/* x between 0 and most, 0 for NaN. All choices are made without branches. */
static inline real own_within(real x, real most)
{
    const word positive = (word)0 - (word)(x > 0.0);
    const real above = own_number(own_bits(x) & positive);
    const word below = (word)0 - (word)(above < most);
    return own_number((own_bits(above) & below) | (own_bits(most) & ~below));
}
