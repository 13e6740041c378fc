/* The length of (a, b), without overflow on the way. */
static inline real own_hypot(real a, real b)
{
    const real scale = own_inverse_scale(own_max(fabs(a), fabs(b)));
    const real x = a * scale;
    const real y = b * scale;
    return sqrt(x * x + y * y) * own_inverse_scale(scale);
}
