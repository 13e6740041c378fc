/* NaN outside of -1 to 1. */
static inline real own_acos(real x)
{
    return own_atan2(sqrt((1.0 - x) * (1.0 + x)), x);
}
