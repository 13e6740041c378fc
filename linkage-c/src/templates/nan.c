static inline real own_nan(void)
{
    return own_number(INFINITE_BITS | (INFINITE_BITS >> 1));
}
