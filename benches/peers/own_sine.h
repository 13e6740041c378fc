/* The sine and cosine of the project, within a unit in the last place, here for angles of moderate size. */
#include <stdint.h>
#include <string.h>

static inline __attribute__((always_inline)) void sine_cosine(double x, double *s, double *c)
{
    const double round = 6755399441055744.0;
    const double shifted = __builtin_fma(x, 0.63661977236758138, round);
    const double n = shifted - round;
    const double rest = __builtin_fma(-n, 0x1.921fb54442d18p0, x);
    const double high = __builtin_fma(-n, 0x1.1a62633145c07p-54, rest);
    const double low = __builtin_fma(-n, 0x1.1a62633145c07p-54, rest - high);
    const double z = high * high, z2 = z * z;
    const double sp = (-2.5050747680755826e-8 + 1.5896225253711582e-10 * z) * z2
        + (-0.00019841269829588127 + 2.7557313620878265e-6 * z);
    const double cp = (2.0875700777873804e-9 - 1.1358533125225159e-11 * z) * z2
        + (2.480158728885015e-5 - 2.75573141788365e-7 * z);
    const double sine = sp * z2 + (-0.1666666666666663 + 0.008333333333322116 * z);
    const double cosine = cp * z2 + (0.041666666666666595 - 0.0013888888888873054 * z);
    const double half = -0.5 * high;
    const double base = half * high + 1;
    const double a = high + (high * z * sine + low * base);
    const double b = base + (z2 * cosine + (half * high + (1 - base) - high * low));
    /* Swapped and negated as n modulo 4 says. */
    uint64_t q, i, j;
    memcpy(&q, &shifted, 8);
    memcpy(&i, &a, 8);
    memcpy(&j, &b, 8);
    const uint64_t odd = (i ^ j) & (0 - (q & 1));
    i ^= odd ^ ((q & 2) << 62);
    j ^= odd ^ (((q + 1) & 2) << 62);
    memcpy(s, &i, 8);
    memcpy(c, &j, 8);
}
