/* a / b, and no number where that is infinite: a rate where the root of a discriminant is 0. */
static inline real own_quotient(real a, real b)
{
    const real quotient = a / b;
    return quotient + 0.0 * quotient;
}
