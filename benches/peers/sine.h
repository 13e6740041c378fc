/* The sine and cosine of the C library, for single calls. */
#define _GNU_SOURCE
#include <math.h>
#define KERNEL

static inline void sine_cosine(double x, double *s, double *c)
{
#ifdef __GLIBC__
    sincos(x, s, c);
#else
    *s = sin(x);
    *c = cos(x);
#endif
}
