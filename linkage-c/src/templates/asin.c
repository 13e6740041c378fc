/* NaN outside of -1 to 1. */
static inline real own_asin(real x)
{
    return own_atan2(x, sqrt((1.0 - x) * (1.0 + x)));
}
