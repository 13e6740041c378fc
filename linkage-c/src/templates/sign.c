/* 1 for zero and above, -1 below. */
static inline real own_sign(real a)
{
    return own_select(a, 1.0, -1.0);
}
