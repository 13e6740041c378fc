static inline real own_atan(real x)
{
    return own_atan2(x, 1.0);
}
