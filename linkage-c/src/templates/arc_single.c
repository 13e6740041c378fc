/* (atan(t) - t) / t^3 in powers of z = t^2, for t up to 1; terms stand side by side. */
static inline real own_arc(real z)
{
    const real z2 = z * z;
    const real a1 = (-0.08400618 * z + 0.10951178) * z2 + (-0.14264041 * z + 0.1999853);
    const real a5 = (-0.0017868582 * z + 0.010886879) * z2 + (-0.031129101 * z + 0.057909753);
    return (a5 * (z2 * z2) + a1) * z + -0.333333;
}
