/* 1 for zero and above, -1 below. */
INLINE real own_sign(real a)
{
    return own_select(a, 1.0, -1.0);
}
